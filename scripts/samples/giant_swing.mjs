import { bvhText } from "./bvh_text.mjs";

// The backward giant swing of a gymnast from Lavshuk and Nwabuisi's paper on BVH files in the analysis and synthesis of
// movement: figure 3 with its nesting and its lost decimal points repaired, and the angles of figure 4 as printed:
// arms, body, legs in degrees.

const printedAngles = [
  [16.6, 7.0, -2.7], [27.8, 6.2, 0.2], [39.6, 5.5, 2.0], [52.7, 4.7, 0.8], [67.5, 3.9, -5.0], [84.1, 3.2, -15.8],
  [102.3, 2.8, -28.2], [121.9, 2.7, -36.5], [142.9, 2.9, -37.2], [164.8, 3.9, -31.4], [186.3, 6.4, -22.3],
  [205.5, 11.8, -11.1], [222.1, 20.6, -0.8], [237.3, 31.0, 3.9], [253.8, 38.2, 2.2], [272.9, 38.1, -2.3],
  [293.4, 31.3, -5.4], [312.2, 21.5, -5.5], [327.2, 12.7, -3.1], [338.7, 6.6, -0.3], [347.8, 3.5, 1.6],
  [355.8, 3.0, 2.3], [363.3, 4.1, 1.9],
];

const rotations = ["Zrotation", "Xrotation", "Yrotation"];

export const giantSwing = () => {
  const legs = { name: "Legs", offset: [0, 12, 0], channels: rotations, endSite: [0, 16, 0] };
  const body = { name: "Body", offset: [0, 10, 0], channels: rotations, children: [legs] };
  const positions = ["Xposition", "Yposition", "Zposition"];
  return bvhText({
    root: { name: "Arms", offset: [0, 0, 0], channels: [...positions, ...rotations], children: [body] },
    frameTime: "0.033333",
    rows: printedAngles.map(([arms, bodyAngle, legsAngle]) => [0, 0, 0, arms, 0, 0, bodyAngle, 0, 0, legsAngle, 0, 0]),
    indent: "  ",
    format: (value) => value.toFixed(1),
  });
};
