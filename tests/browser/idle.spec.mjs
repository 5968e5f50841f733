// What the page does while nobody does anything: nothing.
import { armClip } from "./support/clips.mjs";
import { expect, test } from "./support/fixtures.mjs";

/** In the page before it starts: counts frames that are asked for, and what WebGL is told to draw. */
function countDrawing() {
  window.drawing = { frames: 0, calls: 0 };
  const request = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (callback) => request((nowMs) => {
    window.drawing.frames++;
    callback(nowMs);
  });
  for (const name of ["drawElements", "drawArrays", "drawElementsInstanced", "drawArraysInstanced"]) {
    const draw = WebGL2RenderingContext.prototype[name];
    WebGL2RenderingContext.prototype[name] = function count(...args) {
      window.drawing.calls++;
      return draw.apply(this, args);
    };
  }
}

/** What is drawn within so long; waiting on the side of the test leaves the page alone. */
async function drawnWithin(page, milliseconds) {
  const before = await page.evaluate(() => ({ ...window.drawing }));
  await page.waitForTimeout(milliseconds);
  const after = await page.evaluate(() => ({ ...window.drawing }));
  return { frames: after.frames - before.frames, calls: after.calls - before.calls };
}

/** Waits until five seconds went by without a frame: notices, which stay for four, have gone, panels have come to rest. */
async function settle(page) {
  await expect.poll(async () => (await drawnWithin(page, 5000)).frames, { timeout: 90_000 }).toBe(0);
}

/** What the browser says of a tab behind another one; a browser under test shows each of its tabs. */
function hide(page, hidden) {
  return page.evaluate((value) => {
    Object.defineProperty(document, "hidden", { configurable: true, get: () => value });
    document.dispatchEvent(new Event("visibilitychange"));
  }, hidden);
}

const nothing = { frames: 0, calls: 0 };

test.beforeEach(async ({ marey, page }) => {
  test.slow();
  await page.addInitScript(countDrawing);
  await marey.goto();
});

test("a page that has come to rest draws no frame", async ({ page }) => {
  await settle(page);
  expect(await drawnWithin(page, 2000)).toEqual(nothing);
  expect((await page.evaluate(() => window.drawing)).calls).toBeGreaterThan(20);
});

test("nor does one whose pointer rests over a control", async ({ marey, page }) => {
  const { x, y } = await marey.point("play.toggle");
  await page.mouse.move(x, y);
  await settle(page);
  expect(await drawnWithin(page, 2000)).toEqual(nothing);
});

test("a clip that was paused is at rest again", async ({ marey, page }) => {
  await marey.open("arm.bvh", armClip(200));
  await marey.press("Space");
  await marey.expectState(({ playing, frame }) => playing && frame > 2, true);
  await marey.press("Space");
  await settle(page);
  expect(await drawnWithin(page, 2000)).toEqual(nothing);
});

test("a hidden page does not play on", async ({ marey, page }) => {
  await marey.open("arm.bvh", armClip(200));
  await settle(page);
  await marey.press("Space");
  await marey.expectState(({ playing, frame }) => playing && frame > 2, true);
  await hide(page, true);
  await page.waitForTimeout(500);
  expect(await drawnWithin(page, 1500)).toEqual(nothing);
  await hide(page, false);
  await expect.poll(async () => (await drawnWithin(page, 500)).frames).toBeGreaterThan(1);
});
