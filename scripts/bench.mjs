// npm run bench: builds and runs the benchmarks, and prints them as a table.
import { buildPreset, configurePreset, hasTarget } from "./build/cmake.mjs";
import { Failure, capture, inRoot, main, say } from "./lib/shell.mjs";
import { setUpBench } from "./setup/index.mjs";

const perSecond = (rate, unit) => {
  if (rate === undefined) return "";
  const scale = [[1e9, "G"], [1e6, "M"], [1e3, "k"]].find(([size]) => rate >= size) ?? [1, ""];
  return `${(rate / scale[0]).toFixed(1)} ${scale[1]}${unit}/s`;
};

function toRow(benchmark) {
  const time = `${benchmark.cpu_time.toPrecision(4)} ${benchmark.time_unit}`;
  return [benchmark.name, time, perSecond(benchmark.items_per_second, " items"), perSecond(benchmark.bytes_per_second, "B")];
}

function printTable(rows) {
  const widths = rows[0].map((_, column) => Math.max(...rows.map((row) => row[column].length)));
  for (const row of rows) {
    console.log(row.map((cell, column) => (column === 0 ? cell.padEnd(widths[0]) : cell.padStart(widths[column]))).join("  "));
  }
}

await main(() => {
  setUpBench();
  configurePreset("native");
  if (!hasTarget("native", "marey_bench")) return say("there are no benchmarks in tests/bench");
  buildPreset("native", ["marey_bench"]);
  const args = ["--benchmark_format=json", ...process.argv.slice(2)];
  const { ok, stdout, stderr } = capture(inRoot("build", "native", "tests", "marey_bench"), args);
  if (!ok) throw new Failure(`marey_bench failed: ${stderr.trim().split("\n").at(-1)}`);
  const { context, benchmarks } = JSON.parse(stdout);
  say(`${context.num_cpus} cores at ${context.mhz_per_cpu} MHz, one thread, CPU time`);
  printTable([["benchmark", "time", "items", "bytes"], ...benchmarks.map(toRow)]);
});
