/** A generator of numbers from a seed (mulberry32), with what is drawn from it. */
export function randomFrom(seed) {
  let state = seed | 0;
  const next = () => {
    state = (state + 0x6d2b79f5) | 0;
    let bits = Math.imul(state ^ (state >>> 15), 1 | state);
    bits = (bits + Math.imul(bits ^ (bits >>> 7), 61 | bits)) ^ bits;
    return ((bits ^ (bits >>> 14)) >>> 0) / 4294967296;
  };
  const below = (count) => Math.floor(next() * count);
  const pick = (list) => list[below(list.length)];
  return {
    next,
    below,
    pick,
    between: (low, high) => low + next() * (high - low),
    chance: (share) => next() < share,
    /** A key of `weights`, each as likely as its number says. */
    weighted(weights) {
      let rest = next() * Object.values(weights).reduce((sum, weight) => sum + weight, 0);
      return Object.keys(weights).find((key) => (rest -= weights[key]) < 0) ?? Object.keys(weights)[0];
    },
  };
}
