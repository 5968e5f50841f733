// Kinematics and mechanics as in a lesson: a file is dropped, looked at under one cursor, smoothed, and what is plotted goes
// into the report as a table and as a picture.
import { readFileSync } from "node:fs";
import { inRoot } from "../../scripts/lib/shell.mjs";
import { drop } from "./support/drop.mjs";
import { expect, test } from "./support/fixtures.mjs";

const swing = readFileSync(inRoot("web", "samples", "giant-swing.bvh"), "utf8");

test.use({ viewport: { width: 1280, height: 900 } });

test.beforeEach(async ({ marey, page }) => {
  await marey.goto();
  await drop(page, [{ name: "swing.bvh", text: swing }]);
  await marey.expectState(({ file }) => file, "swing.bvh");
  await marey.press("Shift+M");
  await marey.expectState(({ analysis }) => analysis.plots.map(({ quantity }) => quantity),
    ["angle", "angular_velocity", "angular_acceleration", "torque"]);
});

async function downloadBy(marey, page, id) {
  const waiting = page.waitForEvent("download");
  await marey.click(id);
  const download = await waiting;
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

/** The table behind the lines of its origin: columns by name, and those lines. */
function readTable(text) {
  const lines = text.trim().split("\n");
  const origin = lines.filter((line) => line.startsWith("#"));
  const [head, ...rows] = lines.slice(origin.length).map((line) => line.split(","));
  return { origin, rows: rows.map((row) => Object.fromEntries(row.map((value, i) => [head[i], value]))) };
}

test("angle, velocity, acceleration and torque stand under one cursor, and go into a table", async ({ marey, page }) => {
  await marey.click("outliner.joint.1");
  await marey.expectState(({ analysis }) => analysis.plots.map(({ owner }) => owner), Array(4).fill("Body"));
  if ((await marey.state()).playing) await marey.press("Space");
  const { x, y } = await marey.point("plots.canvas.2", 0.5, 0.4);
  await page.mouse.click(x, y, { delay: 60 });
  await marey.drawn(3);
  const { frame, analysis } = await marey.state();
  expect(frame).toBe(11);
  await marey.picture("analysis");
  const torque = analysis.plots[3].values.z;
  expect((await marey.item("plots.value.3.Z")).label).toBe(torque.toFixed(Math.abs(torque) >= 100 ? 1 : 2));
  const { name, bytes } = await downloadBy(marey, page, "analysis.save_csv");
  expect(name).toBe("swing-plots.csv");
  const { origin, rows } = readTable(bytes.toString());
  expect(origin.join("\n")).toMatch(/# file: swing\.bvh\n# sha256: [0-9a-f]{64}\n# frames: 1 to 23.*\n# derivative: central/);
  expect(rows).toHaveLength(23);
  expect(Number(rows[frame]["torque:Body.z[N.m]"])).toBeCloseTo(torque, 9);
  expect(rows[0]["torque:Body.z[N.m]"]).toBe("");
  expect(Number(rows[frame]["angle:Body.z[rad]"])).toBeCloseTo((analysis.plots[0].values.z * Math.PI) / 180, 9);
});

test("smoothing and masses are chosen, and the plots follow", async ({ marey, page }) => {
  await marey.command("play.go_to_frame", { frame: 10 });
  const before = (await marey.state()).analysis.plots[3].values;
  await marey.click("analysis.body");
  await marey.click("body.derivation");
  await marey.click("body.derivation.butterworth");
  await marey.expectState(({ analysis }) => analysis.derivative, "butterworth:6");
  const smoothed = (await marey.state()).analysis.plots[3].values;
  expect(smoothed.z).not.toBeCloseTo(before.z, 3);
  await marey.picture("body");
  const { x, y } = await marey.point("body.derivation");
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, 400);
  await marey.click("body.mass", { clickCount: 2 });
  await marey.press("Control+a");
  await page.keyboard.type("140");
  await marey.press("Enter");
  await marey.expectState(({ undoName }) => undoName, "Change mass of the body");
  const heavy = (await marey.state()).analysis.plots[3].values;
  expect(heavy.z / smoothed.z).toBeCloseTo(140 / 73, 6);
  await marey.press("Control+z");
  await marey.expectState(({ analysis }) => analysis.plots[3].values.z, smoothed.z);
});

test("plots become pictures for print, and arrows stand on the body", async ({ marey, page }) => {
  const svg = await downloadBy(marey, page, "analysis.save_svg");
  expect(svg.name).toBe("swing-plots.svg");
  expect(svg.bytes.toString()).toContain("Joint torque [N·m]");
  const png = await downloadBy(marey, page, "analysis.save_png");
  expect(png.name).toBe("swing-plots.png");
  expect(png.bytes.subarray(0, 8).toString("latin1")).toBe("\x89PNG\r\n\x1a\n");
  expect(png.bytes.readUInt32BE(16)).toBe(2126);
  await marey.click("menu.Analyse");
  await marey.click("menu.view.com");
  await marey.command("view.arrows.force", { on: true });
  expect((await marey.item("viewport.arrows.2")).label).toMatch(/^Joint force \d+ N$/);
  await marey.picture("arrows");
});

test("quantities are added, set against each other, and told in numbers", async ({ marey }) => {
  await marey.click("plots.add");
  await marey.click("plots.add.kinetic_energy");
  await marey.expectState(({ analysis }) => analysis.plots.at(-1), {
    quantity: "kinetic_energy", owner: "whole body", frame: "", unit: "J", values: expect.anything(), others: [], bands: {},
  });
  await marey.click("plots.mode");
  await marey.click("plots.mode.against");
  await marey.item("plots.against.3");
  await marey.picture("against");
  await marey.click("plots.mode");
  await marey.click("plots.mode.statistics");
  await marey.item("plots.statistics.0.highest");
  await marey.picture("statistics");
});

test("the figure is let go, watched, and put back", async ({ marey }) => {
  const before = await marey.state();
  await marey.click("menu.Analyse");
  await marey.click("menu.analysis.let_go");
  await marey.expectState(({ undoDepth, playing }) => ({ undoDepth, playing }), { undoDepth: before.undoDepth + 1, playing: true });
  await marey.press("Space");
  await marey.picture("let-go");
  await marey.press("Control+z");
  await marey.expectState(({ undoDepth }) => undoDepth, before.undoDepth);
});

// Fixture D of the shared theory, section 7.3: 70 kg of average male proportions.
const gymnast = {
  metres_per_unit: 0.055,
  segments: [["Arms", 10, 0.0988, 0.5315, 0.2789], ["Body", 12, 0.504, 0.3158, 0.4435], ["Legs", 16, 0.3972, 0.2899, 0.2536]].map(
    ([joint, units, share, centre, radius]) => {
      const moment = 70 * share * (radius * 0.055 * units) ** 2;
      return { joint, mass_kg: 70 * share, com_m: [0, centre * 0.055 * units, 0], inertia_kgm2: [moment, 0, moment, 0, 0, 0] };
    }),
};

test("measured segments are dropped on the page, changed, and downloaded again", async ({ marey, page }) => {
  await drop(page, [{ name: "gymnast.json", text: JSON.stringify(gymnast) }]);
  await marey.expectState(({ file, undoName, metresPerUnit }) => ({ file, undoName, metresPerUnit }),
    { file: "swing.bvh", undoName: "Open a model of the body", metresPerUnit: 0.055 });
  await marey.command("view.curves", { on: false });
  await marey.click("outliner.joint.1");
  await marey.click("inspector.tab.body");
  expect((await marey.item("body.table")).label).toBe("Table");
  await marey.click("body.centre.0", { clickCount: 2 });
  await marey.press("Control+a");
  await page.keyboard.type("0.02");
  await marey.press("Enter");
  await marey.expectState(({ undoName }) => undoName, "Change a segment");
  await marey.picture("segment");
  await marey.click("menu.Analyse");
  const { name, bytes } = await downloadBy(marey, page, "menu.analysis.save_model");
  expect(name).toBe("swing-body.json");
  const saved = JSON.parse(bytes.toString());
  expect(saved.segments).toHaveLength(3);
  expect(saved.segments[1].com_m).toEqual([0.02, gymnast.segments[1].com_m[1], 0]);
  expect(saved.segments[2]).toEqual(gymnast.segments[2]);
  await drop(page, [{ name: "broken.json", text: "{ \"segments\": [" }]);
  await marey.expectState(({ messages }) => messages.map(({ title }) => title), ["broken.json could not be opened"]);
  await marey.press("Control+z");
  await marey.press("Control+z");
  await marey.expectState(({ dirty, undoDepth }) => ({ dirty, undoDepth }), { dirty: false, undoDepth: 0 });
});

test("clips are compared with each other", async ({ marey, page }) => {
  const slow = swing.replace(/Frame Time:.*/, "Frame Time: 0.05");
  await page.evaluate(async ([a, b]) => {
    await window.marey.openOther("again.bvh", a);
    await window.marey.openOther("slow.bvh", b);
  }, [swing, slow]);
  await marey.expectState(({ otherFiles }) => otherFiles, ["again.bvh", "slow.bvh"]);
  await marey.command("play.go_to_frame", { frame: 10 });
  const { analysis } = await marey.state();
  expect(analysis.plots[0].others).toHaveLength(2);
  expect(analysis.plots[0].others[0]).toEqual(analysis.plots[0].values);
  expect(analysis.plots[0].others[1].z).toBeLessThan(analysis.plots[0].values.z);
  await marey.picture("compared");
  await marey.click("plots.other.0.remove");
  await marey.expectState(({ otherFiles }) => otherFiles, ["slow.bvh"]);
});
