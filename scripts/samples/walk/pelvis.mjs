import { wave } from "../curves.mjs";
import { fromZxy } from "../rotation.mjs";
import { strideLength } from "./timing.mjs";

// The pelvis through the cycle, the same for both steps: what turns and sways to the sides goes once per cycle, what
// pitches, rises and hurries goes twice.

/** { z, x, y } in degrees: the hip of the stance leg high, a slight tilt forwards, the hip of the leading leg ahead. */
export const pelvisAngles = (phase) => ({
  z: 3.2 * wave(phase, 0.17) + 0.6 * wave(3 * phase, 0.5),
  x: 5.3 + 0.8 * wave(2 * phase, 0.1),
  y: -4.5 * wave(phase, 0.02),
});

export const pelvisRotation = (phase) => fromZxy(pelvisAngles(phase));

/** Centimetres: over the stance foot in its middle, lowest soon after heel strike, fastest in double support. */
export const pelvisPosition = (phase) => [
  2.1 * wave(phase, 0.29),
  93.3 + 1.32 * wave(2 * phase, 0.48) + 0.13 * wave(4 * phase, 0.18),
  strideLength * phase + 0.6 * wave(2 * phase, 0.35),
];
