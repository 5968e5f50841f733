// The clip that is measured: 60 joints, 20,000 frames, six decimals, 37.5 MB; the same numbers in every run.
import { closeSync, existsSync, mkdirSync, openSync, renameSync, writeSync } from "node:fs";
import { dirname } from "node:path";
import { inRoot } from "../lib/shell.mjs";

const jointsPerLimb = 6;

/** Numbers from 0 to 1, mulberry32. */
function randomNumbers(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let bits = Math.imul(state ^ (state >>> 15), 1 | state);
    bits = (bits + Math.imul(bits ^ (bits >>> 7), 61 | bits)) ^ bits;
    return ((bits ^ (bits >>> 14)) >>> 0) / 4294967296;
  };
}

/** A root with limbs of six joints each, a joint to a line group, as far as `joints` go. */
function hierarchyOf(joints, random) {
  const offset = () => `OFFSET ${[0, 0, 0].map(() => (20 * random() - 10).toFixed(6)).join(" ")}`;
  const rotations = "Zrotation Xrotation Yrotation";
  const lines = ["HIERARCHY", "ROOT joint0", "{", offset(), `CHANNELS 6 Xposition Yposition Zposition ${rotations}`];
  for (let joint = 1; joint < joints; joint++) {
    lines.push(`JOINT joint${joint}`, "{", offset(), `CHANNELS 3 ${rotations}`);
    const isTip = joint % jointsPerLimb === 0 || joint === joints - 1;
    if (!isTip) continue;
    lines.push("End Site", "{", offset(), "}");
    const depth = (joint - 1) % jointsPerLimb + 1;
    for (let i = 0; i < depth; i++) lines.push("}");
  }
  if (joints === 1) lines.push("End Site", "{", offset(), "}");
  lines.push("}");
  return lines;
}

/** Writes the file unless it is there; gives its path. */
export function benchClip({ joints = 60, frames = 20_000 } = {}) {
  const path = inRoot("build", "bench", `clip-${joints}x${frames}.bvh`);
  if (existsSync(path)) return path;
  mkdirSync(dirname(path), { recursive: true });
  const random = randomNumbers(1);
  const head = [...hierarchyOf(joints, random), "MOTION", `Frames: ${frames}`, "Frame Time: 0.008333", ""];
  const channels = 3 * joints + 3;
  const waves = Array.from({ length: channels }, () => ({ amplitude: 180 * random() - 90, phase: 6 * random() - 3 }));
  const file = openSync(`${path}.part`, "w");
  writeSync(file, head.join("\n"));
  for (let frame = 0; frame < frames; frame++) {
    const row = waves.map(({ amplitude, phase }) => (amplitude * Math.sin(0.03 * frame + phase)).toFixed(6));
    writeSync(file, `${row.join(" ")}\n`);
  }
  closeSync(file);
  renameSync(`${path}.part`, path);
  return path;
}

/** A figure of the size of a body, for mechanics. */
export const bodyClip = () => benchClip({ joints: 20, frames: 10_000 });
