// The picture in README.md, from the built site in dist/: node scripts/readme_picture.mjs
import { spawnSync } from "node:child_process";
import { inRoot } from "./lib/shell.mjs";

const steps = [
  "wait:2000",
  "key:Escape",
  'select.joint={"joint":2}',
  'curve.select={"channel":9,"first":4,"count":8}',
  'curve.scale={"factor":0.75}',
  'play.go_to_frame={"frame":9}',
  "view.strobe",
  "view.trails",
  "wait:600",
];
const picture = inRoot("docs/images/marey.png");
const options = [picture, "--size", "1440x900", "--query", "sample=giant-swing", ...steps.flatMap((step) => ["--do", step])];
const { status } = spawnSync(process.execPath, [inRoot("scripts/screenshot.mjs"), ...options], { stdio: "inherit" });
process.exitCode = status ?? 1;
