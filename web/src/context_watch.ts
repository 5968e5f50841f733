/** How long the browser may take to give the picture's memory back before the page says that it waits. */
const patienceMs = 4000;

interface Reactions {
  lost(): void;
  restored(): void;
  /** The context has not come back for a while; it still may. */
  overdue(): void;
}

/** Follows the canvas' WebGL context, which the browser may take away at any time and usually gives back, empty. */
export function watchContext(canvas: HTMLCanvasElement, { lost, restored, overdue }: Reactions): void {
  let waiting = 0;
  canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    clearTimeout(waiting);
    waiting = window.setTimeout(overdue, patienceMs);
    lost();
  });
  canvas.addEventListener("webglcontextrestored", () => {
    clearTimeout(waiting);
    restored();
  });
}
