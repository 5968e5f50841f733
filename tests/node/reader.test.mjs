// The module reads a file that comes by pieces: the clip is the one of the whole, memory is that of the samples.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { test } from "node:test";

const program = new URL("../../dist/module/marey.js", import.meta.url);
const skip = !existsSync(program) && "dist/module is not built";
const createMarey = async () => (await import(program)).createMarey();

/** A chain of joints with three rotations each; numbers with six decimals, as most programs write them. */
function longClip(joints, rows) {
  const blocks = Array.from({ length: joints }, (_, i) =>
    `${i === 0 ? "ROOT" : "JOINT"} j${i}\n{\nOFFSET 0 1 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n`);
  const row = Array.from({ length: 3 * joints }, (_, i) => (i * 1.234567 - 90).toFixed(6)).join(" ");
  return `HIERARCHY\n${blocks.join("")}${"}\n".repeat(joints)}MOTION\nFrames: ${rows}\nFrame Time: 0.01\n${`${row}\n`.repeat(rows)}`;
}

test("pieces of any size give the clip of the whole", { skip }, async () => {
  const marey = await createMarey();
  const bytes = readFileSync(new URL("../../web/samples/walk.bvh", import.meta.url));
  const whole = marey.parse(bytes);
  for (const size of [1, 77, 4096, bytes.length]) {
    const reader = marey.reader({ expectedBytes: bytes.length });
    for (let at = 0; at < bytes.length; at += size) assert.ok(reader.feed(bytes.subarray(at, at + size)));
    const clip = reader.finish();
    assert.deepEqual([...clip.channel(3)], [...whole.channel(3)]);
    assert.deepEqual(clip.diagnostics, whole.diagnostics);
    assert.deepEqual(clip.write(), new Uint8Array(bytes));
    clip.dispose();
    assert.throws(() => reader.feed("x"), { code: "invalid_argument" });
  }
});

test("frames are there while the file comes", { skip }, async () => {
  const marey = await createMarey();
  const text = longClip(10, 5000);
  const reader = marey.reader({ expectedBytes: text.length });
  assert.equal(reader.clipSoFar(), undefined);
  reader.feed(text.slice(0, text.length / 2));
  assert.ok(reader.frameCount > 2000 && reader.frameCount < 2600, `${reader.frameCount}`);
  const first = reader.clipSoFar(10);
  assert.equal(first.frameCount, 10);
  assert.ok(Math.abs(first.channel(0)[9] + 90) < 1e-12);
  first.dispose();
  reader.feed(text.slice(text.length / 2));
  assert.equal(reader.finish().frameCount, 5000);
});

test("a file that cannot be read says so, and a reader can be given up", { skip }, async () => {
  const marey = await createMarey();
  const reader = marey.reader();
  reader.feed("no BVH");
  assert.throws(() => reader.finish(), { name: "MareyError", code: "not_bvh" });
  const other = marey.reader();
  other.feed(longClip(3, 100));
  other.cancel();
  other.cancel();
  assert.throws(() => other.finish(), { code: "invalid_argument" });
});

test("limits are options; the sentence names limit and value", { skip }, async () => {
  const marey = await createMarey();
  const text = longClip(3, 100);
  assert.throws(() => marey.parse(text, { limits: { frames: 50 } }), { code: "limit_frames", message: /50 frames/ });
  assert.throws(() => marey.parse(text, { limits: { joints: 2 } }), { code: "limit_joints", message: /\b2\b/ });
  assert.throws(() => marey.parse(text, { limits: { frames: -1 } }), { code: "invalid_argument" });
  assert.throws(() => marey.parse(text, { limits: { toes: 10 } }), { code: "invalid_argument", message: /toes/ });
  assert.equal(marey.parse(text).frameCount, 100);
});
