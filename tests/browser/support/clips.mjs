/** An arm of two links, `frames` frames; the shoulder turns by a degree per frame, the elbow stays. */
export function armClip(frames = 20) {
  const rows = Array.from({ length: frames }, (_, i) => `${i}.00 10.00`);
  return `HIERARCHY
ROOT Shoulder
{
\tOFFSET 0.00 0.00 0.00
\tCHANNELS 1 Zrotation
\tJOINT Elbow
\t{
\t\tOFFSET 10.00 0.00 0.00
\t\tCHANNELS 1 Zrotation
\t\tEnd Site
\t\t{
\t\t\tOFFSET 10.00 0.00 0.00
\t\t}
\t}
}
MOTION
Frames: ${frames}
Frame Time: 0.04
${rows.join("\n")}
`;
}

/** A chain that is nested more deeply than the reader allows: 2000 joints; it is refused at line 4003. */
export const brokenClip = `HIERARCHY
ROOT Link
${"{ OFFSET 0 1 0\nJOINT Link\n".repeat(2500)}{}`;
