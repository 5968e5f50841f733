// What the page says of a file, the other ways to read it, and copies for other programs.
import { readFileSync } from "node:fs";
import { expect, test } from "./support/fixtures.mjs";

/** A root in a pose of its own that then turns slowly; the file declares a frame less than it holds. */
const referenceClip = `HIERARCHY
ROOT Root
{
  OFFSET 0 0 0
  CHANNELS 3 Zrotation Xrotation Yrotation
  JOINT Tip
  {
    OFFSET 0 10 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 5 0
    }
  }
}
MOTION
Frames: 20
Frame Time: 0.05
0 0 0 0 0 0
${Array.from({ length: 20 }, (_, i) => `30 40 ${i} 0 10 0`).join("\n")}
`;

test.use({ viewport: { width: 1280, height: 1000 } });

test.beforeEach(async ({ marey }) => {
  await marey.goto();
  await marey.open("reference.bvh", referenceClip);
});

test("a frame too many is left out by one click and comes back by undo", async ({ marey }) => {
  // What is saved counts what the file holds.
  const repaired = referenceClip.replace("Frames: 20", "Frames: 21");
  expect(await marey.save()).toBe(repaired);
  await marey.press("Shift+P");
  await marey.click("clip.frames.declared@inspector");
  await marey.expectState(({ frames, dirty }) => [frames, dirty], [20, true]);
  expect(await marey.save()).toBe(referenceClip.replace("30 40 19 0 10 0\n", ""));
  await marey.press("Control+z");
  await marey.expectState(({ frames, dirty }) => [frames, dirty], [21, false]);
  expect(await marey.save()).toBe(repaired);
  await marey.picture("report");
});

test("a copy for another program says what it costs and leaves the clip as it is", async ({ marey, page }) => {
  await marey.press("Control+Shift+S");
  await marey.expectState(({ overlay }) => overlay, "save_as");
  await marey.click("save_as.form");
  await marey.click("save_as.form.blender");
  await expect.poll(async () => (await marey.item("save_as.name")).label).toBe("reference-blender.bvh");
  await marey.picture("save-as");
  const waiting = page.waitForEvent("download");
  await marey.drawn();
  await marey.click("save_as.download");
  const download = await waiting;
  expect(download.suggestedFilename()).toBe("reference-blender.bvh");
  expect(readFileSync(await download.path(), "utf8")).toContain("Frames: 21");
  await marey.expectState(({ overlay, dirty }) => [overlay, dirty], ["none", false]);
});
