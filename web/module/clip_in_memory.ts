import type { CoreProgram } from "./core_program.js";
import type {
  AnalyseOptions, Analysis, BodyModel, BodyModelOptions, CharacterSet, Clip, Diagnostic, Exported, ExportTarget, Joint, PositionMeaning,
  WriteForOptions, WriteOptions, WriteTableOptions,
} from "./marey.js";
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

/** In the order of kPositionRuleIds in core/skeleton/position_rule.h. */
const positionMeanings: readonly PositionMeaning[] = ["replace", "add", "per_joint"];

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

  /** Takes over the clip at `handle`. Throws the MareyError that stands there instead. */
  static take(module: CoreProgram, handle: number): ClipInMemory {
    const description = JSON.parse(new TextDecoder().decode(copyText(module, handle)));
    if (module._marey_clip_is_open(handle) !== 0) return new ClipInMemory(module, handle, description);
    module._marey_clip_dispose(handle);
    throw errorOf(description);
  }

  static parseTable(module: CoreProgram, bytes: Uint8Array, strict: boolean, figure?: Clip): ClipInMemory {
    if (figure !== undefined && !(figure instanceof ClipInMemory && figure.module === module)) {
      throw new MareyError("invalid_argument", "The figure is a clip of the same module.");
    }
    const figureAt = figure === undefined ? 0 : figure.open();
    return ClipInMemory.take(module, withMemory(() => withBytes(module, bytes, (address) =>
      module._marey_clip_parse_table(address, bytes.length, strict ? 1 : 0, figureAt))));
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
    this.checkRange(first, count, 0);
    return withMemory(() => {
      const start = this.module._marey_clip_world_positions(handle, first, count) / Float32Array.BYTES_PER_ELEMENT;
      return this.module.HEAPF32.slice(start, start + count * this.nodeCount * 3);
    });
  }

  get positions(): PositionMeaning {
    return positionMeanings[this.module._marey_clip_position_rule(this.open())]!;
  }

  set positions(meaning: PositionMeaning) {
    const rule = positionMeanings.indexOf(meaning);
    if (rule < 0) {
      throw new MareyError("invalid_argument", `Positions mean "${positionMeanings.join('", "')}", not "${String(meaning)}".`);
    }
    this.module._marey_clip_set_position_rule(this.open(), rule);
  }

  write({ decimals, lineEnds, first = 0, count = this.frameCount - first }: WriteOptions = {}): Uint8Array {
    const handle = this.open();
    const style = styleNumbers(decimals, lineEnds);
    const all = first === 0 && count === this.frameCount;
    if (!all) this.checkRange(first, count, 1);
    return withMemory(() => {
      this.module._marey_clip_write(handle, ...style, all ? 0 : first, all ? 0 : count);
      return copyText(this.module, handle);
    });
  }

  writeTable(of: "channels" | "positions", options: WriteTableOptions = {}): Uint8Array {
    const handle = this.open();
    const { lengthUnit = "", first = 0, count = this.frameCount - first } = options;
    if (of !== "channels" && of !== "positions") {
      throw new MareyError("invalid_argument", `A table is of "channels" or "positions", not "${String(of)}".`);
    }
    if (lengthUnit !== "" && !lengthUnits.includes(lengthUnit)) {
      throw new MareyError("invalid_argument", `The unit of length is one of ${lengthUnits.join(", ")}, not "${String(lengthUnit)}".`);
    }
    this.checkRange(first, count, 0);
    const unit = new TextEncoder().encode(lengthUnit);
    return withMemory(() => {
      withBytes(this.module, unit, (address) =>
        this.module._marey_clip_write_table(handle, of === "positions" ? 1 : 0, address, unit.length, first, count));
      return copyText(this.module, handle);
    });
  }

  writeFor(target: ExportTarget, { referencePose, decimals, lineEnds }: WriteForOptions = {}): Exported {
    const handle = this.open();
    const style = styleNumbers(decimals, lineEnds);
    const name = new TextEncoder().encode(target);
    const pose = referencePose === undefined ? -1 : Number(referencePose);
    const [done, bytes] = withMemory(() => [
      withBytes(this.module, name, (address) =>
        this.module._marey_clip_write_for(handle, address, name.length, pose, ...style)),
      copyText(this.module, handle),
    ] as const);
    if (done === 0) throw errorOf(JSON.parse(new TextDecoder().decode(bytes)));
    const reportAt = this.module._marey_clip_report(handle);
    const report = this.module.HEAPU8.slice(reportAt, reportAt + this.module._marey_clip_report_size(handle));
    return { bytes, ...JSON.parse(new TextDecoder().decode(report)) };
  }

  analyse(options: AnalyseOptions): Analysis {
    const handle = this.open();
    if (!Array.isArray(options.quantities) || options.quantities.some((quantity) => typeof quantity !== "string")) {
      throw new MareyError("invalid_argument", "Quantities are a list of texts.");
    }
    for (const name of ["body", "support", "derivative"] as const) {
      if (options[name] !== undefined && typeof options[name] !== "string") {
        throw new MareyError("invalid_argument", `"${name}" is a text.`);
      }
    }
    if (options.frameTime !== undefined && !(options.frameTime > 0 && Number.isFinite(options.frameTime))) {
      throw new MareyError("invalid_argument", "The frame time is a number of seconds above 0.");
    }
    for (const contact of options.contacts ?? []) {
      const isFrame = (frame: unknown) => Number.isInteger(frame) && (frame as number) >= 0 && (frame as number) < 2 ** 31;
      const fits = isFrame(contact.first) && isFrame(contact.last) && ["boolean", "undefined"].includes(typeof contact.touches);
      if (typeof contact.joint !== "string" || !fits) {
        throw new MareyError("invalid_argument", "A contact is { joint, first, last, touches }, frames from 0.");
      }
    }
    checkMass(options.mass);
    if (options.mass !== undefined && options.body === undefined) throw new MareyError("invalid_argument", 'A "mass" is for a "body".');
    const request = new TextEncoder().encode(JSON.stringify(options));
    return withMemory(() => {
      const done = withBytes(this.module, request, (address) => this.module._marey_clip_analyse(handle, address, request.length));
      const answer = JSON.parse(new TextDecoder().decode(copyText(this.module, handle)));
      if (done === 0) throw errorOf(answer);
      const start = this.module._marey_clip_numbers(handle) / Float64Array.BYTES_PER_ELEMENT;
      const columns = (answer.names as string[]).map((name, i) => {
        const at = start + i * this.frameCount;
        return { name, values: this.module.HEAPF64.slice(at, at + this.frameCount) };
      });
      return { columns, notes: answer.notes };
    });
  }

  bodyModel(options: BodyModelOptions = {}): BodyModel {
    const handle = this.open();
    if (options.body !== undefined && typeof options.body !== "string") throw new MareyError("invalid_argument", '"body" is a text.');
    checkMass(options.mass);
    const request = new TextEncoder().encode(JSON.stringify(options));
    return withMemory(() => {
      const done = withBytes(this.module, request, (address) => this.module._marey_clip_body(handle, address, request.length));
      const answer = JSON.parse(new TextDecoder().decode(copyText(this.module, handle)));
      if (done === 0) throw errorOf(answer);
      return answer;
    });
  }

  dispose(): void {
    if (this.handle !== 0) this.module._marey_clip_dispose(this.handle);
    this.handle = 0;
  }

  private open(): number {
    if (this.handle === 0) throw new MareyError("invalid_argument", "The clip has been disposed of.");
    return this.handle;
  }

  private checkRange(first: number, count: number, fewest: number): void {
    if (isIndex(first, this.frameCount + 1) && isIndex(count - fewest, this.frameCount - first + 1 - fewest)) return;
    throw new MareyError("invalid_argument", `Frames ${first} to ${first + count} are not within 0 to ${this.frameCount}.`);
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
const lengthUnits: readonly string[] = ["m", "cm", "mm", "in", "ft", "unit"];

/** Decimals and line ends as the program takes them: -1 for as they are. */
function styleNumbers(decimals?: number, lineEnds?: "lf" | "crlf"): [number, number] {
  if (decimals !== undefined && !isIndex(decimals, mostDecimals + 1)) {
    throw new MareyError("invalid_argument", `Decimals are a whole number from 0 to ${mostDecimals}.`);
  }
  if (lineEnds !== undefined && lineEnds !== "lf" && lineEnds !== "crlf") {
    throw new MareyError("invalid_argument", `Line ends are "lf" or "crlf".`);
  }
  return [decimals ?? -1, lineEnds === undefined ? -1 : lineEnds === "lf" ? 0 : 1];
}

export interface ErrorDescription {
  code: string;
  message: string;
  line: number;
  column: number;
}

export function errorOf({ code, message, line, column }: ErrorDescription): MareyError {
  return new MareyError(code, message, line, column);
}

/**
 * A call for which there may be no memory: of the program, which throws nothing else, or of JavaScript for a copy. What the
 * program had taken for it is given back, and clips are as they were.
 */
export function withMemory<T>(call: () => T): T {
  try {
    return call();
  } catch (error) {
    const isWantOfMemory = error instanceof WebAssembly.Exception || error instanceof RangeError;
    throw isWantOfMemory ? new MareyError("out_of_memory", "There is not enough memory for this.") : error;
  }
}

/** Copies bytes into the program's memory for one call. */
export function withBytes<T>(module: CoreProgram, bytes: Uint8Array, call: (address: number) => T): T {
  const address = module._malloc(Math.max(bytes.length, 1));
  if (address === 0) throw new MareyError("limit_memory", `There is no memory for a file of ${bytes.length} bytes.`);
  module.HEAPU8.set(bytes, address);
  try {
    return call(address);
  } finally {
    module._free(address);
  }
}

function checkMass(mass: number | undefined): void {
  if (mass === undefined || (mass > 0 && Number.isFinite(mass))) return;
  throw new MareyError("invalid_argument", "The mass is a number of kilograms above 0.");
}

function isIndex(value: number, count: number): boolean {
  return Number.isInteger(value) && value >= 0 && value < count;
}

function copyText(module: CoreProgram, handle: number): Uint8Array {
  const address = module._marey_clip_text(handle);
  return module.HEAPU8.slice(address, address + module._marey_clip_text_size(handle));
}
