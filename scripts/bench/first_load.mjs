// How long the page takes from its address to the first frame and to a loaded sample, in Chromium.
import { chromiumFlags, findChromium } from "../lib/chromium.mjs";
import { inRoot } from "../lib/shell.mjs";
import { serveFolder } from "../lib/static_server.mjs";
import { median } from "./median.mjs";

const loads = 7;

/** In the page before it starts: milliseconds since the navigation began, when WebGL first draws and when all is ready. */
function noteTimes() {
  window.loadTimesMs = {};
  const draw = WebGL2RenderingContext.prototype.drawElements;
  WebGL2RenderingContext.prototype.drawElements = function note(...args) {
    window.loadTimesMs.firstFrame ??= performance.now();
    return draw.apply(this, args);
  };
  const waiting = setInterval(() => {
    if (!window.marey) return;
    clearInterval(waiting);
    void window.marey.ready.then(() => { window.loadTimesMs.sample = performance.now(); });
  }, 1);
}

async function loadOnce(browser, address) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
  const page = await context.newPage();
  await page.addInitScript(noteTimes);
  await page.goto(address);
  await page.waitForFunction(() => window.loadTimesMs.sample !== undefined && window.loadTimesMs.firstFrame !== undefined);
  const times = await page.evaluate(() => window.loadTimesMs);
  await context.close();
  return times;
}

/** Median milliseconds of cold loads, each in a browser context of its own, the first of all unmeasured. */
export async function measureFirstLoad() {
  const { chromium } = await import("@playwright/test");
  const server = await serveFolder(inRoot("dist"));
  const browser = await chromium.launch({ executablePath: findChromium(), args: chromiumFlags });
  try {
    const address = `${server.url}/?sample=walk`;
    await loadOnce(browser, address);
    const times = [];
    for (let i = 0; i < loads; i++) times.push(await loadOnce(browser, address));
    return { firstFrame: median(times.map((time) => time.firstFrame)), sample: median(times.map((time) => time.sample)) };
  } finally {
    await browser.close();
    await server.close();
  }
}
