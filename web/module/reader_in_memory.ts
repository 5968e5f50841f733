import { ClipInMemory, errorOf, withBytes, withMemory } from "./clip_in_memory.js";
import type { CoreProgram } from "./core_program.js";
import type { CharacterSet, Clip, ClipReader, Limits, ReaderOptions } from "./marey.js";
import { MareyError } from "./marey_error.js";

/** In the order of kCharacterSets in core/text/character_set.h. */
const characterSets: readonly CharacterSet[] = ["utf-8", "windows-1251", "windows-1252", "gbk", "shift_jis"];

/** By the names of limit_names() in core/bvh/limits.h. */
const limitNames: Record<keyof Limits, string> = {
  joints: "joints", depth: "depth", channels: "channels", frames: "frames", sampleBytes: "sample_bytes", bytes: "bytes",
};

/** Handed to the program at once: enough to be fast, little beside the samples. */
const mostPieceBytes = 512 * 1024;

/** More than any clip has. */
const mostFramesEver = 2 ** 31 - 1;

/** What the program takes for a character set: its index, -1 for a guess. */
function numberOf(set: CharacterSet | undefined): number {
  const index = set === undefined ? -1 : characterSets.indexOf(set);
  if (set !== undefined && index < 0) {
    throw new MareyError("invalid_argument", `namesIn is one of ${characterSets.join(", ")}, not ${String(set)}.`);
  }
  return index;
}

function setOptions(module: CoreProgram, { strict = false, namesIn, limits = {} }: ReaderOptions): void {
  module._marey_reader_options(strict ? 1 : 0, numberOf(namesIn));
  for (const [key, value] of Object.entries(limits)) {
    const name = new TextEncoder().encode(limitNames[key as keyof Limits] ?? key);
    if (!Number.isSafeInteger(value)) throw new MareyError("invalid_argument", `The limit "${key}" is a whole number, not ${String(value)}.`);
    const refusal = withBytes(module, name, (address) => module._marey_reader_limit(address, name.length, value));
    if (refusal === 0) continue;
    const end = module.HEAPU8.indexOf(0, refusal);
    throw errorOf(JSON.parse(new TextDecoder().decode(module.HEAPU8.subarray(refusal, end))));
  }
}

/** A file on its way into the memory of the WebAssembly program. */
export class ReaderInMemory implements ClipReader {
  /** Address of the reader, 0 once it is done. */
  private handle: number;

  constructor(private readonly module: CoreProgram, options: ReaderOptions = {}) {
    const { expectedBytes = 0 } = options;
    if (!(expectedBytes >= 0)) throw new MareyError("invalid_argument", "expectedBytes is the size of a file.");
    setOptions(module, options);
    this.handle = withMemory(() => module._marey_reader_open(expectedBytes));
  }

  feed(piece: Uint8Array | string): boolean {
    const bytes = typeof piece === "string" ? new TextEncoder().encode(piece) : piece;
    for (let at = 0; at < bytes.length; at += mostPieceBytes) {
      const part = bytes.subarray(at, at + mostPieceBytes);
      const wantsMore = this.withMemory((handle) => {
        const address = this.module._marey_reader_piece(handle, part.length);
        this.module.HEAPU8.set(part, address);
        return this.module._marey_reader_feed(handle, part.length);
      });
      if (wantsMore === 0) return false;
    }
    return true;
  }

  get frameCount(): number {
    return this.module._marey_reader_frame_count(this.open());
  }

  clipSoFar(mostFrames = mostFramesEver): Clip | undefined {
    const handle = this.open();
    const clip = withMemory(() => this.module._marey_reader_clip_so_far(handle, Math.min(mostFrames, mostFramesEver)));
    return clip === 0 ? undefined : ClipInMemory.take(this.module, clip);
  }

  finish(): Clip {
    const clip = this.withMemory((handle) => this.module._marey_reader_finish(handle));
    this.cancel();
    return ClipInMemory.take(this.module, clip);
  }

  cancel(): void {
    if (this.handle !== 0) this.module._marey_reader_dispose(this.handle);
    this.handle = 0;
  }

  /** A reader that has come to the end of the memory is done. */
  private withMemory<T>(call: (handle: number) => T): T {
    const handle = this.open();
    try {
      return withMemory(() => call(handle));
    } catch (error) {
      this.cancel();
      throw error;
    }
  }

  private open(): number {
    if (this.handle === 0) throw new MareyError("invalid_argument", "The reader is done.");
    return this.handle;
  }
}
