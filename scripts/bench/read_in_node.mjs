// Reads a file piece by piece with the module under Node and prints, as JSON, what that took: node read_in_node.mjs CLIP.
import { closeSync, fstatSync, openSync, readSync } from "node:fs";
import { createMarey } from "../../dist/module/marey.js";

const { Memory } = WebAssembly;
let memory;
// The program's memory is not exported by the module; it is found where the program is made.
const instantiate = WebAssembly.instantiate;
WebAssembly.instantiate = async (...given) => {
  const result = await instantiate(...given);
  const { exports } = result.instance ?? result;
  memory = Object.values(exports).find((value) => value instanceof Memory);
  return result;
};

const marey = await createMarey();
const file = openSync(process.argv[2], "r");
const piece = new Uint8Array(256 * 1024);
const begun = process.cpuUsage();
const reader = marey.reader({ expectedBytes: fstatSync(file).size });
for (let count; (count = readSync(file, piece)) > 0;) {
  if (!reader.feed(piece.subarray(0, count))) break;
}
closeSync(file);
const clip = reader.finish();
const { user, system } = process.cpuUsage(begun);
console.log(JSON.stringify({
  seconds: (user + system) / 1e6, peakBytes: memory?.buffer.byteLength ?? 0, sampleBytes: clip.channelCount * clip.frameCount * 8,
}));
