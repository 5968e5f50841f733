// The browser takes the WebGL context away and gives it back: nothing is lost but the time between.
import { readFileSync } from "node:fs";
import { armClip } from "./support/clips.mjs";
import { expect, test } from "./support/fixtures.mjs";

/** `lose` and `restore` resolve when the page has heard of it. */
const change = (page, what) => page.evaluate(async (method) => {
  const canvas = document.getElementById("canvas");
  window.loseContext ??= canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
  const heard = new Promise((done) => canvas.addEventListener(method === "loseContext" ? "webglcontextlost" : "webglcontextrestored", done, { once: true }));
  window.loseContext[method]();
  await heard;
}, what);
const lose = (page) => change(page, "loseContext");
const restore = (page) => change(page, "restoreContext");

async function pictureOf(marey, page) {
  await page.mouse.move(3, 3);
  await marey.drawn(6);
  return (await page.screenshot()).toString("base64");
}

test.beforeEach(async ({ marey }) => {
  await marey.goto();
  await marey.open("arm.bvh", armClip(100).replace("Elbow", "右肩"));
  await marey.command("select.joint", { joint: 1 });
  await marey.command("curve.select", { channel: 1, first: 20, count: 30 });
  await marey.command("curve.move", { delta: 12 });
  await marey.command("play.go_to_frame", { frame: 33 });
  await marey.command("view.orbit", { yaw: 35, pitch: 10 });
  await marey.item("outliner.joint.1");
  // The status line of the last command goes by itself, and the letters' file has come.
  await marey.page.waitForTimeout(4500);
});

test("the picture, the changes, the selection and the camera are as before, also the second time", async ({ marey, page }) => {
  const picture = await pictureOf(marey, page);
  const [state, saved] = [await marey.state(), await marey.save()];
  for (let time = 0; time < 2; time++) {
    await lose(page);
    expect(await marey.state()).toEqual(state);
    await marey.drawn(3);
    await restore(page);
    expect(await pictureOf(marey, page) === picture, `the picture after loss ${time + 1}`).toBe(true);
    expect(await marey.state()).toEqual(state);
    expect(await marey.save()).toBe(saved);
  }
  await marey.press("Control+z");
  await marey.expectState(({ undoDepth, redoDepth }) => [undoDepth, redoDepth], [0, 1]);
  await expect(page.locator("#failure")).toBeHidden();
});

test("while a clip plays: it plays on", async ({ marey, page }) => {
  await marey.command("play.toggle");
  await marey.drawn(3);
  await lose(page);
  await page.waitForTimeout(300);
  await restore(page);
  await marey.expectState(({ playing }) => playing, true);
  const frame = async () => (await marey.state()).frame;
  const first = await frame();
  await expect.poll(frame).not.toBe(first);
});

test("what happens in the meantime is seen afterwards", async ({ marey, page }) => {
  await lose(page);
  await marey.command("edit.undo");
  await marey.open("other.bvh", armClip(7));
  await page.setViewportSize({ width: 900, height: 700 });
  await restore(page);
  await marey.expectState(({ file, frames }) => [file, frames], ["other.bvh", 7]);
  await marey.item("outliner.joint.1");
});

test("a context that does not come back: the page says so and offers the file, and goes on when it does come", async ({ marey, page }) => {
  const saved = await marey.save();
  const title = await page.title();
  await lose(page);
  await expect(page.getByRole("heading", { name: "The browser has taken the picture away" })).toBeVisible();
  await page.screenshot({ path: "build/screenshots/context-lost.png" });
  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: "Download the open file" }).click();
  expect(readFileSync(await (await waiting).path(), "utf8")).toBe(saved);
  await restore(page);
  await expect(page.locator("#failure")).toBeHidden();
  await expect(page).toHaveTitle(title);
  await marey.click("play.toggle");
  await marey.expectState(({ playing }) => playing, true);
});
