import { jetOf, quintic, stillAt } from "../curves.mjs";
import {
  add, cross, fromColumns, length, multiply, normalized, rotate, rotationX, scaled, subtract, toDegrees, toZxy,
  transposed,
} from "../rotation.mjs";
import { plantedFoot } from "./contact.mjs";
import { hipOffset, shankLength, thighLength } from "./figure.mjs";
import { ankleDorsiflexion, kneeFlexion, thighAngle } from "./normative.mjs";
import { pelvisAngles, pelvisPosition, pelvisRotation } from "./pelvis.mjs";
import { toeOff } from "./timing.mjs";

// The left leg. On the floor the foot is given and inverse kinematics bends the leg to it; in the air the joints follow
// the normative curves, bent near both ends so that they join the time on the floor.

/** The angle between the sides a and b of a triangle, degrees. */
const angleBetween = (a, b, opposite) => toDegrees(Math.acos((a * a + b * b - opposite * opposite) / (2 * a * b)));

/** The thigh's rotation and the knee's flexion for given ends of the leg; the knee points to `forward`. */
function bentLeg(hip, ankle, forward) {
  const line = subtract(ankle, hip);
  const reach = length(line);
  const up = scaled(line, -1 / reach);
  const hinge = normalized(cross(up, forward));
  const straight = fromColumns(hinge, up, cross(hinge, up));
  return {
    thigh: multiply(straight, rotationX(-angleBetween(thighLength, reach, shankLength))),
    flexion: 180 - angleBetween(thighLength, shankLength, reach),
  };
}

/** Halfway between the way ahead and the way the toes point, level. */
const kneeDirection = (foot) => [foot[2] * 0.5, 0, foot[8]];

function anglesOnFloor(phase) {
  const pelvis = pelvisRotation(phase);
  const hip = add(pelvisPosition(phase), rotate(pelvis, hipOffset));
  const { ankle, foot, toe } = plantedFoot(phase);
  const { thigh, flexion } = bentLeg(hip, ankle, kneeDirection(foot));
  const shank = multiply(thigh, rotationX(flexion));
  const atHip = toZxy(multiply(transposed(pelvis), thigh));
  const atAnkle = toZxy(multiply(transposed(shank), foot));
  const atToe = toZxy(multiply(transposed(foot), toe));
  return [atHip.z, atHip.x, atHip.y, flexion, atAnkle.z, atAnkle.x, atAnkle.y, atToe.x];
}

/** 0 at toe-off and at heel strike, 1 in the middle of the time in the air. */
const lift = (phase) => Math.sin((Math.PI * (phase - toeOff)) / (1 - toeOff)) ** 2;

const none = () => 0;
/**
 * Each joint's curve in the air, and the part of the cycle over which it is bent to the floor's angles after toe-off
 * and before heel strike. The toes are lifted a little more than on average, so that these stiff ones clear the floor.
 */
const jointsInAir = [
  { curve: none, join: 0.4 },
  { curve: (phase) => -thighAngle(phase) - pelvisAngles(phase).x, join: 0.16 },
  { curve: none, join: 0.4 },
  { curve: kneeFlexion, join: 0.16 },
  { curve: none, join: 0.4 },
  { curve: (phase) => -ankleDorsiflexion(phase) - 6 * lift(phase), join: 0.16 },
  { curve: none, join: 0.4 },
  { curve: (phase) => -10 * lift(phase), join: 0.16 },
];

/** The curve bent so that it joins the floor's angles. At heel strike acceleration may jump: that is an impact. */
function joinedToFloor({ curve, join }, i) {
  const miss = (phase) => anglesOnFloor(phase > 0.9 ? phase - 1 : phase)[i] - curve(phase);
  const leaving = quintic(jetOf(miss, toeOff), stillAt(toeOff + join));
  const landing = quintic(stillAt(1 - join), { ...jetOf(miss, 1), curvature: 0 });
  return (phase) =>
    curve(phase) + (phase < toeOff + join ? leaving(phase) : 0) + (phase > 1 - join ? landing(phase) : 0);
}

const curvesInAir = jointsInAir.map(joinedToFloor);

/** [hip z, x, y, knee x, ankle z, x, y, toe x] in degrees. 0 <= phase < 1. */
export const legAngles = (phase) =>
  phase <= toeOff ? anglesOnFloor(phase) : curvesInAir.map((curve) => curve(phase));
