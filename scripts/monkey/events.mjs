// What the monkey can do. An event is a value that can be written down; `play` does it in the page.
import { makeClip } from "./clips.mjs";
import { randomFrom } from "./random.mjs";

const keys = ["Space", "Escape", "Enter", "Tab", "Shift+Tab", "ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home", "End", "PageUp",
  "Delete", "Backspace", "Control+z", "Control+Shift+z", "Control+y", "Control+k", "Control+a", "Control+s", "Control+v", "Alt+a", "[", "]",
  "f", "g", "l", "1", "2", "3", "?", "F1", "Shift+f", "+", "-", "Control+Shift+s", "w", "x", "Shift+ArrowRight"];
const sizes = [[1280, 800], [390, 844], [820, 900], [640, 360], [1600, 600], [320, 320]];
const words = ["knee", "12", "-3.5e2", "1e999", "右", "", "smooth", "0/0", "😀", "a".repeat(300)];
/** Commands that leave the page or ask the system for something. */
const withoutCommands = /^help\.(licence|source|documentation)|^file\.open$/;
const argumentsOfCommands = [undefined, undefined, undefined, {}, { frame: 7 }, { frame: -1 }, { joint: 1 }, { joint: 99999 }, { delta: 3, radius: 2 },
  { factor: 0.5, pivot: 0 }, { value: 12 }, { value: "x" }, { sigma: 2 }, { radius: 5 }, { seconds: 0.02 }, { seconds: 1e9 }, { metres: 0.01 },
  { first: 0, count: 2 }, { first: 5, count: 1e9 }, { channel: 0, first: 0, count: 9 }, { channel: 2, first: 1, count: 4, add: true },
  { yaw: 20, pitch: -5 }, { percent: 150 }, { percent: 100 }, { on: true }, { speed: 0.1 }, { form: "channels" }, { form: "positions", target: "blender" }, []];

/** How likely each kind of event is. */
const weights = { click: 20, move: 8, drag: 16, wheel: 10, doubleClick: 4, rightClick: 4, key: 22, type: 3, command: 20, undo: 8, open: 4,
  drop: 3, paste: 1, touch: 5, pinch: 2, resize: 1.5, theme: 1, context: 0.7, wait: 4, leave: 1 };

/** A point on the page: in a widget that is shown, or anywhere. */
function point(random, { items, size }) {
  const item = random.chance(0.75) && items.length > 0 ? random.pick(items) : { x: 0, y: 0, w: size.width, h: size.height };
  const inside = (low, extent, end) => Math.round(Math.min(Math.max(random.between(low, low + extent), 0), end - 1));
  return { x: inside(item.x, item.w, size.width), y: inside(item.y, item.h, size.height) };
}

const makers = {
  click: (random, view) => ({ ...point(random, view), delay: random.pick([0, 30]) }),
  move: (random, view) => point(random, view),
  drag: (random, view) => ({ from: point(random, view), to: point(random, view), steps: 1 + random.below(6), button: random.pick(["left", "left", "left", "right", "middle"]), key: random.pick(["", "", "", "Shift", "Control", "Escape"]) }),
  wheel: (random, view) => ({ ...point(random, view), dx: random.pick([0, 0, 120, -90]), dy: random.pick([100, -100, 400, -400, 7, -7]), key: random.pick(["", "", "Control", "Shift"]) }),
  doubleClick: (random, view) => point(random, view),
  rightClick: (random, view) => point(random, view),
  key: (random) => ({ chord: random.pick(keys), times: random.chance(0.1) ? 8 : 1 }),
  type: (random) => ({ text: random.pick(words) }),
  command: (random, { commands }) => ({ id: random.pick(commands.filter((id) => !withoutCommands.test(id))), args: random.pick(argumentsOfCommands) }),
  undo: (random) => ({ times: 1 + random.below(5), redo: random.chance(0.4) }),
  open: (random) => ({ seed: random.below(1e9) }),
  drop: (random) => ({ seed: random.below(1e9) }),
  paste: (random) => ({ text: random.pick(words) }),
  touch: (random, view) => ({ from: point(random, view), to: random.chance(0.5) ? point(random, view) : null }),
  pinch: (random, view) => ({ at: point(random, view), spread: random.between(-60, 80) }),
  resize: (random) => ({ size: random.pick(sizes) }),
  theme: (random) => ({ colorScheme: random.pick(["light", "dark"]), reducedMotion: random.pick(["reduce", "no-preference"]) }),
  context: (random) => ({ ms: random.below(400) }),
  wait: (random) => ({ ms: random.below(150) }),
  leave: () => ({}),
};

/** The next event. `view`: { items, commands, size } as the page shows them. */
export function chooseEvent(random, view) {
  const kind = random.weighted(weights);
  return { kind, ...makers[kind](random, view) };
}

async function held(page, key, act) {
  if (key) await page.keyboard.down(key);
  await act();
  if (key) await page.keyboard.up(key);
}

async function drag(page, { from, to, steps, button, key }) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down({ button });
  await held(page, key, () => page.mouse.move(to.x, to.y, { steps }));
  await page.mouse.up({ button });
}

function bytesOfClip(seed) {
  return { name: `monkey-${seed}.bvh`, text: makeClip(randomFrom(seed)) };
}

function drop(page, file) {
  return page.evaluate(({ name, text }) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([text], name));
    for (const type of ["dragenter", "dragover", "drop"]) {
      document.getElementById("canvas").dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
    }
  }, file);
}

async function touch(session, from, to) {
  const at = ({ x, y }, id = 0) => ({ x, y, id });
  await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [at(from)] });
  if (to) await session.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: [at(to)] });
  await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
}

async function pinch(session, { x, y }, spread) {
  const at = (distance) => [{ x: Math.max(x - distance, 0), y, id: 0 }, { x: x + distance, y, id: 1 }];
  await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: at(70) });
  for (const share of [0.5, 1]) await session.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: at(70 + spread * share) });
  await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
}

function loseContext(page, ms) {
  return page.evaluate(async (pause) => {
    const canvas = document.getElementById("canvas");
    window.loseContext ??= canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
    const heard = (type) => new Promise((done) => canvas.addEventListener(type, done, { once: true }));
    const lost = heard("webglcontextlost");
    window.loseContext.loseContext();
    await lost;
    await new Promise((done) => setTimeout(done, pause));
    const restored = heard("webglcontextrestored");
    window.loseContext.restoreContext();
    await restored;
  }, ms);
}

const players = {
  click: (page, { x, y, delay }) => page.mouse.click(x, y, { delay }),
  move: (page, { x, y }) => page.mouse.move(x, y),
  drag,
  async wheel(page, { x, y, dx, dy, key }) {
    await page.mouse.move(x, y);
    await held(page, key, () => page.mouse.wheel(dx, dy));
  },
  doubleClick: (page, { x, y }) => page.mouse.dblclick(x, y),
  rightClick: (page, { x, y }) => page.mouse.click(x, y, { button: "right" }),
  async key(page, { chord, times }) {
    for (let i = 0; i < times; i++) await page.keyboard.press(chord);
  },
  type: (page, { text }) => page.keyboard.insertText(text),
  // What a command refuses is its own affair.
  command: (page, { id, args }) => page.evaluate(([name, value]) => window.marey.command(name, value).then(() => {}, () => {}), [id, args]),
  undo: (page, { times, redo }) => page.evaluate(async ([count, name]) => {
    for (let i = 0; i < count; i++) await window.marey.command(name).catch(() => {});
  }, [times, redo ? "edit.redo" : "edit.undo"]),
  open: (page, { seed }) => page.evaluate(({ name, text }) => window.marey.open(name, text).then(() => {}, () => {}), bytesOfClip(seed)),
  drop: (page, { seed }) => drop(page, bytesOfClip(seed)),
  async paste(page, { text }) {
    await page.evaluate((words) => navigator.clipboard.writeText(words), text);
    await page.keyboard.press("Control+v");
  },
  touch: (page, { from, to }, session) => touch(session, from, to),
  pinch: (page, { at, spread }, session) => pinch(session, at, spread),
  resize: (page, { size: [width, height] }) => page.setViewportSize({ width, height }),
  theme: (page, media) => page.emulateMedia(media),
  context: (page, { ms }) => loseContext(page, ms),
  wait: (page, { ms }) => page.waitForTimeout(ms),
  leave: (page) => page.mouse.move(0, 0),
};

/** `session`: a CDP session of the page. */
export function playEvent(page, event, session) {
  return players[event.kind](page, event, session);
}
