// The pictures of docs/operations.md that only the page can show, of keys and of layers, before and after the operation:
// npm run build, then node scripts/page_pictures.mjs [OPERATION...]
import { readFileSync, writeFileSync } from "node:fs";
import { chromiumFlags, findChromium } from "./lib/chromium.mjs";
import { Failure, inRoot, main } from "./lib/shell.mjs";
import { serveFolder } from "./lib/static_server.mjs";

const knee = "joints=LeftKnee channels=Xrotation";
const keyed = `to-keys tolerance=2 ${knee}`;
const layers = ["layer-add name=Straighter", "layer-add name='Arms out'"];
const onLayer = ["layer-add name=Straighter", `key layer=Straighter ${knee} frame=60 value=0 of=layer`,
  `key layer=Straighter ${knee} frame=90 value=-30 of=layer`, `key layer=Straighter ${knee} frame=120 value=0 of=layer`];

/** `shows` is the part of the page: the curves, or the list of layers. */
const pictures = {
  "to-samples": { shows: "curves", before: [keyed], step: `to-samples ${knee}` },
  "key-insert": { shows: "curves", before: [keyed], step: `key-insert ${knee} frame=100` },
  "layer-add": { shows: "layers", before: layers.slice(0, 1), step: layers[1] },
  "layer-rename": { shows: "layers", before: layers, step: "layer-rename layer='Arms out' name='Arms in'" },
  "layer-order": { shows: "layers", before: layers, step: "layer-order layer='Arms out' to=1" },
  "layer-lock": { shows: "layers", before: layers, step: "layer-lock layer=Straighter" },
  "layers-bake": { shows: "layers", before: onLayer, step: "layers-bake" },
};

/** The part of the page that a picture shows, in CSS pixels. */
const parts = {
  curves: (item) => ({ x: 0, y: item.y - 4, width: 1280, height: 800 - item.y + 4 }),
  layers: (item) => ({ x: 980, y: item.y - 8, width: 300, height: 300 }),
};

async function openPage(browser, url) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 }, colorScheme: "light" });
  await page.addInitScript(() => localStorage.setItem("marey.preferences", JSON.stringify({ welcomeSeen: true })));
  await page.goto(`${url}?sample=walk`);
  await page.waitForFunction(() => window.marey);
  await page.evaluate(() => window.marey.ready);
  return page;
}

const run = (page, id, args) => page.evaluate(([command, value]) => window.marey.command(command, value), [id, args]);

async function edit(page, step) {
  const answer = await run(page, "edit.operation", { do: step });
  if (!answer?.changed) throw new Failure(`${step}: ${JSON.stringify(answer)}`);
}

async function shoot(page, { shows }, path) {
  await page.mouse.move(640, 300);
  await page.waitForTimeout(700);
  const items = await page.evaluate(() => window.marey.ui.items());
  const item = items.find(({ id }) => id === (shows === "curves" ? "timeline.ruler" : "inspector.tab.layers"));
  await page.screenshot({ path, clip: parts[shows](item) });
}

async function picture(browser, url, id) {
  const page = await openPage(browser, url);
  const knees = await page.evaluate(() => window.marey.ui.items().filter(({ label }) => label === "LeftKnee"));
  await page.mouse.click(knees[0].x + 60, knees[0].y + knees[0].h / 2);
  await run(page, "view.layers");
  for (const step of pictures[id].before) await edit(page, step);
  const file = (name) => inRoot("docs", "images", "operations", `${id}-${name}.png`);
  await shoot(page, pictures[id], file("before"));
  await edit(page, pictures[id].step);
  await shoot(page, pictures[id], file("after"));
  await page.close();
}

function addToManual(ids) {
  let manual = readFileSync(inRoot("docs", "operations.md"), "utf8");
  for (const id of ids) {
    const images = `![${id}: before](images/operations/${id}-before.png)\n![${id}: after](images/operations/${id}-after.png)`;
    if (!manual.includes(images)) manual = manual.replace(new RegExp(`(### ${id}\n\n[^\n]*\n)`), (text) => `${text}\n${images}\n`);
  }
  writeFileSync(inRoot("docs", "operations.md"), manual);
}

await main(async () => {
  const ids = process.argv.length > 2 ? process.argv.slice(2) : Object.keys(pictures);
  const executablePath = findChromium();
  if (!executablePath) throw new Failure("there is no Chromium; name one with CHROMIUM=");
  const { chromium } = await import("playwright-core");
  const [server, browser] = await Promise.all([serveFolder(process.env.MAREY_SITE ?? inRoot("dist")),
    chromium.launch({ executablePath, args: chromiumFlags })]);
  try {
    for (const id of ids) await picture(browser, `${server.url}/`, id);
    addToManual(ids);
  } finally {
    await browser.close();
    await server.close();
  }
});
