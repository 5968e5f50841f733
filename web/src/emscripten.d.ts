/** build/wasm/app.js, which esbuild finds by this name. */
declare module "marey-app" {
  export interface EmscriptenModule {
    readonly HEAPU8: Uint8Array<ArrayBuffer>;
    _malloc(size: number): number;
    _free(address: number): void;
    _marey_create(): number;
    _marey_result_data(page: number): number;
    _marey_result_size(page: number): number;
    _marey_add_font(page: number, role: number, bytes: number, size: number): void;
    _marey_start(page: number): number;
    _marey_resize(page: number, width: number, height: number, devicePixelRatio: number): void;
    _marey_frame(page: number, nowMs: number): number;
    _marey_used_memory(): number;
    _marey_forget_letters(page: number): void;
    _marey_lose_context(page: number): void;
    _marey_restore_context(page: number): number;
    _marey_begin_loading(page: number, name: number, nameSize: number, size: number, use: number): number;
    _marey_piece(page: number, size: number): number;
    _marey_feed(page: number, size: number): number;
    _marey_finish_loading(page: number): number;
    _marey_cancel_loading(page: number): void;
    _marey_save(page: number): number;
    _marey_state(page: number): number;
    _marey_commands(page: number): number;
    _marey_items(page: number): number;
    _marey_run_command(page: number, id: number, idSize: number, args: number, argsSize: number): number;
    _marey_pointer_move(page: number, kind: number, x: number, y: number, modifiers: number): void;
    _marey_pointer_leave(page: number): void;
    _marey_pointer_button(page: number, kind: number, button: number, down: number, modifiers: number): void;
    _marey_wheel(page: number, linesX: number, linesY: number, modifiers: number, zoom: number): void;
    _marey_key(page: number, code: number, codeSize: number, key: number, keySize: number, down: number,
      modifiers: number): void;
    _marey_text(page: number, text: number, textSize: number): void;
    _marey_focus(page: number, focused: number): void;
    _marey_has_waiting_input(page: number): number;
    _marey_set_clipboard_text(page: number, text: number, textSize: number): void;
  }

  /** What the page hands to the program before it starts. */
  export interface EmscriptenSettings {
    wasmBinary: Uint8Array;
    host: import("./host").Host;
    onAbort(reason: unknown): void;
    print(line: string): void;
    printErr(line: string): void;
  }

  export default function createModule(settings: EmscriptenSettings): Promise<EmscriptenModule>;
}
