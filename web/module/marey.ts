import createModule from "marey-module";
import { ClipInMemory } from "./clip_in_memory.js";
import { readProgram } from "./read_program.js";

export { MareyError } from "./marey_error.js";

export interface Joint {
  /** The bytes of the file, read as `namesIn` says; names may repeat. */
  readonly name: string;
  /** Index of the parent joint, smaller than the joint's own; -1 for a root. */
  readonly parent: number;
  /** From the parent, in file units. */
  readonly offset: readonly [number, number, number];
  /** "Zrotation", "Xposition" ... in the order of the file's columns. */
  readonly channels: readonly string[];
  /** Offset of the joint's end site, if it has one. */
  readonly endSite?: readonly [number, number, number];
}

/** Something noticed while reading: an assumption, a repair, or an error that left a part unread. */
export interface Diagnostic {
  readonly severity: "note" | "warning" | "error";
  /** Stable identifier: docs/diagnostics.md. */
  readonly code: string;
  /** Of the first finding, from 1; 0 when it has no place in the file. */
  readonly line: number;
  readonly column: number;
  readonly message: string;
  /** How many findings of this kind there are. */
  readonly count: number;
}

/** What the bytes of names stand for, by the labels of the Encoding Standard. Windows-1252 holds Latin-1. */
export type CharacterSet = "utf-8" | "windows-1251" | "windows-1252" | "gbk" | "shift_jis";

/** A BVH clip. Frames, joints and channels count from 0. */
export interface Clip {
  /** In file order, parents first. */
  readonly joints: readonly Joint[];
  /** Joints and end sites. */
  readonly nodeCount: number;
  readonly channelCount: number;
  readonly frameCount: number;
  /** Seconds per frame. */
  readonly frameTime: number;
  /** As given or guessed. `write` gives the names' own bytes whatever it is. */
  readonly namesIn: CharacterSet;
  readonly diagnostics: readonly Diagnostic[];

  /** Samples of a channel over all frames, a copy: degrees or file units. */
  channel(index: number): Float64Array;

  /** Replaces the samples of a channel: `frameCount` finite numbers. */
  setChannel(index: number, values: ArrayLike<number>): void;

  /**
   * World positions in file units, [frame][node][x y z], of `count` frames from `first` on; by default all. Nodes stand
   * as in `marey fk`: joints in file order, each end site behind its joint.
   */
  worldPositions(first?: number, count?: number): Float32Array;

  /**
   * What position channels of joints with an OFFSET mean. The file's numbers decide it first; world positions follow
   * what is set here.
   */
  positions: PositionMeaning;

  /** The clip as a BVH file in the style of the file it was read from, but for what `options` ask. */
  write(options?: WriteOptions): Uint8Array;

  /** Gives the memory back; the clip cannot be used afterwards. */
  dispose(): void;
}

/** A position channel replaces the joint's OFFSET, or is added to it. */
export type PositionMeaning = "replace" | "add";

export interface WriteOptions {
  /** Of samples and offsets, 0 to 15; each number becomes the nearest one that has so many. The frame time stays. */
  decimals?: number;
  lineEnds?: "lf" | "crlf";
  /** The first frame to write; by default 0. */
  first?: number;
  /** How many frames to write; by default all from `first` on. */
  count?: number;
}

export interface ParseOptions {
  /** Refuse what would otherwise be repaired. */
  strict?: boolean;
  /** Character set of the names; by default a guess. */
  namesIn?: CharacterSet;
}

export interface Marey {
  /** Reads a BVH file. Throws a MareyError that says where and why it cannot be read. */
  parse(data: Uint8Array | string, options?: ParseOptions): Clip;
}

export interface MareyOptions {
  /** Contents of marey.wasm, for hosts where it cannot be read from beside the module. */
  wasmBinary?: Uint8Array | ArrayBuffer;
}

/** Loads the WebAssembly core, in browsers, workers and Node. */
export async function createMarey(options: MareyOptions = {}): Promise<Marey> {
  const given = options.wasmBinary;
  const wasmBinary = given ? new Uint8Array(given) : await readProgram(new URL("marey.wasm", import.meta.url));
  const module = await createModule({ wasmBinary });
  return {
    parse(data, { strict = false, namesIn } = {}) {
      const bytes = typeof data === "string" ? new TextEncoder().encode(data) : data;
      return ClipInMemory.parse(module, bytes, strict, namesIn);
    },
  };
}
