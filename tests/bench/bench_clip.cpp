#include "tests/bench/bench_clip.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "core/bvh/reader.h"

namespace marey::bench {
namespace {

[[noreturn]] void give_up(const std::string& reason) {
  std::fprintf(stderr, "%s\n", reason.c_str());
  std::exit(1);
}

std::string read_clip_text(const char* variable) {
  const char* path = std::getenv(variable);
  if (path == nullptr) give_up(std::string(variable) + " does not name the clip; npm run bench makes it and sets this.");
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return std::move(bytes).str();
}

BvhClip read_clip(const std::string& text) {
  Result<BvhClip> clip = read_bvh(text);
  if (!clip) give_up("The clip cannot be read: " + clip.error().message);
  return std::move(clip.value());
}

}  // namespace

const std::string& clip_text() {
  static const std::string text = read_clip_text("MAREY_BENCH_CLIP");
  return text;
}

const BvhClip& clip() {
  static const BvhClip clip = read_clip(clip_text());
  return clip;
}

BvhClip body_clip() { return read_clip(read_clip_text("MAREY_BENCH_BODY")); }

}  // namespace marey::bench
