// How time and memory of reading grow with the size of a file and with the joints of its figure, native and under Node.
import { rmSync, statSync, writeFileSync } from "node:fs";
import { Failure, capture, inRoot, say } from "../lib/shell.mjs";
import { benchClip } from "./clip.mjs";
import { linePlot } from "./plot.mjs";

/** Frames that make some 1, 10, 100 and 500 MB of 60 joints. */
const frameCounts = [535, 5_345, 53_450, 267_250];
const jointCounts = [10, 30, 100, 300, 1000];
const framesOfJoints = 2_000;
const readings = ["native", "Node"];

const programs = {
  native: (clip) => [inRoot("build", "native", "tests", "marey_read_by_pieces"), [clip]],
  Node: (clip) => ["node", [inRoot("scripts", "bench", "read_in_node.mjs"), clip]],
};

/** { seconds, peakBytes, sampleBytes } of reading a clip: the quickest of three. */
function measure(reading, clip) {
  const runs = Array.from({ length: 3 }, () => {
    const { ok, stdout, stderr } = capture(...programs[reading](clip));
    if (!ok) throw new Failure(`reading ${clip} failed (${reading}): ${stderr.trim().split("\n").at(-1)}`);
    return JSON.parse(stdout);
  });
  return runs.sort((a, b) => a.seconds - b.seconds)[0];
}

/** A row for each clip: its joints, frames, bytes, and what each reading took. */
function measureClips(sizes) {
  return sizes.map(({ joints, frames }) => {
    const clip = benchClip({ joints, frames });
    const bytes = statSync(clip).size;
    say(`reading ${joints} joints x ${frames} frames, ${(bytes / 1e6).toFixed(0)} MB`);
    const row = { joints, frames, bytes, ...Object.fromEntries(readings.map((reading) => [reading, measure(reading, clip)])) };
    if (bytes > 5e7) rmSync(clip);
    return row;
  });
}

const number = (value) => value.toFixed(value < 10 ? 2 : value < 100 ? 1 : 0);

function cellsOf({ joints, frames, bytes, native, Node: node }) {
  const samples = native.sampleBytes / 1e6;
  return [joints, frames, number(bytes / 1e6), number(samples), number(native.seconds), number(node.seconds),
    number(native.peakBytes / 1e6), number(node.peakBytes / 1e6)].map(String);
}

/** The table of docs/performance.md, as Markdown. */
export function growthTable(rows) {
  const header = ["joints", "frames", "file, MB", "samples, MB", "native, s", "Node, s", "native peak, MB", "Node heap of the program, MB"];
  return [header, header.map(() => "---"), ...rows.map(cellsOf)].map((cells) => `| ${cells.join(" | ")} |`).join("\n");
}

/** The most memory of reading a clip beside what its samples take, as a sentence. */
export function peakMemory(clip) {
  const { peakBytes, sampleBytes } = measure("native", clip);
  const most = 1.15 * sampleBytes + 8e6;
  return `peak memory while reading, native: ${number(peakBytes / 1e6)} MB for ${number(sampleBytes / 1e6)} MB of samples; ` +
    `goal ${number(most / 1e6)} MB ${peakBytes <= most ? "reached" : "missed"}`;
}

function plotOf(rows, quantity, title, unit, scale, xTitle, xOf) {
  return linePlot({
    title, xTitle, yTitle: unit,
    lines: readings.map((reading) => ({ name: reading, points: rows.map((row) => [xOf(row), row[reading][quantity] * scale]) })),
  });
}

/** Measures, writes docs/images/growth-*.svg, and gives the rows: by size, then by joints. */
export function measureGrowth() {
  const bySize = measureClips(frameCounts.map((frames) => ({ joints: 60, frames })));
  const byJoints = measureClips(jointCounts.map((joints) => ({ joints, frames: framesOfJoints })));
  const megabytes = ({ bytes }) => bytes / 1e6;
  const joints = (row) => row.joints;
  const plots = {
    "growth-time-size": plotOf(bySize, "seconds", "Time to read, by size", "s", 1, "file, MB", megabytes),
    "growth-memory-size": plotOf(bySize, "peakBytes", "Most memory while reading, by size", "MB", 1e-6, "file, MB", megabytes),
    "growth-time-joints": plotOf(byJoints, "seconds", "Time to read 2000 frames, by joints", "s", 1, "joints", joints),
    "growth-memory-joints": plotOf(byJoints, "peakBytes", "Most memory for 2000 frames, by joints", "MB", 1e-6, "joints", joints),
  };
  for (const [name, svg] of Object.entries(plots)) writeFileSync(inRoot("docs", "images", `${name}.svg`), svg);
  return [...bySize, ...byJoints];
}
