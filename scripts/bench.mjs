// npm run bench: builds, measures Marey beside others in one run, and prints the table of goals. Arguments go to the
// native benchmarks, whose own table follows; `npm run bench -- growth` measures files from 1 to 500 MB and figures of 10 to 1000
// joints instead, and draws docs/images/growth-*.svg.
import { cpus } from "node:os";
import { benchClip, bodyClip } from "./bench/clip.mjs";
import { growthTable, measureGrowth, peakMemory } from "./bench/growth.mjs";
import { measureFirstLoad } from "./bench/first_load.mjs";
import { compareInChromium } from "./bench/in_chromium.mjs";
import { measurePage } from "./bench/in_page.mjs";
import { measureNatively } from "./bench/native.mjs";
import { goalRows, mechanicsRows, pageRows, printTable } from "./bench/table.mjs";
import { buildPreset, configurePreset } from "./build/cmake.mjs";
import { buildSite } from "./build/site.mjs";
import { Failure, capture, inRoot, main, say } from "./lib/shell.mjs";
import { setUpBench } from "./setup/index.mjs";

function compareInNode(clip) {
  const { ok, stdout, stderr } = capture("node", [inRoot("scripts/bench/in_node.mjs"), clip, bodyClip()]);
  if (!ok) throw new Failure(`the comparison under Node failed: ${stderr.trim().split("\n").at(-1)}`);
  return JSON.parse(stdout);
}

await main(async () => {
  await setUpBench();
  configurePreset("native");
  buildPreset("native", ["marey_bench", "marey_read_by_pieces"]);
  await buildSite();
  if (process.argv[2] === "growth") {
    console.log(growthTable(measureGrowth()));
    return;
  }
  const clip = benchClip();
  say(`measuring on ${cpus().length} cores (${cpus()[0].model}), each part on one`);
  const native = measureNatively(clip, process.argv.slice(2));
  const node = compareInNode(clip);
  const chromium = await compareInChromium(clip);
  const { frames, joints, bytes } = node.facts;
  say(`the clip: ${joints} joints, ${frames} frames, ${(bytes / 1e6).toFixed(1)} MB; Chromium ${chromium.version}, Node ${process.version}`);
  printTable(["what", "Marey", "peer", "times as fast", "goal"], goalRows({ native, node, chromium }));
  say("mechanics: samples to the torques of all joints, 20 joints, 10,000 frames");
  printTable(["what", "median", "goal"], mechanicsRows({ native, node }));
  say(peakMemory(clip));
  const page = { load: await measureFirstLoad(), frames: await measurePage() };
  say("the page in Chromium, processor time of a frame");
  printTable(["what", "median", "goal"], pageRows(page));
  say("the native benchmarks");
  printTable(["benchmark", "median", "items", "bytes"], native.rows);
});
