// The declarations that are shipped with the JavaScript module compile in somebody else's strict project.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../../", import.meta.url));
const folder = join(root, "build", "module_types");

const user = `
import { createMarey, MareyError, type Clip, type Diagnostic, type Exported, type Joint, type Marey } from "../../dist/module/marey.js";
const marey: Marey = await createMarey();
const clip: Clip = marey.parse(new Uint8Array(), { strict: false });
const joints: readonly Joint[] = clip.joints;
const end: readonly [number, number, number] | undefined = joints[0]?.endSite;
const diagnostics: readonly Diagnostic[] = clip.diagnostics;
const numbers: [number, number] = [clip.frameCount, clip.frameTime];
const samples: Float64Array = clip.channel(0);
clip.setChannel(0, samples);
const positions: Float32Array = clip.worldPositions(0, 1);
const bytes: Uint8Array = clip.write();
const table: Uint8Array = clip.writeTable("positions", { lengthUnit: "cm", first: 0, count: 1 });
const { changes, largestMove }: Exported = clip.writeFor("blender", { referencePose: false });
const again: Clip = marey.parseTable(table, { figure: clip });
clip.dispose();
try { marey.parse("", {}); } catch (error) { if (error instanceof MareyError) console.log(error.code, error.line, error.column); }
console.log(end, diagnostics, numbers, positions, bytes, changes, largestMove, again);
`;

function compile(text) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, "user.mts"), text);
  const options = ["--noEmit", "--strict", "--module", "nodenext", "--target", "es2022", "--types", "node", join(folder, "user.mts")];
  execFileSync("node", [join(root, "node_modules/typescript/bin/tsc"), ...options], { cwd: root, encoding: "utf8" });
}

test("the module's declarations say what it gives", () => compile(user));

test("a wrong use does not compile", () => {
  assert.throws(() => compile(`${user}\nconst wrong: string = clip.frameCount;\n`), ({ stdout }) => stdout.includes("'number' is not assignable"));
});
