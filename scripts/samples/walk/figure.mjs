// A person of 175 cm in T-pose, facing +Z, Y up, left = +X; centimetres. The limbs after Drillis and Contini's fractions
// of stature (Winter, Biomechanics and Motor Control of Human Movement, figure 4.1): hip height 0.530, knee height 0.285,
// ankle height 0.039, shoulder height 0.818, forearm 0.146, foot length 0.152; the other lengths so that the arms span
// little more than the stature.

const rotations = ["Zrotation", "Xrotation", "Yrotation"];
const positions = ["Xposition", "Yposition", "Zposition"];

export const thighLength = 42.9;
export const shankLength = 43.1;
export const hipOffset = [8.8, -3.2, 0];
export const ankleHeight = 6.8;
/** From the ankle to the joint of the toes, which lies above the ball of the foot. */
export const toeOffset = [0, -5, 13];
export const toeTipOffset = [0, -0.8, 6.7];
/** From the ankle to the point of the sole under the heel; not a joint. */
export const heelOffset = [0, -ankleHeight, -5];

const joint = (name, offset, more) => ({ name, offset, channels: rotations, ...more });

function arm(side, sign) {
  const hand = joint(`${side}Wrist`, [sign * 25.3, 0, 0], { endSite: [sign * 17, 0, 0] });
  const forearm = joint(`${side}Elbow`, [sign * 30.2, 0, 0], { children: [hand] });
  const upperArm = joint(`${side}Shoulder`, [sign * 14.8, 0.5, -1.5], { children: [forearm] });
  return joint(`${side}Collar`, [sign * 2.5, 19.5, 1], { children: [upperArm] });
}

function leg(side, sign) {
  const toe = joint(`${side}Toe`, toeOffset, { endSite: toeTipOffset });
  const foot = joint(`${side}Ankle`, [0, -shankLength, 0], { children: [toe] });
  const shank = joint(`${side}Knee`, [0, -thighLength, 0], { children: [foot] });
  return joint(`${side}Hip`, [sign * hipOffset[0], hipOffset[1], hipOffset[2]], { children: [shank] });
}

export function makeFigure() {
  const head = joint("Head", [0, 10.5, 2], { endSite: [0, 17, 0.5] });
  const neck = joint("Neck", [0, 24.5, -1], { children: [head] });
  const chest = joint("Chest", [0, 18, -1], { children: [neck, arm("Left", 1), arm("Right", -1)] });
  const spine = joint("Spine", [0, 9, -1], { children: [chest] });
  return {
    name: "Hips",
    offset: [0, 0, 0],
    channels: [...positions, ...rotations],
    children: [spine, leg("Left", 1), leg("Right", -1)],
  };
}
