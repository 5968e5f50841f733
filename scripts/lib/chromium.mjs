// The system's Chromium for screenshots and tests of the page.
import { existsSync } from "node:fs";

/** Without a graphics card Chromium draws WebGL 2 in software; it speaks to no server of its own. */
export const chromiumFlags = [
  "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "--disable-quic",
  "--disable-background-networking", "--disable-component-update", "--disable-sync",
];

const places = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome",
  "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome"];

/** Path of the browser: CHROMIUM or where systems put it; undefined when there is none. */
export function findChromium() {
  return [process.env.CHROMIUM, ...places].find((path) => path && existsSync(path));
}
