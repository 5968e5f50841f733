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

export interface JointInfo {
  name: string;
  /** Index of the parent joint; -1 for a root. */
  parent: number;
  offset: [number, number, number];
  channels: string[];
}

/** What the page shows. Frames, joints and channels count from 0. */
export interface State {
  /** "walk.bvh"; null while nothing is open. */
  file: string | null;
  joints: JointInfo[];
  channels: number;
  frames: number;
  /** Seconds per frame. */
  frameTime: number;
  /** Whether there are changes that were not downloaded. */
  dirty: boolean;
  undoDepth: number;
  redoDepth: number;
  undoName: string | null;
  redoName: string | null;
  diagnostics: Diagnostic[];
  positionRule: "replace" | "add" | "per_joint";
  upAxis: "X" | "Y" | "Z";
  metresPerUnit: number;

  frame: number;
  /** In frames; between whole numbers while a clip plays slowly. */
  position: number;
  playing: boolean;
  loop: boolean;
  speed: number;
  range: { first: number; count: number };

  selection: {
    joints: number[];
    activeJoint: number | null;
    /** The channels that the curve editor shows. */
    channels: number[];
    samples: { channel: number; first: number; count: number }[];
  };

  /** The layers of keys over the samples, from the lowest. */
  layers: {
    name: string;
    mode: "additive" | "override";
    muted: boolean;
    solo: boolean;
    locked: boolean;
    /** How many channels have keys, and how many keys there are. */
    channels: number;
    keys: number;
  }[];
  /** The layer that keys are set on, from 1; 0 for the channels themselves. */
  activeLayer: number;
  /** Channels that are keys rather than samples, and their keys. */
  keyedChannels: number;
  ownKeys: number;
  /** The clip that was put beside the open one last, by openOther() or by a person. */
  otherFile: string | null;
  /** All of them, at most four. */
  otherFiles: string[];
  theme: "dark" | "light";
  themeChoice: "system" | "dark" | "light";
  interfaceScale: number;
  /** One column, as on a phone. */
  compact: boolean;
  overlay: "none" | "palette" | "shortcuts" | "about" | "welcome";
  sheet: "none" | "curves" | "joints" | "inspector";
  /** What the page has said and nobody has closed yet. */
  messages: { title: string; detail: string }[];
  status: string;
  /** The file that is being read; `size` is 0 if nobody knows it. Frames that have come are shown and cannot be edited yet. */
  loading: { file: string; bytes: number; size: number } | null;
  /** What drawing takes, while the page shows it (view.performance). */
  performance: {
    /** Of the processor for a frame: median and worst of the last 120. */
    frameMs: number;
    worstMs: number;
    drawCalls: number;
    vertices: number;
    /** While the clip plays or last played; 0 before. */
    framesPerSecond: number;
    /** Bytes. */
    memoryUsed: number;
    memoryTotal: number;
    sampleBytes: number;
  } | null;
}

export interface CommandInfo {
  id: string;
  label: string;
  help: string;
  /** "Ctrl+Z"; several are divided by ", ". */
  shortcut: string | null;
  enabled: boolean;
  /** Why the command cannot run now. */
  reason: string | null;
  /** Whether a toggle is on. */
  checked?: boolean;
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
  /** Reads a BVH file piece by piece and opens it; a name that ends in .csv is a table, one in .json a model of the body for the open clip. Rejects with a MareyError { code, message, line, column }; the open document then stays. */
  open(name: string, data: string | Uint8Array | ArrayBuffer | Blob): Promise<State>;
  /** The same for a clip that stands beside the open one, for operations that take another: { do: "append from=NAME" }. */
  openOther(name: string, data: string | Uint8Array | ArrayBuffer | Blob): Promise<State>;
  /** The document as a BVH file, as Download gives it. */
  save(): Uint8Array;
  state(): State;
  commands(): CommandInfo[];
  /** Runs a command. Rejects when it does not exist, cannot run now, or its arguments are wrong. */
  command(id: string, args?: unknown): Promise<unknown>;
  /** Bytes of the program's memory: taken, and held whether taken or not. */
  memory(): { used: number; reserved: number };
  readonly ui: { items(): Item[] };
}

declare global {
  interface Window {
    marey: PageApi;
  }
}
