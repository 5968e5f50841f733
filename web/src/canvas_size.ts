/** Keeps the canvas' drawing buffer at one element per device pixel, whatever the window, zoom or screen. */
export class CanvasSize {
  /** `changed` gets the size in CSS pixels, such that width times ratio is a whole number of device pixels. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly changed: (width: number, height: number, devicePixelRatio: number) => void,
  ) {
    const observer = new ResizeObserver((entries) => this.update(entries[entries.length - 1]));
    try {
      observer.observe(canvas, { box: "device-pixel-content-box" });
    } catch {
      observer.observe(canvas);
    }
    this.watchRatio();
    this.update();
  }

  // The ratio changes without the size when a window moves to another screen.
  private watchRatio(): void {
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener(
      "change",
      () => {
        this.update();
        this.watchRatio();
      },
      { once: true },
    );
  }

  private update(entry?: ResizeObserverEntry): void {
    const ratio = devicePixelRatio || 1;
    const exact = entry?.devicePixelContentBoxSize?.[0];
    const width = devicePixels(this.canvas.clientWidth * ratio, exact?.inlineSize);
    const height = devicePixels(this.canvas.clientHeight * ratio, exact?.blockSize);
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
    this.changed(width / ratio, height / ratio, ratio);
  }
}

/** What the browser says is exact, but some say CSS pixels where the ratio is emulated. */
function devicePixels(estimated: number, exact: number | undefined): number {
  const isPlausible = exact !== undefined && Math.abs(exact - estimated) < 2;
  return Math.max(isPlausible ? exact : Math.round(estimated), 1);
}
