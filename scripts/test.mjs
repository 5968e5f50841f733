// npm test: sets up and runs every test; the last line counts them all.
import { main, say } from "./lib/shell.mjs";
import { setUpTests } from "./setup/index.mjs";
import { tryForSystemPackages } from "./setup/system_packages.mjs";
import {
  hasNativeTarget, runBuild, runNativeProgram, runNodeTests, runNumberTests, runPlaywright, runPreset, runTypeCheck,
} from "./tests/runners.mjs";
import { add, closingLine, noCounts, runStep } from "./tests/step.mjs";

function runBesideMujoco(log) {
  if (!tryForSystemPackages(["mechanics"]) || !hasNativeTarget(log, "marey_mujoco_tests")) {
    say("MuJoCo 2 is not to be had here, so mechanics is not compared with it");
    return { ...noCounts, skipped: 1 };
  }
  return runNativeProgram(log, "marey_mujoco_tests");
}

function runOtherEngines(log) {
  if (!tryForSystemPackages(["engines"])) {
    say("Firefox and WebKit are not to be had here, so the page is not tried in them");
    return { ...noCounts, skipped: 1 };
  }
  const prefix = ["xvfb-run", "-a", "-s", "-screen 0 1400x1000x24"];
  return runNodeTests(log, "tests/engines", { prefix, env: { LIBGL_ALWAYS_SOFTWARE: "1" } });
}

const steps = [
  { name: "native unit tests", body: (log) => runPreset(log, "native", { MAREY_SEQUENCES: "200000" }) },
  { name: "numbers read and written exactly", body: (log) => runNumberTests(log), notes: /compared with/ },
  { name: "mechanics beside MuJoCo", body: runBesideMujoco, notes: /MuJoCo/ },
  { name: "unit tests with sanitizers", body: (log) => runPreset(log, "sanitize") },
  { name: "unit tests as wasm in Node", body: (log) => runPreset(log, "wasm") },
  { name: "types of the page", body: runTypeCheck },
  { name: "build of the site", body: runBuild },
  { name: "command line and module in Node", body: (log) => runNodeTests(log, "tests/node"), notes: /^# .*compared/ },
  { name: "page in Chromium", body: (log) => runPlaywright(log, "tests/browser"), notes: /retry #/ },
  { name: "page in Firefox and WebKit", body: runOtherEngines },
  { name: "gates", body: (log) => runNodeTests(log, "tests/gates"), notes: /^# .* checked$/ },
];

await main(async () => {
  await setUpTests();
  let total = noCounts;
  for (const step of steps) total = add(total, await runStep(step));
  console.log(`\n${closingLine(total)}`);
  if (total.failed > 0) process.exitCode = 1;
});
