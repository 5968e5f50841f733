// The page in other engines than Chromium's. Needs a screen, Xvfb's for example.
import { test } from "node:test";
import { findFirefox, startFirefox } from "./support/firefox.mjs";
import { smokeTest } from "./support/smoke.mjs";
import { findWebKit, startWebKit } from "./support/webkit.mjs";

const missing = (name) => (process.env.DISPLAY ? `there is no ${name} here` : "there is no screen; try xvfb-run");

async function runIn(start, found) {
  const engine = await start(found);
  try {
    await smokeTest(engine);
  } finally {
    await engine.close();
  }
}

const firefox = process.env.DISPLAY && findFirefox();
test("Firefox runs the page", { skip: firefox ? false : missing("Firefox"), timeout: 240_000 }, () => runIn(startFirefox, firefox));

const webKit = process.env.DISPLAY && findWebKit();
test("WebKit runs the page", { skip: webKit ? false : missing("WebKit with its driver"), timeout: 240_000 }, () => runIn(startWebKit, webKit));
