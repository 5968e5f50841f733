// npm run monkey -- [MINUTES] [SEED]: uses the built page at random for MINUTES (5 if not given), in rounds of half a minute with the
// seeds from SEED on. A round is repeated by its seed; its events are in build/monkey.
import { chromium } from "@playwright/test";
import { existsSync, mkdirSync, rmSync } from "node:fs";
import { chromiumFlags, findChromium } from "./lib/chromium.mjs";
import { Failure, inRoot, main, say } from "./lib/shell.mjs";
import { serveFolder } from "./lib/static_server.mjs";
import { playRound } from "./monkey/round.mjs";

const roundMs = 30_000;
const folder = inRoot("build", "monkey");

function readArguments([minutes = "5", seed = "1"]) {
  if (!(Number(minutes) > 0)) throw new Failure(`"${minutes}" is no number of minutes`);
  if (!Number.isInteger(Number(seed))) throw new Failure(`"${seed}" is no whole number`);
  return { end: Date.now() + minutes * 60_000, firstSeed: Number(seed) };
}

async function playSeed(browser, site, seed, milliseconds) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, hasTouch: seed % 2 === 0, colorScheme: "dark" });
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  const page = await context.newPage();
  const log = `${folder}/${seed}.jsonl`;
  rmSync(log, { force: true });
  await page.goto(site);
  const result = await playRound(page, { seed, milliseconds, log });
  if (result.problems.length > 0) await page.screenshot({ path: `${folder}/${seed}.png` }).catch(() => {});
  await context.close();
  return { ...result, log };
}

await main(async () => {
  const { end, firstSeed } = readArguments(process.argv.slice(2));
  const site = process.env.MAREY_SITE ?? inRoot("dist");
  if (!existsSync(`${site}/index.html`)) throw new Failure("there is no built page; npm run build makes it");
  mkdirSync(folder, { recursive: true });
  const server = await serveFolder(site);
  const browser = await chromium.launch({ executablePath: findChromium(), args: chromiumFlags });
  let [rounds, events, findings] = [0, 0, 0];
  for (let seed = firstSeed; Date.now() < end; seed++) {
    const round = await playSeed(browser, server.url, seed, Math.min(roundMs, end - Date.now()));
    rounds += 1;
    events += round.events;
    if (round.problems.length === 0) continue;
    findings += 1;
    say(`seed ${seed}, ${round.events} events in ${round.log}:\n  ${round.problems.join("\n  ")}`);
  }
  await browser.close();
  await server.close();
  say(`${events} events in ${rounds} rounds, ${findings} findings`);
  if (findings > 0) process.exitCode = 1;
});
