// One walking cycle runs from one heel strike of the left foot to the next: phase 0 .. 1. The right side does the same
// half a cycle later.

export const cycles = 3;
/** At 60 frames per second. */
export const framesPerCycle = 64;
/** Centimetres per cycle; 1.35 m/s. */
export const strideLength = 144;

// Phases of the left foot.
export const footFlat = 0.115;
export const heelOff = 0.298;
export const toesRoll = 0.4975;
export const toeOff = 0.6;
