// The Content-Security-Policy of the page: nothing of a whole tour offends it, and what it forbids does not happen.
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { armClip, brokenClip } from "./support/clips.mjs";
import { expect, siteFolder, test } from "./support/fixtures.mjs";

function collectViolations() {
  window.violations = [];
  document.addEventListener("securitypolicyviolation", ({ violatedDirective, blockedURI, sample }) => {
    window.violations.push(`${violatedDirective} ${blockedURI} ${sample}`);
  });
}

const violations = (page) => page.evaluate(() => window.violations);

async function makeTour(marey, page) {
  await marey.open("names.bvh", armClip().replace("Elbow", "右肩"));
  await marey.command("curve.select", { channel: 1, first: 2, count: 5 });
  await marey.command("curve.move", { delta: 3 });
  await marey.command("play.toggle");
  await marey.drawn(4);
  await marey.command("play.toggle");
  for (const id of ["help.commands", "help.shortcuts", "help.about", "file.samples", "file.save_as"]) {
    await marey.command(id);
    await marey.drawn(3);
    await marey.press("Escape");
  }
  const download = page.waitForEvent("download");
  await marey.command("file.save_as", { form: "channels" });
  await (await download).path();
  await page.evaluate((text) => window.marey.open("broken.bvh", text).catch(() => {}), brokenClip);
  await marey.command("view.theme.light");
  await marey.command("file.sample.pendulum");
  await marey.expectState(({ file }) => file, "pendulum.bvh");
  await marey.drawn(4);
}

/** What becomes of each thing that the policy forbids; tried when no test is on the stack. */
function tryForbiddenThings() {
  const attempts = {
    eval: () => (0, eval)("window.evaluated = 1"),
    "new Function": () => new Function("window.evaluated = 1")(),
    "a timer of text": () => setTimeout("window.evaluated = 1"),
    "an inline script": () => {
      const script = document.createElement("script");
      script.append("window.evaluated = 1");
      document.body.append(script);
    },
    "an event attribute": () => {
      const button = document.createElement("button");
      button.setAttribute("onclick", "window.evaluated = 1");
      document.body.append(button);
      button.click();
      button.remove();
    },
    "HTML of text": () => (document.getElementById("status").innerHTML = "<img src=x onerror='window.evaluated = 1'>"),
    "a worker": () => new Worker("main.js"),
    "a frame": () => {
      const frame = document.createElement("iframe");
      frame.src = "icon.svg";
      document.body.append(frame);
    },
    "a style attribute": () => document.body.setAttribute("style", "outline: 7px solid"),
  };
  return new Promise((done) => setTimeout(async () => {
    // Some are refused at once, some when they are to run.
    for (const attempt of Object.values(attempts)) await Promise.resolve().then(attempt).catch(() => {});
    setTimeout(() => done({
      evaluated: window.evaluated ?? null,
      outline: getComputedStyle(document.body).outlineWidth === "7px",
      refused: [...new Set(window.violations.map((text) => text.split(" ")[0]))].sort(),
    }), 300);
  }));
}

/** Trusted types refuse text that would become script before any other rule is asked. */
const expectedRefusals = ["frame-src", "require-trusted-types-for", "style-src-attr"];

const pages = [
  ["the site", (site) => site],
  ["the page as one file", () => pathToFileURL(join(siteFolder, "marey.html")).href],
];
for (const [name, addressOf] of pages) {
  test(`${name}: a tour offends no rule`, async ({ marey, page, site }) => {
    await page.addInitScript(collectViolations);
    await page.goto(addressOf(site));
    await marey.ready();
    await makeTour(marey, page);
    expect(await violations(page)).toEqual([]);
  });

  test(`${name}: text does not become script, and nothing else gets in`, async ({ marey, page, site, expectedProblems }) => {
    // A frame that is refused shows a page of the browser's, in which the fixture's script finds no storage.
    expectedProblems.push(/Content Security Policy|TrustedHTML|TrustedScript|Trusted Type|'localStorage' property/i);
    await page.addInitScript(collectViolations);
    await page.goto(addressOf(site));
    await marey.ready();
    const { evaluated, outline, refused } = await page.evaluate(tryForbiddenThings);
    expect(evaluated).toBeNull();
    expect(outline).toBe(false);
    for (const directive of expectedRefusals) expect.soft(refused).toContain(directive);
  });
}
