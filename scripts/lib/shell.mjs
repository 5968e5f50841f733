// Running other programs from the scripts, and stopping with one clear line when something cannot be had.
import { spawnSync } from "node:child_process";
import { accessSync, constants } from "node:fs";
import { delimiter, join } from "node:path";
import { fileURLToPath } from "node:url";

export const root = fileURLToPath(new URL("../..", import.meta.url));
export const inRoot = (...parts) => join(root, ...parts);

// Clones of the same sources share what ccache has kept, wherever they lie.
process.env.CCACHE_BASEDIR ??= root;
process.env.CCACHE_NOHASHDIR ??= "true";

/** What went wrong in words that a person can act on; `main` prints it without a stack. */
export class Failure extends Error {}

export async function main(body) {
  try {
    await body();
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    console.error(`marey: ${error.message}`);
    process.exitCode = 1;
  }
}

export function say(text) {
  console.log(`marey: ${text}`);
}

export function hasProgram(name) {
  return (process.env.PATH ?? "").split(delimiter).some((folder) => {
    try {
      accessSync(join(folder, name), constants.X_OK);
      return true;
    } catch {
      return false;
    }
  });
}

/** Runs a program with its output shown; throws a Failure when it does not end with 0. */
export function run(command, args, options = {}) {
  const { status, error } = spawnSync(command, args, { cwd: root, stdio: ["ignore", "inherit", "inherit"], ...options });
  if (error) throw new Failure(`${command} could not be started (${error.code})`);
  if (status !== 0) throw new Failure(`${[command, ...args].join(" ")} failed`);
}

/** Runs a program silently; returns { ok, stdout, stderr }. */
export function capture(command, args, options = {}) {
  const result = spawnSync(command, args, { cwd: root, encoding: "utf8", maxBuffer: 1 << 28, ...options });
  return { ok: result.status === 0, stdout: result.stdout ?? "", stderr: result.stderr ?? String(result.error ?? "") };
}
