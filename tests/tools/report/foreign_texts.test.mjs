// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Pages of inputs whose names are scripts: they run none of them, load nothing,
// whatever is clicked, and forbid both.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { cpSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, afterEach, before, test } from "node:test";
import { fileURLToPath } from "node:url";

import { Browser } from "./browser.mjs";
import { writeHumerus, writeRod } from "./made_bones.mjs";
import { dataDir, deform, workDir } from "./programs.mjs";

const image = "<img src=x onerror=alert(1)>";
const drawing = "'\"><svg onload=alert(2)>";
// A file or folder cannot have a slash in its name.
const button = "<button autofocus onfocus=alert(3)>";
let browser;

before(async () => (browser = await Browser.launch()));
after(() => browser?.close());
afterEach(() => browser?.closePages());

// Clicks, checks and opens everything that can be, twice, but for links, which
// lead away.
async function useEverything(page) {
  for (const round of [1, 2]) {
    const all = page.locator("button, summary, input[type=checkbox], .place");
    const count = await all.count();
    assert.ok(count > 0 || round > 0);
    for (let i = 0; i < count; ++i) {
      const one = all.nth(i);
      if (!(await one.isVisible()) || !(await one.isEnabled())) continue;
      await one.click({ force: true, noWaitAfter: true });
      // A dialog covers what is behind it.
      await page.keyboard.press("Escape");
    }
  }
}

async function expectHarmless(page) {
  const policy = await page
    .locator("meta[http-equiv=Content-Security-Policy]")
    .getAttribute("content");
  assert.match(policy, /default-src 'none'/);
  assert.doesNotMatch(policy, /https?:|\*|unsafe-eval/);
  assert.doesNotMatch(policy, /script-src[^;]*unsafe-inline/);
  assert.equal(
    await page.locator("img, [onload], [onerror], [onfocus]").count(),
    0,
  );
  await useEverything(page);
  assert.deepEqual(page.complaints, []);
}

test("the page of a run", async () => {
  const folder = join(workDir, "foreign");
  cpSync(join(dataDir, "phantom"), folder, { recursive: true });
  const file = join(folder, "scene.json");
  const scene = JSON.parse(readFileSync(file, "utf8"));
  scene.name = "</script><script>alert(4)</script>";
  scene.muscles[0].name = image;
  scene.muscles[0].lines[0].name = button;
  scene.bones[0].name = drawing;
  scene.bones[0].body = scene.bones[0].body ?? scene.bones[0].name;
  scene.poses[0].name = drawing;
  scene.poses.length = 2;
  writeFileSync(file, JSON.stringify(scene));
  const out = join(folder, "out");
  assert.equal(deform(`--scene=${file}`, `--out=${out}`, "--html"), 0);
  const page = await browser.openReady(join(out, "report.html"));
  assert.ok((await page.innerText("body")).includes(image));
  await expectHarmless(page);
});

test("the page of joints", async () => {
  const folder = join(workDir, `joints ${button}`);
  mkdirSync(folder);
  const at = (name) => join(folder, `${name}.obj`);
  writeHumerus(at("humerus_r"));
  writeRod(at("scapula_r"), -100, 60, -80);
  writeRod(at(`ulna_r ${image}`), -150, -340, -560);
  writeRod(at(drawing), -120, -40, -200);
  const { status, stderr } = spawnSync(
    process.env.MUSCLEWARP_ARTICULATE,
    [
      `--out=${join(folder, "out")}`,
      `--muscles=${at(drawing)}`,
      "--html",
      at("humerus_r"),
      at("scapula_r"),
      at(`ulna_r ${image}`),
    ],
    { encoding: "utf8" },
  );
  assert.ok(status === 0 || status === 1, stderr);
  const page = await browser.openReady(join(folder, "out", "joints.html"));
  assert.ok((await page.innerText("body")).includes(image));
  await expectHarmless(page);
});

test("the page of a group", async () => {
  const file = join(workDir, "group.html");
  const script = fileURLToPath(
    new URL("../../cohort/write_group_page.py", import.meta.url),
  );
  const { status, stderr } = spawnSync(
    process.env.MUSCLEWARP_PYTHON,
    ["-B", script, file, image, drawing, button],
    { encoding: "utf8" },
  );
  assert.equal(status, 0, stderr);
  const page = await browser.open(file);
  assert.ok((await page.innerText("body")).includes(image));
  await expectHarmless(page);
});
