import { chromiumFlags, findChromium } from "../../scripts/lib/chromium.mjs";
import { inRoot } from "../../scripts/lib/shell.mjs";

export default {
  testDir: ".",
  testMatch: "*.spec.mjs",
  outputDir: inRoot("build", "browser-tests"),
  // WebGL is drawn in software here: two pages at once only get in each other's way.
  workers: 1,
  timeout: 60_000,
  expect: { timeout: 10_000 },
  forbidOnly: true,
  // A slow machine may lose a test to its pace; one that fails twice has failed. npm test names what was tried twice.
  retries: process.env.CI ? 1 : 0,
  use: {
    viewport: { width: 1280, height: 800 },
    colorScheme: "dark",
    launchOptions: { executablePath: findChromium(), args: chromiumFlags },
  },
};
