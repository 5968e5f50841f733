// Each kind of test: how it is started, and how its own report is counted.
import { existsSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { join } from "node:path";
import { Failure, capture, inRoot } from "../lib/shell.mjs";
import { add, noCounts } from "./step.mjs";

const onePassed = { ...noCounts, passed: 1 };

function readJson(path) {
  return JSON.parse(readFileSync(path, "utf8"));
}

function countGoogleTests({ tests, failures, errors = 0, testsuites }) {
  const all = testsuites.flatMap((suite) => suite.testsuite);
  const skipped = all.filter((test) => test.result === "SKIPPED" || test.status === "NOTRUN").length;
  const failed = failures + errors;
  return { passed: tests - failed - skipped, failed, skipped };
}

/** Builds everything of a CMake preset and runs its GoogleTest programs, with what `env` sets for them. */
export function runPreset(log, preset, env = {}) {
  log.must("cmake", ["--preset", preset]);
  log.must("cmake", ["--build", "--preset", preset]);
  const reports = inRoot("build", preset, "reports");
  rmSync(reports, { recursive: true, force: true });
  const ok = log.run("ctest", ["--preset", preset], { env: { ...process.env, ...env } });
  const names = existsSync(reports) ? readdirSync(reports) : [];
  const counts = names.map((name) => countGoogleTests(readJson(join(reports, name)))).reduce(add, noCounts);
  return ok || counts.failed > 0 ? counts : { ...counts, failed: 1 };
}

/** Whether the native build has a target, which it leaves out where a library is missing. */
export function hasNativeTarget(log, name) {
  log.must("cmake", ["--preset", "native"]);
  const targets = capture("cmake", ["--build", "--preset", "native", "--target", "help"]).stdout;
  return new RegExp(`^${name}:`, "m").test(targets);
}

/** Builds a native GoogleTest program that CTest does not run, and runs it, with what `env` sets for it. */
export function runNativeProgram(log, name, env = {}) {
  log.must("cmake", ["--preset", "native"]);
  log.must("cmake", ["--build", "--preset", "native", "--target", name]);
  const report = inRoot("build", "native", "reports", `${name}.json`);
  rmSync(report, { force: true });
  const program = inRoot("build", "native", "tests", name);
  const ok = log.run(program, [`--gtest_output=json:${report}`], { env: { ...process.env, ...env } });
  if (!existsSync(report)) throw new Failure(`${name} left no report`);
  const counts = countGoogleTests(readJson(report));
  return ok || counts.failed > 0 ? counts : { ...counts, failed: 1 };
}

/** Runs the native comparison of millions of numbers; `cases` is how many, the program's own choice if not given. */
export function runNumberTests(log, cases) {
  return runNativeProgram(log, "marey_number_tests", cases === undefined ? {} : { MAREY_NUMBER_CASES: String(cases) });
}

/** Runs test files of Node's own runner. */
export function runNodeTests(log, folder, { prefix = [], env = {} } = {}) {
  const files = existsSync(inRoot(folder)) ? readdirSync(inRoot(folder)).filter((name) => name.endsWith(".test.mjs")) : [];
  if (files.length === 0) throw new Failure(`${folder} holds no *.test.mjs`);
  const command = [...prefix, "node", "--test", "--test-reporter=tap", ...files.map((name) => join(folder, name))];
  const ok = log.run(command[0], command.slice(1), { env: { ...process.env, ...env } });
  const text = log.text();
  const count = (word) => Number(text.match(new RegExp(`^# ${word} (\\d+)$`, "m"))?.[1] ?? 0);
  const failed = count("fail") + count("cancelled");
  return { passed: count("pass"), failed: ok ? failed : Math.max(failed, 1), skipped: count("skipped") };
}

/** Checks the types of the page's TypeScript. */
export function runTypeCheck(log) {
  log.must("node", ["node_modules/typescript/bin/tsc", "--noEmit"]);
  return onePassed;
}

/** Builds the site, of which the browser tests are made. */
export function runBuild(log) {
  log.must("node", ["scripts/build.mjs"]);
  return onePassed;
}

/** Runs the Playwright tests of a folder in the system's Chromium. */
export function runPlaywright(log, folder) {
  if (!existsSync(inRoot(folder))) throw new Failure(`there is no ${folder}`);
  const report = inRoot("build", "reports", "browser.json");
  rmSync(report, { force: true });
  const env = { ...process.env, PLAYWRIGHT_JSON_OUTPUT_NAME: report, PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD: "1" };
  const ok = log.run("node", ["node_modules/@playwright/test/cli.js", "test", "--config", folder, "--reporter=list,json"], { env });
  if (!existsSync(report)) throw new Failure("Playwright left no report");
  const { expected, unexpected, flaky, skipped } = readJson(report).stats;
  return { passed: expected + flaky, failed: ok ? unexpected : Math.max(unexpected, 1), skipped };
}
