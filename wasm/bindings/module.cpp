#include <emscripten/emscripten.h>
#include <malloc.h>

#include <memory>
#include <string>
#include <string_view>

#include "core/text/readable.h"
#include "wasm/bindings/module_clip.h"

void take_read(ModuleClip& clip, marey::Result<marey::BvhClip> read) {
  if (!read) {
    clip.text = describe_error(read.error());
    return;
  }
  clip.bvh = std::move(read.value());
  clip.bvh.diagnostics = marey::readable(clip.bvh.diagnostics, clip.bvh.names_in);
  clip.is_open = true;
  clip.text = describe_clip(clip.bvh);
}

marey::SaveOptions save_options(int decimals, int line_end) {
  marey::SaveOptions options;
  if (decimals >= 0) options.decimals = decimals;
  if (line_end >= 0) options.line_end = static_cast<marey::LineEnd>(line_end);
  return options;
}

namespace {

/// A single frame, asked for again and again by whoever plays or scrubs, is not worth a FrameBlock.
void compute_one_frame(ModuleClip& clip, int frame) {
  const marey::BvhClip& bvh = clip.bvh;
  clip.local.resize(bvh.skeleton);
  clip.world.resize(bvh.skeleton);
  compute_local_pose(bvh.skeleton, bvh.motion, frame, bvh.position_rule, clip.local);
  compute_world_pose(bvh.skeleton, clip.local, clip.world);
  float* out = clip.world_positions.data();
  for (const glm::dvec3& position : clip.world.world_positions) {
    for (int axis = 0; axis < 3; ++axis) *out++ = static_cast<float>(position[axis]);
  }
}

}  // namespace

/// The functions that web/module/marey.ts calls. Text comes in as address and size in bytes, in memory from malloc that
/// the caller releases; what goes out stays at the returned address until the next call with the same clip. Without memory
/// for it a call throws std::bad_alloc, which JavaScript sees as a WebAssembly.Exception.
/// Indices are in range: the caller checks them.
extern "C" {

/// Bytes of the program's memory that are taken.
EMSCRIPTEN_KEEPALIVE size_t marey_used_memory() { return static_cast<size_t>(mallinfo().uordblks); }

EMSCRIPTEN_KEEPALIVE void marey_clip_dispose(ModuleClip* clip) { delete clip; }

EMSCRIPTEN_KEEPALIVE int marey_clip_is_open(const ModuleClip* clip) { return clip->is_open ? 1 : 0; }

/// After reading the clip or the error as JSON, after marey_clip_write the file.
EMSCRIPTEN_KEEPALIVE const char* marey_clip_text(const ModuleClip* clip) { return clip->text.data(); }
EMSCRIPTEN_KEEPALIVE size_t marey_clip_text_size(const ModuleClip* clip) { return clip->text.size(); }

/// The samples of a channel, frame count values, for reading and for writing.
EMSCRIPTEN_KEEPALIVE double* marey_clip_samples(ModuleClip* clip, int channel) {
  return clip->bvh.motion.channel_samples(channel).data();
}

/// World positions of all nodes over a range of frames, [frame][node][x y z].
EMSCRIPTEN_KEEPALIVE const float* marey_clip_world_positions(ModuleClip* clip, int first, int count) {
  const marey::BvhClip& bvh = clip->bvh;
  clip->world_positions.resize(marey::idx(count) * marey::idx(bvh.skeleton.node_count()) * 3);
  if (count == 1) {
    compute_one_frame(*clip, first);
  } else {
    compute_world_positions(bvh.skeleton, bvh.motion, {first, count}, bvh.position_rule,
                            std::span<float>(clip->world_positions));
  }
  return clip->world_positions.data();
}

/// The place in marey::kPositionRuleIds.
EMSCRIPTEN_KEEPALIVE int marey_clip_position_rule(const ModuleClip* clip) {
  return static_cast<int>(clip->bvh.position_rule);
}
EMSCRIPTEN_KEEPALIVE void marey_clip_set_position_rule(ModuleClip* clip, int rule) {
  clip->bvh.position_rule = static_cast<marey::PositionRule>(rule);
}

/// `decimals` and `line_end` (0 LF, 1 CR LF) below 0 leave things as they are, as does a `count` of 0.
EMSCRIPTEN_KEEPALIVE void marey_clip_write(ModuleClip* clip, int decimals, int line_end, int first, int count) {
  marey::SaveOptions options = save_options(decimals, line_end);
  options.frames = {first, count};
  const marey::BvhClip& bvh = clip->bvh;
  const bool as_it_is = options == marey::SaveOptions{};
  clip->text = as_it_is ? write_bvh(bvh.skeleton, bvh.motion, bvh.style) : write_bvh(bvh.skeleton, bvh.motion, bvh.style, options);
}

}  // extern "C"
