// The ways in which a file comes into the page.
import { writeFileSync } from "node:fs";
import { armClip, brokenClip } from "./support/clips.mjs";
import { drop } from "./support/drop.mjs";
import { expect, test } from "./support/fixtures.mjs";

test("by drop, with a sign that it can be dropped", async ({ marey, page }) => {
  await marey.goto();
  const files = [{ name: "arm.bvh", text: armClip() }];
  await drop(page, files, { release: false });
  await expect(page.getByText("Drop a .bvh file to open it")).toBeVisible();
  await marey.picture("drop");
  await drop(page, files);
  await expect(page.getByText("Drop a .bvh file to open it")).toBeHidden();
  await marey.expectState(({ file, frames }) => [file, frames], ["arm.bvh", 20]);
  await expect(page).toHaveTitle("arm.bvh - Marey");
});

test("by drop of several: the first BVH file, and the page says so", async ({ marey, page }) => {
  await marey.goto();
  await drop(page, [{ name: "notes.txt", text: "notes" }, { name: "one.bvh", text: armClip(5) }, { name: "two.bvh", text: armClip(6) }]);
  await marey.expectState(({ file, frames }) => [file, frames], ["one.bvh", 5]);
  await expect(page.getByRole("alert")).toContainText("3 files were given; one.bvh was opened");
  await page.getByRole("button", { name: "Close the message" }).click();
  await expect(page.getByRole("alert")).toBeHidden();
});

test("by the file picker", async ({ marey }, testInfo) => {
  await marey.goto();
  const path = testInfo.outputPath("picked.bvh");
  writeFileSync(path, armClip(7));
  await marey.chooseFile(path, () => marey.press("Control+o"));
  await marey.expectState(({ file, frames }) => [file, frames], ["picked.bvh", 7]);
});

test("by paste of its text", async ({ marey, page, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await marey.goto();
  await page.evaluate((text) => navigator.clipboard.writeText(text), armClip(8));
  await marey.press("Control+v");
  await marey.expectState(({ file, frames }) => [file, frames], ["pasted.bvh", 8]);
});

test("by the page's address: a sample", async ({ marey }) => {
  await marey.goto("?sample=giant-swing");
  await marey.expectState(({ file, frames }) => [file, frames], ["giant-swing.bvh", 23]);
});

test("by the page's address: a file of the same host", async ({ marey }) => {
  await marey.goto("?src=samples/pendulum.bvh");
  await marey.expectState(({ file }) => file, "pendulum.bvh");
});

test("by the page's address: a file that is not there is said to be missing", async ({ marey, page, expectedProblems }) => {
  expectedProblems.push(/404/);
  await marey.goto("?src=samples/none.bvh");
  await expect(page.getByRole("alert")).toContainText("none.bvh could not be loaded: the server answered 404");
});

test("a broken file leaves the open one as it is and says where it is broken", async ({ marey, page }) => {
  await marey.goto();
  await marey.open("arm.bvh", armClip());
  await drop(page, [{ name: "broken.bvh", text: brokenClip }]);
  await marey.expectState(({ messages }) => messages.length, 1);
  const { file, messages: [{ title, detail }] } = await marey.state();
  expect(file).toBe("arm.bvh");
  expect(title).toBe("broken.bvh could not be opened");
  expect(detail).toContain("Line 4003, column 1");
  await expect(page.locator("#status")).toContainText("Line 4003, column 1");
  await marey.picture("broken-file");
  const refusal = await page.evaluate((text) => window.marey.open("b.bvh", text).catch((e) => ({ ...e, name: e.name, message: e.message })), brokenClip);
  expect(refusal).toMatchObject({ name: "MareyError", line: 4003, column: 1 });
  expect(await marey.save()).toBe(armClip());
});

test.describe("for the first time", () => {
  test.use({ firstVisit: true });

  test("the page welcomes with a moving figure", async ({ marey }) => {
    await marey.goto();
    await marey.expectState(({ overlay, file, playing }) => [overlay, file, playing], ["welcome", "walk.bvh", true]);
    await marey.picture("welcome");
    await marey.press("Escape");
    await marey.expectState(({ overlay }) => overlay, "none");
    await marey.goto();
    await marey.expectState(({ overlay }) => overlay, "none");
  });
});
