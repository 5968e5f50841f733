/** What the program asks of the page; web/host_library.js calls it. */
export interface Host {
  askForFile(): void;
  download(name: string, bytes: Uint8Array): void;
  loadSample(id: string): void;
  setClipboardText(text: string): void;
  setDocumentState(name: string, dirty: boolean): void;
  announce(text: string): void;
  drawAfter(milliseconds: number): void;
  storePreferences(json: string): void;
  /** Empty when there are none. */
  loadPreferences(): string;
  systemPreferences(): SystemPreferences;
  setMouseCursor(cssCursor: string): void;
  openLink(url: string): void;
  /** Whether a text field has the keyboard, and where its caret is, in CSS pixels. */
  setTextInput(wanted: boolean, x: number, y: number, height: number): void;
}

export interface SystemPreferences {
  dark: boolean;
  reducedMotion: boolean;
  appleKeys: boolean;
  coarsePointer: boolean;
}
