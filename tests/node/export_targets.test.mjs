// What convert --for writes, read by the programs it is for: three.js's BVHLoader played by its own mixer, and Blender's
// importer where Blender is installed. Joints must be where Marey has them in the file that was exported.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { AnimationMixer, LoopOnce, Vector3 } from "three";
import { BVHLoader } from "three/addons/loaders/BVHLoader.js";
import { root, sampleNames } from "./support/cli.mjs";
import { compare, cutFile, exportFile, sourceFiles } from "./support/exports.mjs";

const tolerance = 1e-4; // of the stature
const hasBlender = spawnSync("blender", ["--version"]).status === 0;

let folder;
let cuts;
before(() => {
  folder = mkdtempSync(join(tmpdir(), "marey-export-"));
  cuts = sourceFiles().map((source) => ({ name: source.name, cut: cutFile(source, folder) })).filter(({ cut }) => cut);
});
after(() => rmSync(folder, { recursive: true }));

/** Adds up what was compared, and fails where a joint is not where it should be. */
class Tally {
  files = 0;
  nodes = 0;
  positions = 0;
  worst = 0;
  moved = 0;

  add(name, exported, point) {
    const { largest, count } = compare(exported, point);
    const size = exported.stature || 1;
    const stated = exported.largestMove > 1e-9 * size ? exported.largestMove : 0;
    const deviation = Math.max(0, largest - stated) / size;
    assert.ok(deviation <= tolerance, `${name}: a joint is off by ${deviation} statures beyond the stated ${stated} units`);
    this.files += 1;
    this.nodes += exported.nodes.filter((node) => node >= 0 && point(node, exported.addedFrames)).length;
    this.positions += count;
    this.worst = Math.max(this.worst, deviation);
    this.moved += stated > 0 ? 1 : 0;
  }

  toString() {
    const worst = this.worst.toExponential(1);
    return `${this.files} files, ${this.nodes} nodes, ${this.positions} positions; largest deviation ${worst} of the stature; ` +
      `${this.moved} files with a stated cost`;
  }
}

/** World positions of three's bones at a frame, as its mixer plays them by name. */
function playWithThree(text, frameTime) {
  const { skeleton, clip } = new BVHLoader().parse(text);
  const mixer = new AnimationMixer(skeleton.bones[0]);
  const action = mixer.clipAction(clip);
  action.setLoop(LoopOnce);
  action.clampWhenFinished = true;
  action.play();
  let shown = -1;
  let points = [];
  return (node, frame) => {
    if (frame !== shown) {
      action.reset().play();
      mixer.setTime(frame * frameTime);
      skeleton.bones[0].updateMatrixWorld(true);
      points = skeleton.bones.map((bone) => new Vector3().setFromMatrixPosition(bone.matrixWorld).toArray());
      shown = frame;
    }
    return points[node];
  };
}

/** What three writes to the console while `read` runs. */
function complaintsOf(read) {
  const { error, warn } = console;
  const complaints = [];
  console.error = console.warn = (...words) => complaints.push(words.join(" "));
  try {
    return { value: read(), complaints };
  } finally {
    Object.assign(console, { error, warn });
  }
}

/** Runs Blender once over all files; gives what it made of each. */
function readWithBlender(files) {
  const jobs = files.map((file) => ({ file, positions: `${file}.json` }));
  const list = join(folder, "jobs.json");
  writeFileSync(list, JSON.stringify(jobs));
  const script = join(root, "tests/node/support/read_with_blender.py");
  const { status, stderr } = spawnSync("blender", ["--background", "--factory-startup", "--python", script, "--", list], { encoding: "utf8" });
  assert.equal(status, 0, stderr);
  return jobs.map(({ positions }) => JSON.parse(readFileSync(positions, "utf8")));
}

/** The node of each joint in a file, and of the only end site of each leaf: [{ name, joint, end }]. */
function bonesOf(text) {
  const bones = [];
  const open = [];
  let node = -1;
  for (const line of text.split("\n").map((row) => row.trim())) {
    const [, keyword, name] = /^(ROOT|JOINT|End Site)\s*(.*)$/.exec(line) ?? [];
    if (keyword === "End Site") open.push({ isEnd: true });
    else if (keyword) bones.push({ name, joint: node + 1, ends: [], children: 0 });
    if (keyword) node += 1;
    if (keyword === "End Site") open.at(-2).ends.push({ node });
    else if (keyword) {
      if (open.length > 0) open.at(-1).children += 1;
      open.push(bones.at(-1));
    }
    if (line.startsWith("OFFSET") && open.at(-1).isEnd) {
      open.at(-2).ends.at(-1).length = Math.hypot(...line.split(/\s+/).slice(1).map(Number));
    }
    if (line === "}") open.pop();
    if (line === "MOTION") break;
  }
  return bones;
}

/** Heads of bones are joints; tails are end sites where the bone has a length of its own, which Blender wants above 0.001. */
function blenderPoints(text, { bones, frames }) {
  const columns = new Map();
  for (const { name, joint, ends, children } of bonesOf(text)) {
    const column = bones.indexOf(name);
    assert.ok(column >= 0, `Blender has no bone ${name}`);
    columns.set(joint, 6 * column);
    if (children === 0 && ends.length === 1 && ends[0].length > 0.002) columns.set(ends[0].node, 6 * column + 3);
  }
  return (node, frame) => (columns.has(node) ? frames[frame].slice(columns.get(node), columns.get(node) + 3) : undefined);
}

describe("exported files", () => {
  for (const target of ["three", "strict"]) {
    test(`for ${target} move in three.js as in Marey`, (t) => {
      const tally = new Tally();
      for (const { name, cut } of cuts) {
        const exported = exportFile(cut, target);
        const { value: point, complaints } = complaintsOf(() => playWithThree(exported.text, exported.info.frame_time));
        assert.deepEqual(complaints, [], name);
        tally.add(name, exported, point);
      }
      t.diagnostic(`${target}: ${tally}`);
      assert.ok(tally.files >= sampleNames.length, `only ${tally.files} files were compared`);
    });
  }

  for (const target of ["blender", "strict"]) {
    test(`for ${target} move in Blender as in Marey`, { skip: !hasBlender && "Blender is not installed" }, (t) => {
      const tally = new Tally();
      const exports = cuts.map(({ name, cut }) => ({ name, ...exportFile(cut, target) }));
      const answers = readWithBlender(exports.map(({ file }) => file));
      exports.forEach((exported, i) => {
        assert.equal(answers[i].complaint, undefined, exported.name);
        tally.add(exported.name, exported, blenderPoints(exported.text, answers[i]));
      });
      t.diagnostic(`${target}: ${tally}`);
      assert.ok(tally.files >= sampleNames.length, `only ${tally.files} files were compared`);
    });
  }
});
