// Runs every gate over the repository's files, and over a copy of the list with one seeded fault to see that it bites.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import * as diagnostics from "./diagnostics.mjs";
import * as foreignNames from "./foreign_names.mjs";
import * as layering from "./layering.mjs";
import * as limits from "./limits.mjs";
import * as pureCore from "./pure_core.mjs";
import * as readmeCommands from "./readme_commands.mjs";
import * as sizes from "./sizes.mjs";
import * as webImports from "./web_imports.mjs";

const root = fileURLToPath(new URL("../../", import.meta.url));

function readRepository() {
  const list = execFileSync("git", ["ls-files", "-z", "--cached", "--others", "--exclude-standard"], { cwd: root, encoding: "utf8" });
  const paths = list.split("\0").filter((path) => path && existsSync(join(root, path)));
  const files = paths.map((path) => ({ path, text: readFileSync(join(root, path), "utf8") }));
  return files.filter(({ text }) => !text.includes("\0"));
}

const files = readRepository();
for (const gate of [layering, webImports, pureCore, sizes, readmeCommands, diagnostics, limits, foreignNames]) {
  test(gate.name, (t) => {
    const { checked, problems } = gate.check(files);
    t.diagnostic(`${gate.name}: ${checked} ${gate.unit} checked`);
    assert.ok(checked > 0, "nothing was checked");
    assert.equal(problems.length, 0, `\n${problems.join("\n")}`);
  });
  for (const seed of gate.seeds) {
    test(`${gate.name}: a seeded fault in ${seed.path} is found`, () => assert.equal(gate.check([seed]).problems.length, 1));
  }
}
