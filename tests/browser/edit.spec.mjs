// The main job: bend a curve with the mouse, see the body follow, undo, redo, download.
import { readFileSync } from "node:fs";
import { armClip } from "./support/clips.mjs";
import { expect, test } from "./support/fixtures.mjs";

const rowsOf = (text) => text.slice(text.indexOf("Frame Time")).trim().split("\n").slice(1).map((row) => row.trim().split(/\s+/));

/** Where a sample stands on the screen, by the page's own reckoning. */
const locate = (marey, channel, frame) => marey.command("curve.locate", { channel, frame });

async function dragSample(marey, channel, frame, dy) {
  const at = await locate(marey, channel, frame);
  await marey.drag(at, { x: at.x, y: at.y + dy });
}

test.beforeEach(async ({ marey }) => {
  await marey.goto();
  await marey.open("arm.bvh", armClip());
  await marey.command("curve.falloff", { radius: 0 });
  await marey.click("outliner.joint.1");
  await marey.expectState(({ selection }) => selection.activeJoint, 1);
  await marey.item("curves.canvas");
});

test("dragging a sample bends the curve and moves the body", async ({ marey, page }) => {
  const { x, y, w, h } = await marey.item("viewport.canvas");
  const clip = { x: x + 0.2 * w, y: y + 0.2 * h, width: 0.6 * w, height: 0.6 * h };
  await marey.command("play.go_to_frame", { frame: 9 });
  await page.mouse.move(5, 5);
  await marey.drawn(4);
  const before = await page.screenshot({ clip });
  await dragSample(marey, 1, 9, -30);
  await page.mouse.move(5, 5);
  await marey.drawn(4);
  const after = await page.screenshot({ clip });
  expect(before.equals(after)).toBe(false);
  await marey.expectState(({ dirty, undoDepth }) => [dirty, undoDepth], [true, 1]);
  await expect(page).toHaveTitle("* arm.bvh - Marey");
  await marey.picture("edited");
});

test("undo and redo by key and by button", async ({ marey }) => {
  await dragSample(marey, 1, 9, -30);
  const edited = await marey.save();
  expect(edited).not.toBe(armClip());
  await marey.press("Control+z");
  await marey.expectState(({ undoDepth, redoDepth, dirty }) => [undoDepth, redoDepth, dirty], [0, 1, false]);
  expect(await marey.save()).toBe(armClip());
  await marey.click("edit.redo");
  await marey.expectState(({ undoDepth }) => undoDepth, 1);
  expect(await marey.save()).toBe(edited);
  await marey.click("edit.undo");
  await marey.expectState(({ undoDepth }) => undoDepth, 0);
  await marey.press("Control+Shift+z");
  await marey.expectState(({ undoDepth }) => undoDepth, 1);
});

test("the downloaded file differs in exactly the edited samples", async ({ marey, page }) => {
  await dragSample(marey, 1, 9, -30);
  const waiting = page.waitForEvent("download");
  await marey.click("file.save");
  const download = await waiting;
  expect(download.suggestedFilename()).toBe("arm.bvh");
  const text = readFileSync(await download.path(), "utf8");
  const [before, after] = [rowsOf(armClip()), rowsOf(text)];
  const differing = before.flatMap((row, frame) => row.flatMap((value, channel) => (value === after[frame][channel] ? [] : [[frame, channel]])));
  expect(differing).toEqual([[9, 1]]);
  expect(Number(after[9][1])).toBeGreaterThan(10);
  expect(text.slice(0, text.indexOf("MOTION"))).toBe(armClip().slice(0, armClip().indexOf("MOTION")));
  await marey.expectState(({ dirty }) => dirty, false);
});

test("an unedited file is downloaded byte for byte", async ({ marey, page }) => {
  const waiting = page.waitForEvent("download");
  await marey.press("Control+s");
  expect(readFileSync(await (await waiting).path(), "utf8")).toBe(armClip());
});

test("a falloff takes neighbours along and is one step to undo", async ({ marey }) => {
  await marey.command("curve.falloff", { radius: 4 });
  await dragSample(marey, 1, 9, -30);
  const after = rowsOf(await marey.save()).map((row) => Number(row[1]));
  expect(after[9]).toBeGreaterThan(after[8]);
  expect(after[8]).toBeGreaterThan(after[7]);
  expect(after[7]).toBeGreaterThan(10);
  expect(after[0]).toBe(10);
  expect(after[19]).toBe(10);
  await marey.press("Control+z");
  expect(await marey.save()).toBe(armClip());
});

test("Escape gives a drag up", async ({ marey, page }) => {
  const at = await locate(marey, 1, 9);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x, at.y - 30, { steps: 4 });
  await marey.drawn(3);
  expect(await marey.save()).not.toBe(armClip());
  await marey.press("Escape");
  await page.mouse.up();
  await marey.drawn(3);
  expect(await marey.save()).toBe(armClip());
  await marey.expectState(({ undoDepth }) => undoDepth, 0);
});

test("a box selects samples, which are then typed, smoothed and scaled", async ({ marey }) => {
  const first = await locate(marey, 1, 5);
  const last = await locate(marey, 1, 8);
  await marey.drag({ x: first.x - 4, y: first.y - 20 }, { x: last.x + 4, y: last.y + 20 });
  await marey.expectState(({ selection }) => selection.samples, [{ channel: 1, first: 5, count: 4 }]);
  await marey.command("curve.set_value", { value: 25 });
  expect(rowsOf(await marey.save()).slice(4, 10).map((row) => Number(row[1]))).toEqual([10, 25, 25, 25, 25, 10]);
  await marey.command("curve.smooth", { sigma: 1 });
  await marey.command("curve.scale", { factor: 0.5, pivot: 0 });
  await marey.expectState(({ undoDepth }) => undoDepth, 3);
});

test("leaving with unsaved changes asks first", async ({ marey, page }) => {
  await dragSample(marey, 1, 9, -30);
  await marey.expectState(({ dirty }) => dirty, true);
  const asked = new Promise((done) => page.once("dialog", async (dialog) => {
    done(dialog.type());
    await dialog.dismiss();
  }));
  await page.evaluate(() => location.reload());
  expect(await asked).toBe("beforeunload");
  await marey.expectState(({ dirty }) => dirty, true);
});
