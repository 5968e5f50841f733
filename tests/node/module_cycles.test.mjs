// A thousand clips, opened and disposed of, leave the module's memory where it was; and a call without memory for it leaves it
// usable.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { test } from "node:test";
import { repairable, sampleNames, smallClip, text } from "./support/cli.mjs";

const program = new URL("../../dist/module/marey.js", import.meta.url);
const skip = !existsSync(program) && "dist/module is not built";

function use(marey, file) {
  const clip = marey.parse(file);
  clip.setChannel(0, clip.channel(0).map((value) => value + 1));
  clip.worldPositions();
  clip.write({ decimals: 2 });
  const table = clip.writeTable("channels");
  if (clip.frameCount > 1) marey.parseTable(table, { figure: clip }).dispose();
  clip.writeFor("blender");
  clip.dispose();
}

test("1000 clips leave the memory as it was", { skip }, async (t) => {
  const { createMarey } = await import(program);
  const marey = await createMarey();
  const files = [smallClip(), repairable, text(sampleNames[0]), smallClip({ name: "Бедро" })];
  const refused = ["", "no BVH file", smallClip().replace("MOTION", "MOVEMENT")];
  const cycle = (i) => {
    use(marey, files[i % files.length]);
    assert.throws(() => marey.parse(refused[i % refused.length], { strict: true }), { name: "MareyError" });
  };
  for (let i = 0; i < 48; i++) cycle(i);
  const before = marey.memory();
  for (let i = 0; i < 996; i++) cycle(i);
  t.diagnostic(`${JSON.stringify(before)} before, ${JSON.stringify(marey.memory())} after`);
  assert.deepEqual(marey.memory(), before);
});

test("a call without memory for it is out_of_memory, and the clip goes on", { skip }, async () => {
  const { createMarey } = await import(program);
  const marey = await createMarey();
  const clip = marey.parse(smallClip({ frames: 300_000, rows: Array.from({ length: 300_000 }, (_, i) => `${i % 360}`) }));
  const { used } = marey.memory();
  const { grow } = WebAssembly.Memory.prototype;
  WebAssembly.Memory.prototype.grow = () => {
    throw new RangeError("no more memory, for a test");
  };
  const others = [];
  try {
    assert.throws(() => {
      for (let i = 0; i < 100; i++) others.push(marey.parse(clip.write()));
    }, { name: "MareyError", code: /^(out_of_memory|limit_memory)$/ });
    assert.throws(() => clip.writeTable("positions") && clip.worldPositions() && clip.writeFor("blender"), { name: "MareyError", code: "out_of_memory" });
    for (const other of others) other.dispose();
    assert.equal(clip.channel(0)[359], 359);
  } finally {
    WebAssembly.Memory.prototype.grow = grow;
  }
  assert.equal(clip.worldPositions().length, 300_000 * clip.nodeCount * 3);
  clip.dispose();
  assert.ok(marey.memory().used < used);
});
