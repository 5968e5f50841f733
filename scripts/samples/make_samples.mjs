// Writes web/samples: node scripts/samples/make_samples.mjs

import { mkdirSync, writeFileSync } from "node:fs";
import { makeSampleFiles } from "./samples.mjs";

const folder = new URL("../../web/samples/", import.meta.url);
mkdirSync(folder, { recursive: true });
for (const { name, text } of makeSampleFiles()) writeFileSync(new URL(name, folder), text);
