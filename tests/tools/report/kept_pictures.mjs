// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// First screens of pages, compared with the pictures in the folder `kept`.
//
// With MUSCLEWARP_KEEP_PICTURES=1 the tests write these pictures in place of
// comparing them; each is to be looked at before it is committed:
//
//   MUSCLEWARP_KEEP_PICTURES=1 MUSCLEWARP_DATA_ROOT=/path/to/data \
//     ctest --preset release -R report_page/Pictures

import assert from "node:assert/strict";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

import { writeInBoxes } from "./box_font.mjs";

const keptDir = fileURLToPath(new URL("kept", import.meta.url));
const keeps = process.env.MUSCLEWARP_KEEP_PICTURES === "1";
const screenshots =
  process.env.MUSCLEWARP_SCREENSHOTS ??
  join(tmpdir(), "musclewarp_screenshots");

export const screens = {
  wide: { viewport: { width: 1400, height: 900 } },
  phone: {
    viewport: { width: 390, height: 844 },
    isMobile: true,
    hasTouch: true,
  },
};

// Pictures are compared at a quarter of their width and height, where
// antialiasing changes little.
const shrinkage = 4;

const farApart = 40; // of 255

// On the embedded scene, 1400 pixels wide: the same page again, or with other
// fonts installed, is 0.00 apart with 0.00 % of it far; with light letters and
// other smoothing 0.21 and 0.04 %. Of the damages in pictures.test.mjs each is
// beyond a limit: the least are a panel of the side gone (1.66, 0.94 %), bones
// hidden (1.28, 2.00 %), and white made bluish (4.76, 0.00 %). Muscles hidden
// are 3.53 and 5.17 %, another view 6.1 and 8.4 %, dark for light 193 and 91 %.
const limits = { mean: 0.8, share: 0.007 };

// The means of blocks, of which the last ones may be narrower.
export function shrink({ width, height, data }) {
  const small = {
    width: Math.ceil(width / shrinkage),
    height: Math.ceil(height / shrinkage),
  };
  const sums = new Float64Array(4 * small.width * small.height);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const block =
        Math.floor(y / shrinkage) * small.width + Math.floor(x / shrinkage);
      const pixel = y * width + x;
      for (let k = 0; k < 3; ++k) sums[4 * block + k] += data[4 * pixel + k];
      sums[4 * block + 3] += 1;
    }
  }
  small.data = Buffer.alloc(sums.length, 255);
  sums.forEach((sum, i) => {
    if (i % 4 < 3) small.data[i] = Math.round(sum / sums[i | 3]);
  });
  return small;
}

// The mean absolute difference of colours (of 255), and the share of pixels
// that are far apart.
export function difference(a, b) {
  const pixels = a.width * a.height;
  let sum = 0;
  let far = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    const apart = [0, 1, 2].map((k) => Math.abs(a.data[i + k] - b.data[i + k]));
    sum += apart[0] + apart[1] + apart[2];
    if (Math.max(...apart) > farApart) ++far;
  }
  return { mean: sum / (3 * pixels), share: far / pixels };
}

export const isLike = ({ mean, share }) =>
  mean <= limits.mean && share <= limits.share;

// The first screen, once everything on it is drawn.
export async function firstScreen(browser, page) {
  await browser.settle(page);
  return page.screenshot();
}

export async function differenceFromKept(browser, png, name) {
  const file = join(keptDir, `${name}.png`);
  assert.ok(existsSync(file), `no ${file}: see kept_pictures.mjs`);
  const kept = await browser.decode(readFileSync(file));
  const now = shrink(await browser.decode(png));
  assert.deepEqual([now.width, now.height], [kept.width, kept.height]);
  return difference(now, kept);
}

async function keepSmall(browser, png, name) {
  const small = shrink(await browser.decode(png));
  mkdirSync(keptDir, { recursive: true });
  writeFileSync(join(keptDir, `${name}.png`), await browser.encode(small));
}

// Nothing, or what is not as it was.
async function changeOf(browser, png, name) {
  if (keeps) {
    await keepSmall(browser, png, name);
    return [];
  }
  const found = await differenceFromKept(browser, png, name);
  if (isLike(found)) return [];
  mkdirSync(screenshots, { recursive: true });
  const shown = join(screenshots, `${name}_changed.png`);
  writeFileSync(shown, png);
  const { mean, share } = found;
  return [
    `${shown} is not like kept/${name}.png: ${mean.toFixed(2)} apart, ` +
      `${(100 * share).toFixed(2)} % of it far`,
  ];
}

// As the page is, for those who look at the screenshots.
async function keepAsItIs(browser, page, name) {
  await browser.settle(page);
  await browser.keep(page, `first_${name}`);
}

// Both before all is written in boxes and after it.
async function takeInBothThemes(page, take) {
  for (const theme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme: theme });
    await page.waitForSelector(`html[data-theme=${theme}]`);
    await take(theme);
  }
}

// Opens the page on all screens in both themes: it must say nothing, fit the
// width, and look as it did.
export async function checkFirstScreens(browser, file, name) {
  const changes = [];
  for (const [screen, options] of Object.entries(screens)) {
    const page = await browser.openReady(file, options);
    const { width } = options.viewport;
    const wide = await page.evaluate(
      () => document.documentElement.scrollWidth,
    );
    assert.ok(wide <= width, `${name}: ${wide} pixels wide on ${width}`);
    await takeInBothThemes(page, (theme) =>
      keepAsItIs(browser, page, `${name}_${screen}_${theme}`),
    );
    await writeInBoxes(page);
    await takeInBothThemes(page, async (theme) => {
      const png = await firstScreen(browser, page);
      const pictureName = `${name}_${screen}_${theme}`;
      changes.push(...(await changeOf(browser, png, pictureName)));
    });
    assert.deepEqual(page.complaints, []);
    await browser.closePages();
  }
  assert.deepEqual(changes, []);
}
