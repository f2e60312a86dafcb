// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// First screens of pages of the data sets, compared with kept pictures.
// kept_pictures.mjs says how these are made anew.

import { join } from "node:path";
import { after, afterEach, before, test } from "node:test";

import { Browser } from "./browser.mjs";
import { checkFirstScreens } from "./kept_pictures.mjs";
import { dataDir, deform, workDir, writePage } from "./programs.mjs";

const root = process.env.MUSCLEWARP_DATA_ROOT;
const skip = root ? false : "MUSCLEWARP_DATA_ROOT is not set";
const scenes = {
  lhdl_hip: join(dataDir, "scenes", "lhdl_hip.json"),
  bodyparts3d_hip: join(dataDir, "scenes", "bodyparts3d_hip.json"),
  bodyparts3d_shank: join(root ?? "", "bodyparts3d_shank/scene_uniform.json"),
};
let browser;

before(async () => {
  if (!skip) browser = await Browser.launch();
});

after(() => browser?.close());
afterEach(() => browser?.closePages());

for (const [name, scene] of Object.entries(scenes)) {
  test(`first screens of ${name}`, { skip }, async () => {
    const run = join(workDir, name);
    deform(
      `--scene=${scene}`,
      `--data_root=${root}`,
      `--out=${run}`,
      "--frames=0:1",
    );
    const page = writePage(run, join(workDir, `${name}.html`));
    await checkFirstScreens(browser, page, name);
  });
}
