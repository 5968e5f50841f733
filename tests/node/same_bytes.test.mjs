// Native code, the same code as WebAssembly, and the shipped JavaScript module read the same bits and write the same bytes.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { MareyError, createMarey } from "../../dist/module/marey.js";
import { root, sample, sampleNames, smallClip } from "./support/cli.mjs";

const shared = process.env.MAREY_SHARED_DIR ?? join(root, "../shared");
const nativeProgram = [join(root, "build/native/tests/marey_byte_hashes")];
const wasmProgram = ["node", join(root, "scripts/run_wasm_program.cjs"), join(root, "build/wasm/tests/marey_byte_hashes.cjs")];

/** Texts whose numbers, blanks and repairs are hard, by name. */
const oddTexts = {
  exponents: smallClip({ rows: ["8.88178e-016", "4.9406564584124654e-324", "1.7976931348623157e308"] }),
  digits: smallClip({ rows: ["0.1234567890123456789", "9007199254740993", "123456789.123456789"] }),
  short: smallClip({ rows: [".5", "-0", "+1."] }),
  repaired: smallClip({ frames: "many", rows: ["1", "x", "1e999"] }).replace("OFFSET 0.0 2.0 0.0", "OFFSET [0, 2, 0]"),
  commas: smallClip({ rows: ["1,5", "2,25", "-3,125"] }),
  carriageReturns: smallClip({ end: "\r\n", frameTime: ".0083333" }),
  utf16: Buffer.from(`\ufeff${smallClip({ name: "Рука" })}`, "utf16le"),
  wideBlanks: smallClip().replace("OFFSET 0.0 2.0", "OFFSET\u00a00.0\u30002.0"),
};

function recordedFiles() {
  const index = join(shared, "bvh/INDEX.tsv");
  if (!existsSync(index)) return [];
  const paths = readFileSync(index, "utf8").split("\n").map((line) => line.split("\t")[0]);
  return paths.filter((path) => path.endsWith(".bvh")).map((path) => join(shared, path));
}

/** FNV-1a with 32 bits over several arrays of bytes, and their number, as tests/bytes/byte_hashes.cpp computes it. */
function hashOf(...parts) {
  let hash = 2166136261;
  let size = 0;
  for (const bytes of parts) {
    for (let i = 0; i < bytes.length; i++) hash = Math.imul(hash ^ bytes[i], 16777619);
    size += bytes.length;
  }
  return `${(hash >>> 0).toString(16).padStart(8, "0")}:${size}`;
}

function runProgram([command, ...args], files) {
  const { status, stdout, stderr } = spawnSync(command, [...args, ...files], { encoding: "utf8", maxBuffer: 1 << 26 });
  assert.equal(status, 0, `${command} ${args.join(" ")}: ${stderr}`);
  return stdout.trim().split("\n").map((line) => JSON.parse(line));
}

function describeByModule(marey, file) {
  let clip;
  try {
    clip = marey.parse(readFileSync(file));
  } catch (error) {
    assert.ok(error instanceof MareyError, String(error));
    return { refused: error.code };
  }
  const channels = Array.from({ length: clip.channelCount }, (_, i) => clip.channel(i));
  const result = { samples: hashOf(...channels.map((samples) => new Uint8Array(samples.buffer))), written: hashOf(clip.write()) };
  if (clip.channelCount > 0) {
    const middle = Math.trunc(clip.channelCount / 2);
    clip.setChannel(middle, channels[middle].map((value, i) => (i % 7 === 0 ? value * 0.5 + 1.25 : value)));
  }
  result.edited = hashOf(clip.write());
  clip.dispose();
  return result;
}

describe("the same bytes everywhere", () => {
  let folder;
  let files;
  let native;
  before(() => {
    folder = mkdtempSync(join(tmpdir(), "marey-bytes-"));
    const odd = Object.entries(oddTexts).map(([name, text]) => {
      const path = join(folder, `${name}.bvh`);
      writeFileSync(path, text);
      return path;
    });
    files = [...sampleNames.map(sample), ...odd, ...recordedFiles()];
    native = runProgram(nativeProgram, files);
  });
  after(() => rmSync(folder, { recursive: true, force: true }));

  test("as WebAssembly: samples read, bytes written, written after an edit, and in the clean form", (t) => {
    const wasm = runProgram(wasmProgram, files);
    files.forEach((file, i) => assert.deepEqual(wasm[i], native[i], file));
    t.diagnostic(`${files.length} files compared between native code and WebAssembly`);
  });

  test("from the module: samples read, bytes written, written after an edit", async (t) => {
    const marey = await createMarey();
    files.forEach((file, i) => {
      const { canonical, ...expected } = native[i];
      assert.deepEqual(describeByModule(marey, file), expected, file);
      assert.ok(canonical || expected.refused, file);
    });
    const refused = native.filter((result) => result.refused).length;
    assert.ok(files.length - refused >= sampleNames.length + Object.keys(oddTexts).length);
    t.diagnostic(`${files.length} files compared between native code and the module, ${refused} of them refused by both`);
  });
});
