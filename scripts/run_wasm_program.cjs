// Runs a program built by Emscripten for Node: node run_wasm_program.cjs PROGRAM.cjs [ARGUMENT...]
// Emscripten before 3.1.25 fetches its own wasm file when there is a fetch, and Node's fetch knows no file paths.
const { resolve } = require("node:path");

delete globalThis.fetch;
process.argv.splice(1, 1);
process.argv[1] = resolve(process.argv[1]);
require(process.argv[1]);
