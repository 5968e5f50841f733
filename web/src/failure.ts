import { AssetError } from "./assets";
import { download } from "./files";

export type FailureKind = "no-wasm" | "no-webgl" | "not-loaded" | "stopped" | "waiting";

const texts: Record<FailureKind, { title: string; reason: string; advice: string }> = {
  "no-wasm": {
    title: "This browser cannot run Marey",
    reason: "Marey is a WebAssembly program, and this browser has no WebAssembly or has switched it off.",
    advice: "Open the page in a current version of Chrome, Edge, Firefox or Safari.",
  },
  "no-webgl": {
    title: "This browser cannot draw Marey",
    reason: "Marey draws with WebGL 2, and this browser does not have it or has switched it off.",
    advice:
      "Allow hardware acceleration in the browser's settings and update the graphics driver, or open the page in " +
      "another current browser.",
  },
  "not-loaded": {
    title: "Marey could not be loaded",
    reason: "A part of the page did not arrive.",
    advice: "Check the connection and load the page again.",
  },
  stopped: {
    title: "Marey has stopped",
    reason: "The program came upon an error of its own and cannot go on.",
    advice: "Nothing was sent anywhere. Load the page again to go on.",
  },
  waiting: {
    title: "The browser has taken the picture away",
    reason:
      "The graphics card is busy or was restarted. Your file and its changes are still here, and the page goes on by " +
      "itself as soon as the browser lets it draw again.",
    advice: "If the picture does not come back, close other tabs or load the page again.",
  },
};

/** The open document as it can still be had after a failure. */
export interface Rescue {
  name: string;
  data: Uint8Array<ArrayBuffer> | Blob;
}

const element = (id: string): HTMLElement => document.getElementById(id)!;

/** Replaces the page by plain HTML that says what happened and what to do. The answer brings the page back. */
export function showFailure(kind: FailureKind, cause: unknown, rescue?: Rescue): () => void {
  const titleBefore = document.title;
  const text = texts[kind];
  element("failure-title").textContent = text.title;
  element("failure-reason").textContent = cause instanceof AssetError ? cause.message : text.reason;
  element("failure-advice").textContent = rescue ? `Download your file first. ${text.advice}` : text.advice;
  element("failure-details").textContent = describe(cause);
  element("failure-reload").onclick = () => location.reload();
  const rescueButton = element("failure-download");
  rescueButton.hidden = !rescue;
  rescueButton.onclick = () => rescue && download(rescue.name, rescue.data);
  element("loading").hidden = true;
  element("canvas").hidden = true;
  element("failure").hidden = false;
  document.title = `${text.title} - Marey`;
  return () => {
    element("failure").hidden = true;
    element("canvas").hidden = false;
    document.title = titleBefore;
  };
}

function describe(cause: unknown): string {
  const what = cause instanceof Error ? `${cause.name}: ${cause.message}\n${cause.stack ?? ""}` : String(cause);
  return `${what}\n\n${navigator.userAgent}`;
}
