// The JavaScript module as it is shipped, dist/module/marey.js.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { before, describe, test } from "node:test";
import { MareyError, createMarey } from "../../dist/module/marey.js";

const sample = (name) => readFileSync(new URL(`../../web/samples/${name}.bvh`, import.meta.url));

// An arm of two links along x: the root turns about z, then the elbow does.
const arm = `HIERARCHY
ROOT Shoulder
{
  OFFSET 1 2 3
  CHANNELS 1 Zrotation
  JOINT Elbow
  {
    OFFSET 10 0 0
    CHANNELS 2 Zrotation Xposition
    End Site
    {
      OFFSET 0 5 0
    }
  }
}
MOTION
Frames: 3
Frame Time: 0.04
0 0 10
90 0 10
90 -90 12
`;

let marey;
before(async () => {
  marey = await createMarey();
});

const near = (actual, expected) => {
  assert.equal(actual.length, expected.length);
  expected.forEach((value, i) => assert.ok(Math.abs(actual[i] - value) < 1e-5, `value ${i}: ${actual[i]}, expected ${value}`));
};

describe("a clip that was read", () => {
  test("tells what the file says", () => {
    const clip = marey.parse(arm);
    assert.deepEqual(clip.joints, [
      { name: "Shoulder", parent: -1, offset: [1, 2, 3], channels: ["Zrotation"] },
      { name: "Elbow", parent: 0, offset: [10, 0, 0], channels: ["Zrotation", "Xposition"], endSite: [0, 5, 0] },
    ]);
    assert.equal(clip.frameCount, 3);
    assert.equal(clip.frameTime, 0.04);
    assert.equal(clip.channelCount, 3);
    assert.equal(clip.nodeCount, 3);
    assert.deepEqual([...clip.channel(0)], [0, 90, 90]);
    assert.deepEqual([...clip.channel(2)], [10, 10, 12]);
  });

  test("gives world positions of joints and end sites", () => {
    const clip = marey.parse(arm);
    near(clip.worldPositions(0, 1), [1, 2, 3, 11, 2, 3, 11, 7, 3]);
    near(clip.worldPositions(1, 1), [1, 2, 3, 1, 12, 3, -4, 12, 3]);
    near(clip.worldPositions(2), [1, 2, 3, 1, 14, 3, 1, 19, 3]);
    assert.deepEqual(clip.worldPositions().slice(9, 18), clip.worldPositions(1, 1));
    assert.equal(clip.worldPositions(3).length, 0);
  });

  test("is written as it was read", () => {
    for (const name of ["giant-swing", "pendulum", "walk", "robot-arm"]) {
      const bytes = sample(name);
      assert.deepEqual(Buffer.from(marey.parse(bytes).write()), bytes, name);
    }
  });

  test("keeps its numbers to the last bit", () => {
    const clip = marey.parse(arm);
    const values = [Math.PI * 1e-7, 1 / 3, -1.7976931348623157e308];
    clip.setChannel(1, values);
    const again = marey.parse(clip.write());
    assert.deepEqual([...again.channel(1)], values);
    assert.deepEqual([...again.channel(0)], [0, 90, 90]);
  });
});

describe("a clip that is written otherwise", () => {
  const text = (clip, options) => new TextDecoder().decode(clip.write(options));

  test("has the decimals, line ends and frames that are asked for", () => {
    const clip = marey.parse(arm);
    assert.equal(text(clip, {}), text(clip));
    assert.equal(text(clip, { lineEnds: "crlf" }), text(clip).replaceAll("\n", "\r\n"));
    assert.match(text(clip, { decimals: 3 }), /OFFSET 1\.000 2\.000 3\.000/);
    const part = marey.parse(clip.write({ first: 1, count: 2 }));
    assert.equal(part.frameCount, 2);
    assert.deepEqual([...part.channel(0)], [...clip.channel(0)].slice(1));
    assert.equal(marey.parse(clip.write({ first: 2 })).frameCount, 1);
  });

  test("is refused with what it cannot have", () => {
    const clip = marey.parse(arm);
    for (const options of [{ decimals: 16 }, { decimals: 1.5 }, { lineEnds: "cr" }, { first: 3 }, { first: 1, count: 3 }, { count: 0 }]) {
      assert.throws(() => clip.write(options), { code: "invalid_argument" }, JSON.stringify(options));
    }
  });
});

describe("positions beside an offset", () => {
  const text = `HIERARCHY
ROOT Root
{
  OFFSET 0 0 0
  CHANNELS 3 Xposition Yposition Zposition
  JOINT Slide
  {
    OFFSET 0 10 0
    CHANNELS 3 Xposition Yposition Zposition
    End Site { OFFSET 0 5 0 }
  }
}
MOTION
Frames: 1
Frame Time: 0.1
0 0 0 1 12 0
`;

  test("replace it or add to it, as is set", () => {
    const clip = marey.parse(text);
    assert.equal(clip.positions, "replace");
    near(clip.worldPositions(), [0, 0, 0, 1, 12, 0, 1, 17, 0]);
    clip.positions = "add";
    assert.equal(clip.positions, "add");
    near(clip.worldPositions(), [0, 0, 0, 1, 22, 0, 1, 27, 0]);
    assert.throws(() => (clip.positions = "both"), { code: "invalid_argument" });
    assert.equal(new TextDecoder().decode(clip.write()), text);
  });

  test("mean what each joint's numbers say where these differ", () => {
    const joint = (name) => `JOINT ${name} { OFFSET 0 10 0 CHANNELS 1 Yposition End Site { OFFSET 0 5 0 } }`;
    const clip = marey.parse(`HIERARCHY ROOT Root { OFFSET 0 0 0 CHANNELS 1 Yposition ${joint("Still")} ${joint("Slide")} }
MOTION Frames: 1 Frame Time: 0.1
0 0 11
`);
    assert.equal(clip.positions, "per_joint");
    assert.deepEqual([...clip.worldPositions()].filter((_, i) => i % 3 === 1), [0, 10, 15, 11, 16]);
    clip.positions = "replace";
    assert.deepEqual([...clip.worldPositions()].filter((_, i) => i % 3 === 1), [0, 0, 5, 11, 16]);
  });
});

describe("tables", () => {
  const text = (bytes) => new TextDecoder().decode(bytes);

  test("of channels come back bit for bit", () => {
    const clip = marey.parse(sample("walk"));
    const again = marey.parseTable(clip.writeTable("channels"), { figure: clip });
    for (let i = 0; i < clip.channelCount; i++) assert.deepEqual(again.channel(i), clip.channel(i));
    assert.deepEqual(again.write(), clip.write());
  });

  test("of positions carry units, and become points", () => {
    const clip = marey.parse(arm);
    const table = text(clip.writeTable("positions", { lengthUnit: "cm", first: 1, count: 2 }));
    const [header, ...rows] = table.trim().split("\n");
    assert.match(header, /^frame,time\[s\],Shoulder\.x\[cm\],/);
    assert.deepEqual(rows.map((row) => row.split(",")[0]), ["2", "3"]);
    const points = marey.parseTable(table);
    assert.deepEqual(points.joints.map(({ name }) => name), ["Shoulder", "Elbow", "Elbow_end"]);
    near(points.worldPositions(0, 1), [...clip.worldPositions(1, 1)]);
  });

  test("are refused with what they cannot have", () => {
    const clip = marey.parse(arm);
    const calls = [() => clip.writeTable("angles"), () => clip.writeTable("channels", { lengthUnit: "mile" }),
      () => clip.writeTable("channels", { first: 2, count: 2 }), () => marey.parseTable("", { figure: {} })];
    for (const call of calls) assert.throws(call, { code: "invalid_argument" });
    assert.throws(() => marey.parseTable("frame,time,Shoulder.Zrotation\n1,0,5\n"), { code: "table_kind", line: 1 });
  });
});

describe("a copy for another program", () => {
  test("says what it costs and shows the same movement", () => {
    const clip = marey.parse(arm.replace("ROOT Shoulder", "ROOT Left Shoulder"));
    const { bytes, changes, names, largestMove } = clip.writeFor("blender", { referencePose: false, lineEnds: "crlf" });
    assert.ok(changes.some(({ kind, message }) => kind === "positions_added" && message.length > 20));
    assert.deepEqual(names.map(({ before, after }) => [before, after]), [["Left Shoulder", "Left_Shoulder"]]);
    assert.ok(largestMove < 1e-9);
    assert.match(new TextDecoder().decode(bytes), /Left_Shoulder\r\n/);
    near(marey.parse(bytes).worldPositions(), [...clip.worldPositions()]);
  });

  test("is refused for a program that is not known", () => {
    assert.throws(() => marey.parse(arm).writeFor("abacus"), { code: "invalid_argument" });
  });
});

describe("a changed channel", () => {
  test("moves the body", () => {
    const clip = marey.parse(arm);
    clip.setChannel(0, new Float32Array([90, 0, 0]));
    near(clip.worldPositions(0, 1), [1, 2, 3, 1, 12, 3, -4, 12, 3]);
  });

  test("is a copy in both directions", () => {
    const clip = marey.parse(arm);
    const channel = clip.channel(0);
    channel[0] = 45;
    assert.equal(clip.channel(0)[0], 0);
    clip.setChannel(0, channel);
    channel[0] = 46;
    assert.equal(clip.channel(0)[0], 45);
  });

  test("must have a finite number for each frame", () => {
    const clip = marey.parse(arm);
    assert.throws(() => clip.setChannel(0, [1, 2]), { name: "MareyError", code: "invalid_argument" });
    assert.throws(() => clip.setChannel(0, [1, NaN, 2]), { name: "MareyError", code: "not_finite" });
    assert.throws(() => clip.setChannel(0, [1, Infinity, 2]), { code: "not_finite" });
    assert.deepEqual([...clip.channel(0)], [0, 90, 90]);
  });
});

describe("what cannot be answered", () => {
  test("is an error with its place in the file", () => {
    const deep = `HIERARCHY\nROOT Link\n${"{ OFFSET 0 1 0\nJOINT Link\n".repeat(2500)}`;
    assert.throws(() => marey.parse(deep), (error) => {
      assert.ok(error instanceof MareyError && error instanceof Error);
      assert.equal(error.code, "limit_depth");
      assert.match(error.message, /2000/);
      assert.ok(error.line > 4000 && error.column >= 1, `${error.line}:${error.column}`);
      return true;
    });
    assert.throws(() => marey.parse("%PDF-1.4"), { name: "MareyError", code: "not_bvh", line: 1, column: 1 });
  });

  test("is told by repairs, which strict reading refuses", () => {
    const lowerCase = arm.replace("CHANNELS 1", "Channels 1");
    const clip = marey.parse(lowerCase);
    assert.ok(clip.diagnostics.length > 0);
    const [{ code, line, column, message, count, severity }] = clip.diagnostics;
    assert.equal(line, 5);
    assert.ok(column >= 1 && count === 1 && message.length > 10 && severity.length > 0);
    assert.throws(() => marey.parse(lowerCase, { strict: true }), { code, line });
    assert.doesNotThrow(() => marey.parse(arm, { strict: true }));
  });

  test("is refused when it is out of range", () => {
    const clip = marey.parse(arm);
    for (const index of [-1, 3, 0.5, NaN, undefined]) assert.throws(() => clip.channel(index), { code: "invalid_argument" });
    for (const range of [[-1, 1], [0, 4], [4], [1, 3], [0, -1], [0.5, 1]]) {
      assert.throws(() => clip.worldPositions(...range), { code: "invalid_argument" }, String(range));
    }
  });

  test("is refused after dispose, which may be called twice", () => {
    const clip = marey.parse(arm);
    clip.dispose();
    clip.dispose();
    for (const use of [() => clip.channel(0), () => clip.write(), () => clip.worldPositions(), () => clip.setChannel(0, [0, 0, 0])]) {
      assert.throws(use, { name: "MareyError" });
    }
    assert.equal(clip.joints.length, 2);
  });

  test("includes an empty file, bytes that are no text, and a file cut anywhere", () => {
    assert.throws(() => marey.parse(""), { name: "MareyError" });
    assert.throws(() => marey.parse(new Uint8Array(1000).fill(255)), { name: "MareyError" });
    for (let length = 0; length < arm.length; length++) {
      try {
        marey.parse(arm.slice(0, length)).dispose();
      } catch (error) {
        assert.ok(error instanceof MareyError, `${length}: ${error}`);
      }
    }
  });
});

describe("memory", () => {
  const long = () => {
    const rows = Array.from({ length: 400_000 }, (_, i) => `${i % 360} 0 10`).join("\n");
    return `${arm.slice(0, arm.indexOf("Frames"))}Frames: 400000\nFrame Time: 0.01\n${rows}\n`;
  };

  test("may grow while copies and clips are held", () => {
    const clip = marey.parse(arm);
    const [channel, positions] = [clip.channel(0), clip.worldPositions()];
    const other = marey.parse(long());
    assert.equal(other.frameCount, 400_000);
    assert.equal(other.worldPositions().length, 400_000 * 9);
    assert.deepEqual([...channel], [0, 90, 90]);
    assert.deepEqual(clip.worldPositions(), positions);
    other.dispose();
  });

  test("is given back by dispose", () => {
    const text = long();
    for (let i = 0; i < 60; i++) {
      const clip = marey.parse(text);
      clip.worldPositions();
      clip.dispose();
    }
  });

  test("is not shared between two instances", async () => {
    const wasmBinary = readFileSync(new URL("../../dist/module/marey.wasm", import.meta.url));
    const other = await createMarey({ wasmBinary });
    assert.equal(other.parse(arm).frameCount, 3);
    assert.equal(marey.parse(arm).frameCount, 3);
  });
});

test("names that are not UTF-8 are shown and written back", () => {
  const bytes = Buffer.from(arm.replace("Shoulder", "Sch\xfctze"), "latin1");
  const clip = marey.parse(bytes);
  assert.equal(clip.joints[0].name, "Schütze");
  assert.deepEqual(Buffer.from(clip.write()), bytes);
});
