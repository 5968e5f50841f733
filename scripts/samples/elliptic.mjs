// Elliptic functions by the arithmetic-geometric mean (Abramowitz and Stegun 16.4, 17.6). `modulus` is k, 0 <= k < 1.

function geometricMeans(modulus) {
  const steps = [{ a: 1, b: Math.sqrt(1 - modulus * modulus), c: modulus }];
  while (Math.abs(steps.at(-1).c) > 1e-16) {
    const { a, b } = steps.at(-1);
    steps.push({ a: (a + b) / 2, b: Math.sqrt(a * b), c: (a - b) / 2 });
  }
  return steps;
}

/** The complete elliptic integral of the first kind, K(k): a quarter of the period of sn. */
export const quarterPeriod = (modulus) => Math.PI / (2 * geometricMeans(modulus).at(-1).a);

/** Jacobi's sn(u, k). */
export function jacobiSn(u, modulus) {
  const steps = geometricMeans(modulus);
  const last = steps.length - 1;
  let phi = 2 ** last * steps[last].a * u;
  for (let i = last; i > 0; i--) phi = (phi + Math.asin((steps[i].c / steps[i].a) * Math.sin(phi))) / 2;
  return Math.sin(phi);
}
