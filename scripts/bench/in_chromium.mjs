// The comparison with three.js in a page of Chromium.
import { copyFileSync, mkdirSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { chromiumFlags, findChromium } from "../lib/chromium.mjs";
import { inRoot } from "../lib/shell.mjs";
import { serveFolder } from "../lib/static_server.mjs";

async function buildPage(folder) {
  const { build } = await import("esbuild");
  mkdirSync(folder, { recursive: true });
  await build({ entryPoints: [inRoot("scripts/bench/page.mjs")], outfile: join(folder, "page.js"), bundle: true, format: "esm",
    target: "es2022", external: ["node:*"], logLevel: "warning" });
  copyFileSync(inRoot("dist/module/marey.wasm"), join(folder, "marey.wasm"));
  writeFileSync(join(folder, "index.html"), '<!doctype html><script type="module" src="page.js"></script>');
}

/** `clip`: path of a file in build/bench. Resolves to what compareWithThree gives, and the browser's version. */
export async function compareInChromium(clip) {
  const folder = inRoot("build", "bench");
  await buildPage(folder);
  const { chromium } = await import("@playwright/test");
  const server = await serveFolder(folder);
  const browser = await chromium.launch({ executablePath: findChromium(), args: chromiumFlags });
  try {
    const page = await browser.newPage();
    page.setDefaultTimeout(0);
    await page.goto(server.url);
    await page.waitForFunction(() => window.compare);
    const comparison = await page.evaluate((address) => window.compare(address), basename(clip));
    return { ...comparison, version: browser.version() };
  } finally {
    await browser.close();
    await server.close();
  }
}
