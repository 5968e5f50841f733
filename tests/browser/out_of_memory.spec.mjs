// Memory that ends: the page says so, and the open document stays, with its changes, as it was.
import { armClip } from "./support/clips.mjs";
import { expect, test } from "./support/fixtures.mjs";
import { installMemoryLimit } from "./support/memory_limit.mjs";

const megabyte = 2 ** 20;

/** A clip of so many frames of a joint with three channels, made in the page. */
function makeLongClip(frames) {
  const rows = [];
  for (let i = 0; i < frames; i++) rows.push(`${i % 90}.00 10.00 20.00`);
  const head = ["HIERARCHY", "ROOT a", "{", "OFFSET 0.00 0.00 0.00", "CHANNELS 3 Zrotation Xrotation Yrotation", "End Site", "{",
    "OFFSET 0.00 1.00 0.00", "}", "}", "MOTION", `Frames: ${frames}`, "Frame Time: 0.01"];
  return `${[...head, ...rows].join("\n")}\n`;
}

/** Opens such a clip with `room` bytes beyond what the program has taken; gives what it was refused with. */
function openWithRoom(page, frames, room) {
  return page.evaluate(async ([count, bytes]) => {
    const text = window.makeLongClip(count);
    window.limitMemory(window.marey.memory().reserved + bytes);
    const refusal = await window.marey.open("long.bvh", text).then(() => undefined, ({ name, code, message }) => ({ name, code, message }));
    window.limitMemory(Infinity);
    return refusal;
  }, [frames, room]);
}

test.beforeEach(async ({ marey, page }) => {
  await page.addInitScript(installMemoryLimit);
  await page.addInitScript(`window.makeLongClip = ${makeLongClip}`);
  await marey.goto();
});

async function expectArmWithOneStep(marey) {
  await marey.expectState(({ file, undoDepth }) => [file, undoDepth], ["arm.bvh", 1]);
  const edited = await marey.save();
  await marey.command("curve.move", { delta: 5 });
  await marey.press("Control+z");
  expect(await marey.save()).toBe(edited);
  await marey.press("Control+z");
  expect(await marey.save()).toBe(armClip());
}

for (const room of [0, 4, 8]) {
  test(`a file without memory for it, ${room} MB left: a sentence, and the open one stays`, async ({ marey, page }) => {
    await marey.open("arm.bvh", armClip());
    await marey.command("curve.select", { channel: 1, first: 2, count: 5 });
    await marey.command("curve.move", { delta: 3 });
    const refusal = await openWithRoom(page, 1_000_000, room * megabyte);
    expect(refusal).toMatchObject({ name: "MareyError", code: "out_of_memory" });
    expect(refusal.message).toContain("memory");
    await marey.drawn(3);
    const { messages } = await marey.state();
    expect(messages.map(({ title, detail }) => `${title}. ${detail}`).join()).toMatch(/long.bvh could not be opened.*not enough memory/);
    await marey.picture(`out-of-memory-${room}`);
    await expectArmWithOneStep(marey);
    expect(await page.evaluate(() => window.marey.open("long.bvh", window.makeLongClip(100_000)).then(({ frames }) => frames))).toBe(100_000);
  });
}

/** In the page: does things with hardly any memory left until they are refused, and what a refusal leaves behind. */
async function editWithoutMemory() {
  const { marey } = window;
  const depths = () => [marey.state().undoDepth, marey.state().redoDepth].join();
  const refused = [];
  const withoutMemory = async (id, args) => {
    const before = depths();
    window.limitMemory(marey.memory().reserved);
    const error = await marey.command(id, args).then(() => undefined, ({ message }) => message);
    window.limitMemory(Infinity);
    if (error === undefined) return true;
    refused.push({ id, error, told: marey.state().messages[0]?.detail ?? "", same: depths() === before });
    return false;
  };
  const text = window.makeLongClip(150_000);
  await marey.open("long.bvh", text);
  await marey.command("clip.remove_frames", { first: 10, count: 70_000 });
  for (const channel of [0, 1, 2]) await marey.command("curve.select", { channel, first: 0, count: 80_000, add: true });
  while (refused.length < 1 && marey.state().undoDepth < 100) await withoutMemory("curve.move", { delta: 1 });
  const present = marey.save().join();
  await marey.command("curve.move", { delta: 1 });
  await marey.command("edit.undo");
  const edited = marey.save().join() === present;
  while (marey.state().undoDepth > 0) if (!(await withoutMemory("edit.undo"))) await marey.command("edit.undo");
  return { refused, edited, asOpened: new TextDecoder().decode(marey.save()) === text };
}

test("edits without memory for them change nothing, and can be done when there is some", async ({ marey, page }) => {
  const { refused, edited, asOpened } = await page.evaluate(editWithoutMemory);
  expect(refused.length).toBeGreaterThan(0);
  for (const { id, error, told, same } of refused) {
    expect(error, id).toContain("not enough memory");
    expect(told, id).toContain("not enough memory");
    expect(same, id).toBe(true);
  }
  expect(edited).toBe(true);
  expect(asOpened).toBe(true);
  await marey.expectState(({ undoDepth, dirty }) => [undoDepth, dirty], [0, false]);
});
