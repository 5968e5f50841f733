// As much of BVH as pictures need, of texts that marey wrote.

/** `joints` with parent and offset, `channels` as "Joint Channel", the frame time, and curve("Joint Channel"). */
export function parseBvh(text) {
  const [head, motion] = text.split("MOTION");
  const joints = [];
  const columns = [];
  const open = [];
  for (const line of head.split("\n").map((words) => words.trim().split(/\s+/))) {
    const joint = open.at(-1);
    if (line[0] === "ROOT" || line[0] === "JOINT") {
      joints.push({ name: line[1], parent: open.at(-1) ?? -1, offset: [0, 0, 0] });
      open.push(joints.length - 1);
    } else if (line[0] === "End") {
      joints.push({ name: "", parent: joint, offset: [0, 0, 0] });
      open.push(joints.length - 1);
    } else if (line[0] === "OFFSET") {
      joints[joint].offset = line.slice(1, 4).map(Number);
    } else if (line[0] === "CHANNELS") {
      columns.push(...line.slice(2).map((channel) => `${joints[joint].name} ${channel}`));
    } else if (line[0] === "}") {
      open.pop();
    }
  }
  const lines = motion.trim().split("\n");
  const rows = lines.slice(2).map((row) => row.trim().split(/\s+/).map(Number));
  return {
    joints,
    channels: columns,
    frameTime: Number(lines[1].split(":")[1]),
    curve(channel) {
      const column = columns.indexOf(channel);
      if (column < 0) throw new Error(`there is no channel ${channel}`);
      return rows.map((row) => row[column]);
    },
  };
}

/** The bones of the rest pose as pairs of points, x and y of the file. */
export function restPose({ joints }) {
  const places = [];
  for (const { parent, offset } of joints) {
    const from = parent < 0 ? [0, 0, 0] : places[parent];
    places.push(parent < 0 ? [0, 0, 0] : offset.map((value, axis) => value + from[axis]));
  }
  return joints.flatMap(({ parent }, i) => (parent < 0 ? [] : [[places[parent], places[i]]]));
}
