// Vectors are [x, y, z]; rotations are 3x3 matrices, row by row in one array of nine, acting on column vectors.
// Angles are in degrees, as in BVH files.

const radians = Math.PI / 180;

const sinDeg = (angle) => Math.sin(angle * radians);
const cosDeg = (angle) => Math.cos(angle * radians);
export const toDegrees = (angle) => angle / radians;

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scaled = (a, factor) => [a[0] * factor, a[1] * factor, a[2] * factor];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = (a) => Math.sqrt(dot(a, a));
export const normalized = (a) => scaled(a, 1 / length(a));
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

export function multiply(a, b) {
  const product = [];
  for (let row = 0; row < 9; row += 3) {
    for (let column = 0; column < 3; column++) {
      product.push(a[row] * b[column] + a[row + 1] * b[column + 3] + a[row + 2] * b[column + 6]);
    }
  }
  return product;
}

export const transposed = (a) => [a[0], a[3], a[6], a[1], a[4], a[7], a[2], a[5], a[8]];

export const rotate = (a, v) => [
  a[0] * v[0] + a[1] * v[1] + a[2] * v[2],
  a[3] * v[0] + a[4] * v[1] + a[5] * v[2],
  a[6] * v[0] + a[7] * v[1] + a[8] * v[2],
];

/** The rotation whose columns are the images of the axes. */
export const fromColumns = (x, y, z) => [x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]];

export function rotationX(angle) {
  const [s, c] = [sinDeg(angle), cosDeg(angle)];
  return [1, 0, 0, 0, c, -s, 0, s, c];
}

export function rotationY(angle) {
  const [s, c] = [sinDeg(angle), cosDeg(angle)];
  return [c, 0, s, 0, 1, 0, -s, 0, c];
}

function rotationZ(angle) {
  const [s, c] = [sinDeg(angle), cosDeg(angle)];
  return [c, -s, 0, s, c, 0, 0, 0, 1];
}

/** BVH's "Zrotation Xrotation Yrotation". */
export const fromZxy = ({ z, x, y }) => multiply(multiply(rotationZ(z), rotationX(x)), rotationY(y));

/** Angles of a rotation for fromZxy, x within -90 .. 90. */
export function toZxy(r) {
  return {
    z: toDegrees(Math.atan2(-r[1], r[4])),
    x: toDegrees(Math.atan2(r[7], Math.hypot(r[8], r[6]))),
    y: toDegrees(Math.atan2(-r[6], r[8])),
  };
}
