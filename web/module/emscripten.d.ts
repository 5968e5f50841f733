/** build/wasm/marey.js, which esbuild finds by this name. */
declare module "marey-module" {
  import type { CoreProgram } from "./core_program.js";
  export default function createModule(settings: { wasmBinary: Uint8Array }): Promise<CoreProgram>;
}

/** What a C++ program throws, as JavaScript sees it; TypeScript's own description of WebAssembly lacks it. */
declare namespace WebAssembly {
  class Exception {}
}
