// npm run fuzz -- [MINUTES] [TARGET]: feeds the core with what nobody would write, for MINUTES (1 if not given) per target of
// tests/fuzz. What it learns stays in build/fuzz/corpus, findings in build/fuzz/findings, totals in build/fuzz/log.tsv.
import { spawnSync } from "node:child_process";
import { appendFileSync, existsSync, mkdirSync, readdirSync } from "node:fs";
import { buildPreset, configurePreset } from "./build/cmake.mjs";
import { Failure, capture, inRoot, main, say } from "./lib/shell.mjs";
import { setUpFuzz } from "./setup/index.mjs";

const targets = readdirSync(inRoot("tests/fuzz/corpus")).sort();
const inBuild = (...parts) => inRoot("build", "fuzz", ...parts);
const mostFindings = 20;
const columns = ["target", "cpu_s", "executions", "executions_per_s", "cov", "ft", "findings", "commit"];

function readArguments([minutes = "1", target]) {
  if (!(Number(minutes) > 0)) throw new Failure(`"${minutes}" is no number of minutes`);
  if (target && !targets.includes(target)) throw new Failure(`there is no target "${target}", but ${targets.join(", ")}`);
  return { seconds: Math.max(1, Math.round(minutes * 60)), chosen: target ? [target] : targets };
}

function libFuzzerArguments(target, seconds) {
  return [`-max_total_time=${seconds}`, "-max_len=4096", "-timeout=60", "-rss_limit_mb=2000", "-print_final_stats=1", "-entropic=0",
    `-dict=${inRoot("tests/fuzz/bvh.dict")}`, `-artifact_prefix=${inBuild("findings", `${target}-`)}`,
    inBuild("corpus", target), inRoot("tests/fuzz/corpus", target)];
}

/** "0m1.50s 0m0.25s", as `times` prints it, in seconds. */
function secondsOf(times) {
  return [...times.matchAll(/(\d+)m([\d.]+)s/g)].reduce((sum, [, minutes, seconds]) => sum + 60 * minutes + Number(seconds), 0);
}

/** Runs a target until its time is over or it finds something; `times` of the shell tells what it cost. */
function runOnce(target, seconds) {
  const script = 'nice -n 19 "$@"; status=$?; times; exit $status';
  const program = inBuild("tests/fuzz", `marey_fuzz_${target}`);
  const args = ["-c", script, "sh", program, ...libFuzzerArguments(target, seconds)];
  const { status, stdout, stderr } = spawnSync("sh", args, { cwd: inBuild(), encoding: "utf8", maxBuffer: 1 << 28 });
  const last = (pattern) => Number([...stderr.matchAll(pattern)].at(-1)?.[1] ?? 0);
  if (status !== 0) console.log(stderr.split("\n").filter((line) => /HARM:|ERROR:|runtime error:|Test unit written/.test(line)).join("\n"));
  return {
    failed: status !== 0,
    cpu: secondsOf(stdout.trim().split("\n").at(-1)),
    executions: last(/stat::number_of_executed_units:\s*(\d+)/g),
    cov: last(/ cov: (\d+)/g),
    ft: last(/ ft: (\d+)/g),
  };
}

/** Goes on behind a finding, as far as the time and `mostFindings` allow. */
function fuzz(target, seconds) {
  const end = Date.now() + 1000 * seconds;
  const total = { cpu: 0, executions: 0, cov: 0, ft: 0, findings: 0 };
  do {
    const left = Math.max(1, Math.round((end - Date.now()) / 1000));
    const part = runOnce(target, left);
    total.cpu += part.cpu;
    total.executions += part.executions;
    total.cov = Math.max(total.cov, part.cov);
    total.ft = Math.max(total.ft, part.ft);
    total.findings += part.failed ? 1 : 0;
  } while (Date.now() < end && total.findings > 0 && total.findings < mostFindings);
  return total;
}

function note(target, { cpu, executions, cov, ft, findings }) {
  const commit = capture("git", ["rev-parse", "--short", "HEAD"]).stdout.trim() || "unknown";
  const cells = [target, cpu.toFixed(1), executions, Math.round(executions / Math.max(cpu, 0.1)), cov, ft, findings, commit];
  const log = inBuild("log.tsv");
  if (!existsSync(log)) appendFileSync(log, `${columns.join("\t")}\n`);
  appendFileSync(log, `${cells.join("\t")}\n`);
  say(columns.map((name, i) => `${name} ${cells[i]}`).join(", "));
}

await main(() => {
  const { seconds, chosen } = readArguments(process.argv.slice(2));
  setUpFuzz();
  configurePreset("fuzz");
  buildPreset("fuzz", chosen.map((target) => `marey_fuzz_${target}`));
  mkdirSync(inBuild("findings"), { recursive: true });
  let findings = 0;
  for (const target of chosen) {
    mkdirSync(inBuild("corpus", target), { recursive: true });
    const total = fuzz(target, seconds);
    note(target, total);
    findings += total.findings;
  }
  if (findings > 0) throw new Failure(`${findings} findings, see build/fuzz/findings`);
});
