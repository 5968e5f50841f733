// One page in the hands of the monkey, and what has to hold afterwards.
import { appendFileSync } from "node:fs";
import { chooseEvent, playEvent } from "./events.mjs";
import { randomFrom } from "./random.mjs";

/** Collects what may not happen. What the page says of a file that it refuses goes to its own messages. */
function watch(page) {
  const problems = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) || message.text().includes("imgui-error")) problems.push(`console: ${message.text()}`);
  });
  page.on("pageerror", (error) => problems.push(`uncaught: ${error.stack ?? error.message}`));
  page.on("crash", () => problems.push("the page crashed"));
  page.on("dialog", (dialog) => dialog.dismiss().catch(() => {}));
  page.on("popup", (popup) => popup.close().catch(() => {}));
  page.on("filechooser", () => {});
  page.on("download", (download) => download.cancel().catch(() => {}));
  return problems;
}

/** Widgets, commands and size, and what a file was when it was opened: files are known by their names. */
async function lookAt(page, opened) {
  const view = await page.evaluate(() => {
    const { file, undoDepth, redoDepth } = window.marey.state();
    return { file, fresh: undoDepth + redoDepth === 0, items: window.marey.ui.items(), commands: window.marey.commands().map(({ id }) => id) };
  });
  if (view.file !== null && !opened.has(view.file) && view.fresh) opened.set(view.file, await savedBytes(page));
  return { ...view, size: page.viewportSize() };
}

const savedBytes = (page) => page.evaluate(() => Array.from(window.marey.save(), (byte) => String.fromCharCode(byte)).join(""));

/** The page draws, answers, shows no failure, and undone to the start a file is as it was opened. */
async function checkAtEnd(page, opened) {
  const problems = [];
  const live = await page.evaluate(async () => {
    for (let i = 0; i < 3; i++) await window.marey.command("view.grid");
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const failed = !document.getElementById("failure").hidden;
    let steps = 0;
    while (window.marey.state().undoDepth > 0 && steps++ < 100_000) await window.marey.command("edit.undo");
    const items = window.marey.ui.items();
    const { file, undoDepth, dirty } = window.marey.state();
    return { failed, steps, undoDepth, dirty, file, shown: items.length, faults: items.filter(({ id }) => id.startsWith("fault.")).map(({ label }) => label) };
  });
  if (live.failed) problems.push("the page shows its failure");
  if (live.shown === 0) problems.push("the page shows nothing");
  if (live.undoDepth !== 0) problems.push(`${live.undoDepth} steps cannot be undone`);
  problems.push(...live.faults.map((label) => `a panel fails: ${label}`));
  const before = live.file === null ? undefined : opened.get(live.file);
  if (before !== undefined && (await savedBytes(page)) !== before) problems.push(`${live.file}, undone to the start, is not as it was opened`);
  return { problems, undone: live.steps };
}

/**
 * Plays events from a seed until `milliseconds` are over or something is wrong. `page` shows the site; `log` is a file for
 * the events, a line each. Gives { events, undone, problems }.
 */
export async function playRound(page, { seed, milliseconds, log }) {
  const problems = watch(page);
  const session = await page.context().newCDPSession(page);
  const random = randomFrom(seed);
  const opened = new Map();
  const end = Date.now() + milliseconds;
  let events = 0;
  await page.waitForFunction(() => window.marey?.ready.then(() => true));
  try {
    while (Date.now() < end && problems.length === 0) {
      const event = chooseEvent(random, await lookAt(page, opened));
      if (log) appendFileSync(log, `${JSON.stringify(event)}\n`);
      await playEvent(page, event, session);
      events++;
    }
    await page.waitForTimeout(300);
    const { problems: found, undone } = await checkAtEnd(page, opened);
    return { events, undone, problems: [...problems, ...found] };
  } catch (error) {
    return { events, undone: 0, problems: [...problems, `the page does not answer: ${error.message}`] };
  }
}
