// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The page of joints in a browser: an arm made on a lathe, of which the shoulder
// is found and the elbow is not.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, afterEach, before, describe, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";

import { Browser, countOf, differentPixels } from "./browser.mjs";
import { headRadius, writeHumerus, writeRod } from "./made_bones.mjs";

const require = createRequire(
  new URL("../../../tools/report/package.json", import.meta.url),
);
const esbuild = require("esbuild");
const work = mkdtempSync(join(tmpdir(), "musclewarp_joints_"));
const html = join(work, "arm", "joints.html");
let browser;

before(async () => {
  const file = (name) => join(work, `${name}.obj`);
  writeHumerus(file("humerus_r"));
  writeRod(file("scapula_r"), -100, 60, -80);
  writeRod(file("ulna_r"), -150, -340, -560);
  const flags = [`--out=${join(work, "arm")}`, "--html"];
  const bones = ["humerus_r", "scapula_r", "ulna_r"].map(file);
  const { status, stderr } = spawnSync(
    process.env.MUSCLEWARP_ARTICULATE,
    [...flags, ...bones],
    { encoding: "utf8" },
  );
  assert.equal(status, 1, stderr); // a joint failed
  browser = await Browser.launch();
});

after(async () => {
  await browser?.close();
  rmSync(work, { recursive: true, force: true });
});
afterEach(() => browser?.closePages());

const item = (page, joint) => page.locator(`[data-joint="${joint}"]`);
const flexion = "#coordinate-arm_flex_r";

test("opens from disk without complaint or request", async () => {
  const page = await browser.openReady(html);
  await browser.keep(page, "joints", { fullPage: true });
  assert.deepEqual(page.complaints, []);
  assert.equal(await page.title(), "arm: musclewarp");
  await page.getByText("2 joints: 1 good, 1 failed").waitFor();
});

test("lists joints with figures and reasons", async () => {
  const page = await browser.openReady(html);
  const shoulder = await item(page, "shoulder_r").innerText();
  assert.match(shoulder, /good/);
  assert.match(
    shoulder,
    new RegExp(`head of the humerus\\s+${headRadius}.0 mm`),
  );
  const elbow = await item(page, "elbow_r").innerText();
  assert.match(elbow, /failed/);
  assert.match(elbow, /the humerus looks at the forearm over 0 degrees/);
  assert.equal(await item(page, "elbow_r").locator("input").count(), 0);
});

test("sliders move bones and what they carry", async () => {
  const page = await browser.openReady(html);
  await page.getByRole("button", { name: "View from right" }).click();
  const start = await browser.look(page);
  const slider = page.locator(flexion);
  assert.equal(await slider.inputValue(), "0");
  await slider.fill("90");
  assert.ok(differentPixels(start, await browser.look(page)) > 1000);
  await page.getByText("90.0°").waitFor();
  await browser.keep(page, "joints_moved");
  await page.getByRole("button", { name: /as in the scan/ }).click();
  assert.equal(await slider.inputValue(), "0");
  assert.ok(differentPixels(start, await browser.look(page)) < 50);
  assert.deepEqual(page.complaints, []);
});

test("a joint that is chosen is highlighted", async () => {
  const page = await browser.openReady(html);
  const child = [240, 185, 107];
  const count = async () => countOf(await browser.look(page), child);
  const before = await count();
  const button = item(page, "shoulder_r").getByRole("button");
  await button.click();
  assert.equal(await button.getAttribute("aria-pressed"), "true");
  assert.ok((await count()) > before + 500);
  await browser.keep(page, "joints_chosen");
  await button.click();
  assert.equal(await button.getAttribute("aria-pressed"), "false");
  assert.ok(Math.abs((await count()) - before) < 50);
});

test("shapes, axes and bones are hidden", async () => {
  const page = await browser.openReady(html);
  for (const box of ["#show-axes", "#show-shapes"]) {
    const before = await browser.look(page);
    await page.locator(box).uncheck();
    assert.ok(differentPixels(before, await browser.look(page)) > 100, box);
  }
  const before = await browser.look(page);
  const bone = page.locator('[data-mesh="humerus_r"] input[type=checkbox]');
  await bone.uncheck();
  assert.ok(differentPixels(before, await browser.look(page)) > 1000);
});

test("is used by keyboard", async () => {
  const page = await browser.openReady(html);
  await page.keyboard.press("j");
  await page.locator('[data-joint="shoulder_r"].selected').waitFor();
  await page.keyboard.press("j");
  await page.locator('[data-joint="elbow_r"].selected').waitFor();
  await page.keyboard.press("j");
  assert.equal(await page.locator(".joint.selected").count(), 0);
  await page.locator(flexion).focus();
  await page.keyboard.press("ArrowRight");
  assert.ok(Number(await page.inputValue(flexion)) > 0);
  await page.keyboard.press("Escape");
  const unlabelled = await page.$$eval(
    "input, button",
    (all) =>
      all.filter((each) => !each.labels?.length && !each.ariaLabel).length,
  );
  const byText = await page.locator(".joint-name").count();
  assert.equal(unlabelled, byText + 1); // and "Close" of the dialog
});

const bundled = join(work, "kinematics.mjs");
await esbuild.build({
  entryPoints: [
    fileURLToPath(
      new URL(
        "../../../tools/report/src/joints/kinematics.ts",
        import.meta.url,
      ),
    ),
  ],
  bundle: true,
  format: "esm",
  outfile: bundled,
  logLevel: "error",
});
const { posesOf } = await import(pathToFileURL(bundled));

// What moves the bones, by itself.
describe("kinematics", () => {
  const degree = Math.PI / 180;
  const [cz, sz] = [Math.cos(20 * degree), Math.sin(20 * degree)];
  const [cx, sx] = [Math.cos(10 * degree), Math.sin(10 * degree)];
  const upright = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const coordinate = (name, axis_in_joint, scan_deg) => ({
    name,
    axis_in_joint,
    scan_deg,
    range_deg: [-90, 90],
  });
  const file = {
    bodies: ["pelvis", "femur", "patella", "tibia"],
    welds: [
      { parent: "ground", child: "pelvis" },
      { parent: "femur", child: "patella" },
    ],
    joints: [
      {
        parent: "pelvis",
        child: "femur",
        center_mm: [1, 2, 3],
        parent_axes: upright,
        // About z by 20 degrees, then about x by 10.
        child_axes: [
          [cz, -sz * cx, sz * sx],
          [sz, cz * cx, -cz * sx],
          [0, sx, cx],
        ],
        coordinates: [
          coordinate("flexion", [0, 0, 1], 20),
          coordinate("adduction", [1, 0, 0], 10),
          coordinate("rotation", [0, 1, 0], 0),
        ],
      },
      {
        parent: "femur",
        child: "tibia",
        center_mm: [1, -400, 3],
        parent_axes: upright,
        child_axes: upright,
        coordinates: [coordinate("knee", [0, 0, -1], 0)],
      },
      { parent: "tibia", child: "talus" }, // failed
    ],
  };
  const scan = { flexion: 20, adduction: 10, rotation: 0, knee: 0 };
  // Where a point of a body goes.
  const moved = (values, body, [x, y, z]) => {
    const e = posesOf(file, { ...scan, ...values }).get(body).elements;
    return [0, 1, 2].map(
      (row) => e[row] * x + e[4 + row] * y + e[8 + row] * z + e[12 + row],
    );
  };
  const assertNear = (point, expected) =>
    point.forEach((number, i) =>
      assert.ok(Math.abs(number - expected[i]) < 1e-9, `${point}`),
    );

  test("bodies are where they were scanned", () => {
    for (const body of file.bodies) {
      assertNear(moved({}, body, [7, -300, 20]), [7, -300, 20]);
    }
  });

  test("bodies turn about joints and carry others", () => {
    assertNear(moved({ knee: 90 }, "tibia", [1, -500, 3]), [-99, -400, 3]);
    assertNear(moved({ knee: 90 }, "patella", [1, -500, 3]), [1, -500, 3]);
    for (const body of ["femur", "patella", "tibia"]) {
      const point = moved({ flexion: 110 }, body, [1, -98, 3]);
      assertNear(point, [101, 2, 3]);
    }
    assertNear(moved({ flexion: 110 }, "pelvis", [1, -98, 3]), [1, -98, 3]);
    // The knee lies to the right of the hip by then.
    const both = { flexion: 110, knee: 90 };
    assertNear(moved(both, "tibia", [1, -500, 3]), [403, -98, 3]);
  });
});
