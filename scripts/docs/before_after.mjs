// What an operation does, as SVG for the documentation: readable on light and dark pages.

const size = { width: 520, height: 170, left: 44, right: 12, top: 26, bottom: 34 };
const ink = "#7d8794";
const grey = "#a3abb5";
const blue = "#3b82d6";

const escape = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
const words = (x, y, text, anchor = "start", extra = "") =>
  `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" text-anchor="${anchor}"${extra}>${escape(text)}</text>`;
const frame = (inner) =>
  `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${size.width} ${size.height}" width="${size.width}" height="${size.height}" ` +
  `font-family="system-ui, sans-serif" font-size="11" fill="${ink}">\n${inner}\n</svg>\n`;
const captionOf = (caption) =>
  words(size.left, 15, caption, "start", ` font-family="ui-monospace, monospace" font-weight="600" font-size="${caption.length > 62 ? 9.5 : 11}"`);

function ticks(low, high, most) {
  const rough = (high - low) / most;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((value) => value >= rough);
  const first = Math.ceil(low / step) * step;
  return Array.from({ length: Math.floor((high - first) / step) + 1 }, (_, i) => Number((first + i * step).toPrecision(6)));
}

/** A curve before, grey, and after, blue; x counts frames from 1. */
export function beforeAfterPlot({ caption, title, unit, before, after }) {
  const all = [...before, ...after];
  const xs = all.map(([x]) => x);
  const ys = all.map(([, y]) => y);
  const [left, right] = [Math.min(...xs), Math.max(...xs)];
  const margin = 0.06 * (Math.max(...ys) - Math.min(...ys) || 1);
  const [low, high] = [Math.min(...ys) - margin, Math.max(...ys) + margin];
  const x = (value) => size.left + ((value - left) / (right - left)) * (size.width - size.left - size.right);
  const y = (value) => size.height - size.bottom - ((value - low) / (high - low)) * (size.height - size.top - size.bottom);
  const grid = ticks(low, high, 4).map((tick) =>
    `<line x1="${size.left}" x2="${size.width - size.right}" y1="${y(tick).toFixed(1)}" y2="${y(tick).toFixed(1)}" stroke="${ink}" stroke-opacity="0.3"/>` +
    words(size.left - 6, y(tick) + 4, `${tick}${unit === "°" ? "°" : ""}`, "end"));
  const along = ticks(left, right, 8).map((tick) => words(x(tick), size.height - size.bottom + 14, String(tick), "middle"));
  const line = (points, color, width) =>
    `<polyline points="${points.map(([a, b]) => `${x(a).toFixed(1)},${y(b).toFixed(1)}`).join(" ")}" fill="none" stroke="${color}" stroke-width="${width}"/>`;
  const units = unit === "°" ? title : `${title}, ${unit}`;
  return frame([captionOf(caption), ...grid, ...along, line(before, grey, 2), line(after, blue, 1.75),
    words(size.left, size.height - 5, units), words(size.width - size.right, size.height - 5, "frame", "end")].join("\n"));
}

/** The names that change, before in grey and after in blue, in as many columns as are needed. */
export function namesPlot({ caption, before, after }) {
  const changed = before.map((name, i) => [name, after[i]]).filter(([a, b]) => a !== b);
  const rowsInColumn = Math.floor((size.height - size.top - 10) / 17);
  const columnWidth = (size.width - size.left) / Math.ceil(changed.length / rowsInColumn);
  const rows = changed.map(([from, to], i) => {
    const x = size.left + Math.floor(i / rowsInColumn) * columnWidth;
    const y = size.top + 17 * (1 + (i % rowsInColumn));
    return words(x, y, from, "start", ` fill="${grey}"`) + words(x + columnWidth / 2, y, to, "start", ` fill="${blue}"`);
  });
  return frame([captionOf(caption), ...rows].join("\n"));
}

/** The rest pose before, grey on the left, and after, blue on the right: the same scale, x to the right and y up. */
export function figurePlot({ caption, before, after }) {
  const points = [...before, ...after].flat();
  const span = (axis) => [Math.min(...points.map((p) => p[axis])), Math.max(...points.map((p) => p[axis]))];
  const [[left, right], [low, high]] = [span(0), span(1)];
  const scale = Math.min((size.height - size.top - 14) / (high - low), (size.width / 2 - 40) / (right - left));
  const figure = (bones, middle, color) => bones.map(([a, b]) => {
    const at = (p) => [middle + (p[0] - (left + right) / 2) * scale, size.height - 8 - (p[1] - low) * scale];
    const [[x1, y1], [x2, y2]] = [at(a), at(b)];
    const line = [x1, y1, x2, y2].map((value) => value.toFixed(1));
    return `<line x1="${line[0]}" y1="${line[1]}" x2="${line[2]}" y2="${line[3]}" stroke="${color}" stroke-width="3" stroke-linecap="round"/>` +
      `<circle cx="${line[2]}" cy="${line[3]}" r="3" fill="${color}"/>`;
  }).join("\n");
  return frame(`${captionOf(caption)}\n${figure(before, size.width * 0.27, grey)}\n${figure(after, size.width * 0.73, blue)}`);
}
