// The command line as tests call it: build/native/marey, or the program that MAREY_CLI names.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

export const root = fileURLToPath(new URL("../../../", import.meta.url));
export const program = process.env.MAREY_CLI ?? join(root, "build/native/marey");
const samples = join(root, "web/samples");
export const sample = (name) => join(samples, `${name}.bvh`);
export const sampleNames = readdirSync(samples).filter((name) => name.endsWith(".bvh")).map((name) => name.slice(0, -4));
export const swing = sample("giant-swing");
export const text = (name) => readFileSync(sample(name), "utf8");

export function run(args, input = "") {
  const { status, stdout, stderr } = spawnSync(program, args, { input, encoding: "latin1", maxBuffer: 1 << 28 });
  return { status, stdout, stderr };
}

export function succeed(args, input) {
  const result = run(args, input);
  assert.deepEqual({ status: result.status, stderr: result.stderr }, { status: 0, stderr: "" }, args.join(" "));
  return result.stdout;
}

/** Runs what must fail as wrong input or usage, with one line on standard error. */
export function refused(args, pattern, input) {
  const { status, stdout, stderr } = run(args, input);
  assert.equal(status, 2, `${args.join(" ")}: ${stderr}`);
  assert.equal(stdout, "");
  assert.match(stderr, /^[^\n]+\n$/, "one line");
  assert.match(stderr, pattern);
}

/** A file of one joint; the parts can be replaced. */
export const smallClip = ({ name = "Hips", frames = 3, frameTime = "0.1", rows = ["1", "2", "3"], end = "\n" } = {}) => [
  "HIERARCHY", `ROOT ${name}`, "{", "  OFFSET 0.0 0.0 0.0", "  CHANNELS 1 Zrotation", "  End Site", "  {",
  "    OFFSET 0.0 2.0 0.0", "  }", "}", "MOTION", `Frames: ${frames}`, `Frame Time: ${frameTime}`, ...rows, "",
].join(end);

/** A repaired file: its frame count is wrong. */
export const repairable = smallClip({ frames: 2 });
