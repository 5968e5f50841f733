// Plots of lines as SVG, for the documentation: readable on light and dark pages.

const size = { width: 480, height: 300, left: 56, right: 16, top: 36, bottom: 44 };
const colors = ["#3b82d6", "#d9822b", "#2f9e6e"];
const ink = "#7d8794";
const mostTicks = 6;

/** A round step that divides [0, most] into at most `mostTicks` parts. */
function stepOf(most) {
  const rough = most / mostTicks;
  const power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map((factor) => factor * power).find((step) => step >= rough);
}

function ticksOf(most) {
  const step = stepOf(most);
  return Array.from({ length: Math.floor(most / step + 1e-9) + 1 }, (_, i) => Number((i * step).toPrecision(6)));
}

const text = (x, y, words, anchor = "middle", weight = 400) =>
  `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" text-anchor="${anchor}" font-weight="${weight}">${words}</text>`;

function gridOf(xMost, yMost, place) {
  const bottom = size.height - size.bottom;
  const across = ticksOf(yMost).map((tick) => {
    const [, y] = place(0, tick);
    return `<line x1="${size.left}" x2="${size.width - size.right}" y1="${y.toFixed(1)}" y2="${y.toFixed(1)}" stroke-opacity="0.3"/>` +
      text(size.left - 8, y + 4, tick, "end");
  });
  const along = ticksOf(xMost).map((tick) => text(place(tick, 0)[0], bottom + 16, tick));
  return `<g stroke="${ink}" stroke-width="1">${across.join("")}</g>${along.join("")}`.replaceAll("<text", `<text stroke="none"`);
}

function lineOf({ name, points }, index, place) {
  const color = colors[index % colors.length];
  const placed = points.map(([x, y]) => place(x, y).map((value) => value.toFixed(1)));
  const dots = placed.map(([x, y]) => `<circle cx="${x}" cy="${y}" r="3" fill="${color}"/>`).join("");
  const legend = `<circle cx="${size.left + 16}" cy="${size.top + 12 + 18 * index}" r="4" fill="${color}"/>` +
    text(size.left + 26, size.top + 16 + 18 * index, name, "start");
  return `<polyline points="${placed.map((point) => point.join(",")).join(" ")}" fill="none" stroke="${color}" stroke-width="2"/>${dots}${legend}`;
}

/** `lines`: { name, points: [x, y][] }[], all values >= 0; both axes begin at 0. */
export function linePlot({ title, xTitle, yTitle, lines }) {
  const all = lines.flatMap(({ points }) => points);
  const xMost = Math.max(...all.map(([x]) => x)) * 1.02;
  const yMost = Math.max(...all.map(([, y]) => y)) * 1.08;
  const place = (x, y) => [
    size.left + (x / xMost) * (size.width - size.left - size.right),
    size.height - size.bottom - (y / yMost) * (size.height - size.top - size.bottom),
  ];
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${size.width} ${size.height}" width="${size.width}" height="${size.height}" ` +
    `font-family="system-ui, sans-serif" font-size="12" fill="${ink}">\n${text(size.width / 2, 20, title, "middle", 600)}\n` +
    `${gridOf(xMost, yMost, place)}\n${lines.map((line, i) => lineOf(line, i, place)).join("\n")}\n` +
    `${text(size.width - size.right, size.height - 8, xTitle, "end")}\n${text(size.left - 8, size.top - 8, yTitle, "end")}\n</svg>\n`;
}
