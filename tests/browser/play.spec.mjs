// Watching a clip: transport, ruler and keys.
import { armClip } from "./support/clips.mjs";
import { expect, test } from "./support/fixtures.mjs";

/** The frame that the page has just drawn, and the time that it was drawn for. */
function sampleFrame(page) {
  return page.evaluate(() => new Promise((done) => {
    requestAnimationFrame((timeMs) => done({ timeMs, frame: window.marey.state().frame }));
  }));
}

test.beforeEach(async ({ marey }) => {
  await marey.goto();
  await marey.open("arm.bvh", armClip(200));
});

test("Space plays and pauses", async ({ marey }) => {
  await marey.press("Space");
  await marey.expectState(({ playing, frame }) => playing && frame > 3, true);
  await marey.press("Space");
  await marey.expectState(({ playing }) => playing, false);
  const { frame } = await marey.state();
  await marey.drawn(5);
  expect((await marey.state()).frame).toBe(frame);
});

test("the play button plays at the clip's own rate", async ({ marey, page }) => {
  await marey.click("play.toggle");
  await marey.expectState(({ playing }) => playing, true);
  const start = await sampleFrame(page);
  await page.waitForTimeout(2000);
  const end = await sampleFrame(page);
  expect(Math.abs(end.frame - start.frame - (end.timeMs - start.timeMs) / 40)).toBeLessThan(3);
});

test("dragging on the ruler scrubs", async ({ marey, page }) => {
  const from = await marey.point("timeline.ruler", 0.2);
  const to = await marey.point("timeline.ruler", 0.8);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await marey.drawn(3);
  const begin = (await marey.state()).frame;
  await page.mouse.move(to.x, to.y, { steps: 5 });
  await marey.drawn(3);
  const end = (await marey.state()).frame;
  await page.mouse.up();
  expect(begin).toBeGreaterThan(10);
  expect(end).toBeGreaterThan(begin + 60);
});

test("arrow keys step, Home and End go to the ends", async ({ marey }) => {
  await marey.press("ArrowRight");
  await marey.press("ArrowRight");
  await marey.press("ArrowLeft");
  await marey.expectState(({ frame }) => frame, 1);
  await marey.press("End");
  await marey.expectState(({ frame }) => frame, 199);
  await marey.press("Home");
  await marey.expectState(({ frame }) => frame, 0);
});
