import { expect } from "@playwright/test";
import { inRoot } from "../../../scripts/lib/shell.mjs";

/** The page as a test sees it: widgets are found by the ids that `window.marey.ui.items()` gives. */
export class MareyPage {
  constructor(page, site) {
    this.page = page;
    this.site = site;
  }

  /** Opens the page and waits until it has started. `query`: "?sample=walk". */
  async goto(query = "") {
    await this.page.goto(`${this.site}/${query}`);
    await this.ready();
  }

  async ready() {
    await this.page.waitForFunction(() => window.marey?.ready.then(() => true));
  }

  state() {
    return this.page.evaluate(() => window.marey.state());
  }

  items() {
    return this.page.evaluate(() => window.marey.ui.items());
  }

  command(id, args) {
    return this.page.evaluate(([name, value]) => window.marey.command(name, value), [id, args]);
  }

  /** Opens a file through the page's API. */
  open(name, text) {
    return this.page.evaluate(([fileName, data]) => window.marey.open(fileName, data), [name, text]);
  }

  /** What Download would give, as text. */
  save() {
    return this.page.evaluate(() => new TextDecoder().decode(window.marey.save()));
  }

  /** A visible widget once it is there and has come to rest. */
  async item(id) {
    let found;
    let before;
    await expect.poll(async () => {
      before = found;
      found = (await this.items()).find((item) => item.id === id);
      return found !== undefined && before !== undefined && found.x === before.x && found.y === before.y;
    }, { message: `the widget ${id} is not shown` }).toBe(true);
    return found;
  }

  /** A point in a widget; `fx`, `fy` from 0 to 1. */
  async point(id, fx = 0.5, fy = 0.5) {
    const { x, y, w, h } = await this.item(id);
    return { x: x + fx * w, y: y + fy * h };
  }

  async click(id, options = {}) {
    const { x, y } = await this.point(id);
    await this.page.mouse.move(x, y);
    await this.page.mouse.click(x, y, { delay: 60, ...options });
  }

  /** Drags with the mouse from one point to another, in steps that the page sees. */
  async drag(from, to, { steps = 6, button = "left" } = {}) {
    const { mouse } = this.page;
    await mouse.move(from.x, from.y);
    await mouse.down({ button });
    for (let i = 1; i <= steps; i++) {
      await mouse.move(from.x + ((to.x - from.x) * i) / steps, from.y + ((to.y - from.y) * i) / steps);
      await this.drawn();
    }
    await mouse.up({ button });
    await this.drawn(3);
  }

  async press(chord) {
    await this.page.keyboard.press(chord, { delay: 40 });
    await this.drawn(3);
  }

  /**
   * Gives a file to the picker that `ask` opens. The browser hears of being watched for pickers and of keys by ways of
   * their own, of which the second can be quicker: the answer to a question comes after the first has been heard.
   */
  async chooseFile(path, ask) {
    const chooser = this.page.waitForEvent("filechooser");
    await this.drawn();
    await ask();
    await (await chooser).setFiles(path);
  }

  /** Waits until the page has drawn so many frames, or would have if there had been any to draw. */
  drawn(frames = 1) {
    return this.page.evaluate(async (count) => {
      for (let i = 0; i < count; i++) await new Promise((done) => requestAnimationFrame(done));
    }, frames);
  }

  /** Waits until a value of the state is what is expected. */
  async expectState(read, expected) {
    await expect.poll(async () => read(await this.state())).toEqual(expected);
  }

  /** Keeps a picture of the page for people to look at. */
  async picture(name) {
    await this.drawn(2);
    await this.page.screenshot({ path: inRoot("build", "screenshots", `${name}.png`) });
  }
}
