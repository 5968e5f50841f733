import { MareyError } from "../module/marey_error";
import type { FileSource } from "./file_source";
import type { FileUse } from "./file_use";
import type { FrameLoop } from "./frame_loop";
import type { Program } from "./program";

/** Fed to the program at once: some milliseconds of work. */
const mostPieceBytes = 512 * 1024;

/** So long the program reads before the browser may answer input and draw. */
const mostWorkMs = 12;

/** How often progress is drawn. */
const progressMs = 100;

/** Ends with the browser's next task: what waits (input, frames) comes first. Not slowed down as timers are. */
function nextTask(): Promise<void> {
  return new Promise((done) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      done();
    };
    port2.postMessage(undefined);
  });
}

/** Brings files into the program piece by piece while the page goes on; the last one that is asked for wins. */
export class FileLoader {
  private running = new AbortController();

  constructor(private readonly program: () => Program, private readonly loop: FrameLoop) {}

  /** Gives up the file that is being read; nothing more of it is fetched. */
  stop(): void {
    this.running.abort();
  }

  /**
   * Reads a file for what it is to be used for. Throws a MareyError when it is refused, was stopped ("cancelled"), or cannot be read to its
   * end ("not_loaded"); what was open before then stays.
   */
  async load(name: string, source: FileSource, use: FileUse): Promise<void> {
    const program = this.program();
    this.stop();
    program.beginLoading(name, source.size, use);
    const { signal } = (this.running = new AbortController());
    this.loop.request();
    try {
      await this.feedAll(program, source, signal);
    } catch (error) {
      if (!signal.aborted) program.cancelLoading();
      if (error instanceof MareyError || error instanceof WebAssembly.RuntimeError) throw error;
      throw new MareyError("not_loaded", `${name} could not be read to its end. Check that it still exists and that the browser may read it.`);
    } finally {
      this.loop.request();
    }
    if (signal.aborted) throw new MareyError("cancelled", `The reading of ${name} was stopped.`);
    program.finishLoading();
  }

  private async feedAll(program: Program, source: FileSource, stopped: AbortSignal): Promise<void> {
    let begunMs = performance.now();
    let drawnMs = begunMs;
    for await (const bytes of source.pieces(stopped)) {
      for (let at = 0; at < bytes.length; at += mostPieceBytes) {
        if (stopped.aborted || !program.feed(bytes.subarray(at, at + mostPieceBytes))) return;
        const nowMs = performance.now();
        if (nowMs - drawnMs > progressMs) {
          this.loop.request();
          drawnMs = nowMs;
        }
        if (nowMs - begunMs < mostWorkMs) continue;
        await nextTask();
        begunMs = performance.now();
      }
    }
  }
}
