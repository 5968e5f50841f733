import createModule from "marey-module";
import { ClipInMemory } from "./clip_in_memory.js";
import { ReaderInMemory } from "./reader_in_memory.js";
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

  /**
   * A CSV table of the samples or of the world positions, as `marey convert` and `marey fk` write them. The channels come
   * back bit for bit by `parseTable`.
   */
  writeTable(of: "channels" | "positions", options?: WriteTableOptions): Uint8Array;

  /**
   * A BVH file as another program wants it, and what that costs; `docs/export-targets.md` has the targets. Throws a
   * MareyError for an unknown target and for a clip that is too long.
   */
  writeFor(target: ExportTarget, options?: WriteForOptions): Exported;

  /**
   * Quantities of kinematics and mechanics in world axes and SI units, as `marey analyse` writes them; docs/mechanics.md has
   * what there is. Throws a MareyError for a quantity, joint or method that there is not, and without a model that is needed.
   */
  analyse(options: AnalyseOptions): Analysis;

  /**
   * Masses for the figure, as `analyse({ model })` takes them: by a table, or, without one, as the names of the joints and the lengths
   * of the bones tell. Throws a MareyError where the figure is none of the table's kind.
   */
  bodyModel(options?: BodyModelOptions): BodyModel;

  /** Gives the memory back; the clip cannot be used afterwards. */
  dispose(): void;
}

/**
 * A position channel replaces the joint's OFFSET, or is added to it; "per_joint": added for the joints that rest at 0 in
 * the file although they have an OFFSET, replacing for the others.
 */
export type PositionMeaning = "replace" | "add" | "per_joint";

export interface WriteOptions {
  /** Of samples and offsets, 0 to 15; each number becomes the nearest one that has so many. The frame time stays. */
  decimals?: number;
  lineEnds?: "lf" | "crlf";
  /** The first frame to write; by default 0. */
  first?: number;
  /** How many frames to write; by default all from `first` on. */
  count?: number;
}

export interface WriteTableOptions {
  /** Writes units into the header. BVH has no unit of length: this says what the numbers are, it converts nothing. */
  lengthUnit?: "m" | "cm" | "mm" | "in" | "ft" | "unit";
  /** The first frame to write; by default 0. */
  first?: number;
  /** How many frames to write; by default all from `first` on. */
  count?: number;
}

/** A rigid segment that a joint carries, in the joint's own axes. */
export interface BodySegment {
  /** Name of the joint; of joints of one name the first is meant. */
  joint: string;
  mass_kg: number;
  /** From the joint's origin. */
  com_m: readonly [number, number, number];
  /** Ixx, Iyy, Izz, Ixy, Ixz, Iyz about the centre of mass; 0 if it is left out. */
  inertia_kgm2?: readonly [number, number, number, number, number, number];
}

/** The masses of a figure, as the JSON of `marey analyse --model` has them. */
export interface BodyModel {
  /** By default as guessed from the stature. */
  metres_per_unit?: number;
  /** Metres per second squared; by default 9.81 down the clip's up axis. */
  gravity?: readonly [number, number, number];
  segments: readonly BodySegment[];
}

export interface BodyModelOptions {
  body?: "deleva-male" | "deleva-female" | "winter" | "rods";
  /** Of the body, in kg; by default that of the table's average subject. */
  mass?: number;
}

/** What holds of the points that hang on a joint, or of an end site, in place of what their paths tell. */
export interface OwnContact {
  /** Name of the joint, or "NAME_end" of its end site. */
  joint: string;
  /** From 0. */
  first: number;
  /** Belongs to it. */
  last: number;
  /** Whether they touch the floor; by default true. */
  touches?: boolean;
}

export interface AnalyseOptions {
  /** "torque:Body", "velocity:*", "position:Hand+0/0.1/0@Hips", "com" ... */
  quantities: readonly string[];
  /** Needed by all that has to do with mass, but for `body`. */
  model?: BodyModel;
  /** Masses by a table, the names of the joints and the lengths of the bones; a model is then not looked at. */
  body?: "deleva-male" | "deleva-female" | "winter" | "rods";
  /** Of the body, in kg, beside `body` and only there; by default that of the table's average subject. */
  mass?: number;
  /** What holds the body; by default "auto". */
  support?: "pivot" | "flight" | "ground" | "auto";
  /** "central" (the default), "butterworth:HZ", "savgol:WINDOW,DEGREE", "gcv" or "spline:DEG,MM". */
  derivative?: string;
  /** Seconds per frame, in place of the file's. */
  frameTime?: number;
  /** Contacts with the floor; of two that differ the later counts. */
  contacts?: readonly OwnContact[];
}

export interface Analysis {
  /** "torque:Body.x[N.m]" and a value for each frame, NaN where it is not defined. */
  readonly columns: readonly { readonly name: string; readonly values: Float64Array }[];
  /** Sentences about what there is to know of them. */
  readonly notes: readonly string[];
}

export type ExportTarget = "strict" | "blender" | "three" | "bvhview" | "pybvh" | "motionbuilder" | "second-life";

export interface WriteForOptions {
  /** Whether the rest pose is the first frame; by default as the target wants it. */
  referencePose?: boolean;
  decimals?: number;
  lineEnds?: "lf" | "crlf";
}

export interface Exported {
  readonly bytes: Uint8Array;
  /** What is not as in the clip; `kind` is one of docs/export-targets.md. */
  readonly changes: readonly { kind: string; isLoss: boolean; count: number; message: string }[];
  /** Joints of the file that have another name in it. */
  readonly names: readonly { joint: number; before: string; after: string }[];
  /** Greatest distance of a joint or end site from where the clip has it, in file units. */
  readonly largestMove: number;
}

export interface ParseTableOptions {
  /** Refuse what would otherwise be repaired. */
  strict?: boolean;
  /** The clip whose channels the table has. Without it the table is one of points, and each becomes a root. */
  figure?: Clip;
}

export interface ParseOptions {
  /** Refuse what would otherwise be repaired. */
  strict?: boolean;
  /** Character set of the names; by default a guess. */
  namesIn?: CharacterSet;
  limits?: Limits;
}

/** What a file may ask for; docs/limits.md has the defaults. */
export interface Limits {
  joints?: number;
  depth?: number;
  channels?: number;
  frames?: number;
  /** Memory for samples. */
  sampleBytes?: number;
  /** Memory for text and samples together. */
  bytes?: number;
}

export interface ReaderOptions extends ParseOptions {
  /** Size of the file, where it is known: room for the samples is then made once and exactly. */
  expectedBytes?: number;
}

/** Reads a BVH file while it comes, without holding its text. */
export interface ClipReader {
  /**
   * Takes the next bytes, or text that ends with a whole character. False once the file cannot be read, whatever follows:
   * `finish` says why.
   */
  feed(piece: Uint8Array | string): boolean;

  /** Frames that are read so far. */
  readonly frameCount: number;

  /**
   * A clip of its own with the first frames, all that are read or `mostFrames`, and without findings; undefined while there
   * are none. Dispose of it.
   */
  clipSoFar(mostFrames?: number): Clip | undefined;

  /** The clip, as `parse` gives it. Throws a MareyError that says where and why the file cannot be read. Ends the reader. */
  finish(): Clip;

  /** Gives the file up and its memory back. */
  cancel(): void;
}

export interface Marey {
  /** Reads a BVH file. Throws a MareyError that says where and why it cannot be read. */
  parse(data: Uint8Array | string, options?: ParseOptions): Clip;

  /** Begins to read a BVH file that comes by pieces. End it by `finish` or `cancel`. */
  reader(options?: ReaderOptions): ClipReader;

  /** Reads a CSV table of channels or of points; docs/command-line.md#tables-in. Throws a MareyError as `parse` does. */
  parseTable(data: Uint8Array | string, options?: ParseTableOptions): Clip;

  /** Bytes of the program's memory: taken by clips that are not disposed of, and held whether taken or not. */
  memory(): { used: number; reserved: number };
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
    parse(data, options = {}) {
      const bytes = bytesOf(data);
      const reader = new ReaderInMemory(module, { ...options, expectedBytes: bytes.length });
      reader.feed(bytes);
      return reader.finish();
    },
    reader: (options) => new ReaderInMemory(module, options),
    parseTable(data, { strict = false, figure } = {}) {
      return ClipInMemory.parseTable(module, bytesOf(data), strict, figure);
    },
    memory: () => ({ used: module._marey_used_memory(), reserved: module.HEAPU8.length }),
  };
}

function bytesOf(data: Uint8Array | string): Uint8Array {
  return typeof data === "string" ? new TextEncoder().encode(data) : data;
}
