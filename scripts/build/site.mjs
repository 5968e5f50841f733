// dist/: the static site, the page as one file, and the JavaScript module.
import { copyFileSync, cpSync, existsSync, mkdirSync, rmSync, writeFileSync } from "node:fs";
import { basename } from "node:path";
import { filesBelow } from "../lib/files.mjs";
import { inRoot, run } from "../lib/shell.mjs";
import { buildPreset, configurePreset } from "./cmake.mjs";
import { buildFonts } from "./fonts.mjs";
import { buildLetters } from "./letters.mjs";
import { makeOneFilePage } from "./one_file.mjs";

const dist = (...parts) => inRoot("dist", ...parts);
const wasm = (...parts) => inRoot("build", "wasm", ...parts);
const isStatic = (path) => !/\.(ts|md)$|^host_library\.js$/.test(path);

async function bundle(entry, outfile, options = {}) {
  const { build } = await import("esbuild");
  await build({
    absWorkingDir: inRoot(),
    entryPoints: [entry],
    outfile,
    bundle: true,
    minify: true,
    format: "esm",
    target: "es2022",
    alias: { "marey-app": wasm("app.js"), "marey-module": wasm("marey.js") },
    logLevel: "warning",
    ...options,
  });
}

function copyStaticFiles() {
  for (const path of filesBelow(inRoot("web")).filter(isStatic)) cpSync(inRoot("web", path), dist(path));
  for (const path of ["LICENSE", "NOTICES.md"].filter((name) => existsSync(inRoot(name)))) {
    copyFileSync(inRoot(path), dist(`${basename(path, ".md")}.txt`));
  }
}

async function buildPage() {
  await bundle("web/src/main.ts", dist("main.js"));
  copyFileSync(wasm("app.wasm"), dist("app.wasm"));
  await buildFonts(dist("fonts"));
  buildLetters(dist("letters"));
}

async function buildModule() {
  await bundle("web/module/marey.ts", dist("module", "marey.js"), { external: ["node:*"], minify: false });
  copyFileSync(wasm("marey.wasm"), dist("module", "marey.wasm"));
  run("node", ["node_modules/typescript/bin/tsc", "--project", "tsconfig.module.json"]);
}

export async function buildSite() {
  configurePreset("wasm");
  buildPreset("wasm", ["marey_page", "marey_module"]);
  rmSync(dist(), { recursive: true, force: true });
  mkdirSync(dist("module"), { recursive: true });
  copyStaticFiles();
  await buildPage();
  await buildModule();
  writeFileSync(dist("marey.html"), makeOneFilePage(dist()));
}
