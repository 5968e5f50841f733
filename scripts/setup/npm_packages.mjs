// The npm packages of package-lock.json; all of them are for building and testing, none is shipped with the core.
import { createHash } from "node:crypto";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { inRoot, run, say } from "../lib/shell.mjs";

const stamp = inRoot("node_modules", ".marey-lock.sha256");

export function needNpmPackages() {
  const lock = createHash("sha256").update(readFileSync(inRoot("package-lock.json"))).digest("hex");
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === lock) return;
  say("installing the npm packages of package-lock.json into node_modules");
  run("npm", ["ci", "--no-fund", "--no-audit", "--loglevel=error"]);
  writeFileSync(stamp, lock);
}
