// Configures and builds the presets of CMakePresets.json.
import { readFileSync } from "node:fs";
import { Failure, capture, inRoot, run } from "../lib/shell.mjs";

export function configurePreset(preset) {
  const { ok, stdout, stderr } = capture("cmake", ["--preset", preset]);
  if (!ok) throw new Failure(`cmake --preset ${preset} failed:\n${stdout}${stderr}`);
}

/** Builds `targets` of a configured preset, or everything in it. */
export function buildPreset(preset, targets = []) {
  const chosen = targets.length > 0 ? ["--target", ...targets] : [];
  run("cmake", ["--build", "--preset", preset, ...chosen]);
}

/** Whether a configured preset has a target of this name. */
export function hasTarget(preset, target) {
  return readFileSync(inRoot("build", preset, "build.ninja"), "utf8").includes(`\nbuild ${target}: `);
}
