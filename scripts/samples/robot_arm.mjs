import { bvhText } from "./bvh_text.mjs";
import {
  cross, dot, fromColumns, multiply, normalized, rotationX, rotationY, scaled, subtract, toDegrees, transposed,
} from "./rotation.mjs";

// A six-axis industrial arm of 1.3 m reach with a gripper, centimetres, facing +Z: one rotation channel per axis, the
// upper arm upright and the forearm level in the rest pose. It carries a part from a table to a tilted tray.

const shoulder = [0, 56, 4];
const elbow = [0, 62, 0];
const forearm = [0, 6, 17];
const wrist = [0, 0, 46];
const flange = [0, 0, 11];
const fingerTip = [0, 0, 14];
const fingerSpread = 3;

const joint = (name, offset, channel, more) => ({ name, offset, channels: [channel], ...more });

function makeArm() {
  const fingers = [1, -1].map((sign) =>
    joint(sign > 0 ? "LeftFinger" : "RightFinger", [sign * fingerSpread, 0, 3], "Yrotation",
      { endSite: [-sign * fingerSpread * 0.6, 0, fingerTip[2] - 3] }));
  const tool = joint("Flange", flange, "Zrotation", { children: fingers });
  const hand = joint("Wrist", wrist, "Xrotation", { children: [tool] });
  const roll = joint("Forearm", forearm, "Zrotation", { children: [hand] });
  const lower = joint("Elbow", elbow, "Xrotation", { children: [roll] });
  const upper = joint("Shoulder", shoulder, "Xrotation", { children: [lower] });
  return joint("Base", [0, 0, 0], "Yrotation", { children: [upper] });
}

/** Base, shoulder and elbow angles that bring the wrist to a point, elbow up. */
function armAngles(wristPoint) {
  const turn = toDegrees(Math.atan2(wristPoint[0], wristPoint[2]));
  const [upperLength, lowerLength] = [elbow[1], Math.hypot(forearm[1], forearm[2] + wrist[2])];
  const out = Math.hypot(wristPoint[0], wristPoint[2]) - shoulder[2];
  const up = wristPoint[1] - shoulder[1];
  const distance = Math.hypot(out, up);
  const opening = Math.acos((upperLength ** 2 + distance ** 2 - lowerLength ** 2) / (2 * upperLength * distance));
  const upperElevation = Math.atan2(up, out) + opening;
  const lowerElevation = Math.atan2(
    up - upperLength * Math.sin(upperElevation), out - upperLength * Math.cos(upperElevation));
  const restElevation = Math.atan2(forearm[1], forearm[2] + wrist[2]);
  const lean = 90 - toDegrees(upperElevation);
  return [turn, lean, toDegrees(restElevation - lowerElevation) - lean];
}

/** The six angles that bring the point between the finger tips to `tip`; the tool points along `approach`. */
function poseAt({ tip, approach, across }) {
  const forward = normalized(approach);
  const side = normalized(subtract(across, scaled(forward, dot(across, forward))));
  const tool = fromColumns(side, cross(forward, side), forward);
  const [turn, lean, bend] = armAngles(subtract(tip, scaled(forward, flange[2] + fingerTip[2])));
  const carried = multiply(rotationY(turn), rotationX(lean + bend));
  const hand = multiply(transposed(carried), tool);
  // Zrotation Xrotation Zrotation, the wrist bent downwards.
  return [
    turn, lean, bend, toDegrees(Math.atan2(hand[2], -hand[5])), toDegrees(Math.acos(hand[8])),
    toDegrees(Math.atan2(hand[6], hand[7])),
  ];
}

const lifted = (place, height) => ({ ...place, tip: subtract(place.tip, scaled(normalized(place.approach), height)) });

const part = { tip: [-53, 8, 56], approach: [0, -1, 0], across: [0.5, 0, 1] };
const tray = { tip: [64, 22, 31], approach: [-0.4, -0.9, 0.15], across: [1, 0, -0.5] };
const home = [0, -20, 10, 0, 60, 0];

const open = 24;
const closed = 0;
const steps = [
  { pose: poseAt(lifted(part, 18)), grip: open, frames: 60 },
  { pose: poseAt(part), grip: open, frames: 36 },
  { pose: poseAt(part), grip: closed, frames: 18 },
  { pose: poseAt(lifted(part, 18)), grip: closed, frames: 36 },
  { pose: poseAt(lifted(tray, 18)), grip: closed, frames: 84 },
  { pose: poseAt(tray), grip: closed, frames: 36 },
  { pose: poseAt(tray), grip: open, frames: 18 },
  { pose: poseAt(lifted(tray, 18)), grip: open, frames: 36 },
  { pose: home, grip: open, frames: 60 },
];

/** The way from 0 to 1 with the least jerk from rest to rest. */
const minimumJerk = (s) => s ** 3 * (10 - 15 * s + 6 * s * s);

function frameRows() {
  let from = [...home, open, -open];
  return steps.flatMap(({ pose, grip, frames }) => {
    const to = [...pose, grip, -grip];
    const rows = Array.from({ length: frames }, (_, i) => {
      const way = minimumJerk(i / frames);
      return from.map((value, channel) => value + way * (to[channel] - value));
    });
    from = to;
    return rows;
  });
}

export const robotArm = () => bvhText({ root: makeArm(), frameTime: "0.0166667", rows: frameRows() });
