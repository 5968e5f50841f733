// The benchmarks of tests/bench: medians of repetitions in shuffled order.
import { Failure, capture, inRoot } from "../lib/shell.mjs";
import { bodyClip } from "./clip.mjs";

const repetitions = ["--benchmark_repetitions=5", "--benchmark_enable_random_interleaving=true", "--benchmark_min_time=0.3",
  "--benchmark_report_aggregates_only=true", "--benchmark_format=json"];
const milliseconds = { ns: 1e-6, us: 1e-3, ms: 1, s: 1e3 };

const perSecond = (rate, unit) => {
  if (rate === undefined) return "";
  const scale = [[1e9, "G"], [1e6, "M"], [1e3, "k"]].find(([size]) => rate >= size) ?? [1, ""];
  return `${(rate / scale[0]).toFixed(1)} ${scale[1]}${unit}/s`;
};

/** { times: median milliseconds of processor time by benchmark, rows: the same as a table }. */
export function measureNatively(clip, args = []) {
  const program = inRoot("build", "native", "tests", "marey_bench");
  const { ok, stdout, stderr } = capture("env", [`MAREY_BENCH_CLIP=${clip}`, `MAREY_BENCH_BODY=${bodyClip()}`, program, ...repetitions, ...args]);
  if (!ok) throw new Failure(`marey_bench failed: ${stderr.trim().split("\n").at(-1)}`);
  const medians = JSON.parse(stdout).benchmarks.filter(({ aggregate_name: name }) => name === "median");
  return {
    times: Object.fromEntries(medians.map((found) => [found.run_name, found.cpu_time * milliseconds[found.time_unit]])),
    rows: medians.map((found) => [found.run_name, `${found.cpu_time.toPrecision(4)} ${found.time_unit}`,
      perSecond(found.items_per_second, " joint-frames"), perSecond(found.bytes_per_second, "B")]),
  };
}
