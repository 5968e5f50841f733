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
  use: {
    viewport: { width: 1280, height: 800 },
    colorScheme: "dark",
    launchOptions: { executablePath: findChromium(), args: chromiumFlags },
  },
};
