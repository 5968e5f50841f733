// The card that says what drawing takes.
import { armClip } from "./support/clips.mjs";
import { expect, test } from "./support/fixtures.mjs";

async function switchOn(marey, page) {
  await marey.press("Control+k");
  await page.keyboard.type("performance", { delay: 30 });
  await marey.press("Enter");
}

test.beforeEach(async ({ marey }) => {
  test.slow();
  await marey.goto();
  await marey.open("arm.bvh", armClip(2000));
});

test("is switched on by the palette and shows numbers", async ({ marey, page }) => {
  expect((await marey.state()).performance).toBeNull();
  await switchOn(marey, page);
  await marey.item("viewport.performance");
  await marey.press("Space");
  await expect.poll(async () => (await marey.state()).performance.framesPerSecond, { timeout: 20_000 }).toBeGreaterThan(1);
  const { performance } = await marey.state();
  expect(performance.frameMs).toBeGreaterThan(0);
  expect(performance.worstMs).toBeGreaterThanOrEqual(performance.frameMs);
  expect(performance.drawCalls).toBeGreaterThan(3);
  expect(performance.vertices).toBeGreaterThan(1000);
  expect(performance.memoryUsed).toBeGreaterThan(1e6);
  expect(performance.memoryTotal).toBeGreaterThan(performance.memoryUsed);
  expect(performance.sampleBytes).toBe(2000 * 2 * 8);
  await marey.picture("performance");
});

test("goes and comes by its keys and is remembered", async ({ marey, page }) => {
  await marey.press("Shift+T");
  await marey.item("viewport.performance");
  await page.reload();
  await marey.ready();
  await marey.item("viewport.performance");
  await marey.press("Shift+T");
  await expect.poll(async () => (await marey.items()).some(({ id }) => id === "viewport.performance")).toBe(false);
});

test("lets the pointer through and keeps no page awake", async ({ marey, page }) => {
  await marey.press("Shift+T");
  const from = await marey.point("viewport.performance");
  const view = () => page.evaluate(() => window.marey.state().status);
  await page.mouse.move(from.x, from.y);
  await expect.poll(view, { message: "the status says what a drag in the viewport does" }).toMatch(/[Dd]rag/);
  await page.evaluate(() => {
    window.frames = 0;
    const request = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (callback) => request((nowMs) => {
      window.frames++;
      callback(nowMs);
    });
  });
  const framesIn = async (milliseconds) => {
    const before = await page.evaluate(() => window.frames);
    await page.waitForTimeout(milliseconds);
    return (await page.evaluate(() => window.frames)) - before;
  };
  // Longer than a notice stays.
  await expect.poll(() => framesIn(5000), { timeout: 90_000 }).toBe(0);
  expect(await framesIn(2000)).toBe(0);
});
