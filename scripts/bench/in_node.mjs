// Prints what the comparison with three.js gives under Node, and the time of mechanics, as JSON:
// node scripts/bench/in_node.mjs CLIP BODY_CLIP.
import { readFileSync } from "node:fs";
import { createMarey } from "../../dist/module/marey.js";
import { compareWithThree, measureTorques } from "./contenders.mjs";

const marey = await createMarey();
const [clip, bodyClip] = process.argv.slice(2).map((path) => readFileSync(path));
console.log(JSON.stringify({ ...compareWithThree(marey, clip), torques: measureTorques(marey, bodyClip) }));
