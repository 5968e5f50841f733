// Everything that has to be there before something is built. Each part looks first and only then installs.
import { Failure } from "../lib/shell.mjs";
import { needImgui } from "./imgui.mjs";
import { needNpmPackages } from "./npm_packages.mjs";
import { needSystemPackages } from "./system_packages.mjs";

function needNode() {
  if (Number(process.versions.node.split(".")[0]) < 18) throw new Failure(`Node 18 or newer is needed, this is ${process.version}`);
}

export function setUpNative() {
  needNode();
  needSystemPackages(["native"]);
}

export async function setUpBench() {
  needNode();
  needSystemPackages(["native", "page", "bench", "test"]);
  needNpmPackages();
  await needImgui();
}

export function setUpFuzz() {
  needNode();
  needSystemPackages(["native", "fuzz"]);
}

export async function setUpPage() {
  needNode();
  needSystemPackages(["native", "page"]);
  needNpmPackages();
  await needImgui();
}

/** The tests need what the benchmarks need. */
export const setUpTests = setUpBench;
