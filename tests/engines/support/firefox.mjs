// Stock Firefox, driven by WebDriver BiDi. Only with a window has it WebGL 2 on a machine without a graphics card.
import { existsSync, mkdirSync } from "node:fs";
import { dirname } from "node:path";
import puppeteer from "puppeteer-core";
import { inRoot } from "../../../scripts/lib/shell.mjs";

const keys = { Space: " " };

export function findFirefox() {
  return [process.env.FIREFOX, "/usr/bin/firefox-esr", "/usr/bin/firefox"].find((path) => path && existsSync(path));
}

export async function startFirefox(executablePath) {
  const browser = await puppeteer.launch({
    browser: "firefox", executablePath, headless: false,
    extraPrefsFirefox: { "webgl.force-enabled": true, "browser.shell.checkDefaultBrowser": false },
  });
  const page = await browser.newPage();
  await page.setViewport({ width: 1200, height: 800 });
  return {
    goto: (url) => page.goto(url),
    evaluate: (body) => page.evaluate(`(() => { ${body} })()`),
    click: ({ x, y }) => page.mouse.click(x, y, { delay: 100 }),
    async drag(from, to) {
      await page.mouse.move(from.x, from.y);
      await page.mouse.down();
      await page.mouse.move(to.x, to.y, { steps: 6 });
      await page.mouse.up();
    },
    async press(key, modifier) {
      if (modifier) await page.keyboard.down(modifier);
      await page.keyboard.press(keys[key] ?? key, { delay: 60 });
      if (modifier) await page.keyboard.up(modifier);
    },
    async picture(name) {
      const path = inRoot("build", "screenshots", `firefox-${name}.png`);
      mkdirSync(dirname(path), { recursive: true });
      await page.screenshot({ path });
    },
    close: () => browser.close(),
  };
}
