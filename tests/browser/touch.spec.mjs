// Fingers: tap, drag, and two fingers for panning and zooming.
import { expect, test } from "./support/fixtures.mjs";
import { armClip } from "./support/clips.mjs";

test.use({ hasTouch: true, viewport: { width: 820, height: 900 } });

/** Moves fingers along straight lines: `from` and `to` are lists of points, one for each finger. */
async function moveFingers(page, from, to, steps = 8) {
  const session = await page.context().newCDPSession(page);
  const at = (t) => from.map((start, id) => ({ id, x: start.x + (to[id].x - start.x) * t, y: start.y + (to[id].y - start.y) * t }));
  for (let id = 0; id < from.length; id++) {
    await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: at(0).slice(0, id + 1) });
  }
  for (let i = 1; i <= steps; i++) {
    await session.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: at(i / steps) });
    await page.waitForTimeout(30);
  }
  await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  await page.evaluate(async () => {
    for (let i = 0; i < 4; i++) await new Promise((done) => requestAnimationFrame(done));
  });
}

test.beforeEach(async ({ marey }) => {
  await marey.goto();
  await marey.open("arm.bvh", armClip(100));
  await marey.drawn(5);
});

test("a tap presses a button", async ({ marey, page }) => {
  const { x, y } = await marey.point("play.toggle");
  await page.touchscreen.tap(x, y);
  await marey.expectState(({ playing }) => playing, true);
});

test("a finger scrubs on the ruler", async ({ marey, page }) => {
  const from = await marey.point("timeline.ruler", 0.2);
  const to = await marey.point("timeline.ruler", 0.7);
  await moveFingers(page, [from], [to]);
  await marey.expectState(({ frame }) => frame > 50, true);
});

test("two fingers zoom and pan the curves without changing them", async ({ marey, page }) => {
  await marey.command("select.joint", { joint: 1 });
  const middle = await marey.point("curves.canvas");
  const places = () => Promise.all([20, 60].map((frame) => marey.command("curve.locate", { channel: 1, frame })));
  const before = await places();
  const spread = (by) => [{ x: middle.x - by, y: middle.y }, { x: middle.x + by, y: middle.y }];
  await moveFingers(page, spread(50), spread(100));
  const zoomed = await places();
  const factor = (zoomed[1].x - zoomed[0].x) / (before[1].x - before[0].x);
  expect(factor).toBeGreaterThan(1.6);
  expect(factor).toBeLessThan(2.4);
  const moved = spread(60).map(({ x, y }) => ({ x: x + 80, y }));
  await moveFingers(page, spread(60), moved);
  const panned = await places();
  expect(panned[0].x - zoomed[0].x).toBeGreaterThan(50);
  expect((panned[1].x - panned[0].x) / (zoomed[1].x - zoomed[0].x)).toBeCloseTo(1, 1);
  await marey.expectState(({ dirty }) => dirty, false);
});

test("the keyboard of a touch screen is asked for by a tap on a field", async ({ marey, page }) => {
  const { x, y } = await marey.point("outliner.search");
  await page.touchscreen.tap(x, y);
  await expect(page.locator("#text-input")).toBeFocused();
});
