// dist/letters: Chinese, Japanese and Korean letters as files of a few dozen letters each, and the style sheet that tells
// the browser which file has which. Nothing of it is loaded before a letter is shown.
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { inRoot } from "../lib/shell.mjs";

// Unicode blocks that each package is taken for, first and last code point. No letter is in two: a browser loads both.
const packages = {
  "@fontsource-variable/noto-sans-kr": [[0x1100, 0x11ff], [0x3130, 0x318f], [0xa960, 0xa97f], [0xac00, 0xd7ff]],
  "@fontsource-variable/noto-sans-sc": [[0x2e80, 0x312f], [0x3190, 0xa95f], [0xf900, 0xffef]],
};

/** The letters of a rule that lie in `blocks`, as ranges. */
function lettersOf(rule, blocks) {
  const ranges = /unicode-range:\s*([^;}]+)/i.exec(rule)[1].split(",");
  return ranges.flatMap((range) => {
    const [first, last = first] = range.trim().slice(2).split("-").map((end) => parseInt(end, 16));
    return blocks.map(([low, high]) => [Math.max(first, low), Math.min(last, high)]).filter(([from, to]) => from <= to);
  });
}

/** The files of a package that have letters of `blocks`, with these as the text of a unicode-range. */
function rulesOf([name, blocks]) {
  const folder = inRoot("node_modules", name);
  const sheet = readFileSync(join(folder, "index.css"), "utf8");
  return [...sheet.matchAll(/@font-face\s*{[^}]*}/g)].flatMap(([rule]) => {
    const letters = lettersOf(rule, blocks);
    if (letters.length === 0) return [];
    const range = letters.map(([first, last]) => `U+${first.toString(16)}${last > first ? `-${last.toString(16)}` : ""}`).join(",");
    return [{ path: join(folder, /url\(\.\/([^)]+)\)/.exec(rule)[1]), range }];
  });
}

export function buildLetters(target) {
  mkdirSync(target, { recursive: true });
  const rules = Object.entries(packages).flatMap(rulesOf);
  for (const { path } of rules) copyFileSync(path, join(target, basename(path)));
  writeFileSync(join(target, "letters.css"), rules.map(({ path, range }) =>
    `@font-face{font-family:"Marey letters";font-weight:100 900;src:url(${basename(path)});unicode-range:${range}}`).join("\n"));
}
