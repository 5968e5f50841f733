// What frames of the page cost the processor, in Chromium: each callback of requestAnimationFrame is timed, which draws
// one frame and hands it to the browser; what the graphics card then does is not in it.
import { cpSync, mkdirSync, rmSync, symlinkSync } from "node:fs";
import { basename, join } from "node:path";
import { chromiumFlags, findChromium } from "../lib/chromium.mjs";
import { inRoot } from "../lib/shell.mjs";
import { serveFolder } from "../lib/static_server.mjs";
import { benchClip } from "./clip.mjs";
import { median } from "./median.mjs";

const stepsMeasured = Number(process.env.STEPS ?? 25);

/**
 * In the page before it starts: times each frame into window.frameTimesMs. Vertices are handed to WebGL, but not drawn:
 * without a graphics card the processor would have to fill the pixels, and the frames would wait for it.
 */
function timeFrames() {
  window.frameTimesMs = [];
  for (const name of ["drawElements", "drawElementsInstanced", "drawArraysInstanced"]) {
    WebGL2RenderingContext.prototype[name] = () => undefined;
  }
  localStorage.setItem("marey.preferences", '{"welcomeSeen":true}');
  const request = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (callback) => request((nowMs) => {
    const begin = performance.now();
    callback(nowMs);
    window.frameTimesMs.push(performance.now() - begin);
  });
}

/** Takes steps, each of which the page answers with a few frames; median milliseconds of the slowest frame of a step. */
async function measureSteps(page, step, count = stepsMeasured) {
  const slowest = [];
  for (let i = -3; i < count; i++) {
    await page.evaluate(() => { window.frameTimesMs.length = 0; });
    await step(i);
    await page.waitForFunction(() => window.frameTimesMs.length >= 3, undefined, { polling: 20 });
    if (i >= 0) slowest.push(Math.max(...await page.evaluate(() => window.frameTimesMs)));
  }
  return median(slowest);
}

async function findItem(page, id) {
  return page.evaluate((wanted) => window.marey.ui.items().find((item) => item.id === wanted), id);
}

/** The pointer moves within the ground of the viewport: nothing else changes. */
const redraw = (page) => measureSteps(page, (i) => page.mouse.move(640 + (i & 1), 120));

/** A turn of the wheel over the curves, in and out again: each column of each curve is another one. */
async function zoom(page) {
  const { x, y, w, h } = await findItem(page, "curves.canvas");
  await page.mouse.move(x + w / 2, y + h / 2);
  return measureSteps(page, (i) => page.mouse.wheel(0, i & 1 ? -100 : 100));
}

/** Drags the frame cursor along the ruler. */
async function scrub(page) {
  const { x, y, w } = await findItem(page, "timeline.ruler");
  await page.mouse.move(x + w / 2, y + 4);
  await page.mouse.down();
  const time = await measureSteps(page, (i) => page.mouse.move(x + w * (0.1 + (0.8 * (((i + 3) * 37) % 100)) / 100), y + 4));
  await page.mouse.up();
  return time;
}

async function measurePlaying(page) {
  await page.evaluate(() => window.marey.command("play.toggle"));
  await page.waitForTimeout(500);
  const times = await page.evaluate(async () => {
    window.frameTimesMs.length = 0;
    await new Promise((done) => setTimeout(done, 4000));
    return window.frameTimesMs;
  });
  await page.evaluate(() => window.marey.command("play.toggle"));
  return median(times);
}

async function measureClip(page, address) {
  await page.evaluate(async (source) => {
    const bytes = new Uint8Array(await (await fetch(source)).arrayBuffer());
    await window.marey.open("big.bvh", bytes);
  }, address);
  const run = (id) => page.evaluate((command) => window.marey.command(command), id);
  await run("select.none");
  const without = await redraw(page);
  await run("select.all");
  await run("curve.fit");
  const results = { without, redraw: await redraw(page), zoom: await zoom(page), scrub: await scrub(page), playing: await measurePlaying(page) };
  return { ...results, curves: results.redraw - without };
}

/** The site with the clip beside it; gives the folder. */
function siteWithClip(clip) {
  const folder = inRoot("build", "bench", "site");
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  cpSync(inRoot("dist"), folder, { recursive: true });
  symlinkSync(clip, join(folder, basename(clip)));
  return folder;
}

/** Median milliseconds of a frame of the page with 100,000 frames of 201 channels. */
export async function measurePage() {
  const clip = benchClip({ joints: 66, frames: 100_000 });
  const server = await serveFolder(siteWithClip(clip));
  const { chromium } = await import("@playwright/test");
  const browser = await chromium.launch({ executablePath: findChromium(), args: chromiumFlags });
  try {
    const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
    page.setDefaultTimeout(0);
    await page.addInitScript(timeFrames);
    await page.goto(server.url);
    await page.waitForFunction(() => window.marey?.ready.then(() => true));
    return await measureClip(page, basename(clip));
  } finally {
    await browser.close();
    await server.close();
  }
}
