// docs/diagnostics.md has one row for each code of core, with the code's severity and what a strict reader does.
import { readFileSync } from "node:fs";

const root = new URL("../../", import.meta.url);
const header = "core/base/diagnostic_code.h";
const table = "core/base/diagnostic_code.cpp";
const page = "docs/diagnostics.md";

// A file that `files` lacks is read from the repository, so that a seed is one file.
const textOf = (files, path) => files.find((file) => file.path === path)?.text ?? readFileSync(new URL(path, root), "utf8");

const withoutComments = (text) => text.replace(/\/\*[\s\S]*?\*\/|\/\/.*$/gm, "");

function findCodes(text) {
  const body = /enum class DiagnosticCode\s*\{([^}]*)\}/.exec(withoutComments(text))?.[1] ?? "";
  return body.split(",").map((name) => name.trim()).filter(Boolean);
}

/** From code to what its row of docs/diagnostics.md has to say. */
function findTraits(text) {
  const rows = withoutComments(text).matchAll(/\{\s*Code::(\w+),\s*"(\w+)",\s*Severity::(\w+),\s*(true|false)\s*\}/g);
  return new Map([...rows].map(([, code, id, severity, refused]) =>
    [code, { id, facts: `${severity.toLowerCase()}, ${refused === "true" ? "refuses" : "reports"}` }]));
}

/** Rows of the tables whose head is "| code | severity | strict | ...". */
function findRows(text) {
  const rows = [];
  let inTable = false;
  for (const [index, line] of text.split("\n").entries()) {
    const cells = line.split("|").slice(1, -1).map((cell) => cell.trim());
    if (!line.startsWith("|")) inTable = false;
    else if (!inTable) inTable = cells[0] === "code";
    else if (!/^-+$/.test(cells[0])) rows.push({ line: index + 1, id: cells[0].replaceAll("`", ""), facts: `${cells[1]}, ${cells[2]}` });
  }
  return rows;
}

function compare(rows, traits) {
  const problems = [];
  const byId = new Map([...traits.values()].map((trait) => [trait.id, trait]));
  for (const { line, id, facts } of rows) {
    const right = byId.get(id)?.facts;
    if (!right) problems.push(`${page}:${line}: core has no code "${id}"`);
    else if (right !== facts) problems.push(`${page}:${line}: "${id}" is said to be "${facts}", in core it is "${right}"`);
    if (rows.find((row) => row.id === id).line !== line) problems.push(`${page}:${line}: "${id}" has a row already`);
  }
  return problems;
}

export const name = "diagnostics";
export const unit = "codes and rows";

export function check(files) {
  const codes = findCodes(textOf(files, header));
  const traits = findTraits(textOf(files, table));
  const rows = findRows(textOf(files, page));
  const known = new Set(rows.map(({ id }) => id));
  const problems = compare(rows, traits);
  if (codes.length === 0) problems.push(`${header}: no code was found`);
  for (const code of codes) {
    const id = traits.get(code)?.id;
    if (!id) problems.push(`${table}: no row for ${code}`);
    else if (!known.has(id)) problems.push(`${page}: no row for "${id}"`);
  }
  return { checked: codes.length + rows.length, problems };
}

const seed = (path, before, after) => ({ path, text: textOf([], path).replace(before, after) });
export const seeds = [
  seed(page, /^\| `row_length`.*\n/m, ""),
  seed(page, /^(\| )`row_length`(.*\n)/m, "$1`row_length`$2$1`row_width`$2"),
  seed(page, /^\| `row_length`.*\n/m, "$&$&"),
  seed(page, "| `row_length` | warning | refuses |", "| `row_length` | note | refuses |"),
  seed(page, "| `row_length` | warning | refuses |", "| `row_length` | warning | reports |"),
  seed(header, "  RowLength,\n", "  RowLength,\n  RowWidth,\n"),
  seed(table, '"row_length", Severity::Warning', '"row_length", Severity::Note'),
];
