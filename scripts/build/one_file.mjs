// The page as one file that works by double click: style, program, fonts and samples are put into index.html.
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { filesBelow } from "../lib/files.mjs";
import { Failure } from "../lib/shell.mjs";

const isEmbedded = (path) => /^(app\.wasm$|fonts\/|samples\/)/.test(path);
const hashOf = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

function replaceOnce(html, pattern, replacement) {
  if (html.split(pattern).length !== 2) throw new Failure(`web/index.html should hold ${pattern} once`);
  return html.replace(pattern, () => replacement);
}

/** Text of marey.html, made of the files of the built site in `folder`. web/src/assets.ts reads what stands in it. */
export function makeOneFilePage(folder) {
  const read = (path) => readFileSync(join(folder, path), "utf8");
  const base64 = (path) => readFileSync(join(folder, path)).toString("base64");
  const style = read("style.css");
  const program = read("main.js");
  const files = filesBelow(folder).filter(isEmbedded).map(
    (path) => `<script type="application/octet-stream" data-file="${path}">${base64(path)}</script>\n`);

  let html = read("index.html");
  html = replaceOnce(html, "script-src 'self'", `script-src ${hashOf(program)}`);
  html = replaceOnce(html, "style-src 'self'", `style-src ${hashOf(style)}`);
  html = replaceOnce(html, "font-src 'self'; ", "");
  html = replaceOnce(html, "img-src 'self' blob:", "img-src data: blob:");
  html = replaceOnce(html, 'href="icon.svg"', `href="data:image/svg+xml;base64,${base64("icon.svg")}"`);
  html = replaceOnce(html, '<link rel="stylesheet" href="style.css" />', `<style>${style}</style>`);
  html = replaceOnce(html, '<script type="module" src="main.js"></script>', "");
  return replaceOnce(html, "</body>", `${files.join("")}<script type="module">${program}</script>\n  </body>`);
}
