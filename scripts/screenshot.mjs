// A picture of the page: node scripts/screenshot.mjs OUT.png [option...]; `--help` lists the options.
import { mkdirSync, readFileSync } from "node:fs";
import { basename, dirname, resolve } from "node:path";
import { parseArgs } from "node:util";
import { findChromium, chromiumFlags } from "./lib/chromium.mjs";
import { Failure, inRoot, main, say } from "./lib/shell.mjs";
import { serveFolder } from "./lib/static_server.mjs";

const help = `node scripts/screenshot.mjs OUT.png [option...]
  --url URL          page to open; default: the built site in dist/
  --site FOLDER      site to serve instead of dist/
  --query TEXT       behind the address, "sample=walk"
  --size WxH         window in CSS pixels, default 1280x800
  --dpr N            device pixels per CSS pixel, default 1
  --theme NAME       dark or light as the system's preference, default dark
  --touch            a touch screen
  --open FILE        open a BVH file; may be repeated
  --do STEP          what to do then, in order; may be repeated:
                       ID or ID=JSON       run a command: play.toggle, file.sample={"id":"walk"}
                       click:ITEM          click a widget; also rightclick:, doubleclick:, hover:
                       drag:ITEM:DX,DY     drag from a widget's middle; ITEM@X,Y starts X,Y behind its corner
                       key:CHORD           press "Control+k"; type:TEXT types
                       wait:MS
                       beside:FILE     put another BVH file beside the open one
  --items            print the visible widgets as JSON
  --state            print the page's state as JSON`;

const options = {
  url: { type: "string" }, site: { type: "string", default: inRoot("dist") }, query: { type: "string" },
  size: { type: "string", default: "1280x800" }, dpr: { type: "string", default: "1" },
  theme: { type: "string", default: "dark" }, touch: { type: "boolean" }, open: { type: "string", multiple: true },
  do: { type: "string", multiple: true }, items: { type: "boolean" }, state: { type: "boolean" }, help: { type: "boolean" },
};

/** Point in a widget: "ITEM" its middle, "ITEM@X,Y" behind its top left corner. */
async function findPoint(page, text) {
  const [id, offset] = text.split("@");
  const item = await page.evaluate((wanted) => window.marey.ui.items().find((found) => found.id === wanted), id);
  if (!item) throw new Failure(`the page shows no widget ${id}`);
  if (!offset) return { x: item.x + item.w / 2, y: item.y + item.h / 2 };
  const [x, y] = offset.split(",").map(Number);
  return { x: item.x + x, y: item.y + y };
}

async function drag(page, text) {
  const [from, distance] = text.split(":");
  const start = await findPoint(page, from);
  const [dx, dy] = distance.split(",").map(Number);
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  await page.mouse.move(start.x + dx, start.y + dy, { steps: 8 });
  await page.waitForTimeout(200);
  await page.mouse.up();
}

/** `how`: "open" or "openOther". */
function openFile(page, file, how) {
  const data = [basename(file), readFileSync(file, "latin1"), how];
  return page.evaluate(([name, text, method]) => window.marey[method](name, Uint8Array.from(text, (c) => c.charCodeAt(0))), data);
}

const steps = {
  click: async (page, text) => { const { x, y } = await findPoint(page, text); await page.mouse.click(x, y, { delay: 80 }); },
  rightclick: async (page, text) => { const { x, y } = await findPoint(page, text); await page.mouse.click(x, y, { delay: 80, button: "right" }); },
  doubleclick: async (page, text) => { const { x, y } = await findPoint(page, text); await page.mouse.dblclick(x, y, { delay: 60 }); },
  hover: async (page, text) => { const { x, y } = await findPoint(page, text); await page.mouse.move(x - 1, y); await page.mouse.move(x, y); await page.waitForTimeout(900); },
  drag,
  key: (page, text) => page.keyboard.press(text, { delay: 80 }),
  type: (page, text) => page.keyboard.type(text, { delay: 40 }),
  wait: (page, text) => page.waitForTimeout(Number(text)),
  beside: (page, file) => openFile(page, file, "openOther"),
};

async function runStep(page, step) {
  const [, name, text] = step.match(/^(\w+):(.*)$/s) ?? [];
  if (name && steps[name]) await steps[name](page, text);
  else {
    const [id, args] = step.split(/=(.*)/s);
    await page.evaluate(([command, value]) => window.marey.command(command, value), [id, args && JSON.parse(args)]);
  }
  await page.waitForTimeout(250);
}

async function openPage(values, address) {
  const executablePath = findChromium();
  if (!executablePath) throw new Failure("there is no Chromium; name one with CHROMIUM=");
  const { chromium } = await import("playwright-core");
  const browser = await chromium.launch({ executablePath, args: chromiumFlags });
  const [width, height] = values.size.split("x").map(Number);
  const page = await browser.newPage({
    viewport: { width, height }, deviceScaleFactor: Number(values.dpr), colorScheme: values.theme, hasTouch: values.touch,
  });
  page.on("console", (message) => console.error(`${message.type()}: ${message.text()}`));
  page.on("pageerror", (error) => console.error(`error: ${error.message}`));
  await page.goto(address);
  await page.waitForFunction(() => window.marey);
  await page.evaluate(() => window.marey.ready).catch((error) => console.error(error.message));
  return { browser, page };
}

async function takePicture(path, values, address) {
  const { browser, page } = await openPage(values, address);
  try {
    for (const file of values.open ?? []) await openFile(page, file, "open");
    for (const step of values.do ?? []) await runStep(page, step);
    await page.waitForTimeout(400);
    mkdirSync(dirname(resolve(path)), { recursive: true });
    await page.screenshot({ path });
    if (values.items) console.log(JSON.stringify(await page.evaluate(() => window.marey.ui.items()), null, 1));
    if (values.state) console.log(JSON.stringify(await page.evaluate(() => window.marey.state()), null, 1));
  } finally {
    await browser.close();
  }
}

await main(async () => {
  const { values, positionals: [path] } = parseArgs({ options, allowPositionals: true });
  if (values.help || !path) {
    console.log(help);
    return;
  }
  const server = values.url ? undefined : await serveFolder(values.site);
  const address = `${values.url ?? `${server.url}/`}${values.query ? `?${values.query}` : ""}`;
  try {
    await takePicture(path, values, address);
    say(`the picture is ${path}`);
  } finally {
    await server?.close();
  }
});
