import { bvhText } from "../bvh_text.mjs";
import { makeFigure } from "./figure.mjs";
import { legAngles } from "./leg.mjs";
import { pelvisAngles, pelvisPosition } from "./pelvis.mjs";
import { cycles, framesPerCycle, strideLength } from "./timing.mjs";
import { armAngles, trunkAngles } from "./upper_body.mjs";

const zxy = ({ z, x, y }) => [z, x, y];
const asSeenInMirror = ({ z, x, y }) => ({ z: -z, x, y: -y });
const same = (angles) => angles;

const armRow = (phase, side) => Object.values(armAngles(phase)).map(side).flatMap(zxy);

function legRow(phase, side) {
  const [hipZ, hipX, hipY, kneeX, ankleZ, ankleX, ankleY, toeX] = legAngles(phase);
  const joints = [
    { z: hipZ, x: hipX, y: hipY },
    { z: 0, x: kneeX, y: 0 },
    { z: ankleZ, x: ankleX, y: ankleY },
    { z: 0, x: toeX, y: 0 },
  ];
  return joints.map(side).flatMap(zxy);
}

function row(frame) {
  const phase = (frame % framesPerCycle) / framesPerCycle;
  const opposite = (phase + 0.5) % 1;
  const [sway, height, forward] = pelvisPosition(phase);
  const cycle = Math.floor(frame / framesPerCycle);
  const { spine, chest, neck, head } = trunkAngles(phase);
  return [
    sway, height, forward + (cycle - cycles / 2) * strideLength, ...zxy(pelvisAngles(phase)),
    ...[spine, chest, neck, head].flatMap(zxy),
    ...armRow(phase, same), ...armRow(opposite, asSeenInMirror),
    ...legRow(phase, same), ...legRow(opposite, asSeenInMirror),
  ];
}

/** A person walking at 1.35 m/s along +Z through the origin; the joint angles loop. */
export const walk = () => bvhText({
  root: makeFigure(),
  frameTime: "0.0166667",
  rows: Array.from({ length: cycles * framesPerCycle }, (_, frame) => row(frame)),
});
