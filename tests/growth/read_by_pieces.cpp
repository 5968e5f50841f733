// Reads a file piece by piece and prints, as JSON, what that took: for scripts/bench/growth.mjs.
#include <cstdio>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include "core/bvh/stream_reader.h"

namespace {

constexpr std::size_t kPiece = std::size_t{256} << 10;

/// The most memory that the program has had so far, in bytes; 0 where the system does not tell.
long long peak_bytes() {
  long long kibibytes = 0;
  if (std::FILE* status = std::fopen("/proc/self/status", "r")) {
    char line[256];
    while (std::fgets(line, sizeof line, status) != nullptr) {
      if (std::strncmp(line, "VmHWM:", 6) == 0) std::sscanf(line + 6, "%lld", &kibibytes);
    }
    std::fclose(status);
  }
  return kibibytes * 1024;
}

}  // namespace

int main(int argument_count, char** arguments) {
  std::FILE* file = argument_count == 2 ? std::fopen(arguments[1], "rb") : nullptr;
  if (file == nullptr) {
    std::fputs("usage: marey_read_by_pieces FILE\n", stderr);
    return 2;
  }
  std::fseek(file, 0, SEEK_END);
  marey::StreamOptions stream;
  stream.expected_bytes = std::ftell(file);
  std::rewind(file);
  const std::clock_t begun = std::clock();
  marey::StreamReader reader({}, stream);
  std::vector<char> piece(kPiece);
  while (const std::size_t count = std::fread(piece.data(), 1, piece.size(), file)) {
    if (!reader.feed({piece.data(), count})) break;
  }
  std::fclose(file);
  const marey::Result<marey::BvhClip> clip = reader.finish();
  const double elapsed_s = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
  if (!clip) {
    std::fprintf(stderr, "%s\n", clip.error().message.c_str());
    return 1;
  }
  std::printf("{\"seconds\": %.6f, \"peakBytes\": %lld, \"sampleBytes\": %zu}\n", elapsed_s, peak_bytes(),
              clip->motion.samples().size_bytes());
  return 0;
}
