// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// First screens of pages of the embedded scene, compared with kept pictures.
// kept_pictures.mjs says how these are made anew.

import assert from "node:assert/strict";
import { join } from "node:path";
import { after, afterEach, before, describe, test } from "node:test";

import { writeInBoxes } from "./box_font.mjs";
import { Browser } from "./browser.mjs";
import {
  checkFirstScreens,
  differenceFromKept,
  firstScreen,
  isLike,
  screens,
} from "./kept_pictures.mjs";
import { dataDir, deform, workDir, writePage } from "./programs.mjs";

const scene = join(dataDir, "phantom", "motion.json");
const html = join(workDir, "motion.html");
let browser;

function run(name, ...flags) {
  const out = join(workDir, name);
  deform(`--scene=${scene}`, `--out=${out}`, ...flags);
  return out;
}

before(async () => {
  writePage(run("motion", "--fibres=20"), html);
  browser = await Browser.launch();
});

after(() => browser?.close());
afterEach(() => browser?.closePages());

describe("first screens", () => {
  test("of the embedded scene", () =>
    checkFirstScreens(browser, html, "embedded"));

  test("of two runs beside each other", async () => {
    const none = run("none", "--frames=0:3");
    const paper = run("paper", "--frames=0:3", "--contact=paper");
    const both = writePage(
      none,
      join(workDir, "both.html"),
      `--compare=${paper}`,
    );
    await checkFirstScreens(browser, both, "compared");
  });
});

const style = (content) => async (page) => {
  const tag = await page.addStyleTag({ content });
  return () => tag.evaluate((node) => node.remove());
};

const colouring = (name) => async (page) => {
  await page.locator("#coloring").selectOption(name);
  return () => page.locator("#coloring").selectOption("name");
};

const view = (name) => async (page) => {
  await page.getByRole("button", { name: `View from ${name}` }).click();
  return () => page.getByRole("button", { name: /Reset/ }).click();
};

const theme = (colorScheme) => async (page) => {
  await page.emulateMedia({ colorScheme });
  return () => page.emulateMedia({ colorScheme: "light" });
};

const without = (label) => async (page) => {
  await page.getByLabel(label, { exact: true }).uncheck();
  return () => page.getByLabel(label, { exact: true }).check();
};

const withoutMuscles = async (page) => {
  const button = (text) =>
    page.locator("#meshes .group button", { hasText: text }).first();
  await button("none").click();
  return () => button("all").click();
};

// By what is wrong: how a page gets so. Each gives what mends the page.
const damages = {
  "an empty view": style("#view { opacity: 0 }"),
  "no side panel": style("aside { display: none !important }"),
  "no panel of crossings": style(
    "aside section:last-child { display: none !important }",
  ),
  "no buttons of the motion": style(".transport { visibility: hidden }"),
  "another background": style(":root { --surface: #eef !important }"),
  "muscles hidden": withoutMuscles,
  "bones hidden": without("All bones"),
  "colours of the stretch": colouring("stretch"),
  "a view from the front": view("anterior"),
  "a view from within": view("medial"),
  "dark for light": theme("dark"),
};

test("damages are seen", async (context) => {
  const page = await browser.openReady(html, screens.wide);
  await writeInBoxes(page);
  const found = async () =>
    differenceFromKept(
      browser,
      await firstScreen(browser, page),
      "embedded_wide_light",
    );
  for (const [name, damage] of Object.entries(damages)) {
    const mend = await damage(page);
    const { mean, share } = await found();
    await mend();
    context.diagnostic(
      `${name}: ${mean.toFixed(2)}, ${(100 * share).toFixed(2)} %`,
    );
    assert.ok(!isLike({ mean, share }), name);
    assert.ok(isLike(await found()), `after ${name}`);
  }
});
