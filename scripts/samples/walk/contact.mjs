import { quintic, stillAt } from "../curves.mjs";
import { add, multiply, rotate, rotationX, rotationY, subtract } from "../rotation.mjs";
import { ankleHeight, heelOffset, toeOffset, toeTipOffset } from "./figure.mjs";
import { footFlat, heelOff, toeOff, toesRoll } from "./timing.mjs";

// The left foot from heel strike to toe-off: it turns about the heel until it is flat, rests, turns about the joint of
// the toes while they stay flat, and at last about the tip of the toes. What it turns about does not move. The ends of
// the curves are chosen so that the leg above comes close to the normative angles.

const toeOutAngle = 7;
const halfStepWidth = 4.5;
/** How far the ankle of the flat foot lies ahead of where the pelvis is at heel strike. */
const plantDistance = 30.8;

// Pitch in degrees, toes up positive; slopes per cycle.
const footLowering = quintic({ at: 0, value: 18, slope: -425, curvature: 6900 }, stillAt(footFlat));
const footRising = quintic(stillAt(heelOff), { at: toeOff, value: -64.5, slope: -423, curvature: 1125 });
const toesRising = quintic(stillAt(toesRoll), { at: toeOff, value: -35, slope: -823, curvature: 0 });

function footPitch(phase) {
  if (phase < footFlat) return footLowering(phase);
  return phase < heelOff ? 0 : footRising(phase);
}

const toePitch = (phase) => (phase < toesRoll ? 0 : toesRising(phase));

const heading = rotationY(toeOutAngle);
const plantedAnkle = [halfStepWidth, ankleHeight, plantDistance];
const plantedHeel = add(plantedAnkle, rotate(heading, heelOffset));
const plantedToe = add(plantedAnkle, rotate(heading, toeOffset));
const plantedTip = add(plantedToe, rotate(heading, toeTipOffset));

/**
 * Where the foot is: { ankle, foot, toe }, a point and two world rotations, seen from the place on the floor where the
 * pelvis is at phase 0. 0 <= phase <= toeOff; slightly beyond, the curves go on.
 */
export function plantedFoot(phase) {
  const foot = multiply(heading, rotationX(-footPitch(phase)));
  if (phase < footFlat) return { ankle: subtract(plantedHeel, rotate(foot, heelOffset)), foot, toe: foot };
  const toe = multiply(heading, rotationX(-toePitch(phase)));
  const toeJoint = subtract(plantedTip, rotate(toe, toeTipOffset));
  return { ankle: subtract(toeJoint, rotate(foot, toeOffset)), foot, toe };
}
