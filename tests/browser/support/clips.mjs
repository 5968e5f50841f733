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

/** Ends in the middle of the hierarchy, on line 7. */
export const brokenClip = `HIERARCHY
ROOT Hips
{
\tOFFSET 0 0 0
\tCHANNELS 1 Zrotation
}
MOSHUN
`;
