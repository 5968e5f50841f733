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
