// What every browser engine must be able to do with the page. An engine gives: goto, evaluate, drag, click, press,
// picture.
import assert from "node:assert/strict";
import { setTimeout as wait } from "node:timers/promises";
import { inRoot } from "../../../scripts/lib/shell.mjs";
import { serveFolder } from "../../../scripts/lib/static_server.mjs";

async function until(what, probe, limitMs = 30_000) {
  const end = Date.now() + limitMs;
  for (;;) {
    const value = await probe();
    if (value) return value;
    if (Date.now() > end) throw new Error(`waited in vain until ${what}`);
    await wait(100);
  }
}

const state = (engine) => engine.evaluate("return window.marey.state()");
const middleOf = (item) => ({ x: Math.round(item.x + item.w / 2), y: Math.round(item.y + item.h / 2) });

function findItem(engine, id) {
  return until(`the widget ${id} is shown`, () =>
    engine.evaluate(`return window.marey.ui.items().find((item) => item.id === ${JSON.stringify(id)}) ?? null`));
}

async function startPage(engine, address) {
  await engine.goto(address);
  await until("the page exists", () => engine.evaluate("return Boolean(window.marey)"));
  const failure = await engine.evaluate("return window.marey.ready.then(() => '', (error) => String(error))");
  assert.equal(failure, "");
  await engine.evaluate("window.problems = []; addEventListener('error', (event) => window.problems.push(event.message))");
  assert.equal((await state(engine)).file, "giant-swing.bvh");
  await engine.press("Escape");
  await until("the welcome is closed", async () => (await state(engine)).overlay === "none");
  if ((await state(engine)).playing) await engine.press("Space");
  await engine.evaluate("return window.marey.command('play.first')");
}

async function playAndPause(engine) {
  await engine.press("Space");
  await until("the clip plays", async () => (await state(engine)).frame > 1);
  await engine.press("Space");
  await until("the clip pauses", async () => !(await state(engine)).playing);
}

async function dragCurve(engine) {
  await engine.click(middleOf(await findItem(engine, "outliner.joint.0")));
  await until("the joint is selected", async () => (await state(engine)).selection.activeJoint === 0);
  await findItem(engine, "curves.canvas");
  const { channels } = (await state(engine)).selection;
  const channel = channels[channels.length - 1];
  const at = await engine.evaluate(`return window.marey.command("curve.locate", { channel: ${channel}, frame: 11 })`);
  const start = { x: Math.round(at.x), y: Math.round(at.y) };
  await engine.drag(start, { x: start.x, y: start.y - 24 });
  await until("the drag is an edit", async () => (await state(engine)).undoDepth === 1);
  await engine.picture("edited");
  await engine.press("z", "Control");
  await until("the edit is undone", async () => (await state(engine)).undoDepth === 0);
}

/** Runs the page in an engine; throws what is wrong. */
export async function smokeTest(engine) {
  const site = await serveFolder(inRoot("dist"));
  try {
    await startPage(engine, `${site.url}/?sample=giant-swing`);
    await engine.picture("started");
    await playAndPause(engine);
    await dragCurve(engine);
    assert.deepEqual(await engine.evaluate("return window.problems"), []);
  } finally {
    await site.close();
  }
}
