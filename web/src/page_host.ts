import { copyText } from "./clipboard";
import { decodeLetters } from "./double_byte";
import type { FileUse } from "./file_use";
import { download } from "./files";
import { showNotice } from "./notice";
import { paintPicture } from "./picture";
import type { Host, LetterCell, SystemPreferences } from "./host";
import { LetterPainter } from "./letter_painter";
import { applyTheme, loadPreferences, storePreferences } from "./preferences";

/** What of the page the program reaches through its host. */
export interface PageParts {
  canvas: HTMLCanvasElement;
  /** Asks for a frame. */
  wake(): void;
  askForFile(use: FileUse): void;
  loadSample(id: string): void;
  stopLoading(): void;
  /** A font has come that letters were waiting for. */
  forgetLetters(): void;
  placeTextInput(wanted: boolean, x: number, y: number, height: number): void;
}

const dark = matchMedia("(prefers-color-scheme: dark)");
const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");
const coarsePointer = matchMedia("(pointer: coarse)");

/** Calls back when the person changes a preference of their system. */
export function watchSystemPreferences(changed: () => void): void {
  for (const query of [dark, reducedMotion, coarsePointer]) query.addEventListener("change", changed);
}

export class PageHost implements Host {
  private readonly status = document.getElementById("status")!;
  private readonly letters: LetterPainter;
  private dirty = false;

  constructor(private readonly parts: PageParts) {
    this.letters = new LetterPainter(() => parts.forgetLetters());
    window.addEventListener("beforeunload", (event) => {
      if (!this.dirty) return;
      event.preventDefault();
      event.returnValue = "";
    });
  }

  askForFile(use: FileUse): void {
    this.parts.askForFile(use);
  }

  download(name: string, bytes: Uint8Array<ArrayBuffer>): void {
    download(name, bytes);
  }

  downloadPicture(name: string, svg: string, pixelWidth: number): void {
    paintPicture(svg, pixelWidth).then(
      (picture) => download(name, picture),
      (error: unknown) => showNotice(`The picture could not be painted. ${error instanceof Error ? error.message : ""}`),
    );
  }

  loadSample(id: string): void {
    this.parts.loadSample(id);
  }

  stopLoading(): void {
    this.parts.stopLoading();
  }

  setClipboardText(text: string): void {
    copyText(text);
  }

  setDocumentState(name: string, dirty: boolean): void {
    this.dirty = dirty;
    document.title = name === "" ? "Marey" : `${dirty ? "* " : ""}${name} - Marey`;
  }

  announce(text: string): void {
    this.status.textContent = text;
  }

  reportFault(text: string): void {
    console.error(text);
  }

  drawAfter(milliseconds: number): void {
    window.setTimeout(this.parts.wake, milliseconds);
  }

  storePreferences(json: string): void {
    storePreferences(json);
    applyTheme(json);
  }

  loadPreferences(): string {
    return loadPreferences();
  }

  systemPreferences(): SystemPreferences {
    return {
      dark: dark.matches,
      reducedMotion: reducedMotion.matches,
      coarsePointer: coarsePointer.matches,
      appleKeys: /Mac|iPhone|iPad/.test(navigator.platform),
    };
  }

  setMouseCursor(cssCursor: string): void {
    this.parts.canvas.style.cursor = cssCursor;
  }

  openLink(url: string): void {
    window.open(url, "_blank", "noopener");
  }

  measureLetter(codePoint: number, em: number, weight: number): number {
    return this.letters.measure(codePoint, em, weight);
  }

  drawLetter(codePoint: number, em: number, weight: number, cell: LetterCell): Uint8Array {
    return this.letters.draw(codePoint, em, weight, cell);
  }

  decodeLetters(set: "gbk" | "shift_jis", codes: Uint8Array): Uint16Array {
    return decodeLetters(set, codes);
  }

  setTextInput(wanted: boolean, x: number, y: number, height: number): void {
    this.parts.placeTextInput(wanted, x, y, height);
  }
}
