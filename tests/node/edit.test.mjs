// marey edit as people and programs call it, and the manual beside the table of operations.
import assert from "node:assert/strict";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { refused, root, run, sample, sampleNames, smallClip, succeed, swing } from "./support/cli.mjs";

let folder;
before(() => { folder = mkdtempSync(join(tmpdir(), "marey-edit-")); });
after(() => rmSync(folder, { recursive: true }));

function scratch(name, content) {
  const path = join(folder, name);
  writeFileSync(path, content);
  return path;
}

const table = JSON.parse(succeed(["edit", "--list", "--json"])).operations;
const edit = (file, ...steps) => succeed(["edit", file, "-", ...steps.flatMap((step) => ["--do", step])]);
const clip = () => scratch("clip.bvh", smallClip({ frames: 5, rows: ["0", "10", "20", "30", "40"] }));
const rowsOf = (text) => text.trimEnd().split("\n").slice(13);

describe("marey edit", () => {
  test("takes steps in their order", () => {
    assert.deepEqual(rowsOf(edit(clip(), "offset by=5 frames=2:3")), ["0", "15", "25", "30", "40"]);
    assert.deepEqual(rowsOf(edit(clip(), "scale factor=2 pivot=first", "offset by=1")), ["1", "21", "41", "61", "81"]);
    assert.deepEqual(rowsOf(edit(clip(), "offset by=1", "scale factor=2 pivot=value")), ["2", "22", "42", "62", "82"]);
    assert.deepEqual(rowsOf(edit(clip(), "trim frames=2:4", "reverse")), ["30", "20", "10"]);
  });

  test("a step that changes nothing gives back the file byte for byte", () => {
    for (const name of sampleNames) {
      const text = readFileSync(sample(name), "latin1");
      assert.equal(edit(sample(name), "offset by=0", "trim"), text, name);
    }
  });

  test("frames that an edit adds and takes away leave the others as they are written", () => {
    const lines = readFileSync(swing, "latin1").split("\n");
    const first = lines.findIndex((line) => line.startsWith("Frame Time")) + 1;
    const edited = edit(swing, "retime speed=2").split("\n");
    assert.deepEqual(edited.slice(first, first + 3), [lines[first], lines[first + 2], lines[first + 4]]);
    assert.equal(edit(swing, "retime speed=0.5", "retime speed=2"), readFileSync(swing, "latin1"));
  });

  test("a recipe says the same as steps do", () => {
    const recipe = [
      { do: "smooth", sigma: 1.5, frames: [2, 20], channels: ["Zrotation"], "blend-in": 2 },
      { do: "mirror" },
      { do: "zero-start", heading: false },
      { do: "warp", points: [[1, 1], [10, 15]] },
    ];
    const file = scratch("recipe.json", JSON.stringify(recipe));
    const bySteps = edit(swing, "smooth sigma=1.5 frames=2:20 channels=Zrotation blend-in=2", "mirror", "zero-start heading=no", "warp points=1:1,10:15");
    assert.equal(succeed(["edit", swing, "-", "--recipe", file]), bySteps);
    assert.equal(succeed(["edit", swing, "-", "--recipe", "-"], JSON.stringify(recipe)), bySteps);
  });

  test("tells what was done as JSON and notes on standard error", () => {
    const out = join(folder, "out.bvh");
    const { steps } = JSON.parse(succeed(["edit", swing, out, "--do", "despike", "--do", "offset by=1 joints=Arms", "--json"]));
    assert.deepEqual(steps.map(({ do: id }) => id), ["despike", "offset"]);
    assert.match(steps[0].notes[0], /spikes? (was|were) taken out\.$/);
    assert.equal(steps[1].changed, true);
    assert.match(run(["edit", swing, "-", "--do", "despike"]).stderr, /^[^\n]*: note: despike: [^\n]*\n$/);
  });

  test("another clip is appended", () => {
    const out = edit(clip(), `append from=${clip()} blend=0 align=no`);
    assert.equal(rowsOf(out).length, 10);
    refused(["edit", clip(), "-", "--do", `append from=${join(folder, "none.bvh")}`], /none\.bvh: error: The file cannot be opened/);
  });

  test("changes the figure and gives back the file when it is changed back", () => {
    const there = scratch("there.bvh", edit(swing, "rename from=* to=my_*", "up-axis to=z"));
    assert.match(readFileSync(there, "latin1"), /ROOT my_Arms[\s\S]*CHANNELS \d [^\n]*Yrotation/);
    const text = readFileSync(swing, "latin1");
    assert.equal(edit(swing, "rename from=* to=my_*", "rename from=my_* to=*"), text);
    assert.match(edit(swing, "change-order order=xyz"), /Xrotation Yrotation Zrotation/);
  });

  test("refuses what it does not know, with place and nearest name", () => {
    const wrong = (step) => ["edit", clip(), "-", "--do", "reverse", "--do", step];
    refused(wrong("smoth"), /^marey: error: Step 2 \(smoth\), column 1: 'smoth' is no operation\. Did you mean 'smooth'\?$/m);
    refused(wrong("smooth sigma=x"), /^marey: error: Step 2 \(smooth\), column 8: 'sigma' is a number, not "x"\.$/m);
    refused(wrong("smooth joints=hip"), /column 8: No joint is called "hip"\. Did you mean 'Hips'\?$/m);
    refused(wrong("smooth 'sigma=1"), /column 8: A quote is not closed\.$/m);
    refused(wrong("butterworth cutoff=6"), /Step 2 \(butterworth\): 'cutoff' is below half the frame rate, 5 Hz, not 6\.$/m);
    refused(wrong("cut"), /Step 2 \(cut\): A clip keeps one frame at least\.$/m);
    refused(["edit", clip(), "-"], /--do/);
    refused(["edit", clip(), "-", "--json", "--do", "reverse"], /--json/);
    refused(["edit", "--help-operation", "smoth"], /Did you mean 'smooth'/);
  });

  test("refuses recipes that are none", () => {
    const recipe = (text) => ["edit", clip(), "-", "--recipe", scratch("wrong.json", text)];
    refused(recipe("[{"), /wrong\.json:1:3: error: The recipe is not valid JSON\.$/m);
    refused(recipe("{}"), /is not a list of steps/);
    refused(recipe('[{"sigma": 2}]'), /Step 1 is not an object with "do"/);
    refused(recipe('[{"do": "smooth", "sigma": null}]'), /Step 1: "sigma" is no text, number/);
    refused(recipe('[{"do": "smooth", "sgma": 2}]'), /Step 1 \(smooth\): 'smooth' has no 'sgma'.*Did you mean 'sigma'/);
  });

  test("lists and describes the operations", () => {
    const list = succeed(["edit", "--list"]);
    for (const { id, help, parameters } of table) {
      assert.ok(list.includes(`  ${id.padEnd(16)} ${help}\n`), id);
      const description = succeed(["edit", "--help-operation", id]);
      for (const { name, label } of parameters) assert.match(description, new RegExp(`^  ${name} +${label}: `, "m"));
    }
  });
});

// As the page writes numbers: large ones with an exponent.
const number = (value) => (Math.abs(value) >= 1e6 || (value > 0 && value < 1e-4) ? value.toExponential() : String(value));

function valuesOf({ kind, choices, least, most, unit }) {
  const fixed = { yes_no: "`yes`, `no`", axis: "`x`, `y`, `z`", frame: "a frame from 1", points: "`FRAME:FRAME,...`", file: "a BVH file", text: "a text" };
  if (kind === "choice") return choices.map((choice) => `\`${choice}\``).join(", ");
  return fixed[kind] ?? `${number(least)} to ${number(most)}${unit && ` ${unit}`}`;
}

function defaultOf({ kind, choices, initial }) {
  if (["points", "file", "text"].includes(kind)) return "";
  if (kind === "choice") return `\`${choices[initial]}\``;
  if (kind === "yes_no") return initial ? "`yes`" : "`no`";
  if (kind === "axis") return `\`${"xyz"[initial]}\``;
  return number(kind === "frame" ? initial + 1 : initial);
}

describe("docs/operations.md", () => {
  const page = readFileSync(join(root, "docs/operations.md"), "utf8");
  const sections = new Map(page.split(/^### /m).slice(1).map((part) => {
    const end = part.indexOf("\n");
    return [part.slice(0, end), part.slice(end).split(/^## /m)[0]];
  }));

  test("has a section for each operation and no other", () => {
    assert.deepEqual([...sections.keys()], table.map(({ id }) => id));
  });

  test("shows pictures that are there, of more than fifty operations", () => {
    const pictures = [...page.matchAll(/!\[[^\]]*\]\(([^)]*)\)/g)].map(([, path]) => path);
    for (const path of pictures) assert.ok(existsSync(join(root, "docs", path)), path);
    assert.ok(pictures.length > 50);
  });

  for (const { id, label, help, parameters } of table) {
    test(`says of ${id} what the table says`, () => {
      const text = sections.get(id) ?? "";
      assert.ok(text.includes(`**${label}.** ${help} `), "label and help");
      const rows = parameters.map((p) => `| \`${p.name}\` | ${valuesOf(p)} | ${defaultOf(p)} | ${p.help} |`);
      assert.deepEqual(text.split("\n").filter((line) => line.startsWith("| `")), rows);
      assert.ok(text.length > help.length + 60, "more than the table says");
    });
  }
});
