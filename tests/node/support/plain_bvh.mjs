// A small BVH reader and forward kinematics for tests, independent of the core and of the sample generators. It reads
// well-formed files only.

const axes = { X: 0, Y: 1, Z: 2 };

function readHierarchy(tokens) {
  const joints = [];
  const open = [];
  let channelCount = 0;
  while (tokens.peek() !== "MOTION") {
    const word = tokens.next();
    if (word === "ROOT" || word === "JOINT") {
      joints.push({ name: tokens.next(), parent: open.at(-1) ?? -1, channels: [], firstChannel: channelCount });
      open.push(joints.length - 1);
    } else if (word === "End") {
      tokens.next();
      const parent = open.at(-1);
      joints.push({ name: `${joints[parent].name}_end`, parent, channels: [], firstChannel: channelCount, isEnd: true });
      open.push(joints.length - 1);
    } else if (word === "OFFSET") {
      joints[open.at(-1)].offset = [tokens.number(), tokens.number(), tokens.number()];
    } else if (word === "CHANNELS") {
      const joint = joints[open.at(-1)];
      joint.channels = Array.from({ length: tokens.number() }, () => tokens.next());
      channelCount += joint.channels.length;
    } else if (word === "}") {
      open.pop();
    }
  }
  return { joints, channelCount };
}

function tokensOf(text) {
  const words = text.split(/\s+/).filter(Boolean);
  let at = 0;
  return { peek: () => words[at], next: () => words[at++], number: () => Number(words[at++]) };
}

/** { joints, frameTime, rows }: end sites are joints with isEnd; rows[frame][channel]. */
export function readBvh(text) {
  const tokens = tokensOf(text);
  const { joints, channelCount } = readHierarchy(tokens);
  tokens.next();
  tokens.next();
  const frameCount = tokens.number();
  tokens.next();
  tokens.next();
  const frameTime = tokens.number();
  const rows = Array.from({ length: frameCount }, () => Array.from({ length: channelCount }, () => tokens.number()));
  if (tokens.peek() !== undefined) throw new Error(`surplus value ${tokens.peek()}`);
  return { joints, frameTime, rows };
}

function elementaryRotation(axis, degrees) {
  const [s, c] = [Math.sin((degrees * Math.PI) / 180), Math.cos((degrees * Math.PI) / 180)];
  const [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
  const matrix = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  matrix[i][i] = c;
  matrix[i][j] = -s;
  matrix[j][i] = s;
  matrix[j][j] = c;
  return matrix;
}

const product = (a, b) => a.map((row) => [0, 1, 2].map((j) => row[0] * b[0][j] + row[1] * b[1][j] + row[2] * b[2][j]));

/** A vector turned by a rotation of `worldPose`. */
export const turned = (matrix, v) => matrix.map((row) => row[0] * v[0] + row[1] * v[1] + row[2] * v[2]);

/** World { position, rotation } of every joint and end site; position channels replace OFFSET. */
export function worldPose({ joints }, row) {
  const pose = [];
  for (const joint of joints) {
    const place = [...joint.offset];
    let rotation = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    joint.channels.forEach((channel, i) => {
      const value = row[joint.firstChannel + i];
      if (channel.endsWith("position")) place[axes[channel[0]]] = value;
      else rotation = product(rotation, elementaryRotation(axes[channel[0]], value));
    });
    const parent = pose[joint.parent];
    if (!parent) pose.push({ position: place, rotation });
    else {
      const offset = turned(parent.rotation, place);
      pose.push({ position: offset.map((v, k) => v + parent.position[k]), rotation: product(parent.rotation, rotation) });
    }
  }
  return pose;
}
