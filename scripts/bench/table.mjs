// The goals of docs/performance.md beside what was measured.

const perSecond = (count, ms, unit) => `${((count / ms) * 1e3 / 1e6).toFixed(1)} M${unit}/s`;

/** [what, Marey, peer, ratio, goal] for each goal. */
export function goalRows({ native: { times }, node, chromium }) {
  const { bytes, frames, joints, poses } = node.facts;
  const row = (what, count, unit, own, peerName, peer, goal) => {
    const ratio = peer / own;
    const verdict = ratio >= goal ? "reached" : "missed";
    return [what, perSecond(count, own, unit), `${peerName} ${perSecond(count, peer, unit)}`, `${ratio.toFixed(1)}x`, `${goal}x ${verdict}`];
  };
  const reading = (what, own, name, peer, goal) => row(what, bytes, "B", own, name, peer, goal);
  const posing = (what, own, name, peer, goal, count = frames) => row(what, count * joints, " joint-frames", own, name, peer, goal);
  return [
    reading("read, native", times["read/marey"], "fast_float scan", times["read/fast_float_scan"], 2),
    reading("read, in Chromium", chromium.results.read.marey, "three", chromium.results.read.three, 30),
    reading("read, in Node", node.results.read.marey, "three", node.results.read.three, 30),
    reading("write, native", times["write/marey"], "fprintf loop", times["write/fprintf"], 15),
    posing("pose a clip, native", times["fk/clip/marey"], "GLM loop", times["fk/clip/glm_matrices"], 8),
    posing("pose a clip, native", times["fk/clip/marey"], "three in Node", node.results.clip.three, 35),
    posing("pose a clip, in Chromium", chromium.results.clip.marey, "three", chromium.results.clip.three, 20),
    posing("pose a frame, in Chromium", chromium.results.pose.marey, "three", chromium.results.pose.three, 5, poses),
    posing("pose a frame, in Node", node.results.pose.marey, "three", node.results.pose.three, 5, poses),
  ];
}

const milliseconds = (ms) => `${ms.toFixed(ms < 100 ? 1 : 0)} ms`;

const timeGoal = (ms, most) => `${most} ms ${ms <= most ? "reached" : "missed"}`;

/** [what, median, goal] of inverse dynamics. */
export function mechanicsRows({ native: { times }, node }) {
  return [
    ["torques, native", milliseconds(times["mechanics/torques"]), timeGoal(times["mechanics/torques"], 150)],
    ["torques, in Node", milliseconds(node.torques), timeGoal(node.torques, 300)],
  ];
}

/** [what, median, goal] of the page: `frames` as measurePage() gives them, `load` as measureFirstLoad() does. */
export function pageRows({ frames, load }) {
  return [
    ["first frame after the address", milliseconds(load.firstFrame), ""],
    ["a sample is open after the address", milliseconds(load.sample), ""],
    ["100,000 frames x 201 channels: redraw of all curves", milliseconds(frames.curves), timeGoal(frames.curves, 4)],
    ["a frame of the page without curves", milliseconds(frames.without), ""],
    ["a frame with all curves", milliseconds(frames.redraw), ""],
    ["the same, zooming in time", milliseconds(frames.zoom), ""],
    ["the same, scrubbing", milliseconds(frames.scrub), ""],
    ["the same, playing", milliseconds(frames.playing), ""],
  ];
}

export function printTable(header, rows) {
  const table = [header, ...rows];
  const widths = header.map((_, column) => Math.max(...table.map((row) => row[column].length)));
  for (const row of table) {
    console.log(row.map((cell, column) => (column === 0 ? cell.padEnd(widths[0]) : cell.padStart(widths[column]))).join("  "));
  }
}
