// `marey check`: limits, and what is odd about a figure and its motion.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { refused, repairable, run, sample, succeed, swing, text } from "./support/cli.mjs";

let folder;
before(() => { folder = mkdtempSync(join(tmpdir(), "marey-check-")); });
after(() => rmSync(folder, { recursive: true }));

function scratch(name, content) {
  const path = join(folder, name);
  writeFileSync(path, content);
  return path;
}

describe("marey check", () => {
  const limitsFile = (limits) => scratch("limits.json", JSON.stringify({ limits }));

  test("passes a clean file", () => {
    assert.equal(succeed(["check", swing]), `${swing}: 0 errors, 0 warnings, 0 limit violations\n`);
  });

  test("passes a file with warnings, and prints them", () => {
    const { status, stdout, stderr } = run(["check", scratch("repairable.bvh", repairable)]);
    assert.equal(status, 0);
    assert.match(stderr, /^[^\n]*repairable\.bvh:\d+:\d+: warning: /);
    assert.match(stdout, /0 errors, 1 warning, 0 limit violations\n$/);
  });

  test("fails where a channel leaves its limits, and says in which frames", () => {
    const file = limitsFile([{ channel: "Legs Zrotation", min: -30, max: 3 }, { channel: "Body Zrotation", max: 38.2 }]);
    const { status, stdout, stderr } = run(["check", swing, "--limits", file]);
    assert.equal(status, 1);
    assert.equal(stderr, "");
    assert.equal(stdout, [
      `${swing}: Legs Zrotation is below -30 in frames 8-10, at worst -37.2 in frame 9`,
      `${swing}: Legs Zrotation is above 3 in frame 14, at worst 3.9 in frame 14`,
      `${swing}: 0 errors, 0 warnings, 2 limit violations`, ""].join("\n"));
  });

  test("--json has the violations and the findings", () => {
    const file = limitsFile([{ channel: "Legs Zrotation", min: -30 }]);
    const { status, stdout, stderr } = run(["check", swing, "--json", "--limits", file]);
    assert.deepEqual([status, stderr], [1, ""]);
    assert.deepEqual(JSON.parse(stdout), { file: swing, errors: 0, warnings: 0, diagnostics: [],
      findings: [], findings_left_out: {}, violations: [
      { channel: "Legs Zrotation", first_frame: 8, last_frame: 10, side: "below", limit: -30, worst: -37.2, worst_frame: 9 }] });
    const repaired = JSON.parse(run(["check", "--json", scratch("repairable.bvh", repairable)]).stdout);
    assert.equal(repaired.warnings, 1);
    assert.equal(repaired.diagnostics[0].code, "frame_count_mismatch");
  });

  test("a limit that is kept exactly is no violation", () => {
    succeed(["check", swing, "--limits", limitsFile([{ channel: "Legs Zrotation", min: -37.2, max: 3.9 }])]);
  });

  test("refuses limits that it does not understand", () => {
    const attempt = (content, pattern) => refused(["check", swing, "--limits", scratch("bad.json", content)], pattern);
    attempt('{"limits": [\n  {"channel": oops}\n]}', /bad\.json:2:15: error: /);
    attempt("[]", /bad\.json: error: .*"limits"/);
    attempt('{"limits": [], "limit": []}', /error: /);
    attempt('{"limits": [{"channel": "Legs Zrotation", "minimum": 3}]}', /Limit 1 has the key "minimum"/);
    attempt('{"limits": [{"channel": "Legs Zrotation"}]}', /Limit 1 has neither min nor max/);
    attempt('{"limits": [{"channel": "Legs Zrotation", "min": "3"}]}', /min that is not a number/);
    attempt('{"limits": [{"channel": "Legs Zrotation", "min": 3, "max": 2}]}', /min above its max/);
    attempt('{"limits": [{"channel": "Tail Zrotation", "min": 3}]}', /no channel "Tail Zrotation"/);
    refused(["check", swing, "--limits", join(folder, "none.json")], /none\.json: error: The file cannot be opened/);
  });
});

describe("what marey check finds odd", () => {
  /** The walk with its rows changed by `change(rows, channel)`, where channel(label) is the column of a channel. */
  function changedWalk(name, change) {
    const whole = text("walk");
    const begin = whole.indexOf("\n", whole.indexOf("Frame Time:")) + 1;
    const labels = whole.slice(0, begin).split(/\b(?:ROOT|JOINT)\b/).slice(1).flatMap((block) => {
      const [, joint] = /^\s*(\S+)/.exec(block);
      return /CHANNELS\s+\d+ ([^\n]*)/.exec(block)[1].trim().split(/\s+/).map((keyword) => `${joint} ${keyword}`);
    });
    const rows = whole.slice(begin).trimEnd().split("\n").map((row) => row.trim().split(/\s+/).map(Number));
    change(rows, (label) => labels.indexOf(label));
    return scratch(name, `${whole.slice(0, begin)}${rows.map((row) => row.join(" ")).join("\n")}\n`);
  }

  test("nothing about the walk and the swing", () => {
    for (const name of ["walk", "giant-swing"]) {
      assert.deepEqual(JSON.parse(succeed(["check", "--json", sample(name)])).findings, []);
      succeed(["check", sample(name)]);
    }
  });

  test("a spike: one note, and the check still passes", () => {
    const file = changedWalk("spike.bvh", (rows, channel) => { rows[99][channel("Head Xrotation")] += 40; });
    const { status, stdout, stderr } = run(["check", file]);
    assert.equal(status, 0);
    assert.match(stderr, /^[^\n]*spike\.bvh: note: 'Head Xrotation' leaves its curve by [\d.]+ degrees in frame 100 alone\. Replace [^\n]*\.\n$/);
    assert.match(stdout, /: 0 errors, 0 warnings, 0 limit violations\n$/);
  });

  test("--json: kind, place and advice, frames from 1", () => {
    const file = changedWalk("jump.bvh", (rows, channel) => {
      rows.slice(99).forEach((row) => { row[channel("Head Xrotation")] += 40; });
    });
    const { status, stdout, stderr } = run(["check", "--json", file]);
    assert.deepEqual([status, stderr], [0, ""]);
    const { file: name, findings: [finding, ...others], findings_left_out } = JSON.parse(stdout);
    const { message, suggestion, ...rest } = finding;
    const headIndex = JSON.parse(succeed(["info", "--json", sample("walk")])).joints.findIndex((joint) => joint.name === "Head");
    assert.deepEqual(rest, { kind: "jump", severity: "note", joint: "Head", joint_index: headIndex, channel: "Head Xrotation",
      first_frame: 99, last_frame: 100, count: 1, tools: [] });
    assert.match(message, /between frames 99 and 100\.$/);
    assert.match(suggestion, /\.$/);
    assert.deepEqual([name, others, findings_left_out], [file, [], {}]);
  });

  test("the programs that stumble, and null for what has no place in time", () => {
    const [finding] = JSON.parse(run(["check", "--json", sample("pendulum")]).stdout).findings;
    assert.deepEqual([finding.kind, finding.joint, finding.channel, finding.first_frame, finding.last_frame],
      ["single_channel_joint", "Pivot", null, null, null]);
    assert.ok(finding.tools.includes("Blender"));
    assert.match(run(["check", sample("pendulum")]).stderr, /note: .*Known to stumble over it: Blender, [^\n]*\.\n$/);
  });

  test("what the reader notes too is one line, with its place", () => {
    const limb = "  JOINT Arm\n  {\n    OFFSET 1 0 0\n    CHANNELS 3 Zrotation Xrotation Yrotation\n    End Site\n    {\n      OFFSET 1 0 0\n    }\n  }\n";
    const file = scratch("twins.bvh", `HIERARCHY\nROOT Hips\n{\n  OFFSET 0 0 0\n  CHANNELS 3 Zrotation Xrotation Yrotation\n${limb}${limb}}\nMOTION\nFrames: 1\nFrame Time: 0.1\n${"0 ".repeat(9)}\n`);
    const { status, stderr } = run(["check", file]);
    assert.equal(status, 0);
    assert.match(stderr, /^[^\n]*twins\.bvh:15:\d+: note: 'Arm' \(2 joints\) is the name of more than one joint\.[^\n]*three\.js\.\n$/);
  });

  test("a file that is refused still gives JSON", () => {
    const { status, stdout } = run(["check", "--json", scratch("nothing.bvh", "")]);
    assert.equal(status, 2);
    assert.equal(JSON.parse(stdout).error.code, "empty_file");
  });
});
