// Reading a clip beside the bare scan of its numbers, and writing it beside a loop of fprintf.
#include <benchmark/benchmark.h>
#include <fast_float/fast_float.h>

#include <cstdio>
#include <vector>

#include "core/bvh/stream_reader.h"
#include "core/bvh/writer.h"
#include "tests/bench/bench_clip.h"

namespace marey {
namespace {

void count_bytes(benchmark::State& state, std::size_t bytes) {
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(bytes));
}

// By pieces, as the command line, the page and the module read.
void marey_read(benchmark::State& state) {
  const std::string& text = bench::clip_text();
  for (auto _ : state) {
    StreamReader reader({}, {.expected_bytes = static_cast<std::int64_t>(text.size())});
    reader.feed(text);
    const Result<BvhClip> clip = reader.finish();
    benchmark::DoNotOptimize(clip->motion.samples().data());
  }
  count_bytes(state, text.size());
}

// Nothing but the numbers of the rows, in the order of the file, into memory that is there already.
void fast_float_scan(benchmark::State& state) {
  const std::string& text = bench::clip_text();
  const std::size_t rows = text.find('\n', text.find("Frame Time:")) + 1;
  std::vector<double> samples(bench::clip().motion.samples().size());
  for (auto _ : state) {
    const char* p = text.data() + rows;
    const char* end = text.data() + text.size();
    for (double& sample : samples) {
      while (p != end && (*p == ' ' || *p == '\n')) ++p;
      p = fast_float::from_chars(p, end, sample).ptr;
    }
    benchmark::DoNotOptimize(samples.data());
  }
  count_bytes(state, text.size());
}

void marey_write(benchmark::State& state) {
  const BvhClip& clip = bench::clip();
  for (auto _ : state) benchmark::DoNotOptimize(write_bvh(clip.skeleton, clip.motion, clip.style));
  count_bytes(state, bench::clip_text().size());
}

// As a first program would: a number at a time. The device swallows the text, so only the making of it is timed.
void fprintf_loop(benchmark::State& state) {
  const Motion& motion = bench::clip().motion;
  std::FILE* out = std::fopen("/dev/null", "w");
  for (auto _ : state) {
    for (FrameIndex frame = 0; frame < motion.frame_count(); ++frame) {
      for (ChannelIndex channel = 0; channel < motion.channel_count(); ++channel) {
        std::fprintf(out, "%f ", motion.sample(channel, frame));
      }
      std::fputc('\n', out);
    }
  }
  std::fclose(out);
  count_bytes(state, bench::clip_text().size());
}

BENCHMARK(marey_read)->Name("read/marey")->Unit(benchmark::kMillisecond);
BENCHMARK(fast_float_scan)->Name("read/fast_float_scan")->Unit(benchmark::kMillisecond);
BENCHMARK(marey_write)->Name("write/marey")->Unit(benchmark::kMillisecond);
BENCHMARK(fprintf_loop)->Name("write/fprintf")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace marey
