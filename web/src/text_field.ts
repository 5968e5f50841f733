import type { Program } from "./program";

/** Stands before what is typed, so that a touch keyboard has something to delete. */
const sentinel = "\u200b";

const noModifiers = { ctrlKey: false, shiftKey: false, altKey: false, metaKey: false };

/**
 * The hidden text area that has the keyboard while a field in the canvas wants text: it raises the keyboard of a phone
 * and takes input methods. What is typed into it is sent on; what an input method changes later is sent as deletions
 * and new text.
 */
export class TextField {
  private typed = sentinel;
  private composing = false;
  isActive = false;

  constructor(
    private readonly element: HTMLTextAreaElement,
    private readonly canvas: HTMLCanvasElement,
    private readonly program: () => Program,
    private readonly wake: () => void,
  ) {
    element.value = sentinel;
    element.addEventListener("input", () => this.sendChange());
    element.addEventListener("compositionstart", () => (this.composing = true));
    element.addEventListener("compositionend", () => {
      this.composing = false;
      this.sendChange();
      this.forgetTyped();
    });
  }

  /** Called by the program whenever a field takes or loses the keyboard or moves its caret. CSS pixels. */
  place(wanted: boolean, x: number, y: number, height: number): void {
    const style = this.element.style;
    style.left = `${Math.round(x)}px`;
    style.top = `${Math.round(y)}px`;
    style.height = `${Math.round(height)}px`;
    if (wanted === this.isActive) return;
    this.isActive = wanted;
    this.composing = false;
    this.forgetTyped();
    this.takeKeyboard();
  }

  /** Brings the keyboard back from other elements of the page. */
  takeKeyboard(): void {
    const target = this.isActive ? this.element : this.canvas;
    if (document.activeElement !== target) target.focus({ preventScroll: true });
  }

  /** The caret has moved or the text was changed by a key: earlier characters are no longer in front of the caret. */
  forgetTyped(): void {
    if (this.composing || this.element.value === sentinel) return;
    this.element.value = this.typed = sentinel;
    this.element.setSelectionRange(1, 1);
  }

  private sendChange(): void {
    const now = this.element.value.startsWith(sentinel) ? this.element.value : sentinel + this.element.value;
    const before = [...this.typed];
    const after = [...now];
    const deletesSentinel = this.element.value === "";
    let kept = 0;
    while (kept < before.length && kept < after.length && before[kept] === after[kept]) kept++;
    this.pressBackspace(before.length - kept + (deletesSentinel ? 1 : 0));
    if (kept < after.length) this.program().typeText(after.slice(kept).join(""));
    this.typed = now;
    if (deletesSentinel) this.element.value = sentinel;
    this.wake();
  }

  private pressBackspace(times: number): void {
    for (let i = 0; i < times; i++) {
      this.program().pressKey("Backspace", "Backspace", true, noModifiers);
      this.program().pressKey("Backspace", "Backspace", false, noModifiers);
    }
  }
}
