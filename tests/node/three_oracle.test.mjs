// World positions beside those of three.js's BVHLoader, an independent reader, on every recorded file there is.
// three adds position channels to OFFSET; the clips are put into the same convention here.
import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { Vector3 } from "three";
import { BVHLoader } from "three/addons/loaders/BVHLoader.js";
import { createMarey } from "../../dist/module/marey.js";

const shared = process.env.MAREY_SHARED_DIR ?? fileURLToPath(new URL("../../../shared", import.meta.url));
const folder = join(shared, "bvh");
const tolerance = 1e-4; // of the stature

const recordedFiles = () =>
  readdirSync(folder, { recursive: true })
    .filter((name) => name.toLowerCase().endsWith(".bvh"))
    .sort();

/** What three makes of a text, or { complaint } when it throws or writes to the console. */
function readWithThree(text) {
  const complaints = [];
  const { error, warn } = console;
  console.error = console.warn = (...words) => complaints.push(words.join(" "));
  try {
    const { skeleton, clip } = new BVHLoader().parse(text);
    return complaints.length > 0 ? { complaint: complaints[0] } : { bones: skeleton.bones, tracks: clip.tracks };
  } catch (failure) {
    return { complaint: failure.message };
  } finally {
    Object.assign(console, { error, warn });
  }
}

/**
 * Poses three's bones frame by frame. The loader makes a position and a rotation track for each bone in order, so they
 * are bound by place: three's mixer binds by name, and names repeat in real files.
 */
class ThreeFigure {
  constructor({ bones, tracks }) {
    this.bones = bones;
    this.moving = bones.filter((bone) => bone.name !== "ENDSITE");
    this.tracks = tracks;
    this.frameCount = tracks[0].times.length;
  }

  /** World positions of joints and end sites, in file order. */
  positions(frame) {
    this.moving.forEach((bone, i) => {
      bone.position.fromArray(this.tracks[2 * i].values, 3 * frame);
      bone.quaternion.fromArray(this.tracks[2 * i + 1].values, 4 * frame);
    });
    this.bones[0].updateMatrixWorld(true);
    return this.bones.map((bone) => new Vector3().setFromMatrixPosition(bone.matrixWorld));
  }
}

/** Adds OFFSET to the position channels of a clip that replaces it. */
function addOffsets(clip) {
  if (clip.diagnostics.some(({ code }) => code === "positions_add_to_offset")) return;
  let channel = 0;
  for (const { channels, offset } of clip.joints) {
    for (const name of channels) {
      const axis = /^[XYZ]position$/i.test(name) ? "XYZ".indexOf(name[0].toUpperCase()) : -1;
      if (axis >= 0) clip.setChannel(channel, clip.channel(channel).map((value) => value + offset[axis]));
      channel += 1;
    }
  }
}

/** Largest extent of the rest pose. */
function statureOf(joints) {
  const rest = [];
  const points = [];
  for (const { parent, offset, endSite } of joints) {
    const place = parent < 0 ? [0, 0, 0] : offset.map((value, axis) => value + rest[parent][axis]);
    rest.push(place);
    points.push(place);
    if (endSite) points.push(endSite.map((value, axis) => value + place[axis]));
  }
  const extents = [0, 1, 2].map((axis) => {
    const values = points.map((point) => point[axis]);
    return Math.max(...values) - Math.min(...values);
  });
  return Math.max(...extents);
}

/** Largest distance of a node in all frames that both have, as a part of the stature. */
function largestDeviation(clip, figure) {
  const positions = clip.worldPositions();
  let largest = 0;
  for (let frame = 0; frame < Math.min(clip.frameCount, figure.frameCount); ++frame) {
    figure.positions(frame).forEach(({ x, y, z }, node) => {
      const at = 3 * (frame * clip.nodeCount + node);
      const distance = Math.hypot(positions[at] - x, positions[at + 1] - y, positions[at + 2] - z);
      if (!(distance <= largest)) largest = distance;
    });
  }
  return largest / statureOf(clip.joints);
}

test("world positions equal those of three's BVHLoader", { skip: !existsSync(folder) && "no recorded files" }, async (t) => {
  const marey = await createMarey();
  const compared = { files: 0, nodes: 0, positions: 0, worst: 0 };
  const unread = [];
  for (const name of recordedFiles()) {
    const bytes = readFileSync(join(folder, name));
    const three = readWithThree(bytes.toString("utf8"));
    if (three.complaint) {
      unread.push(`${name}: ${three.complaint}`);
      continue;
    }
    const clip = marey.parse(bytes);
    const figure = new ThreeFigure(three);
    addOffsets(clip);
    assert.equal(clip.nodeCount, figure.bones.length, `${name}: number of nodes`);
    assert.ok(clip.frameCount >= figure.frameCount, `${name}: ${clip.frameCount} frames, three has ${figure.frameCount}`);
    const deviation = largestDeviation(clip, figure);
    assert.ok(deviation <= tolerance, `${name}: a node is off by ${deviation} statures`);
    compared.files += 1;
    compared.nodes += clip.nodeCount;
    compared.positions += clip.nodeCount * figure.frameCount;
    compared.worst = Math.max(compared.worst, deviation);
    clip.dispose();
  }
  unread.forEach((line) => t.diagnostic(`three could not read ${line}`));
  t.diagnostic(
    `${compared.files} files, ${compared.nodes} nodes, ${compared.positions} positions compared with three.js; ` +
      `largest deviation ${compared.worst.toExponential(1)} of the stature; three could not read ${unread.length} files`,
  );
  assert.ok(compared.files >= 30, `only ${compared.files} files were compared`);
});
