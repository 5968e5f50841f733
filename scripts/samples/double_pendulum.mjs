import { bvhText } from "./bvh_text.mjs";
import { toDegrees } from "./rotation.mjs";

// Two equal point masses on two equal rods, released from rest with the upper rod level and the lower one hanging:
// a swing that never repeats. The equations of motion are integrated by the classical Runge-Kutta method, in steps so
// small that the energy keeps twelve digits.

const rodLength = 60;  // cm
const gravity = 980.665;  // cm/s^2
const framesPerSecond = 60;
const frameCount = 600;
const stepsPerFrame = 200;

/** Rates of { upper angle, lower angle, upper rate, lower rate }; angles against the vertical in radians. */
function rates([upper, lower, upperRate, lowerRate]) {
  const [s, c] = [Math.sin(upper - lower), Math.cos(upper - lower)];
  const pull = gravity / rodLength;
  const upperForce = -s * lowerRate ** 2 - 2 * pull * Math.sin(upper);
  const lowerForce = s * upperRate ** 2 - pull * Math.sin(lower);
  const inertia = 2 - c * c;
  return [upperRate, lowerRate, (upperForce - c * lowerForce) / inertia, (2 * lowerForce - c * upperForce) / inertia];
}

const moved = (state, rate, time) => state.map((value, i) => value + rate[i] * time);

function stepped(state, time) {
  const k1 = rates(state);
  const k2 = rates(moved(state, k1, time / 2));
  const k3 = rates(moved(state, k2, time / 2));
  const k4 = rates(moved(state, k3, time));
  return state.map((value, i) => value + (time / 6) * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]));
}

/** Energy per mass in cm^2/s^2, 0 with both rods level and at rest. */
export function energy([upper, lower, upperRate, lowerRate]) {
  const kinetic = rodLength ** 2 *
    (upperRate ** 2 + lowerRate ** 2 / 2 + upperRate * lowerRate * Math.cos(upper - lower));
  return kinetic - gravity * rodLength * (2 * Math.cos(upper) + Math.cos(lower));
}

/** The state at every frame. */
export function swing(start = [Math.PI / 2, 0, 0, 0]) {
  const states = [start];
  while (states.length < frameCount) {
    let state = states.at(-1);
    for (let i = 0; i < stepsPerFrame; i++) state = stepped(state, 1 / (framesPerSecond * stepsPerFrame));
    states.push(state);
  }
  return states;
}

export const doublePendulum = () => {
  const lower = { name: "Lower", offset: [0, -rodLength, 0], channels: ["Zrotation"], endSite: [0, -rodLength, 0] };
  return bvhText({
    root: { name: "Upper", offset: [0, 140, 0], channels: ["Zrotation"], children: [lower] },
    frameTime: String(1 / framesPerSecond),
    rows: swing().map(([upper, low]) => [toDegrees(upper), toDegrees(low - upper)]),
  });
};
