// Names in scripts that the page's own faces lack.
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { armClip } from "./support/clips.mjs";
import { expect, siteFolder, test } from "./support/fixtures.mjs";

const farEastern = armClip(2).replace("Shoulder", "右肩").replace("Elbow", "팔꿈치");

/** Paths of files of letters that the page asks for. */
function watchLetters(page) {
  const paths = [];
  page.on("response", (response) => {
    const { pathname } = new URL(response.url());
    if (pathname.startsWith("/letters/")) paths.push(`${response.status()} ${pathname}`);
  });
  return paths;
}

test("letters of a far eastern name come from the page's own folder, and only once they are shown", async ({ marey, page }) => {
  const paths = watchLetters(page);
  await marey.goto();
  await marey.open("plain.bvh", armClip(2));
  await marey.drawn(3);
  expect(paths).toEqual([]);
  await marey.open("names.bvh", farEastern);
  await expect.poll(() => paths.filter((path) => /^200 .*noto-sans-(sc|kr).*\.woff2$/.test(path)).length).toBeGreaterThan(1);
  expect(paths.every((path) => path.startsWith("200 "))).toBe(true);
  // The style sheet and at most a file for each letter.
  expect(paths.length).toBeLessThanOrEqual(6);
  await marey.drawn(6);
  await marey.picture("far-eastern-names");
});

test("two letters look different once their font is there", async ({ marey, page }) => {
  const picture = async (name) => {
    await marey.open("names.bvh", armClip(2).replace("Shoulder", name));
    // The file with the letter is on its way: its place is blank first.
    await page.evaluate(() => document.fonts.ready);
    await page.waitForTimeout(400);
    await marey.drawn(3);
    const { x, y, w, h } = await marey.item("outliner.joint.0");
    return (await page.screenshot({ clip: { x, y, width: w, height: h } })).toString("base64");
  };
  await marey.goto();
  const [right, left, blank] = [await picture("右"), await picture("左"), await picture("\u3000")];
  expect(new Set([right, left, blank]).size).toBe(3);
  expect(await picture("右")).toBe(right);
});

test("the page as one file asks nobody for letters", async ({ marey, page }) => {
  await page.goto(pathToFileURL(join(siteFolder, "marey.html")).href);
  await marey.ready();
  await marey.open("names.bvh", farEastern);
  await marey.drawn(6);
  await marey.expectState(({ joints }) => joints.map(({ name }) => name), ["右肩", "팔꿈치"]);
});

/** A figure whose joints have the letters of a lead byte each as their names, in the bytes of a double-byte set. */
function lettersClip(set) {
  const decoder = new TextDecoder(set);
  const names = [];
  const parts = ["HIERARCHY\nROOT Root\n{\nOFFSET 0 0 0\nCHANNELS 1 Zrotation\n"];
  for (let lead = 0x81; lead <= 0xfe; lead++) {
    const bytes = [];
    let letters = "";
    for (let trail = 0x40; trail <= 0xfe; trail++) {
      const letter = decoder.decode(Uint8Array.of(lead, trail));
      const isLetter = [...letter].length === 1 && !/[\ufffd\ue000-\uf8ff]/.test(letter) && letter.charCodeAt(0) > 0x7f;
      if (!isLetter || trail === 0x7b || trail === 0x7d) continue; // braces end names, mostly
      bytes.push(lead, trail);
      letters += letter;
    }
    if (bytes.length === 0) continue;
    names.push(`n${letters}`); // a name does not begin with the byte A0, which is a blank elsewhere
    parts.push("JOINT n", Buffer.from(bytes), "\n{\nOFFSET 0 1 0\nCHANNELS 1 Zrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n");
  }
  parts.push(`}\nMOTION\nFrames: 1\nFrame Time: 0.1\n${"0 ".repeat(names.length + 1)}\n`);
  return { names, bytes: Buffer.concat(parts.map((part) => Buffer.from(part))) };
}

for (const set of ["gbk", "shift_jis"]) {
  test(`all letters of ${set} are those of the standard`, async ({ marey, page }) => {
    const { names, bytes } = lettersClip(set);
    expect(names.join("").length).toBeGreaterThan(set === "gbk" ? 21_000 : 7000);
    await marey.goto();
    await page.evaluate((list) => window.marey.open("letters.bvh", Uint8Array.from(list)), [...bytes]);
    await marey.command(`clip.names_in.${set}`);
    expect((await marey.state()).joints.slice(1).map(({ name }) => name)).toEqual(names);
  });
}
