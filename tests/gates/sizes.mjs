// Files of at most 400 lines, functions of at most 40.
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, normalize } from "node:path";
import ts from "typescript";

const maxFileLines = 400;
const maxFunctionLines = 40;
const isCpp = (path) => /\.(h|cpp)$/.test(path);
const isScript = (path) => /\.(ts|js|mjs|cjs)$/.test(path);
const isSource = (path) => isCpp(path) || isScript(path) || /\.(css|html|cmake|sh)$|CMakeLists\.txt$/.test(path);

/** Functions of C++ files as { path, name, line, lines }, by universal-ctags, which reads files only. */
function findCppFunctions(files) {
  const folder = mkdtempSync(join(tmpdir(), "marey-gate-"));
  try {
    for (const { path, text } of files) {
      mkdirSync(dirname(join(folder, path)), { recursive: true });
      writeFileSync(join(folder, path), text);
    }
    const args = ["-R", "--languages=C++", "--map-C++=+.h", "--kinds-C++=f", "--fields=+ne", "--output-format=json", "-f", "-", "."];
    const output = execFileSync("ctags", args, { cwd: folder, encoding: "utf8", maxBuffer: 1 << 28 });
    const tags = output.split("\n").filter(Boolean).map((line) => JSON.parse(line));
    return tags.filter((tag) => tag.end).map(({ path, name, line, end }) => ({ path: normalize(path), name, line, lines: end - line + 1 }));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

// `describe` only groups tests; what it holds is measured one by one.
function isGroup(node) {
  return ts.isCallExpression(node.parent) && /\bdescribe\b/.test(node.parent.expression.getText());
}

function findScriptFunctions({ path, text }) {
  const source = ts.createSourceFile(path, text, ts.ScriptTarget.Latest, true);
  const lineOf = (position) => source.getLineAndCharacterOfPosition(position).line + 1;
  const found = [];
  const visit = (node) => {
    if (ts.isFunctionLike(node) && node.body && !isGroup(node)) {
      const line = lineOf(node.getStart());
      const name = (node.name ?? node.parent.name)?.getText() ?? "a function";
      found.push({ path, name, line, lines: lineOf(node.end) - line + 1 });
    }
    ts.forEachChild(node, visit);
  };
  visit(source);
  return found;
}

export const name = "sizes";
export const unit = "files and functions";

export function check(files) {
  const sources = files.filter(({ path }) => isSource(path));
  const problems = sources
    .map(({ path, text }) => ({ path, lines: text.replace(/\n$/, "").split("\n").length }))
    .filter(({ lines }) => lines > maxFileLines)
    .map(({ path, lines }) => `${path}: ${lines} lines, at most ${maxFileLines}`);
  const scripts = sources.filter(({ path }) => isScript(path)).flatMap(findScriptFunctions);
  const functions = [...findCppFunctions(sources.filter(({ path }) => isCpp(path))), ...scripts];
  for (const { path, name, line, lines } of functions) {
    if (lines > maxFunctionLines) problems.push(`${path}:${line}: ${name} has ${lines} lines, at most ${maxFunctionLines}`);
  }
  return { checked: sources.length + functions.length, problems };
}

const long = (first, last) => [first, ...Array(maxFunctionLines - 1).fill("  x += 1;"), last].join("\n");
export const seeds = [
  { path: "core/base/seed.cpp", text: "\n".repeat(maxFileLines + 1) },
  { path: "core/base/seed.cpp", text: long("void seed(int& x) {", "}\n") },
  { path: "tests/core/seed_test.cpp", text: long("TEST(Seed, IsLong) {", "}\n") },
  { path: "web/src/seed.ts", text: long("const seed = (x: number) => {", "};\n") },
  { path: "scripts/seed.mjs", text: long("export function seed(x) {", "}\n") },
];
