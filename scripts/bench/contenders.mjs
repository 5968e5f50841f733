// Marey's JavaScript module beside three.js, in Node and in a page: the same code for both.
import { AnimationMixer } from "three";
import { BVHLoader } from "three/addons/loaders/BVHLoader.js";
import { median } from "./median.mjs";

/** Runs the contenders in turns, once unmeasured; median milliseconds by name. */
function measure(contenders, rounds) {
  const times = Object.fromEntries(Object.keys(contenders).map((name) => [name, []]));
  for (let round = -1; round < rounds; round++) {
    for (const [name, run] of Object.entries(contenders)) {
      const start = performance.now();
      run();
      const elapsed = performance.now() - start;
      if (round >= 0) times[name].push(elapsed);
    }
  }
  return Object.fromEntries(Object.entries(times).map(([name, values]) => [name, median(values)]));
}

function threeFigure(text) {
  const { skeleton, clip } = new BVHLoader().parse(text);
  const root = skeleton.bones[0];
  const mixer = new AnimationMixer(root);
  mixer.clipAction(clip).play();
  return (time) => {
    mixer.setTime(time);
    root.updateMatrixWorld(true);
  };
}

/**
 * Times in milliseconds by what is done and by whom. `bytes`: the clip; both get what they read best, bytes or a text.
 */
export function compareWithThree(marey, bytes, rounds = 5) {
  const text = new TextDecoder().decode(bytes);
  const clip = marey.parse(bytes);
  const pose = threeFigure(text);
  const { frameCount, frameTime } = clip;
  const poses = 2000;
  const results = {
    read: measure({
      marey: () => marey.parse(bytes).dispose(),
      three: () => new BVHLoader().parse(text),
    }, rounds),
    clip: measure({
      marey: () => clip.worldPositions(),
      three: () => {
        for (let frame = 0; frame < frameCount; frame++) pose(frame * frameTime);
      },
    }, rounds),
    pose: measure({
      marey: () => {
        for (let i = 0; i < poses; i++) clip.worldPositions((i * 997) % frameCount, 1);
      },
      three: () => {
        for (let i = 0; i < poses; i++) pose(((i * 997) % frameCount) * frameTime);
      },
    }, rounds),
  };
  const facts = { frames: frameCount, joints: clip.joints.length, bytes: bytes.length, poses };
  clip.dispose();
  return { facts, results };
}

/** Milliseconds from samples to the torques of all joints. */
export function measureTorques(marey, bytes, rounds = 5) {
  const clip = marey.parse(bytes);
  const { torques } = measure({
    torques: () => clip.analyse({ quantities: ["torque:*"], body: "rods", mass: 70, support: "flight" }),
  }, rounds);
  clip.dispose();
  return torques;
}
