// Damaged files: native code and WebAssembly do no harm, and come to the same verdicts about each of some 20 000 texts.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { root } from "./support/cli.mjs";

const programs = {
  native: [join(root, "build/native/tests/marey_damage_tests")],
  WebAssembly: ["node", join(root, "scripts/run_wasm_program.cjs"), join(root, "build/wasm/tests/marey_damage_tests.cjs")],
};

/** The verdicts that the program's tests recorded, by name; those that record none only have to pass. */
function runProgram(name, folder) {
  const report = join(folder, `${name}.json`);
  const [command, ...args] = programs[name];
  const { status, stdout, stderr } = spawnSync(command, [...args, `--gtest_output=json:${report}`], { encoding: "utf8" });
  assert.equal(status, 0, `${name}: ${stdout}${stderr}`);
  const tests = JSON.parse(readFileSync(report, "utf8")).testsuites.flatMap((suite) => suite.testsuite).filter(({ verdict }) => verdict);
  return new Map(tests.map((result) => [`${result.classname}.${result.name}`, result.verdict]));
}

test("damaged files get the same verdicts native and as WebAssembly", (t) => {
  const folder = mkdtempSync(join(tmpdir(), "marey-damage-"));
  t.after(() => rmSync(folder, { recursive: true, force: true }));
  const native = runProgram("native", folder);
  const wasm = runProgram("WebAssembly", folder);
  assert.ok(native.size >= 15);
  let texts = 0;
  for (const [name, verdict] of native) {
    assert.match(verdict, /^[0-9a-f]{16} of \d+ texts$/, name);
    assert.equal(wasm.get(name), verdict, name);
    texts += Number(verdict.split(" ")[2]);
  }
  t.diagnostic(`${texts} damaged texts compared between native code and WebAssembly`);
});
