import { lockConnections, readAddress } from "./address";
import { Application } from "./application";
import { AssetError } from "./assets";
import type { FailureKind } from "./failure";
import { hideLoading, loadProgramFiles } from "./loading";
import { makePageApi } from "./make_page_api";
import { MareyError } from "../module/marey_error";
import { applyTheme, loadPreferences } from "./preferences";

/** So long the page waits with its first picture for the file that it shows. */
const patienceMs = 400;

/** What the browser lacks, if anything. */
function findMissingPart(): FailureKind | undefined {
  if (typeof WebAssembly !== "object") return "no-wasm";
  if (typeof WebGL2RenderingContext === "undefined") return "no-webgl";
  return undefined;
}

function kindOfFailure(error: unknown): FailureKind {
  if (error instanceof AssetError) return "not-loaded";
  if (error instanceof MareyError) return "no-webgl";
  return error instanceof WebAssembly.CompileError ? "no-wasm" : "stopped";
}

async function startPage(application: Application, started: () => void): Promise<void> {
  const request = readAddress(location.search, document.baseURI);
  lockConnections(request);
  const missing = findMissingPart();
  if (missing) {
    const error = new Error("The browser lacks a part that the page needs.");
    application.fail(missing, error);
    throw error;
  }
  try {
    await application.start(await loadProgramFiles());
    started();
    const opened = application.openRequested(request);
    // A file that takes longer shows its progress in the page.
    await Promise.race([opened, new Promise((done) => setTimeout(done, patienceMs))]);
    application.loop.drawNow();
    application.loop.request();
    hideLoading();
    await opened;
  } catch (error) {
    application.fail(kindOfFailure(error), error);
    throw error;
  }
}

applyTheme(loadPreferences());
const application = new Application();
let tellStarted = (): void => {};
const started = new Promise<void>((done) => (tellStarted = done));
const ready = startPage(application, tellStarted);
ready.catch(() => {});
// What is called before the start waits for it, or for the news that there will be none.
window.marey = makePageApi(application, ready, Promise.race([started, ready]));
