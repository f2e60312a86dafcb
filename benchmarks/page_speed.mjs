// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// How quickly pages of musclewarp-report are ready, and how many frames a
// second they show of 30 asked for, in headless Chromium without a graphics
// card.
//
// usage: MUSCLEWARP_CHROMIUM=$(command -v chromium) \
//        node benchmarks/page_speed.mjs PAGE.html...

import { statSync } from "node:fs";
import { resolve } from "node:path";

import { Browser } from "../tests/tools/report/browser.mjs";

const seconds = 5;
const viewport = { width: 1280, height: 800 };

// Opens it twice: the first time the browser itself is not ready.
async function readyAfter(browser, file) {
  let elapsed = 0;
  for (let i = 0; i < 2; ++i) {
    const start = performance.now();
    const page = await browser.open(file, { viewport });
    await page.waitForSelector("html[data-ready]");
    await page.evaluate(() => new Promise(requestAnimationFrame));
    elapsed = performance.now() - start;
    await browser.closePages();
  }
  return elapsed;
}

async function framesPerSecond(browser, file) {
  const page = await browser.openReady(file, { viewport });
  await page.getByLabel("Frames per second").selectOption("30");
  await page.locator("#play").click();
  await page.waitForTimeout(500);
  const shown = await page.evaluate(async (milliseconds) => {
    const slider = document.querySelector("#slider");
    const start = performance.now();
    let frames = 0;
    let last = slider.value;
    while (performance.now() - start < milliseconds) {
      await new Promise(requestAnimationFrame);
      if (slider.value !== last) ++frames;
      last = slider.value;
    }
    return frames;
  }, 1000 * seconds);
  await browser.closePages();
  return shown / seconds;
}

const browser = await Browser.launch();
for (const file of process.argv.slice(2).map((path) => resolve(path))) {
  const mebibytes = (statSync(file).size / (1 << 20)).toFixed(1);
  const ready = ((await readyAfter(browser, file)) / 1000).toFixed(1);
  const rate = (await framesPerSecond(browser, file)).toFixed(0);
  console.log(
    `${file}: ${mebibytes} MiB, ready after ${ready} s, ${rate} frames a second`,
  );
}
await browser.close();
