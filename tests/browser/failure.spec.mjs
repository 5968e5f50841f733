// The page says what is wrong, and what to do, when it cannot run.
import { expect, test } from "./support/fixtures.mjs";

const failure = (page) => page.getByRole("alert").filter({ has: page.getByRole("heading") });

test("without WebGL 2", async ({ page, site }) => {
  await page.addInitScript(() => {
    const original = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (type, ...rest) {
      return type.startsWith("webgl") ? null : original.call(this, type, ...rest);
    };
  });
  await page.goto(site);
  await expect(failure(page)).toContainText("This browser cannot draw Marey");
  await expect(failure(page)).toContainText("hardware acceleration");
  await expect(page.locator("#loading")).toBeHidden();
});

test("without WebAssembly", async ({ page, site }) => {
  await page.addInitScript(() => delete globalThis.WebAssembly);
  await page.goto(site);
  await expect(failure(page)).toContainText("This browser cannot run Marey");
});

test("when a part of the page does not arrive", async ({ page, site }) => {
  await page.route("**/app.wasm", (route) => route.fulfill({ status: 503 }));
  await page.goto(site);
  await expect(failure(page)).toContainText("app.wasm could not be loaded (the server answered 503)");
  await page.unroute("**/app.wasm");
  await page.getByRole("button", { name: "Load the page again" }).click();
  await page.waitForFunction(() => window.marey?.ready.then(() => true));
  await expect(failure(page)).toBeHidden();
});

test("`ready` is rejected when the page cannot start", async ({ page, site }) => {
  await page.route("**/fonts/icons.ttf", (route) => route.abort());
  await page.goto(site);
  const reason = await page.evaluate(() => window.marey.ready.then(() => "started", (error) => error.message));
  expect(reason).toContain("icons.ttf");
});

test("the loading bar stands in the theme's colours until the program has come", async ({ page, site }) => {
  let release;
  const held = new Promise((done) => (release = done));
  await page.route("**/app.wasm", async (route) => {
    await held;
    await route.continue();
  });
  await page.emulateMedia({ colorScheme: "light" });
  await page.goto(site);
  await expect(page.getByRole("progressbar", { name: "Loading" })).toBeVisible();
  const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  expect(await background()).toBe("rgb(236, 238, 241)");
  await page.emulateMedia({ colorScheme: "dark" });
  expect(await background()).toBe("rgb(20, 22, 26)");
  release();
  await page.evaluate(() => window.marey.ready);
  await expect(page.getByRole("progressbar")).toBeHidden();
});
