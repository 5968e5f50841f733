// The samples and recorded files, cut to their first frames, written for a program by the command line, beside Marey's own world
// positions of what was cut.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { root, run, sample, sampleNames, succeed } from "./cli.mjs";

const recordedFolder = join(process.env.MAREY_SHARED_DIR ?? join(root, "../shared"), "bvh");
const mostFrames = 40;

/** { name, file }: the samples, and the recorded files where that folder is there. */
export function sourceFiles() {
  const recorded = existsSync(recordedFolder) ? readdirSync(recordedFolder, { recursive: true }) : [];
  return [
    ...sampleNames.map((name) => ({ name, file: sample(name) })),
    ...recorded.filter((name) => name.toLowerCase().endsWith(".bvh")).sort().map((name) => ({ name, file: join(recordedFolder, name) })),
  ];
}

const infoOf = (file) => JSON.parse(run(["info", file, "--json"]).stdout);

/** World positions of all nodes, [frame][node * 3 + axis]; without frames none. */
function worldPositions(file) {
  const [, ...rows] = run(["fk", file]).stdout.trimEnd().split("\n");
  return rows.map((row) => row.split(",").slice(2).map(Number));
}

/** The first frames of a file in a file of their own; undefined where it cannot be read. */
export function cutFile({ name, file }, folder) {
  const { error, frame_count: frames } = infoOf(file);
  if (error) return undefined;
  const cut = join(folder, `${name.replaceAll(/[^\w.]/g, "_").replace(/\.bvh$/i, "")}.bvh`);
  const range = frames > 0 ? ["--frames", `1:${Math.min(frames, mostFrames)}`] : [];
  run(["convert", file, cut, ...range]);
  return cut;
}

/**
 * Writes a cut file for a target: { file, text, info, positions, nodes, addedFrames, largestMove }. `positions` are those
 * of the cut file, `nodes` says where its nodes are in the written one, -1 for nowhere.
 */
export function exportFile(cut, target) {
  const file = cut.replace(/\.bvh$/i, `.${target}.bvh`);
  const report = JSON.parse(succeed(["convert", cut, file, "--for", target, "--json"]));
  return {
    file,
    text: readFileSync(file, "utf8"),
    info: infoOf(file),
    stature: infoOf(cut).stature,
    positions: worldPositions(cut),
    nodes: report.nodes,
    addedFrames: report.added_frames,
    largestMove: report.largest_move,
  };
}

/** The largest distance of `point(node, frame)`, an [x, y, z] or undefined, from the clip's own positions; how many there were. */
export function compare(exported, point) {
  let largest = 0;
  let count = 0;
  exported.positions.forEach((row, frame) => {
    exported.nodes.forEach((node, original) => {
      const found = node < 0 ? undefined : point(node, frame + exported.addedFrames);
      if (!found) return;
      const distance = Math.hypot(...found.map((value, axis) => value - row[3 * original + axis]));
      if (!(distance <= largest)) largest = distance;
      count += 1;
    });
  });
  return { largest, count };
}
