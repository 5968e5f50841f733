// Operations, layers and keys by the page's own controls, with the mouse and the keyboard.
import { writeFileSync } from "node:fs";
import { armClip } from "./support/clips.mjs";
import { expect, test } from "./support/fixtures.mjs";

test.beforeEach(async ({ marey }) => {
  await marey.goto();
  await marey.open("arm.bvh", armClip());
  await marey.click("outliner.joint.1");
  await marey.expectState(({ selection }) => selection.activeJoint, 1);
});

/** Clicks a widget as soon as it stands still for a frame: quicker than marey.click(), as it is done some hundred times here. */
async function press(marey, page, id) {
  const find = async () => (await marey.items()).find((item) => item.id === id);
  let [found, before] = [await find(), undefined];
  for (let tries = 0; tries < 200 && (!found || !before || found.y !== before.y); tries++) {
    await marey.drawn(2);
    [found, before] = [await find(), found];
  }
  expect(found, `the widget ${id}`).toBeTruthy();
  await page.mouse.click(found.x + found.w / 2, found.y + found.h / 2, { delay: 20 });
  await marey.drawn(3);
}

/** Opens the form of an operation from the list, found by its name. */
async function openForm(marey, page, id, label) {
  await press(marey, page, "operations.search");
  await marey.press("Control+a");
  await page.keyboard.type(label);
  await marey.drawn(label.length + 4); // a letter may take a frame of its own, and each moves the list
  await press(marey, page, `operation.${id}`);
}

test("each operation is found, previewed, applied and undone", async ({ marey, page }) => {
  test.setTimeout(900_000);
  const text = await marey.save();
  const commands = await page.evaluate(() => window.marey.commands());
  const forms = commands.filter(({ id }) => id.startsWith("operation."));
  expect(forms.length).toBeGreaterThan(55);
  await marey.click("inspector.tab.edit");
  let changed = 0;
  for (const { id, label } of forms) {
    await openForm(marey, page, id.slice("operation.".length), label.replace("…", ""));
    await press(marey, page, "operation.apply");
    if ((await marey.items()).some((item) => item.id === "operation.cancel")) await press(marey, page, "operation.cancel");
    changed += (await marey.state()).undoDepth > 0 ? 1 : 0;
    while ((await marey.state()).undoDepth > 0) await marey.command("edit.undo");
    expect(await marey.save(), id).toBe(text);
  }
  expect(changed).toBeGreaterThan(5);
});

test("another clip is appended, and joints are spliced from it", async ({ marey, page }, info) => {
  const text = await marey.save();
  const path = info.outputPath("other arm.bvh");
  writeFileSync(path, armClip());
  await marey.click("inspector.tab.edit");
  await openForm(marey, page, "append", "Append clip");
  await marey.chooseFile(path, () => marey.click("operation.value.from"));
  await marey.expectState(({ otherFile, file }) => [otherFile, file], ["other arm.bvh", "arm.bvh"]);
  // The arm stands on no ground along which it could be moved.
  expect((await marey.item("operation.refusal")).label).toContain("position");
  await marey.click("operation.value.align");
  await marey.click("operation.value.align.no");
  await marey.expectState(({ undoDepth }) => undoDepth, 1);
  expect((await marey.item("operation.other")).label).toBe("other arm.bvh");
  await marey.picture("append");
  const { frames } = await marey.state();
  await marey.click("operation.apply");
  await marey.command("edit.undo");
  expect(await marey.save()).toBe(text);
  expect(frames).toBeGreaterThan((await marey.state()).frames);
  const answer = await marey.command("edit.operation", { do: "splice from='other arm.bvh' at=3 joints=Shoulder" });
  expect(answer.changed).toBe(true);
});

test("a value drawn by the mouse changes the preview, and Escape takes it back", async ({ marey, page }) => {
  const text = await marey.save();
  await marey.click("inspector.tab.edit");
  await openForm(marey, page, "offset", "Offset");
  const { x, y, w, h } = await marey.item("operation.value.by");
  const at = { x: x + w / 2, y: y + h / 2 };
  await marey.drag(at, { x: at.x + 80, y: at.y });
  await marey.expectState(({ undoDepth }) => undoDepth, 1);
  expect(await marey.save()).not.toBe(text);
  await marey.press("Escape");
  await marey.expectState(({ undoDepth }) => undoDepth, 0);
  expect(await marey.save()).toBe(text);
});

test("a capture is corrected by keys on a layer, which can be muted", async ({ marey }) => {
  const text = await marey.save();
  await marey.press("Shift+l");
  await marey.click("layer.add@layers");
  for (const frame of [0, 19]) {
    await marey.command("play.go_to_frame", { frame });
    await marey.press("k");
  }
  expect(await marey.save()).toBe(text);
  await marey.command("play.go_to_frame", { frame: 9 });
  await marey.press("k");
  const at = await marey.command("curve.locate", { channel: 1, frame: 9 });
  await marey.drag(at, { x: at.x, y: at.y - 40 });
  const edited = await marey.save();
  expect(edited).not.toBe(text);
  await marey.expectState(({ layers, activeLayer }) => [layers.length, activeLayer], [1, 1]);
  await marey.click("layers.mute.0");
  expect(await marey.save()).toBe(text);
  await marey.click("layers.mute.0");
  expect(await marey.save()).toBe(edited);
  await marey.picture("layers");
});

test("curves become keys, and the filter explorer and the orders show them", async ({ marey, page }) => {
  await marey.click("inspector.tab.edit");
  await openForm(marey, page, "to-keys", "Samples to keys");
  await marey.click("operation.apply");
  await marey.expectState(({ keyedChannels }) => keyedChannels > 0, true);
  await marey.press("Alt+2");
  await marey.item("explorer.plot.3");
  await marey.picture("explorer");
  await marey.press("Alt+3");
  await marey.item("orders.plot.5");
  await marey.picture("orders");
  await marey.press("Alt+1");
  await marey.item("curves.canvas");
});
