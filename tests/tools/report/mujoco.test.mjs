// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// A model of musclewarp-export --format=mjcf in MuJoCo itself: its official
// build for npm.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { test } from "node:test";

import { dataDir, deform, readReport, workDir } from "./programs.mjs";

const require = createRequire(
  new URL("../../../tools/report/package.json", import.meta.url),
);

// The value of a polynomial, and its derivative.
const valueOf = (coefficients, x) =>
  coefficients.reduceRight((sum, c) => sum * x + c, 0);
const slopeOf = (coefficients, x) =>
  valueOf(
    coefficients.slice(1).map((c, i) => (i + 1) * c),
    x,
  );

// The length of a path of model.fit.json, mm, and its moment arms.
function pathAt({ exponents, coefficients_mm: coefficients }, q) {
  let length = 0;
  const arms = q.map(() => 0);
  exponents.forEach((row, i) => {
    const powers = row.map((n, k) => q[k] ** n);
    length += coefficients[i] * powers.reduce((a, b) => a * b, 1);
    row.forEach((n, k) => {
      if (n === 0) return;
      const others = powers.reduce((a, b, j) => (j === k ? a : a * b), 1);
      arms[k] -= coefficients[i] * n * q[k] ** (n - 1) * others;
    });
  });
  return { length, arms };
}

// A model in MuJoCo, with the names of its parts.
class Simulation {
  static async load(dir) {
    const { default: loadMujoco } = await import(require.resolve("mujoco-js"));
    const mujoco = await loadMujoco();
    mujoco.FS.mkdir("/model");
    mujoco.FS.mkdir("/model/assets");
    const copy = (file) =>
      mujoco.FS.writeFile(`/model/${file}`, readFileSync(join(dir, file)));
    copy("model.xml");
    for (const file of readdirSync(join(dir, "assets"))) {
      copy(`assets/${file}`);
    }
    const model = mujoco.MjModel.loadFromXML("/model/model.xml");
    const fit = JSON.parse(readFileSync(join(dir, "model.fit.json"), "utf8"));
    return new Simulation(mujoco, model, fit);
  }

  constructor(mujoco, model, fit) {
    Object.assign(this, { mujoco, model, fit });
    this.data = new mujoco.MjData(model);
    const namesAt = (addresses) =>
      Array.from(addresses, (start) => {
        let end = start;
        while (model.names[end] !== 0) ++end;
        return String.fromCharCode(...model.names.slice(start, end));
      });
    this.joints = namesAt(model.name_jntadr);
    this.tendons = namesAt(model.name_tendonadr);
    this.restart();
  }

  restart() {
    this.mujoco.mj_resetDataKeyframe(this.model, this.data, 0);
  }

  place(joint) {
    return this.model.jnt_qposadr[this.joints.indexOf(joint)];
  }

  // Takes coordinates to values, and all that follows them.
  goTo(values) {
    this.restart();
    const q = Array.from(this.data.qpos);
    for (const [name, value] of Object.entries(values)) {
      q[this.place(name)] = value;
    }
    // Those that follow may be followed themselves.
    for (let round = 0; round < 3; ++round) {
      for (const { joint, of, coefficients } of this.fit.joints) {
        const x = of ? q[this.place(of)] : 0;
        q[this.place(joint)] = valueOf(coefficients, x);
      }
    }
    this.data.qpos.set(q);
    this.mujoco.mj_forward(this.model, this.data);
  }

  // The moment arm of a tendon about a coordinate, mm, with all that follows.
  armOf(tendon, coordinate) {
    const rates = { [coordinate]: 1 };
    for (let round = 0; round < 3; ++round) {
      for (const { joint, of, coefficients } of this.fit.joints) {
        if (rates[of] === undefined) continue;
        const x = this.data.qpos[this.place(of)];
        rates[joint] = rates[of] * slopeOf(coefficients, x);
      }
    }
    const row = this.tendons.indexOf(tendon) * this.model.nv;
    return Object.entries(rates).reduce((sum, [joint, rate]) => {
      const dof = this.model.jnt_dofadr[this.joints.indexOf(joint)];
      return sum - 1000 * rate * this.data.ten_J[row + dof];
    }, 0);
  }

  lengthOf(tendon) {
    return 1000 * this.data.ten_length[this.tendons.indexOf(tendon)];
  }

  // The vertices of a skin, mm, from the places of its bodies, as MuJoCo draws
  // them.
  skin(skin) {
    const { model, data } = this;
    const points = Array.from({ length: model.skin_vertnum[skin] }, () => [
      0, 0, 0,
    ]);
    const first = model.skin_boneadr[skin];
    const rest = model.skin_vert.slice(3 * model.skin_vertadr[skin]);
    for (let b = first; b < first + model.skin_bonenum[skin]; ++b) {
      const body = model.skin_bonebodyid[b];
      const from = turnOf(model.skin_bonebindquat.slice(4 * b, 4 * b + 4));
      const bind = model.skin_bonebindpos.slice(3 * b, 3 * b + 3);
      const to = data.xmat.slice(9 * body, 9 * body + 9);
      const at = data.xpos.slice(3 * body, 3 * body + 3);
      const start = model.skin_bonevertadr[b];
      for (let i = start; i < start + model.skin_bonevertnum[b]; ++i) {
        const vertex = model.skin_bonevertid[i];
        const weight = model.skin_bonevertweight[i];
        const seen = [0, 1, 2].map((k) => rest[3 * vertex + k] - bind[k]);
        const own = [0, 1, 2].map((k) =>
          seen.reduce((sum, x, j) => sum + from[j][k] * x, 0),
        );
        for (let k = 0; k < 3; ++k) {
          const moved = own.reduce((sum, x, j) => sum + to[3 * k + j] * x, 0);
          points[vertex][k] += 1000 * weight * (at[k] + moved);
        }
      }
    }
    return points;
  }
}

// The matrix of a quaternion w, x, y, z.
function turnOf([w, x, y, z]) {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
}

// The vertices of a .ply file as musclewarp-deform writes it.
function pointsOf(file) {
  const bytes = readFileSync(file);
  const end = bytes.indexOf("end_header\n") + "end_header\n".length;
  const [, count] = /element vertex (\d+)/.exec(
    bytes.toString("latin1", 0, end),
  );
  return Array.from({ length: Number(count) }, (_, i) =>
    [0, 1, 2].map((k) => bytes.readDoubleLE(end + 8 * (3 * i + k))),
  );
}

// Numbers from 0 to 1 that are the same every time.
function draws(seed) {
  let state = seed;
  return () => {
    state = (state * 16807) % 2147483647;
    return state / 2147483647;
  };
}

const median = (numbers) => numbers.sort((a, b) => a - b)[numbers.length >> 1];

let simulation;
const run = join(workDir, "postures");

test("MuJoCo loads the model of a design of postures", async () => {
  const scene = JSON.parse(
    readFileSync(join(dataDir, "phantom", "motion.json"), "utf8"),
  );
  scene.motion = {
    design: "latin_hypercube",
    postures: 16,
    coordinates: { hip_flexion_r: [-10, 40] },
  };
  const file = join(workDir, "postures.json");
  writeFileSync(file, JSON.stringify(scene));
  const root = join(dataDir, "phantom");
  deform(
    "--contact=certified",
    `--scene=${file}`,
    `--data_root=${root}`,
    `--out=${run}`,
  );
  const out = join(workDir, "mujoco");
  const flags = [`--in=${run}`, `--out=${out}`, "--format=mjcf"];
  flags.push("--max_skin_distance_mm=0.05"); // so that there are slides
  const { status, stderr } = spawnSync(process.env.MUSCLEWARP_EXPORT, flags);
  assert.ok(status === 0 || status === 1, String(stderr));
  simulation = await Simulation.load(out);
  const { model, fit } = simulation;
  const count = (object) => Object.keys(object).length;
  assert.equal(model.ntendon, count(fit.tendons));
  assert.equal(model.nu, count(fit.tendons));
  assert.equal(model.nskin, count(fit.skins));
  assert.ok(model.nskin > 0 && model.nmesh > 0);
});

test("its tendons are as long as ours, with our moment arms", () => {
  const draw = draws(1);
  for (const [name, path] of Object.entries(simulation.fit.muscles)) {
    const lengths = [];
    const arms = [];
    for (let i = 0; i < 50; ++i) {
      const q = path.coordinates.map((c) => {
        const [low, high] = path.range[c];
        return low + draw() * (high - low);
      });
      simulation.goTo(
        Object.fromEntries(path.coordinates.map((c, k) => [c, q[k]])),
      );
      const ours = pathAt(path, q);
      lengths.push(Math.abs(simulation.lengthOf(name) - ours.length));
      path.coordinates.forEach((c, k) =>
        arms.push(Math.abs(simulation.armOf(name, c) - ours.arms[k])),
      );
    }
    assert.ok(median(arms) < 2, `${name}: arms off by ${median(arms)} mm`);
    assert.ok(median(lengths) < 2, `${name}: ${median(lengths)} mm`);
  }
});

test("its skins are as far from the frames as is told", () => {
  const { model, fit } = simulation;
  const report = readReport(run);
  const sceneFromGround = report.motion.rest.scene_from_ground.slice(0, 3);
  const place = ([x, y, z]) =>
    sceneFromGround.map(([a, b, c, d]) => a * x + b * y + c * z + d);
  const names = Object.keys(fit.skins);
  const sums = names.map(() => 0);
  assert.ok(names.some((name) => fit.skins[name].slides > 0));
  for (const { index, coordinates } of report.frames) {
    const { hip_flexion_r: degrees } = coordinates;
    simulation.goTo({ hip_flexion_r: (degrees * Math.PI) / 180 });
    const folder = `frame_${String(index).padStart(4, "0")}`;
    names.forEach((name, skin) => {
      const wanted = pointsOf(join(run, folder, `${name}.ply`));
      const skinned = simulation.skin(skin);
      assert.equal(skinned.length, wanted.length);
      const distances = skinned.map((point, i) =>
        Math.hypot(...place(point).map((x, k) => x - wanted[i][k])),
      );
      sums[skin] += distances.reduce((a, b) => a + b, 0) / distances.length;
    });
  }
  names.forEach((name, skin) => {
    const mean = sums[skin] / report.frames.length;
    const told = fit.skins[name].distance_mean_mm;
    // Skins have numbers of four bytes.
    assert.ok(Math.abs(mean - told) < 0.01, `${name}: ${mean}, told ${told}`);
    assert.ok(told <= 0.05, `${name}: ${told}`);
  });
});

test("it steps 1000 times without a warning", () => {
  const { mujoco, model, data } = simulation;
  simulation.restart();
  for (let i = 0; i < 1000; ++i) mujoco.mj_step(model, data);
  for (let i = 0; i < 8; ++i) {
    assert.equal(data.warning.get(i).number, 0, `warning ${i}`);
  }
  assert.ok(Array.from(data.qpos).every(Number.isFinite));
});
