// docs/limits.md has one row for each limit of the reader, with its default, and names no other.
import { readFileSync } from "node:fs";

const root = new URL("../../", import.meta.url);
const header = "core/bvh/limits.h";
const page = "docs/limits.md";

// A file that `files` lacks is read from the repository, so that a seed is one file.
const textOf = (files, path) => files.find((file) => file.path === path)?.text ?? readFileSync(new URL(path, root), "utf8");

const withBlanks = (number) => String(number).replace(/\B(?=(\d{3})+$)/g, " ");
const gibibytes = (bytes) => (bytes === Infinity ? "none" : `${bytes / 2 ** 30} GiB`);

/** The value of an expression of the header, where addresses have 32 bits or not. */
function valueOf(expression, narrow) {
  const names = { kGibibyte: 2 ** 30, INT64_MAX: Infinity, kAddressesAre32Bit: narrow };
  const script = expression.replaceAll("'", "").replace(/\b[A-Za-z_]\w*\b/g, (name) => `(${names[name]})`);
  return Function(`return ${script};`)();
}

/** From the name of a limit to how its row has to say the default. */
function findDefaults(text) {
  const body = /struct ReadLimits \{([\s\S]*?)\n\};/.exec(text)?.[1] ?? "";
  const fields = [...body.matchAll(/^\s*(int|std::int64_t) (\w+) = ([^;]+);/gm)];
  return new Map(fields.map(([, type, name, expression]) => {
    const wide = valueOf(expression, false);
    if (type === "int") return [name, withBlanks(wide)];
    return [name, `${gibibytes(wide)}; WebAssembly ${gibibytes(valueOf(expression, true))}`];
  }));
}

function findRows(text) {
  const rows = text.split("\n").map((line) => line.split("|").slice(1, -1).map((cell) => cell.trim()));
  return rows.filter((cells) => /^`max_\w+`$/.test(cells[3] ?? "")).map((cells) => ({ name: cells[3].replaceAll("`", ""), value: cells[1] }));
}

export const name = "limits";
export const unit = "limits and rows";

export function check(files) {
  const defaults = findDefaults(textOf(files, header));
  const rows = findRows(textOf(files, page));
  const problems = rows.filter(({ name, value }) => defaults.get(name) !== value)
    .map(({ name, value }) => `${page}: ${name} is said to be "${value}", in core it is "${defaults.get(name)}"`);
  const missing = [...defaults.keys()].filter((name) => !rows.some((row) => row.name === name));
  problems.push(...missing.map((name) => `${page}: no row for ${name}`));
  if (defaults.size === 0) problems.push(`${header}: no limit was found`);
  return { checked: defaults.size + rows.length, problems };
}

const seed = (path, before, after) => ({ path, text: textOf([], path).replace(before, after) });
export const seeds = [
  seed(page, "| 10 000 |", "| 20 000 |"),
  seed(page, "3 GiB; WebAssembly 1 GiB", "3 GiB; WebAssembly 2 GiB"),
  seed(page, /^.*`max_depth` \|\n/m, ""),
  seed(header, "max_frames = 10'000'000", "max_frames = 1'000'000"),
  seed(header, "  int max_depth", "  int max_names = 7;\n  int max_depth"),
];
