// Who may include whom. The one place where the arrows between rooms stand.
const basics = ["core/base", "core/text", "core/math", "core/skeleton", "core/motion"];
const mechanics = [...basics, "core/kinematics"];
const core = [...mechanics, "core/signal", "core/bvh", "core/structure", "core/mesh", "core/editing", "core/biomechanics",
  "core/retargeting", "core/constraints", "core/table", "core/lint",
  "core/interchange", "core/document"];

const arrows = {
  "core/base": [],
  "core/text": ["core/base"],
  "core/math": ["core/base"],
  "core/signal": ["core/base", "core/math"],
  "core/skeleton": ["core/base", "core/text", "core/math"],
  "core/motion": ["core/base", "core/text", "core/math", "core/skeleton"],
  "core/bvh": basics,
  "core/structure": basics,
  "core/mesh": basics,
  "core/kinematics": basics,
  "core/editing": [...mechanics, "core/signal", "core/biomechanics"],
  "core/biomechanics": [...mechanics, "core/signal"],
  "core/retargeting": mechanics,
  "core/constraints": mechanics,
  "core/table": [...mechanics, "core/bvh"],
  "core/lint": mechanics,
  "core/interchange": [...mechanics, "core/bvh", "core/lint"],
  "core/document": core,
  cli: core,
  "wasm/render": core,
  "wasm/platform": [...core, "wasm/render", "wasm/app"],
  "wasm/app": [...core, "wasm/render", "wasm/platform", "wasm/views"],
  "wasm/views": [...core, "wasm/render", "wasm/platform", "wasm/app"],
  "wasm/bindings": [...core, "wasm/render", "wasm/platform", "wasm/app", "wasm/views"],
};

// Parts of a room that only some others may include, whatever the arrows say.
const doors = [
  { part: /^wasm\/platform\/(web|headless)\//, open: ["wasm/platform", "wasm/bindings"] },
  { part: /^wasm\/render\/(?!(scene|curve_batch)\.h$)/, open: ["wasm/render", "wasm/platform", "wasm/bindings"] },
];

const rooms = Object.keys(arrows);
const findRoom = (path) => rooms.find((room) => path.startsWith(`${room}/`));

function findFault(from, target) {
  const room = findRoom(from);
  const to = findRoom(target);
  if (!to) return "is not a path from the root of the repository";
  const door = doors.find(({ part }) => part.test(target));
  if (door && !door.open.includes(room)) return "is private to its room";
  if (to !== room && !arrows[room].includes(to)) return `is an arrow from ${room} to ${to}`;
  return undefined;
}

export const name = "layering";
export const unit = "includes";

export function check(files) {
  const problems = [];
  let checked = 0;
  for (const { path, text } of files.filter((file) => /\.(h|cpp)$/.test(file.path) && findRoom(file.path))) {
    for (const [, target] of text.matchAll(/^\s*#\s*include\s+"([^"]+)"/gm)) {
      checked += 1;
      const fault = findFault(path, target);
      if (fault) problems.push(`${path}: #include "${target}" ${fault}`);
    }
  }
  return { checked, problems };
}

export const seeds = [
  { path: "core/signal/seed.h", text: '#include "core/motion/clip.h"\n' },
  { path: "core/bvh/seed.cpp", text: '#include "core/kinematics/pose.h"\n' },
  { path: "core/motion/seed.h", text: '#include "core/document/document.h"\n' },
  { path: "core/base/seed.h", text: '#include "wasm/app/app.h"\n' },
  { path: "core/text/seed.h", text: '#include "core/skeleton/skeleton.h"\n' },
  { path: "core/math/seed.h", text: '#include "../base/result.h"\n' },
  { path: "wasm/views/seed.cpp", text: '#include "wasm/platform/web/host.h"\n' },
  { path: "wasm/render/seed.cpp", text: '#include "wasm/app/theme.h"\n' },
];
