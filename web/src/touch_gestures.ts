import { Button, type ModifierState, type Program } from "./program";

/** A finger that moves less than this, in CSS pixels, is tapping. */
const tapRadius = 6;
const longPressMs = 500;
/** Browsers tell of moves when they draw: where that is slow, a finger may have moved long ago. */
const longPressFrames = 2;
/** Wheel lines for a doubling of the distance between two fingers. */
const linesPerDoubling = 5;

interface Finger {
  x: number;
  y: number;
}

type Phase =
  | { kind: "idle" }
  /** One finger down, not known yet for what. */
  | { kind: "undecided"; start: Finger }
  | { kind: "drag" }
  | { kind: "pinch"; distance: number; upright: boolean }
  /** What was begun is over; waits until all fingers are lifted. */
  | { kind: "done" };

/**
 * What fingers mean: a tap is a click, a drag is a drag with the left button, a long press a click with the right one.
 * Two fingers drag with the middle button and turn the wheel by their distance where their middle is; with Ctrl when
 * they stand above each other, which graphs take as zoom along the upright axis.
 */
export class TouchGestures {
  private readonly fingers = new Map<number, Finger>();
  private phase: Phase = { kind: "idle" };

  constructor(
    private readonly program: Program,
    private readonly effects: { wake(): void; takeInput(): void },
  ) {}

  down(event: PointerEvent): void {
    this.fingers.set(event.pointerId, place(event));
    if (this.fingers.size === 1) this.beginTouch(place(event), event);
    else if (this.fingers.size === 2) this.beginPinch(event);
    else this.endPinch(event);
    this.effects.wake();
  }

  move(event: PointerEvent): void {
    if (!this.fingers.has(event.pointerId)) return;
    this.fingers.set(event.pointerId, place(event));
    if (this.phase.kind === "undecided") this.decide(this.phase.start, event);
    if (this.phase.kind === "drag") this.program.movePointer("touch", event.clientX, event.clientY, event);
    if (this.phase.kind === "pinch") this.pinch(this.phase.distance, this.phase.upright, event);
    this.effects.wake();
  }

  up(event: PointerEvent): void {
    const phase = this.phase;
    this.fingers.delete(event.pointerId);
    if (phase.kind === "undecided") this.click(Button.Left, phase.start, event);
    else this.release(event);
    this.finish();
    this.effects.takeInput();
    this.program.leavePointer();
    this.effects.wake();
  }

  cancel(event: PointerEvent): void {
    this.fingers.delete(event.pointerId);
    this.release(event);
    this.finish();
    this.program.leavePointer();
    this.effects.wake();
  }

  private beginTouch(start: Finger, modifiers: ModifierState): void {
    const phase: Phase = { kind: "undecided", start };
    this.phase = phase;
    const endWait = (): void => {
      if (this.phase === phase) this.pressLong(start, modifiers);
    };
    window.setTimeout(() => afterFrames(longPressFrames, endWait), longPressMs);
    this.program.movePointer("touch", start.x, start.y, modifiers);
  }

  private pressLong(start: Finger, modifiers: ModifierState): void {
    this.phase = { kind: "done" };
    this.click(Button.Right, start, modifiers);
    this.effects.wake();
  }

  private decide(start: Finger, event: PointerEvent): void {
    if (distanceBetween(start, place(event)) <= tapRadius) return;
    this.press(Button.Left, start, event);
    this.phase = { kind: "drag" };
  }

  private beginPinch(event: PointerEvent): void {
    this.release(event);
    this.press(Button.Middle, this.middle(), event);
    const [a, b] = this.firstTwo();
    const upright = Math.abs(a.y - b.y) > Math.abs(a.x - b.x);
    this.phase = { kind: "pinch", distance: this.spread(), upright };
  }

  private pinch(previousDistance: number, upright: boolean, event: PointerEvent): void {
    const middle = this.middle();
    const distance = this.spread();
    this.program.movePointer("touch", middle.x, middle.y, event);
    const lines = linesPerDoubling * Math.log2(distance / previousDistance);
    if (lines !== 0) this.program.turnWheel(0, lines, event, upright);
    this.phase = { kind: "pinch", distance, upright };
  }

  private endPinch(event: PointerEvent): void {
    this.release(event);
    this.phase = { kind: "done" };
  }

  private press(button: Button, at: Finger, modifiers: ModifierState): void {
    this.program.movePointer("touch", at.x, at.y, modifiers);
    this.program.pressButton("touch", button, true, modifiers);
  }

  private click(button: Button, at: Finger, modifiers: ModifierState): void {
    this.press(button, at, modifiers);
    this.program.pressButton("touch", button, false, modifiers);
  }

  /** Lifts the button that the phase holds down. */
  private release(modifiers: ModifierState): void {
    if (this.phase.kind === "drag") this.program.pressButton("touch", Button.Left, false, modifiers);
    if (this.phase.kind === "pinch") this.program.pressButton("touch", Button.Middle, false, modifiers);
  }

  private finish(): void {
    this.phase = this.fingers.size === 0 ? { kind: "idle" } : { kind: "done" };
  }

  private middle(): Finger {
    const [a, b] = this.firstTwo();
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
  }

  private spread(): number {
    return Math.max(distanceBetween(...this.firstTwo()), 1);
  }

  private firstTwo(): [Finger, Finger] {
    const [a, b] = this.fingers.values();
    return [a!, b ?? a!];
  }
}

function place(event: PointerEvent): Finger {
  return { x: event.clientX, y: event.clientY };
}

function afterFrames(count: number, then: () => void): void {
  if (count === 0) then();
  else requestAnimationFrame(() => afterFrames(count - 1, then));
}

function distanceBetween(a: Finger, b: Finger): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}
