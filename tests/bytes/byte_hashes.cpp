// Tells what reading and writing give, file by file, so that tests/node can compare native code, the same code as
// WebAssembly, and the JavaScript module: `marey_byte_hashes FILE ...` prints a line of JSON for each.
#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "core/bvh/reader.h"
#include "core/bvh/writer.h"
#include "tests/support/files.h"

namespace marey {
namespace {

/// FNV-1a with 32 bits and the number of bytes, as tests/node/same_bytes.test.mjs computes it.
std::string hash_of(std::string_view bytes, std::uint32_t hash = 2166136261U) {
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return fmt::format("{:08x}:{}", hash, bytes.size());
}

std::string_view bytes_of(std::span<const double> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

/// The edit that the test makes through the module too: every seventh sample of the middle channel.
void edit(Motion& motion) {
  if (motion.channel_count() == 0) return;
  const std::span<double> samples = motion.channel_samples(motion.channel_count() / 2);
  for (std::size_t i = 0; i < samples.size(); i += 7) samples[i] = samples[i] * 0.5 + 1.25;
}

nlohmann::json describe(const std::string& path) {
  const std::string text = test::read_file(path).value_or("");
  Result<BvhClip> clip = read_bvh(text);
  if (!clip) return {{"refused", diagnostic_id(clip.error().code)}};
  nlohmann::json result;
  result["samples"] = hash_of(bytes_of(clip->motion.samples()));
  result["written"] = hash_of(write_bvh(clip->skeleton, clip->motion, clip->style));
  result["canonical"] = hash_of(write_bvh(clip->skeleton, clip->motion, {}));
  edit(clip->motion);
  result["edited"] = hash_of(write_bvh(clip->skeleton, clip->motion, clip->style));
  return result;
}

}  // namespace
}  // namespace marey

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) std::puts(marey::describe(argv[i]).dump().c_str());
}
