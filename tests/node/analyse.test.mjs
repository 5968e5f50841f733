// marey analyse as people and programs call it, and the same by the JavaScript module.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { createMarey } from "../../dist/module/marey.js";
import { refused, run, sample, swing } from "./support/cli.mjs";

// Fixture D of the shared theory, section 7.3: 70 kg of average male proportions on the printed gymnast.
const links = [[10, 0.0988, 0.5315, 0.2789], [12, 0.504, 0.3158, 0.4435], [16, 0.3972, 0.2899, 0.2536]];
const model = {
  metres_per_unit: 0.055,
  gravity: [0, -9.81, 0],
  segments: links.map(([units, mass, centre, radius], i) => {
    const length = 0.055 * units;
    const moment = 70 * mass * (radius * length) ** 2;
    return { joint: ["Arms", "Body", "Legs"][i], mass_kg: 70 * mass, com_m: [0, centre * length, 0], inertia_kgm2: [moment, 0, moment, 0, 0, 0] };
  }),
};

let folder;
before(() => { folder = mkdtempSync(join(tmpdir(), "marey-analyse-")); });
after(() => rmSync(folder, { recursive: true }));

function scratch(name, content) {
  const path = join(folder, name);
  writeFileSync(path, content);
  return path;
}

const modelFile = () => scratch("model.json", JSON.stringify(model));

/** The table of a call, by column names; notes on standard error are no failure. */
function tableOf(...args) {
  const { status, stdout, stderr } = run(["analyse", swing, ...args]);
  assert.equal(status, 0, stderr);
  const [header, ...rows] = stdout.trimEnd().split("\n").map((line) => line.split(","));
  return { header, rows, at: (name, frame) => rows[frame - 1][header.indexOf(name)] };
}

const wanted = "torque:*,reaction,com,kinetic_energy,angular_momentum:Arms";
const retimed = () => tableOf("-q", wanted, "--model", modelFile(), "--support", "pivot", "--frame-time", "0.066667");

describe("marey analyse", () => {
  test("gives the torques and the bar force of the giant swing", () => {
    const table = retimed();
    assert.deepEqual(table.header.slice(0, 5), ["frame", "time[s]", "torque:Arms.x[N.m]", "torque:Arms.y[N.m]", "torque:Arms.z[N.m]"]);
    assert.equal(table.rows.length, 23);
    const expected = { "torque:Arms.z[N.m]": 37.47891, "torque:Body.z[N.m]": 171.01373, "torque:Legs.z[N.m]": -33.49078, "reaction.x[N]": -1565.32879,
      "reaction.y[N]": 2734.16069, "com.x[m]": 0.49308, "kinetic_energy[J]": 1591.6194, "angular_momentum:Arms.z[kg.m2/s]": 515.21212 };
    for (const [name, value] of Object.entries(expected)) {
      assert.ok(Math.abs(Number(table.at(name, 12)) - value) < 1e-6 * Math.abs(value) + 6e-6, `${name}: ${table.at(name, 12)}`);
    }
    assert.equal(table.at("torque:Body.z[N.m]", 1), "");
    assert.equal(table.at("torque:Body.z[N.m]", 23), "");
    assert.notEqual(table.at("com.x[m]", 1), "");
  });

  test("needs no model for kinematics", () => {
    const table = tableOf("-q", "angular_velocity:Arms", "-q", "velocity:Legs_end angle:*");
    assert.ok(Math.abs(Number(table.at("angular_velocity:Arms.z[rad/s]", 10)) - 11.3622) < 1e-4);
    assert.ok(table.header.includes("angle:Legs.z[rad]"));
    assert.equal(run(["analyse", "-q", "angle:*", swing]).status, 0);
  });

  test("finds masses by names and bones", () => {
    const table = tableOf("-q", "com,reaction", "--body", "deleva-male", "--mass", "70", "--frame-time", "0.066667");
    assert.ok(Math.abs(Number(table.at("com.x[m]", 12)) - 0.49308) < 0.05, table.at("com.x[m]", 12));
    const { stderr } = run(["analyse", sample("walk"), "-q", "com", "--body", "deleva-female"]);
    assert.match(stderr, /note: Masses of 61\.9 kg: .*left thigh 9\.\d+ kg on /);
    const rods = run(["analyse", sample("robot-arm"), "-q", "com", "--body", "rods"]);
    assert.equal(rods.status, 0, rods.stderr);
  });

  test("sees from joints, from points fixed to them, and along the way", () => {
    const table = tableOf("-q", "position:Legs+0/0.88/0@Legs,included_angle:Body,work:Legs,zmp,rotation_angle:Legs@world", "--body", "rods", "--support", "pivot");
    assert.ok(Math.abs(Number(table.at("position:Legs+0/0.88/0@Legs.y[m]", 12)) - 0.88) < 1e-12);
    assert.ok(Math.abs(Number(table.at("included_angle:Body[rad]", 1)) - (173 * Math.PI) / 180) < 1e-9);
    assert.ok(table.header.includes("zmp.x[m]") && table.header.includes("rotation_angle:Legs@world[rad]"));
    assert.match(run(["analyse", swing, "-q", "com@Nobody", "--body", "rods"]).stderr, /'Nobody' is no frame of reference/);
  });

  test("judges", () => {
    const { status, stderr } = run(["analyse", swing, "--judge", "--body", "deleva-male"]);
    assert.equal(status, 0, stderr);
    assert.match(stderr, /note: .*energy/i);
    assert.match(run(["analyse", swing]).stderr, /Say what to write by -q, --judge, or --save-model/);
  });

  test("takes contacts as they are said", () => {
    const analyse = (...args) => {
      const { status, stdout, stderr } = run(["analyse", sample("walk"), "-q", "reaction", "--body", "deleva-male", ...args]);
      assert.equal(status, 0, stderr);
      return stdout.trimEnd().split("\n").slice(1).map((line) => Number(line.split(",")[3]));
    };
    const detected = analyse();
    const middle = detected.length >> 1;
    assert.ok(detected[middle] > 100, `${detected[middle]}`);
    const none = analyse("--no-contact", `Hips:1:${middle + 1}`);
    assert.ok(none.slice(1, middle + 1).every((force) => force === 0));
    assert.deepEqual(none.slice(middle + 1), detected.slice(middle + 1));
    assert.deepEqual(analyse("--contact", "Hips:2:3", "--contact", "Hips:5:6", "--no-contact", `Hips:1:${middle + 1}`), none);
  });

  test("says what is wrong", () => {
    const broken = scratch("broken.json", `{"segments": [{"joint": "Arms"`);
    const noJoint = scratch("no_joint.json", JSON.stringify({ segments: [{ joint: "Head", mass_kg: 1, com_m: [0, 0, 0] }] }));
    const tooLarge = scratch("too_large.json", `{"segments": [{"joint": "Arms", "mass_kg": 1e400, "com_m": [0, 0, 0]}]}`);
    for (const [args, pattern] of [
      [["-q", "torque:*"], /'torque' needs the masses of the segments/],
      [["-q", "torque:Head", "--model", modelFile()], /There is no joint 'Head'/],
      [["-q", "com", "--mass", "70"], /--mass/],
      [["-q", "speed"], /'speed' is not a quantity; there are position, velocity/],
      [["-q", "com", "--model", broken], /broken\.json:1:\d+: error: The model is not valid JSON/],
      [["-q", "com", "--model", tooLarge], /too_large\.json: error: The model has a number that is too large/],
      [["-q", "com", "--model", noJoint], /Segment 1 of the model hangs on a joint 'Head'/],
      [["-q", "velocity:*", "--derivative", "spline"], /'spline' is not a way to differentiate/],
      [["-q", "velocity:*", "--support", "rope"], /rope/],
      [["-q", "velocity:*", "--frame-time", "0"], /frame-time/],
      [["-q", "angle:*", "--contact", "Legs"], /'Legs' is no contact: write JOINT:FIRST:LAST/],
      [["-q", "angle:*", "--contact", "Legs:0:3"], /'Legs:0:3' is no contact/],
      [["-q", "angle:*", "--no-contact", "Legs:5:3"], /do not follow one another/],
      [["-q", "angle:*", "--no-contact", "Tail:1:3"], /There is no joint 'Tail'/],
    ]) {
      refused(["analyse", swing, ...args], pattern);
    }
  });

  test("tells what the numbers rest on", () => {
    const { stderr } = run(["analyse", swing, "-q", "reaction", "--model", modelFile()]);
    assert.match(stderr, /note: Held at its root; the torque there is a residual/);
  });
});

describe("models of the body", () => {
  test("are written as they are read", () => {
    const saved = join(folder, "saved.json");
    assert.equal(run(["analyse", swing, "--model", modelFile(), "--save-model", saved]).status, 0);
    assert.deepEqual(JSON.parse(readFileSync(saved, "utf8")), model);
    refused(["analyse", swing, "--save-model", saved], /--body, or --model/);
    refused(["analyse", swing, "-q", "com", "--body", "rods", "--save-model", "-"], /standard output/);
    const made = join(folder, "made.json");
    const quantities = ["-q", "torque:*", "--support", "pivot"];
    const direct = run(["analyse", swing, ...quantities, "--body", "deleva-male", "--save-model", made]);
    assert.deepEqual(run(["analyse", swing, ...quantities, "--model", made]).stdout, direct.stdout);
  });

  test("are the same by the module", async () => {
    const marey = await createMarey();
    const clip = marey.parse(readFileSync(swing));
    const saved = join(folder, "rods.json");
    assert.equal(run(["analyse", swing, "--body", "rods", "--mass", "50", "--save-model", saved]).status, 0);
    const made = clip.bodyModel({ body: "rods", mass: 50 });
    assert.equal(made.segments.length, 3);
    made.segments.forEach((segment, i) => assert.ok(Math.abs(segment.mass_kg - JSON.parse(readFileSync(saved, "utf8")).segments[i].mass_kg) < 1e-9));
    assert.ok(Math.abs(clip.bodyModel().segments.reduce((sum, { mass_kg }) => sum + mass_kg, 0) - 73) < 1e-9);
    assert.ok(Math.abs(clip.bodyModel({ mass: 80 }).segments.reduce((sum, { mass_kg }) => sum + mass_kg, 0) - 80) < 1e-9);
    assert.throws(() => clip.analyse({ quantities: ["angle:*"], mass: 80 }), { code: "invalid_argument" });
    assert.throws(() => clip.bodyModel({ body: "wood" }), { code: "invalid_argument" });
    assert.throws(() => clip.bodyModel({ mass: 0 }), { code: "invalid_argument" });
    clip.dispose();
  });
});

describe("clip.analyse", () => {
  test("gives the numbers of the command line", async () => {
    const marey = await createMarey();
    const clip = marey.parse(readFileSync(swing));
    const { columns, notes } = clip.analyse({ quantities: wanted.split(","), model, support: "pivot", frameTime: 0.066667 });
    const table = retimed();
    assert.deepEqual(columns.map(({ name }) => name), table.header.slice(2));
    for (const { name, values } of columns) {
      assert.ok(values instanceof Float64Array);
      values.forEach((value, i) => {
        const cell = table.at(name, i + 1);
        assert.ok(cell === "" ? Number.isNaN(value) : Math.abs(value - Number(cell)) <= 1e-9 * (1 + Math.abs(value)), `${name} ${i + 1}`);
      });
    }
    assert.match(notes.join(" "), /residual/);
    const code = (call) => { try { call(); } catch (error) { return error.code; } };
    assert.equal(code(() => clip.analyse({ quantities: ["torque:*"] })), "invalid_argument");
    assert.equal(code(() => clip.analyse({ quantities: "com" })), "invalid_argument");
    assert.equal(code(() => clip.analyse({ quantities: ["com"], model: {} })), "invalid_argument");
    assert.equal(code(() => clip.analyse({ quantities: ["angle:*"], support: "rope" })), "invalid_argument");
    assert.equal(code(() => clip.analyse({ quantities: ["angle:*"], frameTime: -1 })), "invalid_argument");
    const walk = marey.parse(readFileSync(sample("walk")));
    const reaction = (contacts) => walk.analyse({ quantities: ["reaction"], body: "rods", contacts }).columns[1].values;
    assert.ok(reaction()[90] > 100);
    assert.equal(reaction([{ joint: "Hips", first: 80, last: 95, touches: false }])[90], 0);
    assert.equal(reaction([{ joint: "Hips", first: 80, last: 95, touches: false }])[96], reaction()[96]);
    for (const contacts of [[{ joint: "Hips" }], [{ joint: 5, first: 1, last: 2 }], [{ joint: "Tail", first: 1, last: 2 }], [{ joint: "Hips", first: 2, last: 1 }]]) {
      assert.equal(code(() => reaction(contacts)), "invalid_argument");
    }
    walk.dispose();
    for (const name of ["body", "support", "derivative"]) {
      assert.equal(code(() => clip.analyse({ quantities: ["angle:*"], [name]: 5 })), "invalid_argument", name);
    }
    clip.dispose();
  });
});
