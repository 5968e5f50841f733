// The command line as people and programs call it: build/native/marey, or the program that MAREY_CLI names.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { program, refused, repairable, root, run, sample, sampleNames, smallClip, succeed, swing, text } from "./support/cli.mjs";
import { readBvh, worldPose } from "./support/plain_bvh.mjs";

let folder;
before(() => { folder = mkdtempSync(join(tmpdir(), "marey-cli-")); });
after(() => rmSync(folder, { recursive: true }));

function scratch(name, content) {
  const path = join(folder, name);
  writeFileSync(path, content);
  return path;
}

const table = (csv) => csv.trimEnd().split("\n").map((line) => line.split(","));

describe("marey", () => {
  test("--version names the program and its version", () => {
    const { version } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
    assert.equal(succeed(["--version"]), `marey ${version}\n`);
  });

  test("--help lists the commands, each of which has its own", () => {
    const help = succeed(["--help"]);
    for (const command of ["info", "convert", "fk", "fmt", "check"]) {
      assert.match(help, new RegExp(`^  ${command} +[A-Z]`, "m"));
      assert.match(succeed([command, "--help"]), /--strict/);
    }
  });

  test("refuses wrong usage", () => {
    refused([], /^marey: error: .*subcommand/i);
    refused(["juggle"], /^marey: error: /);
    refused(["info"], /^marey: error: FILE is required/);
    refused(["info", swing, "--colour"], /^marey: error: .*--colour/);
    refused(["fk", swing, "two"], /^marey: error: .*two/);
    refused(["convert", swing], /^marey: error: OUT is required/);
  });

  for (const command of ["info", "fk", "fmt", "check"]) {
    test(`${command} refuses what it cannot read`, () => {
      refused([command, join(folder, "missing.bvh")], /missing\.bvh: error: The file cannot be opened: No such file/);
      refused([command, folder], /error: This is a folder, not a file\.$/m);
      refused([command, scratch("broken.bvh", "HIERARCHY\n{\n}\n")], /broken\.bvh:4:1: error: The hierarchy has no joint.*\.$/m);
      refused([command, scratch("empty.bvh", "")], /empty\.bvh(:\d+:\d+)?: error: /);
      refused([command, "-"], /^<stdin>(:\d+:\d+)?: error: /, "not a motion");
    });

    test(`${command} --strict refuses a repair and tells its place`, () => {
      const file = scratch("repairable.bvh", repairable);
      assert.equal(run([command, file]).status, 0);
      refused([command, "--strict", file], /repairable\.bvh:\d+:\d+: error: /);
      assert.equal(run([command, "--strict", swing]).status, 0);
    });

    test(`${command} reads standard input`, () => {
      const fromFile = succeed([command, swing]).replaceAll(swing, "<stdin>");
      assert.equal(succeed([command, "-"], text("giant-swing")), fromFile);
    });
  }
});

describe("a file with a part that cannot be read", () => {
  const damaged = smallClip().replace("OFFSET 0.0 2.0 0.0", "OFFSET 0.0 2.0 two");
  const line = /^[^\n]*damaged\.bvh:8:20: error: [^\n]*\n$/;

  for (const command of ["info", "fk", "fmt"]) {
    test(`${command} goes on and says what is missing`, () => {
      const { status, stdout, stderr } = run([command, scratch("damaged.bvh", damaged)]);
      assert.equal(status, 0);
      assert.match(stderr, line);
      assert.notEqual(stdout, "");
    });
  }

  test("check fails", () => {
    const { status, stdout, stderr } = run(["check", scratch("damaged.bvh", damaged)]);
    assert.equal(status, 1);
    assert.match(stderr.replace(/\n.*: note: .*$/m, ""), line);
    assert.match(stdout, /: 1 error, 0 warnings, 0 limit violations\n$/);
  });
});

describe("marey info", () => {
  test("tells what the clip holds", () => {
    const out = succeed(["info", swing]);
    for (const line of [/joints +3, and 1 end site/, /channels +12/, /frames +23/, /frame time +0\.033333 s, 30 per second/,
      /duration +0\.733326 s/, /Euler orders +ZXY \(3 joints\)/, /stature +38 units/, /unit +/]) {
      assert.match(out, line);
    }
    assert.match(out, /\n {4}Body Zrotation Xrotation Yrotation\n/);
  });

  test("--json has the documented keys", () => {
    const info = JSON.parse(succeed(["info", "--json", swing]));
    assert.deepEqual(info.joints.map(({ name, parent }) => [name, parent]), [["Arms", -1], ["Body", 0], ["Legs", 1]]);
    assert.deepEqual(info.joints[1].offset, [0, 10, 0]);
    assert.deepEqual(info.joints[1].channels, ["Zrotation", "Xrotation", "Yrotation"]);
    assert.deepEqual(info.joints[2].end_site, [0, 16, 0]);
    assert.ok(!("end_site" in info.joints[1]));
    assert.equal(info.channel_count, 12);
    assert.equal(info.frame_count, 23);
    assert.equal(info.frame_time, 0.033333);
    assert.deepEqual(info.diagnostics, []);
  });

  test("repairs are told: as lines on standard error, or in the JSON", () => {
    const file = scratch("repairable.bvh", repairable);
    const plain = run(["info", file]);
    assert.equal(plain.status, 0);
    assert.match(plain.stderr, /^[^\n]*repairable\.bvh:\d+:\d+: warning: [^\n]*\n$/);
    const json = run(["info", "--json", file]);
    assert.equal(json.stderr, "");
    const [{ severity, code, line, column, message, count }] = JSON.parse(json.stdout).diagnostics;
    assert.deepEqual([severity, code, count], ["warning", "frame_count_mismatch", 1]);
    assert.ok(line > 0 && column > 0 && message.length > 10);
  });

  test("names that are not UTF-8 still make valid JSON", () => {
    const file = scratch("latin1.bvh", Buffer.from(smallClip({ name: "H\xfcfte" }), "latin1"));
    assert.match(JSON.parse(run(["info", "--json", file]).stdout).joints[0].name, /^H.+fte$/);
  });
});

describe("--json of a file that is refused", () => {
  for (const command of ["info", "check"]) {
    test(`${command} prints code, place and sentence beside the line on standard error`, () => {
      const { status, stdout, stderr } = run([command, "--json", scratch("broken.bvh", "HIERARCHY\n{\n}\n")]);
      assert.equal(status, 2);
      const { error } = JSON.parse(stdout);
      assert.deepEqual([error.code, error.line, error.column], ["missing_root", 4, 1]);
      assert.match(stderr, /^[^\n]*broken\.bvh:4:1: error: [^\n]*\n$/);
      assert.ok(stderr.trimEnd().endsWith(error.message));
      const strict = run([command, "--json", "--strict", scratch("repairable.bvh", repairable)]);
      assert.equal(JSON.parse(strict.stdout).error.code, "frame_count_mismatch");
    });
  }
});

describe("marey fmt", () => {
  test("--canonical writes one form of the same clip, whatever its style was", () => {
    const odd = "\uFEFFhierarchy\r\nROOT\tA\r\n{ OFFSET 0 1.50 0\r\nCHANNELS 1 Zrotation End Site { OFFSET 0 2 0 } }\r\n"
      + "MOTION\r\nFrames: 2\r\nFrame Time: .04\r\n 1.0 \r\n-0.50";
    const plain = "HIERARCHY\nROOT A\n{\n  OFFSET 0 1.5 0\n  CHANNELS 1 Zrotation\n  End Site\n  {\n    OFFSET 0 2 0\n  }\n}\n"
      + "MOTION\nFrames: 2\nFrame Time: 0.04\n1\n-0.5\n";
    const forms = [odd, plain].map((bvh) => run(["fmt", "--canonical", "-"], Buffer.from(bvh, "utf8")).stdout);
    assert.equal(forms[0], forms[1]);
    assert.deepEqual(forms[0].match(/-?[\d.]+/g).map(Number), plain.match(/-?[\d.]+/g).map(Number));
    assert.equal(run(["fmt", "--canonical", "-"], forms[0]).stdout, forms[0]);
  });

  for (const name of sampleNames) {
    test(`gives ${name}.bvh back byte for byte`, () => assert.equal(succeed(["fmt", sample(name)]), text(name)));
  }

  test("keeps CRLF, NULs and all other bytes of a file in binary form", () => {
    const windows = smallClip({ name: "H\xfcfte", end: "\r\n" });
    const path = scratch("windows.bvh", Buffer.from(windows, "latin1"));
    assert.equal(run(["fmt", path]).stdout, windows);
  });

  test("writes the repaired file, which strict reading then accepts", () => {
    const out = join(folder, "repaired.bvh");
    assert.equal(run(["fmt", scratch("repairable.bvh", repairable), "-o", out]).status, 0);
    assert.equal(readFileSync(out, "utf8"), repairable.replace("Frames: 2", "Frames: 3"));
    succeed(["fmt", "--strict", out]);
  });

  test("can write over its input", () => {
    const path = scratch("same.bvh", repairable);
    assert.equal(run(["fmt", path, "-o", path]).status, 0);
    assert.equal(readFileSync(path, "utf8"), repairable.replace("Frames: 2", "Frames: 3"));
  });
});

describe("marey fk", () => {
  test("header: joints in file order, end sites behind theirs", () => {
    const [header] = table(succeed(["fk", swing]));
    const nodes = ["Arms", "Body", "Legs", "Legs_end"];
    assert.deepEqual(header, ["frame", "time", ...nodes.flatMap((node) => ["x", "y", "z"].map((axis) => `${node}.${axis}`))]);
  });

  for (const name of sampleNames) {
    test(`positions of ${name} agree with plain forward kinematics`, () => {
      const clip = readBvh(text(name));
      const [header, ...rows] = table(succeed(["fk", sample(name)]));
      assert.equal(rows.length, clip.rows.length);
      rows.forEach((row, frame) => {
        assert.equal(Number(row[0]), frame + 1);
        assert.equal(Number(row[1]), frame * clip.frameTime);
        const expected = worldPose(clip, clip.rows[frame]).flatMap(({ position }) => position);
        assert.equal(row.length, header.length);
        expected.forEach((value, i) => assert.ok(Math.abs(value - Number(row[i + 2])) < 1e-9, `${header[i + 2]} in row ${frame + 1}`));
      });
    });
  }

  test("-o writes the same into a file", () => {
    const out = join(folder, "positions.csv");
    assert.equal(succeed(["fk", swing, "-o", out]), "");
    assert.equal(readFileSync(out, "utf8"), succeed(["fk", swing]));
  });

  test("--positions chooses what position channels mean", () => {
    const moved = scratch("moved.bvh", smallClip().replace("OFFSET 0.0 0.0 0.0", "OFFSET 0.0 5.0 0.0").replace("Zrotation", "Yposition"));
    const height = (args) => Number(table(succeed(["fk", moved, ...args]))[1][3]);
    assert.equal(height([]), 1);
    assert.equal(height(["--positions", "replace"]), 1);
    assert.equal(height(["--positions", "add"]), 6);
    refused(["fk", moved, "--positions", "double"], /--positions/);
  });

  test("names with commas and quotes are quoted", () => {
    const file = scratch("names.bvh", smallClip({ name: 'a,"b"' }));
    assert.match(run(["fk", file]).stdout, /^frame,time,"a,""b"".x",/);
  });
});

describe("marey convert", () => {
  const converted = (name, args = []) => {
    const out = join(folder, name);
    succeed(["convert", swing, out, ...args]);
    return readFileSync(out, "utf8");
  };

  test("to CSV: one column per channel, the numbers of the file", () => {
    const clip = readBvh(text("giant-swing"));
    const [header, ...rows] = table(converted("swing.csv"));
    const channels = clip.joints.flatMap(({ name, channels }) => channels.map((channel) => `${name}.${channel}`));
    assert.deepEqual(header, ["frame", "time", ...channels]);
    rows.forEach((row, frame) => assert.deepEqual(row.slice(2).map(Number), clip.rows[frame]));
  });

  test("to BVH: the same file, in upper-case extension as well", () => {
    assert.equal(converted("swing.bvh"), text("giant-swing"));
    assert.equal(converted("swing.BVH"), text("giant-swing"));
  });

  test("--frames keeps the frames named, both ends included", () => {
    const clip = readBvh(text("giant-swing"));
    const part = readBvh(converted("part.bvh", ["--frames", "5:8"]));
    assert.deepEqual(part.rows, clip.rows.slice(4, 8));
    assert.deepEqual(part.joints, clip.joints);
    assert.deepEqual(readBvh(converted("one.bvh", ["--frames", "23:23"])).rows, [clip.rows[22]]);
  });

  test("--decimals and --line-ends change just these", () => {
    assert.equal(converted("crlf.bvh", ["--line-ends", "crlf"]), text("giant-swing").replaceAll("\n", "\r\n"));
    const before = readBvh(text("giant-swing"));
    const after = readBvh(converted("short.bvh", ["--decimals", "1"]));
    after.rows.forEach((row, frame) => row.forEach((value, channel) => {
      assert.equal(value, Number(value.toFixed(1)));
      assert.ok(Math.abs(value - before.rows[frame][channel]) <= 0.05 + 1e-12, `frame ${frame + 1}, channel ${channel}`);
    }));
    refused(["convert", swing, join(folder, "never.csv"), "--decimals", "2"], /--decimals and --line-ends go with BVH/);
    refused(["convert", swing, join(folder, "never.bvh"), "--decimals", "16"], /decimals/);
  });

  test("--frames keeps the text of the rows", () => {
    const file = scratch("odd-rows.bvh", smallClip({ rows: ["1.50", "+3.0\t", "  5.000"] }));
    const part = succeed(["convert", file, "-", "--frames", "2:3"]);
    assert.equal(part, smallClip({ frames: 2, rows: ["+3.0\t", "  5.000"] }));
  });

  test("--fps resamples at the given rate over the same time", () => {
    const clip = readBvh(text("walk"));
    const out = join(folder, "resampled.bvh");
    succeed(["convert", sample("walk"), out, "--fps", "30"]);
    const half = readBvh(readFileSync(out, "utf8"));
    assert.ok(Math.abs(half.frameTime - 1 / 30) < 1e-6);
    const steps = Math.abs(half.rows.length - clip.rows.length / 2);
    assert.ok(steps <= 1, `${half.rows.length} frames`);
    half.rows.slice(0, 90).forEach((row, frame) => row.forEach((value, channel) => {
      assert.ok(Math.abs(value - clip.rows[2 * frame][channel]) < 0.02, `frame ${frame + 1}, channel ${channel}`);
    }));
  });

  test("writes BVH or, with --to, CSV to standard output", () => {
    assert.equal(succeed(["convert", swing, "-"]), text("giant-swing"));
    assert.equal(succeed(["convert", swing, "-", "--to", "csv"]), converted("again.csv"));
    assert.equal(succeed(["convert", "-", "-"], text("giant-swing")), text("giant-swing"));
  });

  test("refuses formats, ranges and rates that make no sense", () => {
    const out = join(folder, "never.bvh");
    refused(["convert", swing, join(folder, "never.xyz")], /\.xyz/);
    refused(["convert", swing, join(folder, "never")], /bvh/);
    for (const range of ["0:3", "4:2", "5:24", "x:3", "3", "1:2:3", "-1:2", "1:99999999999"]) {
      refused(["convert", swing, out, `--frames=${range}`], /error: .*(frames|clip has)/i);
    }
    for (const rate of ["0", "-30", "nan", "inf", "fast", "1e300"]) refused(["convert", swing, out, `--fps=${rate}`], /fps/);
    refused(["convert", join(folder, "missing.bvh"), out], /missing\.bvh: error: /);
    refused(["convert", scratch("repairable.bvh", repairable), out, "--strict"], /repairable\.bvh:\d+:\d+: error: /);
    assert.ok(!existsSync(out));
  });
});

describe("output", () => {
  test("that cannot be written is an error", () => {
    refused(["fmt", swing, "-o", folder], /error: The file cannot be written: Is a directory/);
    refused(["fk", swing, "-o", join(folder, "no/such/place.csv")], /error: The file cannot be written: No such file/);
  });

  test("to a full device is an error", { skip: !existsSync("/dev/full") && "no /dev/full" }, () => {
    refused(["fk", sample("walk"), "-o", "/dev/full"], /error: The file cannot be written: No space left/);
  });

  test("into a pipe that is closed early ends quietly", async () => {
    const rows = Array.from({ length: 200_000 }, (_, i) => String(i));
    const file = scratch("long.bvh", smallClip({ frames: rows.length, rows }));
    const child = spawn(program, ["fk", file], { stdio: ["ignore", "pipe", "pipe"] });
    let stderr = "";
    child.stderr.on("data", (data) => { stderr += data; });
    child.stdout.once("data", () => child.stdout.destroy());
    const [code, signal] = await new Promise((resolve) => child.on("close", (...end) => resolve(end)));
    assert.deepEqual({ code, signal, stderr }, { code: 0, signal: null, stderr: "" });
  });

  test("is complete for a long clip", () => {
    const rows = Array.from({ length: 100_000 }, (_, i) => String(i / 8));
    const file = scratch("long.bvh", smallClip({ frames: rows.length, rows }));
    mkdirSync(join(folder, "deep"), { recursive: true });
    const out = join(folder, "deep", "long.csv");
    succeed(["convert", file, out]);
    const last = readFileSync(out, "utf8").trimEnd().split("\n").at(-1);
    assert.equal(last.split(",")[2], String(99_999 / 8));
  });
});
