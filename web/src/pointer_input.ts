import { Button, type PointerKind, type Program } from "./program";
import { TouchGestures } from "./touch_gestures";

/** DOM's numbers of the mouse buttons: 0 left, 1 middle, 2 right. */
const buttons: Record<number, Button> = { 0: Button.Left, 1: Button.Middle, 2: Button.Right };

const linesPerPixel = 1 / 100;
const linesPerPage = 8;

export interface PointerEffects {
  /** Asks for a frame after input. */
  wake(): void;
  /** Lets the program take the input at once. */
  takeInput(): void;
  /** Brings the keyboard to the program. */
  takeKeyboard(): void;
}

/** Sends mouse, pen, touch and wheel to the program. */
export class PointerInput {
  private readonly touches: TouchGestures;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly program: Program,
    private readonly effects: PointerEffects,
  ) {
    this.touches = new TouchGestures(program, effects);
    canvas.addEventListener("pointerdown", (event) => this.down(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("pointerup", (event) => this.up(event));
    canvas.addEventListener("pointercancel", (event) => this.cancel(event));
    canvas.addEventListener("pointerleave", (event) => this.leave(event));
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    // The keyboard stays with the text field, or the canvas: a click does not move it.
    canvas.addEventListener("mousedown", (event) => event.preventDefault());
  }

  private down(event: PointerEvent): void {
    this.canvas.setPointerCapture(event.pointerId);
    this.effects.takeKeyboard();
    if (event.pointerType === "touch") {
      this.touches.down(event);
      return;
    }
    this.sendPosition(event);
    this.sendButton(event, true);
  }

  private move(event: PointerEvent): void {
    if (event.pointerType === "touch") {
      this.touches.move(event);
      return;
    }
    this.sendPosition(event);
    // A further button pressed or released while one is held comes as a move.
    if (event.button >= 0) this.sendButton(event, (event.buttons & domButtonBit(event.button)) !== 0);
  }

  private up(event: PointerEvent): void {
    if (event.pointerType === "touch") {
      this.touches.up(event);
      return;
    }
    this.sendPosition(event);
    this.sendButton(event, false);
    this.effects.takeInput();
  }

  private cancel(event: PointerEvent): void {
    if (event.pointerType === "touch") {
      this.touches.cancel(event);
      return;
    }
    for (const button of Object.values(buttons)) this.program.pressButton(kindOf(event), button, false, event);
    this.leave(event);
  }

  private leave(event: PointerEvent): void {
    if (event.pointerType === "touch") return;
    this.program.leavePointer();
    this.effects.wake();
  }

  private sendPosition(event: PointerEvent): void {
    this.program.movePointer(kindOf(event), event.clientX, event.clientY, event);
    this.effects.wake();
  }

  private sendButton(event: PointerEvent, down: boolean): void {
    const button = buttons[event.button];
    if (button !== undefined) this.program.pressButton(kindOf(event), button, down, event);
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? linesPerPixel
      : event.deltaMode === WheelEvent.DOM_DELTA_PAGE ? linesPerPage : 1 / 3;
    let [x, y] = [-event.deltaX * lines, -event.deltaY * lines];
    // Some browsers already turn the wheel sideways while Shift is held; the program does so itself.
    if (event.shiftKey && y === 0) [x, y] = [0, x];
    this.program.movePointer("mouse", event.clientX, event.clientY, event);
    this.program.turnWheel(x, y, event, event.ctrlKey);
    this.effects.wake();
  }
}

function kindOf(event: PointerEvent): PointerKind {
  return event.pointerType === "pen" ? "pen" : "mouse";
}

/** The bit in PointerEvent.buttons for a PointerEvent.button. */
function domButtonBit(button: number): number {
  return [1, 4, 2][button] ?? 1 << button;
}
