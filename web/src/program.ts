import type { EmscriptenModule } from "marey-app";
import type { FileUse } from "./file_use";
import { MareyError } from "../module/marey_error";

export type FontRole = "text" | "semibold" | "mono" | "icons";
export type PointerKind = "mouse" | "pen" | "touch";
/** Mouse buttons in ImGui's order. */
export enum Button { Left, Right, Middle }

export interface ModifierState {
  ctrlKey: boolean;
  shiftKey: boolean;
  altKey: boolean;
  metaKey: boolean;
}

const fontRoles: FontRole[] = ["text", "semibold", "mono", "icons"];
const pointerKinds: PointerKind[] = ["mouse", "pen", "touch"];

function modifierBits(state: ModifierState): number {
  return (state.ctrlKey ? 1 : 0) | (state.shiftKey ? 2 : 0) | (state.altKey ? 4 : 0) | (state.metaKey ? 8 : 0);
}

/** There is no memory for handing something to the program, which therefore has not heard of it. */
export class NoRoomError extends MareyError {}

/** The program in WebAssembly: wasm/bindings/page*.cpp with JavaScript's types. Lengths are CSS pixels. */
export class Program {
  private readonly page: number;

  constructor(private readonly module: EmscriptenModule) {
    this.page = module._marey_create();
  }

  addFont(role: FontRole, bytes: Uint8Array): void {
    this.withBytes([bytes], (address, size) =>
      this.module._marey_add_font(this.page, fontRoles.indexOf(role), address!, size!));
  }

  /** Throws a MareyError when the browser gives no WebGL 2. */
  start(): void {
    this.check(this.module._marey_start(this.page));
  }

  resize(width: number, height: number, devicePixelRatio: number): void {
    this.module._marey_resize(this.page, width, height, devicePixelRatio);
  }

  /** Draws; true when a further frame is wanted without new input. Throws a MareyError when the program cannot go on. */
  frame(nowMs: number): boolean {
    const wanted = this.module._marey_frame(this.page, nowMs);
    this.check(wanted + 1);
    return wanted > 0;
  }

  /** Has letters of the browser's fonts drawn again. */
  forgetLetters(): void {
    this.module._marey_forget_letters(this.page);
  }

  loseContext(): void {
    this.module._marey_lose_context(this.page);
  }

  restoreContext(): void {
    this.check(this.module._marey_restore_context(this.page));
  }

  /** Bytes of the program's memory: taken, and held whether taken or not. */
  memory(): { used: number; reserved: number } {
    return { used: this.module._marey_used_memory(), reserved: this.module.HEAPU8.length };
  }

  /**
   * Begins to read a file of `size` bytes, 0 if nobody knows; one that is still being read is given up. `use`: what
   * it is read for.
   */
  beginLoading(name: string, size: number, use: FileUse): void {
    this.check(this.withBytes([encode(name)], (nameAt, nameSize) =>
      this.module._marey_begin_loading(this.page, nameAt!, nameSize!, size, use)));
  }

  /** Reads the next bytes. False when no more are wanted: finishLoading() says why. */
  feed(bytes: Uint8Array): boolean {
    const address = this.module._marey_piece(this.page, bytes.length);
    if (address === 0) throw new NoRoomError("out_of_memory", "The browser gives no more memory.");
    this.module.HEAPU8.set(bytes, address);
    return this.module._marey_feed(this.page, bytes.length) !== 0;
  }

  /** Opens what was read. Throws a MareyError with the place in the file; the document that was open then stays. */
  finishLoading(): void {
    this.check(this.module._marey_finish_loading(this.page));
  }

  cancelLoading(): void {
    this.module._marey_cancel_loading(this.page);
  }

  save(): Uint8Array<ArrayBuffer> {
    this.check(this.module._marey_save(this.page));
    return this.resultBytes();
  }

  state(): unknown {
    this.check(this.module._marey_state(this.page));
    return JSON.parse(this.resultText());
  }

  commands(): unknown {
    this.check(this.module._marey_commands(this.page));
    return JSON.parse(this.resultText());
  }

  items(): unknown {
    this.check(this.module._marey_items(this.page));
    return JSON.parse(this.resultText());
  }

  runCommand(id: string, args: unknown): unknown {
    const argsText = args === undefined ? "" : JSON.stringify(args);
    this.check(this.withBytes([encode(id), encode(argsText)], (idAt, idSize, argsAt, argsSize) =>
      this.module._marey_run_command(this.page, idAt!, idSize!, argsAt!, argsSize!)));
    return JSON.parse(this.resultText());
  }

  movePointer(kind: PointerKind, x: number, y: number, modifiers: ModifierState): void {
    this.module._marey_pointer_move(this.page, pointerKinds.indexOf(kind), x, y, modifierBits(modifiers));
  }

  leavePointer(): void {
    this.module._marey_pointer_leave(this.page);
  }

  pressButton(kind: PointerKind, button: Button, down: boolean, modifiers: ModifierState): void {
    const bits = modifierBits(modifiers);
    this.module._marey_pointer_button(this.page, pointerKinds.indexOf(kind), button, down ? 1 : 0, bits);
  }

  /** Distances in lines, up and left positive. */
  turnWheel(linesX: number, linesY: number, modifiers: ModifierState, zoom: boolean): void {
    this.module._marey_wheel(this.page, linesX, linesY, modifierBits(modifiers), zoom ? 1 : 0);
  }

  pressKey(code: string, key: string, down: boolean, modifiers: ModifierState): void {
    const bits = modifierBits(modifiers);
    this.withBytes([encode(code), encode(key)], (codeAt, codeSize, keyAt, keySize) =>
      this.module._marey_key(this.page, codeAt!, codeSize!, keyAt!, keySize!, down ? 1 : 0, bits));
  }

  typeText(text: string): void {
    this.withBytes([encode(text)], (address, size) => this.module._marey_text(this.page, address!, size!));
  }

  setFocus(focused: boolean): void {
    this.module._marey_focus(this.page, focused ? 1 : 0);
  }

  /** Whether input waits for a further frame: a press and its release are taken in one each. */
  hasWaitingInput(): boolean {
    return this.module._marey_has_waiting_input(this.page) !== 0;
  }

  setClipboardText(text: string): void {
    this.withBytes([encode(text)], (address, size) =>
      this.module._marey_set_clipboard_text(this.page, address!, size!));
  }

  /** Copies byte blocks into the program's memory for one call: (address, size, address, size, ...). */
  private withBytes<T>(blocks: Uint8Array[], call: (...places: number[]) => T): T {
    const addresses = blocks.map((block) => this.module._malloc(Math.max(block.length, 1)));
    try {
      if (addresses.includes(0)) throw new NoRoomError("out_of_memory", "The browser gives no more memory.");
      blocks.forEach((block, i) => this.module.HEAPU8.set(block, addresses[i]));
      return call(...blocks.flatMap((block, i) => [addresses[i]!, block.length]));
    } finally {
      addresses.forEach((address) => this.module._free(address));
    }
  }

  private resultBytes(): Uint8Array<ArrayBuffer> {
    const address = this.module._marey_result_data(this.page);
    try {
      return this.module.HEAPU8.slice(address, address + this.module._marey_result_size(this.page));
    } catch (error) {
      throw error instanceof RangeError ? new MareyError("out_of_memory", "There is not enough memory for a copy of the file.") : error;
    }
  }

  private resultText(): string {
    return new TextDecoder().decode(this.resultBytes());
  }

  private check(succeeded: number): void {
    if (succeeded !== 0) return;
    const { code, message, line, column } = JSON.parse(this.resultText());
    throw new MareyError(code, message, line, column);
  }
}

function encode(text: string): Uint8Array {
  return new TextEncoder().encode(text);
}
