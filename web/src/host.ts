import type { FileUse } from "./file_use";

/** What the program asks of the page; web/host_library.js calls it. */
export interface Host {
  askForFile(use: FileUse): void;
  download(name: string, bytes: Uint8Array): void;
  /** A drawing in SVG, as a PNG so many pixels wide. */
  downloadPicture(name: string, svg: string, pixelWidth: number): void;
  loadSample(id: string): void;
  /** Nothing more of the file that is being read is wanted. */
  stopLoading(): void;
  setClipboardText(text: string): void;
  setDocumentState(name: string, dirty: boolean): void;
  announce(text: string): void;
  reportFault(text: string): void;
  drawAfter(milliseconds: number): void;
  storePreferences(json: string): void;
  /** Empty when there are none. */
  loadPreferences(): string;
  systemPreferences(): SystemPreferences;
  setMouseCursor(cssCursor: string): void;
  openLink(url: string): void;
  /** Width of a letter of the browser's fonts; lengths in device pixels. */
  measureLetter(codePoint: number, em: number, weight: number): number;
  /** Its coverage from 0 to 255, row by row. */
  drawLetter(codePoint: number, em: number, weight: number, cell: LetterCell): Uint8Array;
  /** The letters of two-byte codes, lead and trail in turn; 0 where a code has none. */
  decodeLetters(set: "gbk" | "shift_jis", codes: Uint8Array): Uint16Array;
  /** Whether a text field has the keyboard, and where its caret is, in CSS pixels. */
  setTextInput(wanted: boolean, x: number, y: number, height: number): void;
}

/** A square to draw a letter in, and where its pen stands. */
export interface LetterCell {
  side: number;
  penX: number;
  penY: number;
}

export interface SystemPreferences {
  dark: boolean;
  reducedMotion: boolean;
  appleKeys: boolean;
  coarsePointer: boolean;
}
