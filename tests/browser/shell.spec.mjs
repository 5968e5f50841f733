// What the page around the program promises.
import { createServer } from "node:http";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { armClip } from "./support/clips.mjs";
import { expect, siteFolder, test } from "./support/fixtures.mjs";

/** Counts the frames that the page asks for. */
async function countFrames(page) {
  await page.addInitScript(() => {
    const request = window.requestAnimationFrame;
    window.askedFrames = 0;
    window.requestAnimationFrame = (callback) => {
      window.askedFrames++;
      return request.call(window, callback);
    };
  });
}

test("an idle page draws nothing", async ({ marey, page }) => {
  await countFrames(page);
  await marey.goto("?sample=giant-swing");
  const asked = () => page.evaluate(() => window.askedFrames);
  await marey.expectState(({ status }) => status, "");
  await expect.poll(async () => {
    const before = await asked();
    await page.waitForTimeout(1500);
    return (await asked()) - before;
  }, { timeout: 20_000 }).toBe(0);
  const before = await asked();
  await page.waitForTimeout(2000);
  expect((await asked()) - before).toBe(0);
  await page.mouse.move(300, 300);
  expect(await asked()).toBeGreaterThan(before);
});

test("a lost WebGL context comes back with everything in it", async ({ marey, page, expectedProblems }) => {
  expectedProblems.push(/CONTEXT_LOST|context lost/i);
  await marey.goto("?sample=giant-swing");
  await page.mouse.move(5, 5);
  await marey.drawn(5);
  await page.waitForTimeout(4500);
  const before = await page.screenshot();
  await page.evaluate(async () => {
    const canvas = document.getElementById("canvas");
    const extension = canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
    extension.loseContext();
    await new Promise((done) => setTimeout(done, 300));
    extension.restoreContext();
    await new Promise((done) => canvas.addEventListener("webglcontextrestored", done, { once: true }));
  });
  await marey.drawn(5);
  expect((await page.screenshot()).equals(before)).toBe(true);
});

test("a program that fails leaves the edited document to be downloaded", async ({ marey, page }) => {
  await marey.goto();
  await marey.open("arm.bvh", armClip());
  await marey.command("select.joint", { joint: 1 });
  await marey.command("curve.select", { channel: 1, first: 3, count: 1 });
  await marey.command("curve.set_value", { value: 77 });
  await page.evaluate(() => {
    WebGL2RenderingContext.prototype.drawElements = () => { throw new Error("a fault for the test"); };
  });
  await page.mouse.move(200, 200);
  await expect(page.getByRole("alert")).toContainText("Marey has stopped");
  await marey.picture("failure");
  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: "Download the open file" }).click();
  const download = await waiting;
  expect(download.suggestedFilename()).toBe("arm.bvh");
  expect(readFileSync(await download.path(), "utf8")).toBe(armClip().replace("3.00 10.00", "3.00 77.00"));
});

test("the page connects to no other host, whatever asks for it", async ({ marey, page, expectedProblems }) => {
  expectedProblems.push(/Content Security Policy|violates/);
  const other = createServer((_, response) => response.writeHead(200, { "Access-Control-Allow-Origin": "*" }).end(armClip(3)));
  await new Promise((done) => other.listen(0, "127.0.0.1", done));
  const address = `http://127.0.0.1:${other.address().port}/far.bvh`;
  try {
    await marey.goto();
    const answer = await page.evaluate((url) => fetch(url).then(() => "fetched", () => "refused"), address);
    expect(answer).toBe("refused");
  } finally {
    other.close();
  }
});

test("a file of another host is opened when the address names it", async ({ marey, page, expectedProblems }) => {
  const other = createServer((_, response) => response.writeHead(200, { "Access-Control-Allow-Origin": "*" }).end(armClip(3)));
  await new Promise((done) => other.listen(0, "127.0.0.1", done));
  const address = `http://127.0.0.1:${other.address().port}/far.bvh`;
  expectedProblems.push(/^request: http:\/\/127\.0\.0\.1:\d+\/far\.bvh$/);
  try {
    await marey.goto(`?src=${encodeURIComponent(address)}`);
    await marey.expectState(({ file, frames }) => [file, frames], ["far.bvh", 3]);
    await expect(page.locator("#notice")).toBeHidden();
  } finally {
    other.close();
  }
});

test("the page as one file runs by double click", async ({ marey, page }) => {
  await page.goto(pathToFileURL(join(siteFolder, "marey.html")).href);
  await marey.ready();
  await marey.expectState(({ file }) => file, "walk.bvh");
  await marey.command("file.sample.giant-swing");
  await marey.expectState(({ file }) => file, "giant-swing.bvh");
  await marey.picture("one-file");
});

test("the theme follows the system, and the HTML follows the chosen theme", async ({ marey, page }) => {
  await marey.goto();
  await page.emulateMedia({ colorScheme: "light" });
  await marey.expectState(({ theme }) => theme, "light");
  await marey.picture("light");
  await marey.command("view.theme.dark");
  await marey.expectState(({ theme }) => theme, "dark");
  await expect.poll(() => page.evaluate(() => getComputedStyle(document.body).backgroundColor)).toBe("rgb(20, 22, 26)");
});

test("text goes into a field in the canvas, also from an input method", async ({ marey, page, context }) => {
  await marey.goto("?sample=walk");
  await marey.click("outliner.search");
  await expect(page.locator("#text-input")).toBeFocused();
  await page.keyboard.type("knee", { delay: 30 });
  const joints = async () => (await marey.items()).filter(({ id }) => /^outliner\.joint\.\d+$/.test(id)).map(({ label }) => label);
  const found = async () => (await joints()).filter((name) => /knee|shin|leg/i.test(name)).length;
  await expect.poll(async () => (await joints()).length).toBeLessThan(8);
  await expect.poll(found).toBeGreaterThan(0);
  await marey.press("Control+a");
  const session = await context.newCDPSession(page);
  await session.send("Input.imeSetComposition", { text: "ㅎ", selectionStart: 1, selectionEnd: 1 });
  await session.send("Input.imeSetComposition", { text: "한", selectionStart: 1, selectionEnd: 1 });
  await session.send("Input.insertText", { text: "한" });
  await expect.poll(async () => (await joints()).length).toBe(0);
  await marey.press("Backspace");
  await expect.poll(async () => (await joints()).length).toBeGreaterThan(10);
  await marey.press("Escape");
});

for (const { name, size, scale } of [
  { name: "phone", size: { width: 390, height: 844 }, scale: 2 },
  { name: "small-phone", size: { width: 360, height: 640 }, scale: 2 },
  { name: "wide", size: { width: 1920, height: 1080 }, scale: 1 },
]) {
  test.describe(name, () => {
    test.use({ viewport: size, deviceScaleFactor: scale });

    test("the canvas has one element per device pixel", async ({ marey, page }) => {
      await marey.goto("?sample=walk");
      const canvas = await page.evaluate(() => [document.getElementById("canvas").width, document.getElementById("canvas").height]);
      expect(canvas).toEqual([size.width * scale, size.height * scale]);
      await marey.picture(`size-${name}`);
      await page.setViewportSize({ width: size.width - 20, height: size.height - 40 });
      await expect.poll(() => page.evaluate(() => document.getElementById("canvas").width)).toBe((size.width - 20) * scale);
    });
  });
}
