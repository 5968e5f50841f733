/** Polynomial of degree five through value, slope and curvature at both ends; arguments beyond the ends extend it. */
export function quintic(from, to) {
  const span = to.at - from.at;
  const [v0, s0, c0] = [from.value, from.slope * span, from.curvature * span * span];
  const [v1, s1, c1] = [to.value, to.slope * span, to.curvature * span * span];
  const rise = v1 - v0 - s0 - c0 / 2;
  const slopeRise = s1 - s0 - c0;
  const curvatureRise = c1 - c0;
  const a3 = 10 * rise - 4 * slopeRise + curvatureRise / 2;
  const a4 = -15 * rise + 7 * slopeRise - curvatureRise;
  const a5 = 6 * rise - 3 * slopeRise + curvatureRise / 2;
  return (at) => {
    const s = (at - from.at) / span;
    return v0 + s * (s0 + s * (c0 / 2 + s * (a3 + s * (a4 + s * a5))));
  };
}

const jetStep = 1e-3;

/** Value, slope and curvature of a smooth function by central differences over jetStep, as `quintic` takes them. */
export function jetOf(curve, at) {
  const [before, here, after] = [curve(at - jetStep), curve(at), curve(at + jetStep)];
  const [slope, curvature] = [(after - before) / (2 * jetStep), (after - 2 * here + before) / jetStep ** 2];
  return { at, value: here, slope, curvature };
}

/**
 * A periodic function with period 1 from its values at equally spaced phases: the Fourier terms up to `harmonics`,
 * which is the least-squares fit of that smoothness.
 */
export function fourierFit(values, harmonics) {
  const count = values.length;
  const terms = [];
  for (let harmonic = 0; harmonic <= harmonics; harmonic++) {
    let [cosine, sine] = [0, 0];
    values.forEach((value, i) => {
      cosine += value * Math.cos((2 * Math.PI * harmonic * i) / count);
      sine += value * Math.sin((2 * Math.PI * harmonic * i) / count);
    });
    const weight = (harmonic === 0 ? 1 : 2) / count;
    terms.push({ turn: 2 * Math.PI * harmonic, cosine: cosine * weight, sine: sine * weight });
  }
  const valueOf = ({ turn, cosine, sine }, phase) => cosine * Math.cos(turn * phase) + sine * Math.sin(turn * phase);
  return (phase) => terms.reduce((sum, term) => sum + valueOf(term, phase), 0);
}

/** cos of a whole turn per unit of phase, shifted so that it peaks at `peak`. */
export const wave = (phase, peak) => Math.cos(2 * Math.PI * (phase - peak));

/** Value, slope and curvature 0, as `quintic` takes them. */
export const stillAt = (at) => ({ at, value: 0, slope: 0, curvature: 0 });
