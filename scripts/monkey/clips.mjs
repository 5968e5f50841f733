// Files for the monkey: the samples, small clips, and both damaged.
import { readFileSync, readdirSync } from "node:fs";
import { inRoot } from "../lib/shell.mjs";

const samples = readdirSync(inRoot("web/samples")).filter((name) => name.endsWith(".bvh"));

const texts = samples.map((name) => readFileSync(inRoot("web/samples", name), "utf8"));

function smallClip(random) {
  const joints = 1 + random.below(6);
  const frames = random.pick([0, 1, 2, 3, 30, 200]);
  const names = ["Hips", "右肩", "팔꿈치", "Колено", "LeftArm", "RightArm", "a".repeat(90), "Ünïcode"];
  const lines = ["HIERARCHY"];
  for (let i = 0; i < joints; i++) {
    const channels = i === 0 && random.chance(0.5) ? "6 Xposition Yposition Zposition Zrotation Xrotation Yrotation" : "3 Zrotation Xrotation Yrotation";
    lines.push(`${i === 0 ? "ROOT" : "JOINT"} ${random.pick(names)}${i}`, "{", `OFFSET 0.00 ${i}.00 0.00`, `CHANNELS ${channels}`);
  }
  lines.push("End Site", "{", "OFFSET 0.00 1.00 0.00", "}", ...Array(joints).fill("}"));
  const width = lines.filter((line) => line.startsWith("CHANNELS")).reduce((sum, line) => sum + Number(line.split(" ")[1]), 0);
  lines.push("MOTION", `Frames: ${frames}`, `Frame Time: ${random.pick(["0.033333", "0.008333", "0.5"])}`);
  for (let i = 0; i < frames; i++) lines.push(Array.from({ length: width }, () => random.between(-180, 180).toFixed(2)).join(" "));
  return `${lines.join("\n")}\n`;
}

function damaged(random, text) {
  const at = random.below(text.length);
  const size = random.below(200);
  const kinds = {
    cut: () => text.slice(0, at),
    hole: () => text.slice(0, at) + text.slice(at + size),
    doubled: () => text.slice(0, at + size) + text.slice(at),
    exchanged: () => text.slice(0, at) + random.pick(["{", "}", "nan", "1e999", "\0", "JOINT", "Frames: 9999999", "\uffff", ","]) + text.slice(at + 1),
    nothing: () => "",
  };
  return kinds[random.pick(Object.keys(kinds))]();
}

/** The text of a file; two calls with the same state of `random` give the same. */
export function makeClip(random) {
  const text = random.chance(0.3) ? random.pick(texts) : smallClip(random);
  return random.chance(0.3) ? damaged(random, text) : text;
}
