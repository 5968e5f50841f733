// A file that is too large for WebAssembly is refused by the JavaScript module, which goes on working.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { test } from "node:test";

const program = new URL("../../dist/module/marey.js", import.meta.url);
const skip = !existsSync(program) && "dist/module is not built";

/** A file of one joint with so many channels, whose samples are all 1. */
function fileOfOnes(rows, channels) {
  const head = Buffer.from(["HIERARCHY", "ROOT a", "{", "OFFSET 0 0 0", `CHANNELS ${channels}${" Xrotation".repeat(channels)}`, "}",
    "MOTION", `Frames: ${rows}`, "Frame Time: 0.1", ""].join("\n"));
  const file = Buffer.alloc(head.length + rows * channels * 2);
  file.fill(`${"1 ".repeat(channels - 1)}1\n`, head.length);
  head.copy(file);
  return file;
}

test("samples beyond the memory of WebAssembly are limit_memory", { skip }, async () => {
  const { createMarey } = await import(program);
  const marey = await createMarey();
  assert.throws(() => marey.parse(fileOfOnes(2_500_000, 90)), { name: "MareyError", code: "limit_memory" });
  assert.equal(marey.parse(fileOfOnes(3, 2)).frameCount, 3);
});
