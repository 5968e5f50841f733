import { bvhText } from "./bvh_text.mjs";
import { jacobiSn, quarterPeriod } from "./elliptic.mjs";
import { toDegrees } from "./rotation.mjs";

// A point mass on a rod, released from rest at 90 degrees. The motion is known exactly:
//   sin(angle / 2) = k sn(w t + K),  k = sin(amplitude / 2),  w = sqrt(g / length),  period = 4 K / w.
// The length is chosen so that one period is a whole number of frames, and the clip loops.

const amplitude = Math.PI / 2;
const framesPerSecond = 60;
const framesPerPeriod = 156;
const periods = 3;
const gravity = 980.665;  // cm/s^2

const modulus = Math.sin(amplitude / 2);
const rate = (4 * quarterPeriod(modulus) * framesPerSecond) / framesPerPeriod;
const length = gravity / rate ** 2;

function angleAt(frame) {
  const argument = rate * (frame / framesPerSecond) + quarterPeriod(modulus);
  return toDegrees(2 * Math.asin(modulus * jacobiSn(argument, modulus)));
}

export const pendulum = () => bvhText({
  root: { name: "Pivot", offset: [0, 140, 0], channels: ["Zrotation"], endSite: [0, -length, 0] },
  frameTime: String(1 / framesPerSecond),
  rows: Array.from({ length: periods * framesPerPeriod }, (_, frame) => [angleAt(frame % framesPerPeriod)]),
});
