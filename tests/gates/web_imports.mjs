// The page's TypeScript imports only what lies in web/ and the two programs made by Emscripten; the module knows
// nothing of the page.
import { posix } from "node:path";

const built = ["marey-app", "marey-module"];

function findFault(path, target) {
  if (built.includes(target) || target.startsWith("node:")) return undefined;
  if (!target.startsWith(".")) return "is a package; the page ships none";
  const file = posix.join(posix.dirname(path), target);
  if (!file.startsWith("web/")) return "leaves web/";
  if (path.startsWith("web/module/") && !file.startsWith("web/module/")) return "leaves web/module/";
  return undefined;
}

export const name = "imports of the page";
export const unit = "imports";

export function check(files) {
  const problems = [];
  let checked = 0;
  for (const { path, text } of files.filter((file) => /^web\/.*\.ts$/.test(file.path))) {
    for (const [, target] of text.matchAll(/\b(?:from|import)\s*\(?\s*"([^"]+)"/g)) {
      checked += 1;
      const fault = findFault(path, target);
      if (fault) problems.push(`${path}: "${target}" ${fault}`);
    }
  }
  return { checked, problems };
}

export const seeds = [
  { path: "web/src/seed.ts", text: 'import { Vector3 } from "three";\n' },
  { path: "web/module/seed.ts", text: 'import { open } from "../src/page.js";\n' },
  { path: "web/src/seed.ts", text: 'const all = await import("../../scripts/start.mjs");\n' },
];
