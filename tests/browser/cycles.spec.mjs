// A thousand files opened one after the other leave the page's memory where it was.
import { armClip, brokenClip } from "./support/clips.mjs";
import { expect, test } from "./support/fixtures.mjs";

/** Counts the GL objects that are made and not deleted. */
function countGlObjects() {
  window.glObjects = {};
  const kinds = ["Buffer", "Texture", "Program", "Shader", "Framebuffer", "Renderbuffer", "VertexArray", "Sampler", "Query"];
  for (const kind of kinds) {
    const prototype = WebGL2RenderingContext.prototype;
    const [create, remove] = [prototype[`create${kind}`], prototype[`delete${kind}`]];
    const alive = new Set();
    prototype[`create${kind}`] = function (...args) {
      const object = create.apply(this, args);
      alive.add(object);
      return object;
    };
    prototype[`delete${kind}`] = function (object) {
      alive.delete(object);
      return remove.call(this, object);
    };
    Object.defineProperty(window.glObjects, kind, { enumerable: true, get: () => alive.size });
  }
}

/** Opens files in turns, some of them refused, some edited, so many cycles. */
function openInTurns([files, from, count]) {
  const open = async ({ name, text, refused, edit }) => {
    const opened = await window.marey.open(name, text).then(() => true, () => false);
    if (opened === Boolean(refused)) throw new Error(`${name} was ${opened ? "opened" : "refused"}`);
    if (!edit) return;
    await window.marey.command("curve.select", { channel: 0, first: 1, count: 3 });
    await window.marey.command("curve.move", { delta: 2 });
    if (edit === "undone") await window.marey.command("edit.undo");
  };
  return (async () => {
    for (let i = from; i < from + count; i++) await open(files[i % files.length]);
  })();
}

const files = [
  { name: "short.bvh", text: armClip(5) },
  { name: "edited.bvh", text: armClip(40), edit: "kept" },
  { name: "broken.bvh", text: brokenClip, refused: true },
  { name: "names.bvh", text: armClip(8).replace("Elbow", "Локоть") },
  { name: "long.bvh", text: armClip(2000), edit: "undone" },
  { name: "points.csv", text: `time,a.x,a.y,a.z\n${[0, 1, 2, 3].map((i) => `${i / 25},${i},0,1`).join("\n")}\n` },
  { name: "empty.bvh", text: "", refused: true },
  { name: "repaired.bvh", text: armClip(9).replace("Frames: 9", "Frames: 12") },
];

test.use({ viewport: { width: 400, height: 300 } });

test(`a thousand files leave the memory as it was`, async ({ marey, page }, testInfo) => {
  test.setTimeout(240_000);
  await page.addInitScript(countGlObjects);
  await marey.goto();
  const session = await page.context().newCDPSession(page);
  const measure = async () => {
    await marey.drawn(3);
    await session.send("HeapProfiler.collectGarbage");
    const { usedSize } = await session.send("Runtime.getHeapUsage");
    return page.evaluate((script) => ({ ...window.marey.memory(), ...window.glObjects, script }), usedSize);
  };
  const half = files.length * 62;
  const measured = [];
  for (const [from, count] of [[0, files.length * 10], [0, half], [half, half]]) {
    await page.evaluate(openInTurns, [files, from, count]);
    measured.push(await measure());
  }
  testInfo.annotations.push({ type: "memory", description: JSON.stringify(measured) });
  const [before, between, after] = measured;
  const { script: scriptBefore, used: usedBefore, ...heldBefore } = before;
  const { script: scriptAfter, used: usedAfter, ...heldAfter } = after;
  expect(heldAfter).toEqual(heldBefore);
  // A buffer that grew once, for a longer message, grew in one half. What one kind of file leaves behind, be it the smallest
  // block there is (16 bytes), grows in both.
  const grown = [between.used - usedBefore, usedAfter - between.used];
  expect(Math.min(...grown), `bytes grown in each half: ${grown}`).toBeLessThan(16 * (half / files.length));
  // V8 keeps code and caches as it likes; a document kept by mistake would be 1000 times this page's state.
  expect(scriptAfter - scriptBefore).toBeLessThan(1_000_000);
});
