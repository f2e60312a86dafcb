// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// A .glb file of musclewarp-export before the validator of its format and the
// loader of three.js, which the page and most viewers of the web use.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { test } from "node:test";

import { dataDir, deform, readReport, workDir } from "./programs.mjs";

const require = createRequire(
  new URL("../../../tools/report/package.json", import.meta.url),
);
const validator = require("gltf-validator");
const three = (file) =>
  import(
    new URL(`../../../tools/report/node_modules/three/${file}`, import.meta.url)
  );

test("a motion as glTF", async () => {
  const run = join(workDir, "run");
  const scene = join(dataDir, "phantom", "motion.json");
  deform(`--scene=${scene}`, "--frames=0:8:4", `--out=${run}`);
  const file = join(workDir, "motion.glb");
  const flags = [`--in=${run}`, `--out=${file}`, "--format=glb"];
  execFileSync(process.env.MUSCLEWARP_EXPORT, flags);
  const bytes = new Uint8Array(readFileSync(file));

  const { issues } = await validator.validateBytes(bytes);
  assert.equal(issues.numErrors, 0, JSON.stringify(issues.messages));
  assert.equal(issues.numWarnings, 0, JSON.stringify(issues.messages));

  const { GLTFLoader } = await three("examples/jsm/loaders/GLTFLoader.js");
  const { AnimationMixer } = await three("build/three.module.js");
  globalThis.self ??= globalThis; // which the loader expects of browsers
  const gltf = await new GLTFLoader().parseAsync(bytes.buffer, "");
  const { muscles, bones } = readReport(run).prepare;
  for (const { name } of [...muscles, ...bones]) {
    const mesh = gltf.scene.getObjectByName(name);
    assert.ok(mesh?.isMesh, name);
    const targets = mesh.geometry.morphAttributes.position ?? [];
    assert.equal(targets.length, muscles.some((m) => m.name === name) ? 3 : 0);
  }
  // In the last frame every muscle shows the last target, and the femur has
  // turned by the 40 degrees of the motion.
  const [clip] = gltf.animations;
  const mixer = new AnimationMixer(gltf.scene);
  mixer.clipAction(clip).play();
  mixer.setTime(clip.duration - 1e-6);
  const muscle = gltf.scene.getObjectByName(muscles[0].name);
  assert.ok(muscle.morphTargetInfluences[2] > 0.999);
  assert.ok(muscle.morphTargetInfluences[0] < 0.001);
  const { quaternion } = gltf.scene.getObjectByName("femur_r");
  const frame = readReport(run).frames.at(-1);
  const degrees = (2 * Math.acos(Math.abs(quaternion.w)) * 180) / Math.PI;
  const [flexion] = Object.values(frame.coordinates);
  assert.ok(Math.abs(degrees - Math.abs(flexion)) < 0.1, `${degrees}`);
});
