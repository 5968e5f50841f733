// What a person downloads before the page can start: the program and its script, as a server would compress them.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { brotliCompressSync } from "node:zlib";
import { root } from "./support/cli.mjs";

const mostBytes = 700_000;

test("the program and its script come in at most 700 kB", (t) => {
  const sizes = ["app.wasm", "main.js"].map((name) => brotliCompressSync(readFileSync(join(root, "dist", name))).length);
  const total = sizes.reduce((sum, size) => sum + size, 0);
  t.diagnostic(`program ${sizes[0]} bytes, script ${sizes[1]} bytes, compressed by Brotli`);
  assert.ok(total <= mostBytes, `${total} bytes`);
});
