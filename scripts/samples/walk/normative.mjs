import { fourierFit } from "../curves.mjs";

// Joint angles of adults walking at their own pace, every 5 % of the cycle from heel strike, rounded to half a degree
// between the tables of Winter (2009) and the curves of Perry (1992); degrees in the sagittal plane.

const harmonics = 7;

/** Thigh against the vertical, knee ahead of the hip positive. */
export const thighAngle = fourierFit(
  [22, 22, 19, 14.5, 9.5, 4, -1.5, -6.5, -11, -15, -17.5, -16.5, -11, -1.5, 9, 17, 22.5, 25.5, 26, 24], harmonics);

/** Knee, flexion positive. */
export const kneeFlexion = fourierFit(
  [5, 11.5, 17, 18.5, 16.5, 13, 9.5, 7, 6, 7.5, 12, 22.5, 38, 53.5, 62, 60.5, 49, 31.5, 14, 4.5], harmonics);

/** Ankle, dorsiflexion positive. */
export const ankleDorsiflexion = fourierFit(
  [0, -4.5, -4, 0, 3, 5, 7, 8.5, 10, 10, 6.5, -3.5, -15, -17.5, -10, -3, 1, 2.5, 2, 0.5], harmonics);
