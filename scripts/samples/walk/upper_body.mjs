import { wave } from "../curves.mjs";
import { fromZxy, multiply, toZxy, transposed } from "../rotation.mjs";
import { pelvisAngles } from "./pelvis.mjs";

const mean = (a, b) => ({ z: (a.z + b.z) / 2, x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 });

// World angles in degrees: the chest turns against the pelvis and leans over the stance foot, the head stays where it
// looks and nods against the rise of the body.
const chestAngles = (phase) => ({
  z: -1.2 * wave(phase, 0.28),
  x: 2.5 + 0.6 * wave(2 * phase, 0.6),
  y: 4 * wave(phase, 0.04),
});
const headAngles = (phase) => ({
  z: -0.3 * wave(phase, 0.28),
  x: 1.5 + 0.8 * wave(2 * phase, 0.54),
  y: 0.6 * wave(phase, 0.1),
});

const relative = (parent, child) => toZxy(multiply(transposed(fromZxy(parent)), fromZxy(child)));

/** { spine, chest, neck, head }: angles against the part below, the turning shared between two joints each. */
export function trunkAngles(phase) {
  const [pelvis, chest, head] = [pelvisAngles(phase), chestAngles(phase), headAngles(phase)];
  const [spine, neck] = [mean(pelvis, chest), mean(chest, head)];
  return {
    spine: relative(pelvis, spine),
    chest: relative(spine, chest),
    neck: relative(chest, neck),
    head: relative(neck, head),
  };
}

/**
 * The left arm { collar, shoulder, elbow, wrist }: lowered from the T-pose, forward with the right leg, the elbow
 * bending most when the hand is in front, the forearm and the hand slightly late.
 */
export function armAngles(phase) {
  return {
    collar: { z: -5, x: 0, y: 1 - 2.5 * wave(phase, 0.5) },
    shoulder: { z: -78 - 1.5 * wave(2 * phase, 0.5), x: 5, y: 4 - 16 * wave(phase, 0.5) },
    elbow: { z: 0, x: 0, y: -19 - 8 * wave(phase, 0.55) - 1.5 * wave(2 * phase, 0.55) },
    wrist: { z: -8 - 3 * wave(phase, 0.62), x: 22, y: 4 },
  };
}
