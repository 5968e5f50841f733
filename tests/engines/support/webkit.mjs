// WebKitGTK's MiniBrowser, driven by plain WebDriver.
import { spawn } from "node:child_process";
import { existsSync, mkdirSync, readdirSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import { dirname, join } from "node:path";
import { setTimeout as wait } from "node:timers/promises";
import { inRoot } from "../../../scripts/lib/shell.mjs";

const keys = { Space: " ", Control: "\ue009", Escape: "\ue00c" };

/** Paths of the driver and of MiniBrowser, or undefined when one is missing. */
export function findWebKit() {
  const driver = ["/usr/bin/WebKitWebDriver"].find(existsSync);
  const libraries = ["/usr/lib/x86_64-linux-gnu", "/usr/lib/aarch64-linux-gnu"].filter(existsSync);
  const browsers = libraries.flatMap((folder) => readdirSync(folder).filter((name) => /^webkit2?gtk-\d/.test(name)).sort().reverse()
    .map((name) => join(folder, name, "MiniBrowser")));
  const browser = browsers.find(existsSync);
  return driver && browser ? { driver, browser } : undefined;
}

function findFreePort() {
  return new Promise((done) => {
    const server = createServer().listen(0, "127.0.0.1", () => {
      const { port } = server.address();
      server.close(() => done(port));
    });
  });
}

async function call(method, url, body) {
  const response = await fetch(url, { method, body: body === undefined ? undefined : JSON.stringify(body) });
  const { value } = await response.json();
  if (!response.ok) throw new Error(`WebDriver: ${value.error}: ${value.message}`);
  return value;
}

async function startSession(base, browser) {
  const options = { "webkitgtk:browserOptions": { binary: browser, args: ["--automation"] } };
  for (let attempt = 0; ; attempt++) {
    try {
      return await call("POST", `${base}/session`, { capabilities: { alwaysMatch: options } });
    } catch (error) {
      if (attempt === 50 || !/fetch failed/.test(error.message)) throw error;
      await wait(100);
    }
  }
}

const moveTo = ({ x, y }, duration = 0) => ({ type: "pointerMove", duration, x, y });
const pause = (duration) => ({ type: "pause", duration });

function makeEngine(session) {
  const act = (...actions) => call("POST", `${session}/actions`, { actions });
  const point = (actions) => act({ type: "pointer", id: "mouse", parameters: { pointerType: "mouse" }, actions });
  const down = { type: "pointerDown", button: 0 };
  const up = { type: "pointerUp", button: 0 };
  return {
    goto: (url) => call("POST", `${session}/url`, { url }),
    evaluate: (body) => call("POST", `${session}/execute/async`, {
      script: `const done = arguments[0]; Promise.resolve((() => { ${body} })()).then((value) => done(value ?? null));`, args: [],
    }),
    click: (at) => point([moveTo(at), pause(100), down, pause(100), up]),
    drag(from, to) {
      const steps = [1, 2, 3, 4, 5, 6].map((i) => ({
        x: Math.round(from.x + ((to.x - from.x) * i) / 6), y: Math.round(from.y + ((to.y - from.y) * i) / 6),
      }));
      return point([moveTo(from), pause(200), down, pause(200), ...steps.flatMap((at) => [moveTo(at), pause(100)]), up]);
    },
    press(key, modifier) {
      const chord = [modifier, key].filter(Boolean).map((name) => keys[name] ?? name);
      const downs = chord.map((value) => ({ type: "keyDown", value }));
      const ups = [...chord].reverse().map((value) => ({ type: "keyUp", value }));
      return act({ type: "key", id: "keyboard", actions: [...downs, pause(80), ...ups] });
    },
    async picture(name) {
      const path = inRoot("build", "screenshots", `webkit-${name}.png`);
      mkdirSync(dirname(path), { recursive: true });
      writeFileSync(path, Buffer.from(await call("GET", `${session}/screenshot`), "base64"));
    },
  };
}

export async function startWebKit({ driver, browser }) {
  const port = await findFreePort();
  const process = spawn(driver, [`--port=${port}`, "--host=127.0.0.1"], { stdio: "ignore" });
  try {
    const base = `http://127.0.0.1:${port}`;
    const session = `${base}/session/${(await startSession(base, browser)).sessionId}`;
    await call("POST", `${session}/timeouts`, { script: 60_000 });
    await call("POST", `${session}/window/rect`, { width: 1200, height: 850 });
    const close = async () => {
      await call("DELETE", session).catch(() => {});
      process.kill();
    };
    return { ...makeEngine(session), close };
  } catch (error) {
    process.kill();
    throw error;
  }
}
