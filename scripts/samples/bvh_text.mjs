/** Shortest text of a number cut to six decimals; never "-0". */
function formatNumber(value) {
  const rounded = Number(value.toFixed(6));
  return rounded === 0 ? "0" : String(rounded);
}

function jointLines(joint, keyword, margin, style) {
  const inner = margin + style.indent;
  const offsetLine = (offset) => `OFFSET ${offset.map(style.format).join(" ")}`;
  const lines = [
    `${margin}${keyword} ${joint.name}`,
    `${margin}{`,
    `${inner}${offsetLine(joint.offset)}`,
    `${inner}CHANNELS ${joint.channels.length} ${joint.channels.join(" ")}`,
  ];
  for (const child of joint.children ?? []) lines.push(...jointLines(child, "JOINT", inner, style));
  if (joint.endSite) {
    lines.push(`${inner}End Site`, `${inner}{`, `${inner}${style.indent}${offsetLine(joint.endSite)}`, `${inner}}`);
  }
  lines.push(`${margin}}`);
  return lines;
}

/**
 * A BVH file. A joint is { name, offset, channels, children?, endSite? }; a row holds the numbers of one frame in the
 * order in which the joints are written. `frameTime` is text, so that its decimals are the caller's choice.
 */
export function bvhText({ root, frameTime, rows, indent = "\t", format = formatNumber }) {
  return [
    "HIERARCHY",
    ...jointLines(root, "ROOT", "", { indent, format }),
    "MOTION",
    `Frames: ${rows.length}`,
    `Frame Time: ${frameTime}`,
    ...rows.map((row) => row.map(format).join(" ")),
    "",
  ].join("\n");
}
