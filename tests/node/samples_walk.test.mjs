// The walking figure: feet that neither slide nor sink, joints within their normal range, both sides alike. Centimetres.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { readBvh, turned, worldPose } from "./support/plain_bvh.mjs";

const clip = readBvh(readFileSync(new URL("../../web/samples/walk.bvh", import.meta.url), "utf8"));
const framesPerCycle = 64;
const frameCount = clip.rows.length;
const index = (name) => clip.joints.findIndex((joint) => joint.name === name);
const poses = clip.rows.map((row) => worldPose(clip, row));

function samples(name, channel) {
  const joint = clip.joints[index(name)];
  const column = joint.firstChannel + joint.channels.indexOf(channel);
  return clip.rows.map((row) => row[column]);
}

/** World path of a point that is fixed to a joint. */
const pathOf = (name, point) => poses.map((pose) => {
  const { position, rotation } = pose[index(name)];
  return turned(rotation, point).map((value, k) => value + position[k]);
});

/** The points that can carry the foot, each with its height when it does. */
const supports = (side) => [
  { path: pathOf(`${side}Ankle`, [0, -6.8, -5]), height: 0 },  // sole under the heel
  { path: pathOf(`${side}Toe`, [0, 0, 0]), height: 1.8 },
  { path: pathOf(`${side}Toe`, [0, -0.8, 6.7]), height: 1 },
];
const supportsOf = { Left: supports("Left"), Right: supports("Right") };
const allSupports = [...supportsOf.Left, ...supportsOf.Right];
const touches = ({ path, height }, frame) => path[frame][1] < height + 1e-4;
const range = (values) => [Math.min(...values), Math.max(...values)];

function assertRange(values, [lowFrom, lowTo], [highFrom, highTo], what) {
  const [low, high] = range(values);
  assert.ok(low >= lowFrom && low <= lowTo, `${what}: lowest ${low}`);
  assert.ok(high >= highFrom && high <= highTo, `${what}: highest ${high}`);
}

test("what carries the foot moves by less than 0.1 mm per second", () => {
  let checked = 0;
  for (const support of allSupports) {
    for (let frame = 0; frame + 1 < frameCount; frame++) {
      if (!touches(support, frame) || !touches(support, frame + 1)) continue;
      const [from, to] = [support.path[frame], support.path[frame + 1]];
      const speed = Math.hypot(...to.map((value, k) => value - from[k])) / clip.frameTime;
      assert.ok(speed < 0.01, `${speed} cm/s in frame ${frame + 1}`);
      checked += 1;
    }
  }
  assert.ok(checked > 2 * 0.6 * frameCount, `only ${checked} pairs of frames`);
});

test("nothing is more than 0.1 mm below the floor, and a foot in the air clears it by 5 mm at its middle", () => {
  const tracked = allSupports.map(({ path, height }) => path.map(([, y]) => y - height));
  const joints = clip.joints.map((_, joint) => poses.map((pose) => pose[joint].position[1]));
  for (const heights of [...tracked, ...joints]) assert.ok(range(heights)[0] > -0.01, `${range(heights)[0]} cm`);
  const midSwing = [0, 1, 2].map((cycle) => Math.round((cycle + 0.8) * framesPerCycle));
  for (const frame of midSwing) {
    for (const { path, height } of supportsOf.Left) assert.ok(path[frame][1] - height > 0.5, `frame ${frame + 1}`);
  }
});

test("one foot is always down, both for a fifth of the time", () => {
  let both = 0;
  for (let frame = 0; frame < frameCount; frame++) {
    const down = ["Left", "Right"].filter((side) => supportsOf[side].some((support) => touches(support, frame)));
    assert.ok(down.length > 0, `frame ${frame + 1}`);
    both += down.length === 2 ? 1 : 0;
  }
  assert.ok(Math.abs(both / frameCount - 0.2) < 0.03, `${both} of ${frameCount} frames`);
});
test("the right side does what the left does, mirrored, half a cycle later", () => {
  for (const { name, channels } of clip.joints.filter((joint) => joint.name.startsWith("Left") && !joint.isEnd)) {
    for (const channel of channels) {
      const sign = channel === "Xrotation" ? 1 : -1;
      const [left, right] = [samples(name, channel), samples(name.replace("Left", "Right"), channel)];
      left.forEach((value, frame) => {
        const later = right[(frame + framesPerCycle / 2) % frameCount];
        assert.ok(Math.abs(later - sign * value) < 2e-6, `${name} ${channel} in frame ${frame + 1}`);
      });
    }
  }
});

test("every cycle has the same angles, 144 cm further on", () => {
  for (let frame = 0; frame + framesPerCycle < frameCount; frame++) {
    clip.rows[frame].forEach((value, channel) => {
      const advance = channel === 2 ? 144 : 0;
      assert.ok(Math.abs(clip.rows[frame + framesPerCycle][channel] - value - advance) < 2e-6);
    });
  }
  const speed = 144 / (framesPerCycle * clip.frameTime);
  assert.ok(Math.abs(speed - 135) < 0.01, `${speed} cm/s`);
});

test("joint angles keep to the normal range of walking", () => {
  const knee = samples("LeftKnee", "Xrotation");
  assertRange(knee, [3, 6], [58, 65], "knee flexion");
  assert.ok(knee.slice(0, 20).some((flexion) => flexion > 15 && flexion < 20), "the knee gives way after heel strike");
  assertRange(samples("LeftHip", "Xrotation"), [-33, -27], [10, 16], "hip extension");
  assertRange(samples("LeftAnkle", "Xrotation"), [-18, -8], [15, 25], "plantarflexion");
  assertRange(samples("Hips", "Zrotation"), [-5, -3], [3, 5], "pelvic list");
  assertRange(samples("Hips", "Yrotation"), [-6, -4], [4, 6], "pelvic rotation");
  const heights = samples("Hips", "Yposition");
  assert.ok(range(heights)[1] - range(heights)[0] > 2 && range(heights)[1] - range(heights)[0] < 5, "rise of the pelvis");
});

test("knees and elbows are hinges that bend one way", () => {
  for (const side of ["Left", "Right"]) {
    const others = [...samples(`${side}Knee`, "Zrotation"), ...samples(`${side}Knee`, "Yrotation")];
    assert.ok(others.every((value) => value === 0));
    const sign = side === "Left" ? -1 : 1;
    assert.ok(samples(`${side}Elbow`, "Yrotation").every((value) => sign * value > 5 && sign * value < 60));
  }
});

test("the head looks ahead and the arms swing against the legs", () => {
  for (const pose of poses) {
    const ahead = turned(pose[index("Head")].rotation, [0, 0, 1]);
    assert.ok(ahead[2] > Math.cos((5 * Math.PI) / 180));
  }
  const heelStrike = poses[framesPerCycle];
  const z = (name) => heelStrike[index(name)].position[2];
  assert.ok(z("LeftAnkle") > z("RightAnkle") && z("LeftWrist") < z("RightWrist"));
});

test("no angle jumps: successive differences change by little", () => {
  for (let channel = 0; channel < clip.rows[0].length; channel++) {
    for (let frame = 1; frame + 1 < frameCount; frame++) {
      const [before, here, after] = [-1, 0, 1].map((step) => clip.rows[frame + step][channel]);
      assert.ok(Math.abs(after - 2 * here + before) < 4, `channel ${channel}, frame ${frame + 1}`);
    }
  }
});
