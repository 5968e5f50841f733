// Samples of a figure of 20 joints over 10,000 frames to the torques of all joints. Items are joints x frames.
#include <benchmark/benchmark.h>

#include "core/biomechanics/analysis.h"
#include "core/biomechanics/chosen_body.h"
#include "core/document/document.h"
#include "tests/bench/bench_clip.h"

namespace marey {
namespace {

void torques(benchmark::State& state) {
  Clip clip = make_clip(bench::body_clip());
  clip.body.table = BodyTable::Rods;
  AnalysisRequest request;
  request.quantities = {"torque:*"};
  request.model = find_chosen_body(clip)->body.model;
  request.support = SupportKind::Flight;
  for (auto _ : state) benchmark::DoNotOptimize(analyse(clip, request));
  state.SetItemsProcessed(state.iterations() * clip.motion.frame_count() * clip.skeleton.joint_count());
}

BENCHMARK(torques)->Name("mechanics/torques")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace marey
