// The sample files: what they claim holds, checked from the files alone by means that did not make them.
import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { describe, test } from "node:test";
import { energy, swing } from "../../scripts/samples/double_pendulum.mjs";
import { makeSampleFiles } from "../../scripts/samples/samples.mjs";
import { readBvh, turned, worldPose } from "./support/plain_bvh.mjs";

const folder = new URL("../../web/samples/", import.meta.url);
const readSample = (name) => readFileSync(new URL(name, folder), "utf8");
const shared = process.env.MAREY_SHARED_DIR ?? fileURLToPath(new URL("../../../shared", import.meta.url));

const near = (actual, expected, tolerance, what) =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${what}: ${actual}, expected ${expected} within ${tolerance}`);
const radians = (degrees) => (degrees * Math.PI) / 180;

/** Derivatives of samples with spacing h by central differences, exact for polynomials of degree six. */
const rate = (v, i, h) => (45 * (v[i + 1] - v[i - 1]) - 9 * (v[i + 2] - v[i - 2]) + v[i + 3] - v[i - 3]) / (60 * h);
const acceleration = (v, i, h) =>
  (2 * (v[i + 3] + v[i - 3]) - 27 * (v[i + 2] + v[i - 2]) + 270 * (v[i + 1] + v[i - 1]) - 490 * v[i]) / (180 * h * h);

describe("sample files", () => {
  const files = makeSampleFiles();

  for (const { name, text } of files) {
    test(`${name} is what the generator makes`, () => assert.equal(readSample(name), text));
  }

  test("the list names every file, with its joints and frames", () => {
    const { samples } = JSON.parse(readSample("index.json"));
    const onDisk = readdirSync(folder).filter((name) => name.endsWith(".bvh"));
    assert.deepEqual(samples.map(({ file }) => file).sort(), onDisk.sort());
    for (const { file, joints, frames, title, description, licence } of samples) {
      const clip = readBvh(readSample(file));
      assert.equal(clip.joints.filter((joint) => !joint.isEnd).length, joints, file);
      assert.equal(clip.rows.length, frames, file);
      assert.ok(title && /^[A-Z].*\.$/.test(description), file);
      assert.equal(licence, "MIT");
    }
  });
});

describe("giant swing", () => {
  const clip = readBvh(readSample("giant-swing.bvh"));

  test("joints lie where the closed form puts them", () => {
    const known = {  // frame: shoulder, hip, feet
      1: [-2.856884, 9.583226, -7.661072, 20.579578, -13.36888, 35.52685],
      12: [4.305111, -9.025853, 11.576972, -18.571535, 18.641065, -32.927669],
      23: [-0.57564, 9.983418, -2.121187, 21.883472, -4.706849, 37.673164],
    };
    for (const [frame, expected] of Object.entries(known)) {
      const pose = worldPose(clip, clip.rows[frame - 1]).slice(1);
      const flat = pose.flatMap(({ position }) => position.slice(0, 2));
      flat.forEach((value, i) => near(value, expected[i], 1e-6, `frame ${frame}, coordinate ${i}`));
    }
  });

  test("23 frames of 0.033333 s that end at 363.3 degrees", () => {
    assert.equal(clip.rows.length, 23);
    assert.equal(clip.frameTime, 0.033333);
    assert.equal(clip.rows[22][3], 363.3);
  });

  const oracle = `${shared}/oracle/gymnast_corrected.bvh`;
  test("the numbers are those of the paper", { skip: !existsSync(oracle) && "no ../shared" }, () => {
    assert.equal(readSample("giant-swing.bvh"), readFileSync(oracle, "utf8"));
  });
});

describe("pendulum", () => {
  const clip = readBvh(readSample("pendulum.bvh"));
  const angles = clip.rows.map(([angle]) => radians(angle));
  const length = -clip.joints[1].offset[1];
  const pull = 980.665 / length;
  const step = clip.frameTime;

  test("obeys its equation of motion", () => {
    for (let i = 3; i < angles.length - 3; i++) {
      near(acceleration(angles, i, step), -pull * Math.sin(angles[i]), 5e-4, `acceleration at frame ${i + 1}, rad/s^2`);
    }
  });

  test("has the period of the complete elliptic integral, a whole number of frames", () => {
    const modulus = Math.sin(angles[0] / 2);
    const parts = 200;  // the midpoint rule converges fast on a periodic integrand
    let integral = 0;
    for (let i = 0; i < parts; i++) {
      const phi = ((i + 0.5) * Math.PI) / (2 * parts);
      integral += Math.PI / (2 * parts) / Math.sqrt(1 - (modulus * Math.sin(phi)) ** 2);
    }
    near((4 * integral) / Math.sqrt(pull), 156 * step, 1e-8, "period in s");
    angles.forEach((angle, i) => assert.equal(angle, angles[i % 156], `frame ${i + 1}`));
    assert.equal(angles.length % 156, 0);
  });

  test("passes the lowest point a quarter of the period after its release, and turns at the other side", () => {
    near(angles[0], Math.PI / 2, 1e-12, "release");
    near(angles[39], 0, 1e-8, "lowest point");
    near(angles[78], -Math.PI / 2, 1e-8, "turning point");
  });
});

describe("double pendulum", () => {
  const clip = readBvh(readSample("double-pendulum.bvh"));
  const length = 60;

  test("the integration loses no energy", () => {
    const states = swing();
    for (const state of states) near(energy(state) / energy(states[0]), 1, 1e-11, "energy");
  });

  test("the file holds that motion: its energy is constant within the error of differentiating at 60 per second", () => {
    const upper = clip.rows.map(([angle]) => radians(angle));
    const lower = clip.rows.map(([first, second]) => radians(first + second));
    const scale = 980.665 * length;
    for (let i = 3; i < upper.length - 3; i++) {
      const [u, l] = [rate(upper, i, clip.frameTime), rate(lower, i, clip.frameTime)];
      const kinetic = length ** 2 * (u * u + (l * l) / 2 + u * l * Math.cos(upper[i] - lower[i]));
      const total = (kinetic - scale * (2 * Math.cos(upper[i]) + Math.cos(lower[i]))) / scale;
      near(total, -1, 1e-2, `energy at frame ${i + 1}`);
    }
  });
});

describe("robot arm", () => {
  const clip = readBvh(readSample("robot-arm.bvh"));
  const flange = clip.joints.findIndex(({ name }) => name === "Flange");

  function toolAt(frame) {
    const { position, rotation } = worldPose(clip, clip.rows[frame])[flange];
    const pointing = turned(rotation, [0, 0, 1]);
    return { tip: position.map((value, k) => value + 14 * pointing[k]), pointing };
  }

  test("every joint has one rotation channel", () => {
    for (const { name, channels, isEnd } of clip.joints) {
      if (!isEnd) assert.ok(channels.length === 1 && channels[0].endsWith("rotation"), name);
    }
  });

  test("grips the part from above and puts it down on the tilted tray", () => {
    const tilt = Math.hypot(-0.4, -0.9, 0.15);
    const stations = [
      { frames: [96, 114], tip: [-53, 8, 56], pointing: [0, -1, 0] },
      { frames: [270, 288], tip: [64, 22, 31], pointing: [-0.4 / tilt, -0.9 / tilt, 0.15 / tilt] },
    ];
    for (const { frames, tip, pointing } of stations) {
      for (const frame of frames) {
        const tool = toolAt(frame);
        tip.forEach((value, k) => near(tool.tip[k], value, 1e-5, `tip at frame ${frame + 1}`));
        pointing.forEach((value, k) => near(tool.pointing[k], value, 1e-6, `direction at frame ${frame + 1}`));
      }
    }
  });

  test("loops, starts and stops at rest, and no axis is faster than a real one", () => {
    const rows = [...clip.rows, ...clip.rows];
    for (let frame = 0; frame < clip.rows.length; frame++) {
      rows[frame].forEach((value, channel) => {
        const speed = Math.abs(rows[frame + 1][channel] - value) / clip.frameTime;
        assert.ok(speed < 250, `channel ${channel} turns at ${speed} degrees/s in frame ${frame + 1}`);
      });
    }
    clip.rows[0].forEach((value, channel) => near(clip.rows.at(-1)[channel], value, 0.01, `end of channel ${channel}`));
  });
});
