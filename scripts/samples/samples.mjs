import { doublePendulum } from "./double_pendulum.mjs";
import { giantSwing } from "./giant_swing.mjs";
import { pendulum } from "./pendulum.mjs";
import { robotArm } from "./robot_arm.mjs";
import { walk } from "./walk/walk.mjs";

const samples = [
  {
    id: "giant-swing",
    title: "Giant swing",
    description: "A gymnast of three links swings backwards round the high bar, by the angles printed in a paper.",
    text: giantSwing,
  },
  {
    id: "walk",
    title: "Walk",
    description: "A person of 175 cm walks three full cycles at 1.35 m/s; the joint angles loop.",
    text: walk,
  },
  {
    id: "pendulum",
    title: "Pendulum",
    description: "A pendulum swings 90 degrees to each side, as the exact solution has it, with a period of 2.6 s.",
    text: pendulum,
  },
  {
    id: "double-pendulum",
    title: "Double pendulum",
    description: "Two rods swing from rest and never repeat, while their energy stays the same.",
    text: doublePendulum,
  },
  {
    id: "robot-arm",
    title: "Robot arm",
    description: "A six-axis arm with a gripper carries a part from a table to a tilted tray with minimum-jerk movements.",
    text: robotArm,
  },
];

const countOf = (text, pattern) => (text.match(pattern) ?? []).length;

/** Every file of web/samples: { name, text }, the list of samples last. */
export function makeSampleFiles() {
  const files = samples.map((sample) => ({ name: `${sample.id}.bvh`, text: sample.text() }));
  const list = samples.map(({ id, title, description }, i) => ({
    id,
    file: files[i].name,
    title,
    description,
    joints: countOf(files[i].text, /^\s*(ROOT|JOINT) /gm),
    frames: Number(/^Frames: (\d+)$/m.exec(files[i].text)[1]),
    licence: "MIT",
  }));
  return [...files, { name: "index.json", text: `${JSON.stringify({ samples: list }, null, 2)}\n` }];
}
