// Tables in, and files for named programs, from the command line.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { refused, run, sample, sampleNames, smallClip, succeed, swing } from "./support/cli.mjs";

let folder;
before(() => { folder = mkdtempSync(join(tmpdir(), "marey-interchange-")); });
after(() => rmSync(folder, { recursive: true }));

function scratch(name, content) {
  const path = join(folder, name);
  if (content !== undefined) writeFileSync(path, content);
  return path;
}

describe("convert from CSV", () => {
  for (const name of sampleNames) {
    test(`gives ${name} back byte for byte`, () => {
      const table = scratch(`${name}.csv`);
      const again = scratch(`${name}.bvh`);
      succeed(["convert", sample(name), table, "--units", "cm"]);
      succeed(["convert", table, again, "--skeleton", sample(name)]);
      assert.equal(readFileSync(again, "latin1"), readFileSync(sample(name), "latin1"));
    });
  }

  test("reads points and gives their table back byte for byte", () => {
    const points = scratch("points.csv", succeed(["fk", swing]));
    const clip = scratch("points.bvh");
    succeed(["convert", points, clip]);
    assert.equal(succeed(["fk", clip]), readFileSync(points, "latin1"));
    assert.equal(JSON.parse(run(["info", clip, "--json"]).stdout).joints.every(({ parent }) => parent === -1), true);
  });

  test("reads a table from standard input and says what it assumes", () => {
    const { status, stdout, stderr } = run(["convert", "-", "-", "--from", "csv"], "P.x;P.y\n1,5;2\n3;4\n");
    assert.equal(status, 0);
    assert.match(stdout, /ROOT P\n\{\n {2}OFFSET 0\.0 0\.0 0\.0\n {2}CHANNELS 2 Xposition Yposition\n/);
    assert.match(stderr, /^<stdin>:1:1: note: There is no column 'time'/);
  });

  test("refuses what it cannot use, with its place", () => {
    const table = scratch("bad.csv", "time,Hips.Zrotation\n0,1\n0.1,one\n");
    const figure = scratch("figure.bvh", smallClip());
    refused(["convert", table, scratch("out.bvh"), "--skeleton", figure], /bad\.csv:3:5: error: In the column 'Hips\.Zrotation'/);
    refused(["convert", table, scratch("out.bvh")], /bad\.csv:1:1: error: The table holds channels/);
    refused(["convert", figure, scratch("out.bvh"), "--skeleton", figure], /marey: error: --skeleton goes with a table/);
    refused(["convert", figure, scratch("out.bvh"), "--units", "m"], /marey: error: --units goes with a table/);
    refused(["convert", figure, scratch("out.csv"), "--units", "mile"], /marey: error: --units/);
  });
});

describe("convert --for", () => {
  const odd = smallClip().replace("ROOT Hips", "ROOT Mein Hüfte");

  test("tells what was changed as notes", () => {
    const { status, stdout, stderr } = run(["convert", scratch("odd.bvh", odd), "-", "--for", "pybvh"]);
    assert.equal(status, 0);
    assert.match(stdout, /ROOT Mein_Hufte\n/);
    assert.match(stdout, /CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation/);
    const notes = stderr.trimEnd().split("\n");
    assert.equal(notes.length, 3);
    notes.forEach((note) => assert.match(note, /odd\.bvh: note: .*\.$/));
  });

  test("tells it as JSON", () => {
    const file = scratch("odd.bvh", odd);
    const report = JSON.parse(succeed(["convert", file, scratch("odd-out.bvh"), "--for", "pybvh", "--json"]));
    assert.equal(report.target, "pybvh");
    assert.deepEqual(report.changes.map(({ kind }) => kind), ["positions_added", "rotations_added", "names_changed"]);
    assert.equal(report.names[0].after, "Mein_Hufte");
    assert.deepEqual(report.nodes, [0, 1]);
    assert.equal(report.largest_move, 0);
  });

  test("leaves a file alone that has all the target wants", () => {
    assert.equal(succeed(["convert", swing, "-", "--for", "strict"]), succeed(["fmt", swing, "--canonical"]));
  });

  test("puts a reference pose in front on wish, behind --frames", () => {
    const frames = (args) => /Frames: (\d+)/.exec(run(["convert", swing, "-", "--frames", "3:6", "--for", ...args]).stdout)[1];
    assert.equal(frames(["blender"]), "4");
    assert.equal(frames(["blender", "--reference-pose", "yes"]), "5");
    assert.equal(frames(["motionbuilder"]), "5");
    assert.equal(frames(["motionbuilder", "--reference-pose", "no"]), "4");
  });

  test("refuses wrong usage", () => {
    refused(["convert", swing, "-", "--for", "paint"], /"paint" is no target; marey targets lists them/);
    refused(["convert", swing, "-", "--to", "csv", "--for", "strict"], /--for writes BVH/);
    refused(["convert", swing, "-", "--for", "strict", "--json"], /--json wants standard output/);
    refused(["convert", swing, "-", "--reference-pose", "yes"], /go with --for/);
  });

  test("reads what it wrote", () => {
    for (const name of sampleNames) {
      for (const target of ["strict", "blender", "three", "bvhview", "pybvh", "motionbuilder", "second-life"]) {
        const written = run(["convert", sample(name), "-", "--for", target]).stdout;
        assert.equal(run(["info", "--strict", "-"], written).status, 0, `${name} for ${target}`);
      }
    }
  });
});

test("targets lists what convert --for takes", () => {
  const { targets } = JSON.parse(succeed(["targets", "--json"]));
  const listed = succeed(["targets"]);
  for (const { id, needs } of targets) {
    assert.match(listed, new RegExp(`^${id} \\(`, "m"));
    assert.ok(needs.length > 0);
    assert.equal(run(["convert", swing, "-", "--for", id]).status, 0, id);
  }
  const page = readFileSync(new URL("../../docs/export-targets.md", import.meta.url), "utf8");
  const rows = [...page.matchAll(/^\| `([\w-]+)` \| .* \| .* \| .* \|$/gm)].map(([, id]) => id);
  assert.deepEqual(rows, targets.map(({ id }) => id), "docs/export-targets.md lists the targets");
});
