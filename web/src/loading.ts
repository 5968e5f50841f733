import { readAsset } from "./assets";
import type { FontRole } from "./program";

/** The parts of the program and roughly how many bytes each has, for the bar. */
const parts: { path: string; role?: FontRole; expectedBytes: number }[] = [
  { path: "app.wasm", expectedBytes: 1_600_000 },
  { path: "fonts/inter-regular.ttf", role: "text", expectedBytes: 230_000 },
  { path: "fonts/inter-semibold.ttf", role: "semibold", expectedBytes: 230_000 },
  { path: "fonts/jetbrains-mono-regular.ttf", role: "mono", expectedBytes: 90_000 },
  { path: "fonts/icons.ttf", role: "icons", expectedBytes: 30_000 },
];

export interface ProgramFiles {
  wasm: Uint8Array<ArrayBuffer>;
  fonts: { role: FontRole; bytes: Uint8Array<ArrayBuffer> }[];
}

/** Loads the program and its fonts side by side and shows how far it has come. Throws an AssetError. */
export async function loadProgramFiles(): Promise<ProgramFiles> {
  const bar = document.getElementById("loading-bar") as HTMLProgressElement;
  const loaded = parts.map(() => 0);
  const total = parts.reduce((sum, part) => sum + part.expectedBytes, 0);
  const files = await Promise.all(parts.map((part, i) => readAsset(part.path, (bytes) => {
    loaded[i] = Math.min(bytes, part.expectedBytes);
    bar.value = loaded.reduce((sum, count) => sum + count, 0) / total;
  })));
  bar.value = 1;
  const fonts = parts.flatMap(({ role }, i) => (role ? [{ role, bytes: files[i]! }] : []));
  return { wasm: files[0]!, fonts };
}

export function hideLoading(): void {
  document.getElementById("loading")!.hidden = true;
}
