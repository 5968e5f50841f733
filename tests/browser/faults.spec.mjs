// An error in one panel leaves the others as they are.
import { armClip } from "./support/clips.mjs";
import { expect, test } from "./support/fixtures.mjs";

/** The letters of far eastern names come from the browser in the midst of drawing a panel; here the browser fails. */
function breakLetters() {
  const { measureText } = CanvasRenderingContext2D.prototype;
  window.lettersAreBroken = true;
  CanvasRenderingContext2D.prototype.measureText = function (text) {
    if (window.lettersAreBroken) throw new Error("the browser has no letters, for a test");
    return measureText.call(this, text);
  };
}

const ids = async (marey) => (await marey.items()).map(({ id }) => id);

test("a panel that fails says so, can be tried again, and the others go on", async ({ marey, page, context, expectedProblems }) => {
  expectedProblems.push(/^console: The list of joints met with an error.*outliner: Error: the browser has no letters/s);
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  const told = [];
  page.on("console", (message) => message.type() === "error" && told.push(message.text()));
  await page.addInitScript(breakLetters);
  await marey.goto();
  const text = armClip().replace("Elbow", "右肩");
  await marey.open("names.bvh", text);
  // Once for its file of letters to come, until which it is blank and is not measured.
  await marey.item("fault.outliner.retry");
  await expect(page.locator("#status")).toContainText("The list of joints met with an error");
  await marey.picture("panel-fault");
  for (const id of ["curves.canvas", "viewport.canvas", "play.toggle", "timeline.ruler"]) {
    expect(await ids(marey), id).toContain(id);
  }
  await marey.press("Space");
  await marey.expectState(({ playing }) => playing, true);
  await marey.press("Space");
  await marey.command("curve.select", { channel: 0, first: 2, count: 3 });
  await marey.command("curve.move", { delta: 2 });
  await marey.press("Control+z");
  expect(await marey.save()).toBe(text);
  expect(told).toHaveLength(1);

  await marey.click("fault.outliner.copy");
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toContain("the browser has no letters, for a test");
  await marey.click("fault.outliner.retry");
  await expect.poll(() => told.length).toBe(2);
  await page.evaluate(() => (window.lettersAreBroken = false));
  await marey.click("fault.outliner.retry");
  await marey.item("outliner.joint.1");
  expect(await ids(marey)).not.toContain("fault.outliner.retry");
});
