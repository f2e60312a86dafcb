// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The page in a browser: hip flexion of the LHDL data set, with and without
// contact.

import assert from "node:assert/strict";
import { statSync } from "node:fs";
import { join } from "node:path";
import { after, afterEach, before, test } from "node:test";

import { Browser, countOf } from "./browser.mjs";
import { dataDir, deform, workDir, writePage } from "./programs.mjs";

const mebibyte = 1 << 20;
const root = process.env.MUSCLEWARP_DATA_ROOT;
const skip = root ? false : "MUSCLEWARP_DATA_ROOT is not set";
let browser;

before(async () => {
  if (skip) return;
  const scene = join(dataDir, "scenes", "lhdl_hip_motion.json");
  for (const contact of ["none", "paper"]) {
    deform(
      `--scene=${scene}`,
      `--data_root=${root}`,
      `--contact=${contact}`,
      `--out=${join(workDir, contact)}`,
      "--fibres=50",
    );
  }
  browser = await Browser.launch();
});

after(() => browser?.close());
afterEach(() => browser?.closePages());

for (const contact of ["none", "paper"]) {
  test(`a page of hip flexion, contact ${contact}`, { skip }, async () => {
    const page = writePage(
      join(workDir, contact),
      `${workDir}/${contact}.html`,
    );
    assert.ok(statSync(page).size < 12 * mebibyte);
    const opened = await browser.openReady(page);
    assert.deepEqual(opened.complaints, []);
    assert.equal(await opened.locator(".strip .mark").count(), 37);
    await opened.locator("#slider").fill("36");
    await opened.getByText("hip_flexion_r 60 degrees").first().waitFor();
    await browser.settle(opened);
    await browser.keep(opened, `lhdl_${contact}`, { fullPage: true });
  });
}

test(
  "hip flexion with and without contact beside each other",
  { skip },
  async () => {
    const page = writePage(
      join(workDir, "none"),
      join(workDir, "both.html"),
      `--compare=${join(workDir, "paper")}`,
    );
    const opened = await browser.openReady(page);
    await opened.locator("#slider").fill("36");
    const picture = await browser.look(opened);
    // Gluteus maximus and medius: the first two colours.
    for (const color of [
      [204, 102, 119],
      [92, 106, 196],
    ]) {
      assert.ok(countOf(picture, color) > 5000);
    }
    await opened.locator("#coloring").selectOption("gap");
    await browser.settle(opened);
    await browser.keep(opened, "lhdl_both");
    assert.deepEqual(opened.complaints, []);
  },
);
