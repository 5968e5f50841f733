/** A finding about the open file. */
export interface Diagnostic {
  severity: "note" | "warning" | "error";
  code: string;
  /** From 1; 0 when the finding has no place in the file. */
  line: number;
  column: number;
  message: string;
  count: number;
}

/** What the page shows; frames count from 0. */
export interface State {
  file: string;
  frames: number;
  frame: number;
  frameTime: number;
  playing: boolean;
  dirty: boolean;
  undoDepth: number;
  redoDepth: number;
  diagnostics: Diagnostic[];
  [more: string]: unknown;
}

export interface CommandInfo {
  id: string;
  label: string;
  /** "Ctrl+Z"; empty for none. */
  shortcut: string;
  enabled: boolean;
}

/** A visible widget, in CSS pixels of the page. */
export interface Item {
  id: string;
  label: string;
  x: number;
  y: number;
  w: number;
  h: number;
}

/** `window.marey`: docs/page-api.md. */
export interface PageApi {
  /** Resolves when the page has started and has opened what its address asks for. */
  readonly ready: Promise<void>;
  /** Opens a BVH file. Rejects with a MareyError { code, message, line, column }; the open document then stays. */
  open(name: string, data: string | Uint8Array | ArrayBuffer | Blob): Promise<State>;
  /** The document as a BVH file, as Download gives it. */
  save(): Uint8Array;
  state(): State;
  commands(): CommandInfo[];
  /** Runs a command. Rejects when it does not exist, cannot run now, or its arguments are wrong. */
  command(id: string, args?: unknown): Promise<unknown>;
  readonly ui: { items(): Item[] };
}

declare global {
  interface Window {
    marey: PageApi;
  }
}
