// The pictures of docs/operations.md, one for each operation that changes a curve or the rest pose, made by the operation
// itself on web/samples/walk.bvh: node scripts/operation_pictures.mjs
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { capture, Failure, inRoot, main } from "./lib/shell.mjs";
import { beforeAfterPlot, figurePlot, namesPlot } from "./docs/before_after.mjs";
import { parseBvh, restPose } from "./docs/small_bvh.mjs";

const marey = inRoot("build", "native", "marey");
const sample = inRoot("web", "samples", "walk.bvh");
const swing = readFileSync(inRoot("web", "samples", "giant-swing.bvh"), "utf8");
const noisy = "noise amplitude=2 seed=3 joints=LeftKnee";
const layer = ["layer-add name=Fix", "key layer=Fix joints=LeftKnee channels=Xrotation frame=60 value=0 of=layer",
  "key layer=Fix joints=LeftKnee channels=Xrotation frame=90 value=-30 of=layer",
  "key layer=Fix joints=LeftKnee channels=Xrotation frame=120 value=0 of=layer"];
const keyed = ["to-keys tolerance=2 joints=LeftKnee"];
const knee = "joints=LeftKnee";
const part = `${knee} frames=70:110`;

/** A chain as some programs write it, with a position in each joint. */
const sixChannels = `HIERARCHY
ROOT Hips
{
OFFSET 0 90 0
CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
${["Spine", "Chest", "Head"].map((name) => `JOINT ${name}\n{\nOFFSET 0 20 0\n\
CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n`).join("")}End Site\n{\nOFFSET 0 15 0\n}\n}\n}\n}\n}
MOTION
Frames: 1
Frame Time: 0.01
0 90 0 0 0 0 ${"0 20 0 0 0 0 ".repeat(3)}
`;

/** What each picture shows: `before` and `step` on a channel, or on the rest pose. */
const pictures = {
  smooth: { before: [noisy], step: `smooth sigma=3 ${part} blend-in=5 blend-out=5` },
  butterworth: { before: [noisy], step: `butterworth cutoff=6 ${knee}` },
  "savitzky-golay": { before: [noisy], step: `savitzky-golay window=15 ${knee}` },
  median: { before: [noisy], step: `median window=9 ${knee}` },
  despike: { before: [`offset by=25 ${knee} frames=80`, `offset by=20 ${knee} frames=145`], step: `despike ${knee}` },
  "fill-gaps": { before: [`hold ${part}`], step: `fill-gaps still=10 ${knee}` },
  scale: { step: `scale factor=1.5 ${part} blend-in=10 blend-out=10` },
  offset: { step: `offset by=15 ${part} blend-in=10 blend-out=10` },
  "time-offset": { step: `time-offset by=10 ${knee} ends=loop` },
  noise: { step: `noise amplitude=4 period=4 ${part}` },
  reverse: { step: `reverse ${part}` },
  hold: { step: `hold ${part}` },
  "blend-neighbour": { step: `blend-neighbour factor=-0.7 ${part}` },
  "blend-default": { step: `blend-default factor=0.7 ${part} blend-in=10 blend-out=10` },
  "blend-ease": { step: `blend-ease factor=0.8 ${part}` },
  "push-pull": { step: `push-pull factor=0.3 ${part}` },
  breakdown: { step: `breakdown factor=0.5 ${part}` },
  "match-slope": { step: `match-slope factor=-0.6 ${part}` },
  "loop-match": { step: `loop-match ${knee} frames=40:150` },
  unroll: { before: [`offset by=360 ${knee} frames=80:100`], step: `unroll ${knee}` },
  "solve-angles": { before: [`offset by=360 ${knee} frames=80:100`], step: `solve-angles ${knee}` },
  "rotation-filter": { before: [noisy], step: `rotation-filter sigma=3 ${knee}` },
  mirror: { step: "mirror" },
  "in-place": { step: "in-place", channel: "Hips Zposition" },
  turn: { step: "turn angle=60", channel: "Hips Xposition" },
  move: { step: "move z=100", channel: "Hips Zposition" },
  "zero-start": { before: ["move z=80"], step: "zero-start", channel: "Hips Zposition" },
  "path-scale": { step: "path-scale factor=0.5", channel: "Hips Zposition" },
  retime: { step: "retime speed=2 frames=60:120" },
  "set-duration": { step: "set-duration seconds=1.6 frames=60:120" },
  warp: { step: "warp points=1:1,80:60,110:140,192:192" },
  resample: { step: "resample rate=15", byTime: true },
  trim: { step: "trim frames=60:120" },
  cut: { step: "cut frames=60:120" },
  insert: { step: "insert at=80 count=40 fill=blend" },
  append: { step: `append from=${sample}` },
  splice: { before: ["hold joints=LeftKnee"], step: `splice from=${sample} joints=LeftKnee frames=70:110 blend-in=8 blend-out=8` },
  "let-go": { clip: swing, step: "let-go frame=7 seconds=4 start=at-rest", channel: "Arms Zrotation" },
  "change-order": { step: "change-order order=xyz joints=LeftShoulder", channel: "LeftShoulder Zrotation" },
  "up-axis": { step: "up-axis to=z", figure: true },
  "rest-pose": { step: "rest-pose frame=40", figure: true },
  "scale-figure": { step: "scale-figure factor=0.7", figure: true },
  "delete-joint": { step: "delete-joint joints=LeftElbow", figure: true },
  "insert-joint": { step: "insert-joint joints=LeftElbow name=LeftTwist", figure: true },
  reparent: { step: "reparent joints=LeftShoulder to=Hips", figure: true },
  "to-keys": { step: `to-keys tolerance=4 interpolation=linear ${knee}` },
  key: { before: layer.slice(0, 2), step: "key layer=Fix joints=LeftKnee channels=Xrotation frame=90 value=-20" },
  "key-delete": { before: keyed, step: `key-delete ${part}` },
  "key-move": { before: keyed, step: `key-move by=6 value=-10 ${part}` },
  "key-interpolation": { before: keyed, step: `key-interpolation interpolation=linear ${knee}` },
  "key-handles": { before: keyed, step: `key-handles kind=flat ${knee}` },
  "key-extrapolation": { before: keyed.concat(`key-delete ${knee} frames=100:192`), step: `key-extrapolation behind=cycle ${knee}` },
  "layer-delete": { before: layer, step: "layer-delete" },
  "layer-mute": { before: layer, step: "layer-mute" },
  "layer-solo": { before: [...layer, "layer-add name=Other"], step: "layer-solo layer=Other" },
  "layer-mode": { before: layer, step: "layer-mode mode=override" },
  "layer-weight": { before: layer, step: "layer-weight value=0.5" },
  rename: { step: "rename from=Left* to=L_*", names: true },
  "remove-positions": { clip: sixChannels, step: "remove-positions", channels: true },
  // Layers, locks and keys are shown by the page: page_pictures.mjs.
  "to-samples": null, "key-insert": null, "layer-add": null, "layer-rename": null, "layer-order": null, "layer-lock": null,
  "layers-bake": null,
};

function edited(steps, clip) {
  const input = clip ?? readFileSync(sample, "utf8");
  if (steps.length === 0) return parseBvh(input);
  const { ok, stdout, stderr } = capture(marey, ["edit", "-", "-", ...steps.flatMap((step) => ["--do", step])], { input });
  if (!ok) throw new Failure(`${steps.join(" | ")}: ${stderr}`);
  return parseBvh(stdout);
}

function pictureOf({ clip, before = [], step, channel = "LeftKnee Xrotation", figure, byTime, names, channels }) {
  const [from, to] = [edited(before, clip), edited([...before, step], clip)];
  const caption = step.replaceAll(sample, "walk.bvh");
  if (names) return namesPlot({ caption, before: namesOf(from), after: namesOf(to) });
  if (channels) return namesPlot({ caption, before: channelsOf(from), after: channelsOf(to) });
  if (figure) return figurePlot({ caption, before: restPose(from), after: restPose(to) });
  const curve = (clip) => clip.curve(channel).map((value, i) => [byTime ? i * clip.frameTime * 60 + 1 : i + 1, value]);
  return beforeAfterPlot({ caption, title: channel, unit: channel.endsWith("position") ? "cm" : "°", before: curve(from), after: curve(to) });
}

function channelsOf({ joints, channels }) {
  return namesOf({ joints }).map((name) => {
    const own = channels.filter((channel) => channel.startsWith(`${name} `)).map((channel) => channel.split(" ")[1]);
    return `${name}: ${own.map((kind) => kind[0] + (kind.endsWith("position") ? "pos" : "rot")).join(" ")}`;
  });
}

function namesOf({ joints }) {
  return joints.map(({ name }) => name).filter((name) => name !== "");
}

await main(() => {
  const folder = inRoot("docs", "images", "operations");
  mkdirSync(folder, { recursive: true });
  const { operations } = JSON.parse(capture(marey, ["edit", "--list", "--json"]).stdout);
  let page = readFileSync(inRoot("docs", "operations.md"), "utf8");
  for (const { id } of operations) {
    if (!(id in pictures)) throw new Failure(`operation_pictures.mjs says nothing of ${id}`);
    if (!pictures[id]) continue;
    writeFileSync(inRoot("docs", "images", "operations", `${id}.svg`), pictureOf(pictures[id]));
    const image = `![${id}: before grey, after blue](images/operations/${id}.svg)`;
    if (!page.includes(image)) page = page.replace(new RegExp(`(### ${id}\n\n[^\n]*\n)`), `$1\n${image}\n`);
  }
  writeFileSync(inRoot("docs", "operations.md"), page);
});
