// Runs in a page: window.compare(address of the clip) gives what the comparison with three.js gives there.
import { createMarey } from "../../dist/module/marey.js";
import { compareWithThree } from "./contenders.mjs";

async function bytesAt(address) {
  return new Uint8Array(await (await fetch(address)).arrayBuffer());
}

window.compare = async (address) =>
  compareWithThree(await createMarey({ wasmBinary: await bytesAt("marey.wasm") }), await bytesAt(address));
