/** At most so many frames are drawn at once to bring waiting input to the program. */
const mostFramesAtOnce = 8;

/** Frames drawn after the last input: ImGui shows the answer to an input in the frame after the one that takes it. */
const framesAfterInput = 3;

/** Draws frames while they are wanted and none otherwise, and none while the page is hidden: wake it when it is seen. */
export class FrameLoop {
  private scheduled = 0;
  private framesLeft = 0;
  private paused = false;

  /** `draw` returns true when a further frame is wanted; what it throws ends the loop and goes to `fail`. */
  constructor(
    private readonly draw: (nowMs: number) => boolean,
    private readonly fail: (error: unknown) => void,
  ) {}

  /** After any input or change from outside. */
  request(): void {
    this.framesLeft = framesAfterInput;
    this.schedule();
  }

  /** Draws at once, for a canvas that has just been emptied and for callers that look at the result. */
  drawNow(): void {
    if (this.paused) return;
    this.run(performance.now());
  }

  /**
   * Draws at once until the program has taken all input: files, clipboard and keyboards of phones may only be opened
   * while the browser still handles the event that asks for them.
   */
  takeInputNow(hasWaitingInput: () => boolean): void {
    this.request();
    for (let i = 0; i < mostFramesAtOnce && !this.paused && hasWaitingInput(); i++) this.drawNow();
  }

  pause(): void {
    this.paused = true;
    cancelAnimationFrame(this.scheduled);
    this.scheduled = 0;
  }

  resume(): void {
    this.paused = false;
    this.request();
  }

  private schedule(): void {
    if (this.paused || this.scheduled !== 0 || document.hidden) return;
    this.scheduled = requestAnimationFrame((nowMs) => {
      this.scheduled = 0;
      this.run(nowMs);
    });
  }

  private run(nowMs: number): void {
    try {
      const wantsMore = this.draw(nowMs);
      this.framesLeft = Math.max(this.framesLeft - 1, 0);
      if (wantsMore || this.framesLeft > 0) this.schedule();
    } catch (error) {
      this.pause();
      this.fail(error);
    }
  }
}
