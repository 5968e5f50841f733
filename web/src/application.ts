import createModule from "marey-app";
import { type Request, fileNameOf } from "./address";
import { readAsset } from "./assets";
import { CanvasSize } from "./canvas_size";
import { watchContext } from "./context_watch";
import { MareyError } from "../module/marey_error";
import { type FailureKind, type Rescue, showFailure } from "./failure";
import { FileLoader } from "./file_loader";
import { type FileUse, fileUse, usualUse } from "./file_use";
import { type FileSource, sourceOf, sourceOfResponse } from "./file_source";
import { Files } from "./files";
import { FrameLoop } from "./frame_loop";
import { KeyboardInput, shortcutChords } from "./keyboard_input";
import type { ProgramFiles } from "./loading";
import { showNotice } from "./notice";
import type { CommandInfo, State } from "./page_api";
import { PageHost, watchSystemPreferences } from "./page_host";
import { PointerInput } from "./pointer_input";
import { NoRoomError, Program } from "./program";
import { TextField } from "./text_field";

/** Shown when the page's address asks for nothing else. */
const firstSample = "walk";

/** The started page: the program and everything that feeds it. */
export class Application {
  readonly loop: FrameLoop;
  /** Undefined until start() is done. */
  program!: Program;
  private readonly canvas = document.getElementById("canvas") as HTMLCanvasElement;
  private readonly files: Files;
  private readonly loader: FileLoader;
  private readonly textField: TextField;
  private opened: { name: string; source: FileSource } | undefined;
  private failed = false;

  constructor() {
    this.loop = new FrameLoop((nowMs) => this.program.frame(nowMs), (error) => this.fail("stopped", error));
    this.files = new Files((name, data) => void this.tryToOpen(name, sourceOf(data)));
    this.loader = new FileLoader(() => this.program, this.loop);
    const textElement = document.getElementById("text-input") as HTMLTextAreaElement;
    this.textField = new TextField(textElement, this.canvas, () => this.program, () => this.loop.request());
  }

  /** Starts the program; throws a MareyError when there is no WebGL 2. */
  async start({ wasm, fonts }: ProgramFiles): Promise<void> {
    const host = new PageHost({
      canvas: this.canvas,
      wake: () => this.loop.request(),
      askForFile: (use) => this.files.ask((name, data) =>
        void this.tryToOpen(name, sourceOf(data), use === fileUse.document ? usualUse(name) : use)),
      loadSample: (id) => void this.loadSample(id),
      stopLoading: () => this.loader.stop(),
      forgetLetters: () => {
        this.program.forgetLetters();
        this.loop.request();
      },
      placeTextInput: (wanted, x, y, height) => this.textField.place(wanted, x, y, height),
    });
    const module = await createModule({
      wasmBinary: wasm,
      host,
      onAbort: (reason) => this.fail(this.program ? "stopped" : "no-wasm", reason),
      print: (line) => console.info(line),
      printErr: (line) => console.error(line),
    });
    this.program = new Program(module);
    for (const { role, bytes } of fonts) this.program.addFont(role, bytes);
    this.program.start();
    this.connect();
  }

  /** Opens what the page's address asks for, or the first sample. What fails is said on the page. */
  async openRequested({ src, sample }: Request): Promise<void> {
    if (src === undefined) {
      await this.loadSample(sample ?? firstSample);
      return;
    }
    const response = await fetch(src).catch(() => undefined);
    if (!response?.ok) {
      const reason = response ? `the server answered ${response.status}` : "its server cannot be reached or does not allow it";
      showNotice(`${src.href} could not be loaded: ${reason}.`);
      return;
    }
    await this.tryToOpen(fileNameOf(src), sourceOfResponse(response));
  }

  /**
   * Reads a file for what it is to be used for. Throws a MareyError when it is refused; the program shows it
   * too.
   */
  async open(name: string, source: FileSource, use = usualUse(name)): Promise<void> {
    try {
      await this.loader.load(name, source, use);
      if (use === fileUse.document) this.opened = { name, source };
    } catch (error) {
      if (!(error instanceof MareyError)) this.fail("stopped", error);
      throw error;
    } finally {
      this.loop.request();
    }
  }

  state(): State {
    return this.program.state() as State;
  }

  fail(kind: FailureKind, cause: unknown): void {
    if (this.failed) return;
    this.failed = true;
    this.loop.pause();
    showFailure(kind, cause, this.rescue());
  }

  private connect(): void {
    const wake = (): void => this.loop.request();
    new CanvasSize(this.canvas, (width, height, ratio) => {
      this.program.resize(width, height, ratio);
      this.loop.drawNow();
      wake();
    });
    const takeInput = (): void => this.loop.takeInputNow(() => this.program.hasWaitingInput());
    new PointerInput(this.canvas, this.program, { wake, takeInput, takeKeyboard: () => this.textField.takeKeyboard() });
    const shortcuts = (this.program.commands() as CommandInfo[]).map(({ shortcut }) => shortcut ?? "");
    new KeyboardInput(this.program, this.textField, shortcutChords(shortcuts), { wake, takeInput });
    window.addEventListener("paste", (event) => this.paste(event));
    document.addEventListener("visibilitychange", wake);
    watchSystemPreferences(wake);
    this.followContext();
    this.textField.takeKeyboard();
  }

  private followContext(): void {
    let hideWaiting = (): void => {};
    watchContext(this.canvas, {
      lost: () => {
        this.loop.pause();
        this.program.loseContext();
      },
      overdue: () => {
        if (!this.failed) hideWaiting = showFailure("waiting", "The WebGL context was lost.", this.rescue());
      },
      restored: () => {
        if (this.failed) return;
        try {
          this.program.restoreContext();
          hideWaiting();
          this.loop.resume();
        } catch (error) {
          this.fail("no-webgl", error);
        }
      },
    });
  }

  private paste(event: ClipboardEvent): void {
    if (!event.clipboardData) return;
    const text = event.clipboardData.getData("text/plain");
    this.program.setClipboardText(text);
    if (this.textField.isActive && text !== "") this.program.typeText(text);
    else this.files.paste(event.clipboardData);
    event.preventDefault();
    this.loop.request();
  }

  private async loadSample(id: string): Promise<void> {
    try {
      await this.tryToOpen(`${id}.bvh`, sourceOf(new Blob([await readAsset(`samples/${id}.bvh`)])));
    } catch (error) {
      showNotice(`The sample could not be loaded: ${error instanceof Error ? error.message : error}`);
    }
  }

  private async tryToOpen(name: string, source: FileSource, use?: FileUse): Promise<void> {
    try {
      await this.open(name, source, use);
    } catch (error) {
      // The program says why it refused a file; it does not hear of one that does not come, or for which there is no room.
      if (!(error instanceof MareyError)) return;
      if (error instanceof NoRoomError) {
        showNotice(`There is not enough memory for ${name}. What was open stays as it was. Close other tabs, or use the command line.`);
      }
      if (error.code === "not_loaded") showNotice(error.message);
    }
  }

  /** The open document with its edits if the program still answers, else as it was opened. */
  private rescue(): Rescue | undefined {
    if (!this.opened) return undefined;
    const { name, source } = this.opened;
    try {
      return { name, data: this.program.save() };
    } catch {
      const data = source.kept();
      return data && { name, data };
    }
  }
}
