import { isOneFile } from "./assets";
import type { LetterCell } from "./host";

/** The family of letters/letters.css, a few dozen letters to a file, loaded as they are asked for. */
const family = "Marey letters";
const faces = `"${family}", system-ui, sans-serif`;
const stylesheet = "letters/letters.css";

/**
 * Draws single letters that the page's own faces lack: those of letters/letters.css, else the system's. While a file of
 * letters is on its way they are blank; `arrived` tells that some can be drawn anew.
 */
export class LetterPainter {
  private readonly context = document.createElement("canvas").getContext("2d", { willReadFrequently: true })!;
  private sheet: Promise<void> | undefined;
  private readonly asked = new Set<string>();
  private readonly settled = new Set<string>();
  private telling = false;

  constructor(private readonly arrived: () => void) {}

  measure(codePoint: number, em: number, weight: number): number {
    const letter = this.ready(codePoint, weight);
    if (letter === undefined) return em;
    this.context.font = fontOf(em, weight);
    return this.context.measureText(letter).width;
  }

  draw(codePoint: number, em: number, weight: number, { side, penX, penY }: LetterCell): Uint8Array {
    const coverage = new Uint8Array(side * side);
    const letter = this.ready(codePoint, weight);
    if (letter === undefined) return coverage;
    const { canvas } = this.context;
    // Sets the canvas back in any case.
    canvas.width = Math.max(canvas.width, side);
    canvas.height = Math.max(canvas.height, side);
    this.context.clearRect(0, 0, side, side);
    this.context.font = fontOf(em, weight);
    this.context.fillText(letter, penX, penY);
    const { data } = this.context.getImageData(0, 0, side, side);
    for (let i = 0; i < coverage.length; i++) coverage[i] = data[4 * i + 3]!;
    return coverage;
  }

  /** The letter where its font is there or cannot be had; else undefined, and the font is asked for. */
  private ready(codePoint: number, weight: number): string | undefined {
    const letter = String.fromCodePoint(codePoint);
    if (this.settled.has(letter)) return letter;
    if (!this.asked.has(letter)) {
      this.asked.add(letter);
      void this.load(letter, weight);
    }
    return undefined;
  }

  private async load(letter: string, weight: number): Promise<void> {
    this.sheet ??= addStylesheet();
    await this.sheet;
    await document.fonts.load(fontOf(16, weight), letter).catch(() => []);
    this.settled.add(letter);
    if (this.telling) return;
    // Files of letters come in a burst: told once for all of it.
    this.telling = true;
    setTimeout(() => {
      this.telling = false;
      this.arrived();
    }, 30);
  }
}

function fontOf(em: number, weight: number): string {
  return `${weight} ${em}px ${faces}`;
}

/** Done when the sheet is there or cannot be had: the system's fonts serve then, as in the page that is one file. */
async function addStylesheet(): Promise<void> {
  if (isOneFile()) return;
  await new Promise<void>((done) => {
    const link = document.createElement("link");
    link.rel = "stylesheet";
    link.href = stylesheet;
    link.addEventListener("load", () => done());
    link.addEventListener("error", () => done());
    document.head.append(link);
  });
}
