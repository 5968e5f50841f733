#include <emscripten/emscripten.h>

#include <memory>
#include <string>
#include <string_view>

#include "core/bvh/stream_reader.h"
#include "wasm/bindings/module_clip.h"

namespace {

/// A file that JavaScript feeds.
struct ModuleReader {
  ModuleReader(const marey::ReadOptions& options, const marey::StreamOptions& stream) : reader(options, stream) {}
  marey::StreamReader reader;
  std::string piece;
};

/// What the next reader is made with.
marey::ReadOptions next_options;

}  // namespace

/// Reading by pieces; see module.cpp for how text comes and goes.
extern "C" {

/// Options of the next reader, which takes them over. `names_in`: index in marey::kCharacterSets, -1 for a guess.
EMSCRIPTEN_KEEPALIVE void marey_reader_options(int strict, int names_in) {
  next_options = {};
  next_options.strict = strict != 0;
  if (names_in >= 0) next_options.names_in = marey::kCharacterSets[marey::idx(names_in)];
}

/// One of the limits of the next reader; null, or the error as JSON until the next call.
EMSCRIPTEN_KEEPALIVE const char* marey_reader_limit(const char* name, size_t name_size, double value) {
  static std::string refusal;
  const marey::Status status = set_limit(next_options.limits, std::string_view(name, name_size), static_cast<std::int64_t>(value));
  if (status) return nullptr;
  refusal = describe_error(status.error());
  return refusal.c_str();
}

/// `expected_bytes`: size of the file, 0 if nobody knows.
EMSCRIPTEN_KEEPALIVE ModuleReader* marey_reader_open(double expected_bytes) {
  marey::StreamOptions stream;
  stream.expected_bytes = static_cast<std::int64_t>(expected_bytes);
  return new ModuleReader(next_options, stream);
}

/// Where the next piece, of `size` bytes, is to be put.
EMSCRIPTEN_KEEPALIVE char* marey_reader_piece(ModuleReader* reader, size_t size) {
  if (reader->piece.size() < size) reader->piece.resize(size);
  return reader->piece.data();
}

/// Reads `size` bytes of the piece; 0 when no more are wanted.
EMSCRIPTEN_KEEPALIVE int marey_reader_feed(ModuleReader* reader, size_t size) {
  return reader->reader.feed(std::string_view(reader->piece.data(), size)) ? 1 : 0;
}

EMSCRIPTEN_KEEPALIVE int marey_reader_frame_count(const ModuleReader* reader) { return reader->reader.frame_count(); }

/// The first frames that are known, at most `most_frames`, as a clip of its own; null while there are none.
EMSCRIPTEN_KEEPALIVE ModuleClip* marey_reader_clip_so_far(const ModuleReader* reader, double most_frames) {
  const auto frames = static_cast<std::int64_t>(most_frames);
  std::optional<marey::BvhClip> so_far = reader->reader.clip_so_far(frames * reader->reader.channel_count());
  if (!so_far) return nullptr;
  auto clip = std::make_unique<ModuleClip>();
  take_read(*clip, std::move(*so_far));
  return clip.release();
}

/// Never null; marey_clip_is_open tells whether the file could be read. The reader is only good for being disposed of then.
EMSCRIPTEN_KEEPALIVE ModuleClip* marey_reader_finish(ModuleReader* reader) {
  reader->piece = {};
  auto clip = std::make_unique<ModuleClip>();
  take_read(*clip, reader->reader.finish());
  return clip.release();
}

EMSCRIPTEN_KEEPALIVE void marey_reader_dispose(ModuleReader* reader) { delete reader; }

}  // extern "C"
