// Names in character sets other than UTF-8, on the command line and in the JavaScript module.
import assert from "node:assert/strict";
import { before, describe, test } from "node:test";
import { createMarey } from "../../dist/module/marey.js";
import { refused, run, smallClip } from "./support/cli.mjs";

// How programs of a country save the name, found by encoding every letter with what TextDecoder makes of its bytes.
function bytesIn(set, name) {
  if (set === "utf-8") return Buffer.from(name);
  const decoder = new TextDecoder(set);
  const codes = new Map();
  for (let code = 0; code < 0x10000; code++) {
    const bytes = code < 0x100 ? [code] : [code >> 8, code & 0xff];
    const letter = decoder.decode(Uint8Array.from(bytes));
    if ([...letter].length === 1 && !codes.has(letter)) codes.set(letter, bytes);
  }
  return Buffer.from([...name].flatMap((letter) => codes.get(letter)));
}

const names = [
  ["windows-1251", "Голова"], ["windows-1252", "Rückenwirbel"], ["gbk", "左上臂"], ["shift_jis", "左ひじボーン"], ["utf-8", "Колено 膝"],
].map(([set, name]) => ({ set, name, bytes: bytesIn(set, name) }));

const fileWith = (bytes, options = {}) => {
  const [front, end] = smallClip({ name: "\0", ...options }).split("\0");
  return Buffer.concat([Buffer.from(front), bytes, Buffer.from(end)]);
};
const text = (latin1) => Buffer.from(latin1, "latin1").toString();

describe("the command line", () => {
  for (const { set, name, bytes } of names) {
    test(`shows ${name} in ${set} and writes its bytes back`, () => {
      const file = fileWith(bytes);
      const info = JSON.parse(text(run(["info", "-", "--json"], file).stdout));
      assert.equal(info.joints[0].name, name);
      assert.equal(info.names_in, set);
      assert.deepEqual(info.diagnostics.map(({ code }) => code), set === "utf-8" ? [] : ["names_not_utf8"]);
      assert.match(text(run(["info", "-"], file).stdout), new RegExp(`^  ${name} Zrotation$`, "m"));
      assert.match(text(run(["fk", "-"], file).stdout), new RegExp(`^frame,time,${name}\\.x,`));
      assert.match(text(run(["convert", "-", "-", "--to", "csv"], file).stdout), new RegExp(`^frame,time,${name}\\.Zrotation\n`));
      assert.match(text(run(["check", "-"], file).stderr), new RegExp(`'${name}'`));
      assert.equal(run(["fmt", "-"], file).stdout, file.toString("latin1"));
      // The header is printed anew because of the stray word.
      const stray = Buffer.from(file.toString("latin1").replace("MOTION", "stray\nMOTION"), "latin1");
      assert.equal(run(["fmt", "-"], stray).stdout, file.toString("latin1"));
    });
  }

  test("reads names in the set that is asked for", () => {
    const file = fileWith(names[0].bytes);
    const info = JSON.parse(text(run(["info", "-", "--json", "--names-in", "windows-1252"], file).stdout));
    assert.equal(info.joints[0].name, "Ãîëîâà");
    assert.deepEqual(info.diagnostics, []);
    refused(["info", "-", "--names-in", "latin-1"], /names-in/, file);
  });

  test("quotes names in findings as letters", () => {
    const { stderr } = run(["info", "-"], fileWith(names[0].bytes, { end: "\n" }).toString("latin1").replace("  CHANNELS 1 Zrotation\n", ""));
    assert.match(text(stderr), /'Голова' has no CHANNELS line/);
  });
});

describe("the module", () => {
  let marey;
  before(async () => {
    marey = await createMarey();
  });

  for (const { set, name, bytes } of names) {
    test(`shows ${name} in ${set} and writes its bytes back`, () => {
      const file = fileWith(bytes);
      const clip = marey.parse(file);
      assert.equal(clip.joints[0].name, name);
      assert.equal(clip.namesIn, set);
      clip.setChannel(0, [1, 2, 4]);
      assert.equal(Buffer.from(clip.write()).toString("latin1"), fileWith(bytes, { rows: ["1", "2", "4"] }).toString("latin1"));
      clip.dispose();
    });

    test(`reads names in ${set} when asked to`, () => {
      const clip = marey.parse(fileWith(bytes), { namesIn: set });
      assert.equal(clip.joints[0].name, name);
      assert.equal(clip.namesIn, set);
      clip.dispose();
    });
  }

  test("knows no other sets", () => {
    assert.throws(() => marey.parse(fileWith(names[0].bytes), { namesIn: "latin-1" }), { code: "invalid_argument" });
  });
});
