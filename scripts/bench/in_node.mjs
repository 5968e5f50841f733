// Prints what the comparison with three.js gives under Node, as JSON: node scripts/bench/in_node.mjs CLIP.
import { readFileSync } from "node:fs";
import { createMarey } from "../../dist/module/marey.js";
import { compareWithThree } from "./contenders.mjs";

console.log(JSON.stringify(compareWithThree(await createMarey(), readFileSync(process.argv[2]))));
