import type { CoreProgram } from "./core_program.js";
import type { CharacterSet, Clip, Diagnostic, Joint, PositionMeaning, WriteOptions } from "./marey.js";
import { MareyError } from "./marey_error.js";

interface Description {
  joints: Joint[];
  nodeCount: number;
  channelCount: number;
  frameCount: number;
  frameTime: number;
  namesIn: CharacterSet;
  diagnostics: Diagnostic[];
}

/** In the order of kCharacterSets in core/text/character_set.h. */
const characterSets: readonly CharacterSet[] = ["utf-8", "windows-1251", "windows-1252", "gbk", "shift_jis"];

/** What the program takes for a character set: its index, -1 for a guess. */
function numberOf(set: CharacterSet | undefined): number {
  const index = set === undefined ? -1 : characterSets.indexOf(set);
  if (set !== undefined && index < 0) {
    throw new MareyError("invalid_argument", `namesIn is one of ${characterSets.join(", ")}, not ${String(set)}.`);
  }
  return index;
}

/**
 * A clip in the memory of the WebAssembly program. That memory may move whenever the program is called, so addresses
 * and views are taken anew after each call and only copies are given out.
 */
export class ClipInMemory implements Clip {
  readonly joints: readonly Joint[];
  readonly nodeCount: number;
  readonly channelCount: number;
  readonly frameCount: number;
  readonly frameTime: number;
  readonly namesIn: CharacterSet;
  readonly diagnostics: readonly Diagnostic[];

  /** `handle`: address of the clip, 0 once it is disposed of. */
  private constructor(private readonly module: CoreProgram, private handle: number, description: Description) {
    this.joints = description.joints;
    this.nodeCount = description.nodeCount;
    this.channelCount = description.channelCount;
    this.frameCount = description.frameCount;
    this.frameTime = description.frameTime;
    this.namesIn = description.namesIn;
    this.diagnostics = description.diagnostics;
  }

  static parse(module: CoreProgram, bytes: Uint8Array, strict: boolean, namesIn?: CharacterSet): ClipInMemory {
    const set = numberOf(namesIn);
    const address = module._malloc(Math.max(bytes.length, 1));
    if (address === 0) throw new MareyError("limit_memory", `There is no memory for a file of ${bytes.length} bytes.`);
    module.HEAPU8.set(bytes, address);
    const handle = module._marey_clip_parse(address, bytes.length, strict ? 1 : 0, set);
    module._free(address);
    const description = JSON.parse(new TextDecoder().decode(copyText(module, handle)));
    if (module._marey_clip_is_open(handle) !== 0) return new ClipInMemory(module, handle, description);
    module._marey_clip_dispose(handle);
    throw new MareyError(description.code, description.message, description.line, description.column);
  }

  channel(index: number): Float64Array {
    const start = this.samplesAt(index);
    return this.module.HEAPF64.slice(start, start + this.frameCount);
  }

  setChannel(index: number, values: ArrayLike<number>): void {
    const start = this.samplesAt(index);
    if (values.length !== this.frameCount) {
      throw new MareyError("invalid_argument", `A channel has ${this.frameCount} values, not ${values.length}.`);
    }
    const samples = Float64Array.from(values);
    const bad = samples.findIndex((value) => !Number.isFinite(value));
    if (bad >= 0) throw new MareyError("not_finite", `The value of frame ${bad} is not a finite number.`);
    this.module.HEAPF64.set(samples, start);
  }

  worldPositions(first = 0, count = this.frameCount - first): Float32Array {
    const handle = this.open();
    const fits = isIndex(first, this.frameCount + 1) && isIndex(count, this.frameCount - first + 1);
    if (!fits) {
      throw new MareyError("invalid_argument", `Frames ${first} to ${first + count} are not within 0 to ${this.frameCount}.`);
    }
    const start = this.module._marey_clip_world_positions(handle, first, count) / Float32Array.BYTES_PER_ELEMENT;
    return this.module.HEAPF32.slice(start, start + count * this.nodeCount * 3);
  }

  get positions(): PositionMeaning {
    return this.module._marey_clip_positions_add(this.open()) !== 0 ? "add" : "replace";
  }

  set positions(meaning: PositionMeaning) {
    if (meaning !== "add" && meaning !== "replace") {
      throw new MareyError("invalid_argument", `Positions "add" or "replace", they do not "${String(meaning)}".`);
    }
    this.module._marey_clip_set_positions_add(this.open(), meaning === "add" ? 1 : 0);
  }

  write({ decimals, lineEnds, first = 0, count = this.frameCount - first }: WriteOptions = {}): Uint8Array {
    const handle = this.open();
    if (decimals !== undefined && !isIndex(decimals, mostDecimals + 1)) {
      throw new MareyError("invalid_argument", `Decimals are a whole number from 0 to ${mostDecimals}.`);
    }
    if (lineEnds !== undefined && lineEnds !== "lf" && lineEnds !== "crlf") {
      throw new MareyError("invalid_argument", `Line ends are "lf" or "crlf".`);
    }
    const all = first === 0 && count === this.frameCount;
    if (!all && (!isIndex(first, this.frameCount) || !isIndex(count - 1, this.frameCount - first))) {
      throw new MareyError("invalid_argument", `Frames ${first} to ${first + count} are not within 0 to ${this.frameCount}.`);
    }
    const lineEnd = lineEnds === undefined ? -1 : lineEnds === "lf" ? 0 : 1;
    this.module._marey_clip_write(handle, decimals ?? -1, lineEnd, all ? 0 : first, all ? 0 : count);
    return copyText(this.module, handle);
  }

  dispose(): void {
    if (this.handle !== 0) this.module._marey_clip_dispose(this.handle);
    this.handle = 0;
  }

  private open(): number {
    if (this.handle === 0) throw new MareyError("invalid_argument", "The clip has been disposed of.");
    return this.handle;
  }

  /** Position of a channel's samples in HEAPF64. */
  private samplesAt(channel: number): number {
    const handle = this.open();
    if (!isIndex(channel, this.channelCount)) {
      throw new MareyError("invalid_argument", `There is no channel ${channel}; the clip has ${this.channelCount}.`);
    }
    return this.module._marey_clip_samples(handle, channel) / Float64Array.BYTES_PER_ELEMENT;
  }
}

const mostDecimals = 15;

function isIndex(value: number, count: number): boolean {
  return Number.isInteger(value) && value >= 0 && value < count;
}

function copyText(module: CoreProgram, handle: number): Uint8Array {
  const address = module._marey_clip_text(handle);
  return module.HEAPU8.slice(address, address + module._marey_clip_text_size(handle));
}
