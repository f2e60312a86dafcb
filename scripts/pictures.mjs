// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Takes the pictures of the README from pages of musclewarp-report.
//
// usage: node scripts/pictures.mjs page PAGE.html OUT.png
//        node scripts/pictures.mjs frames PAGE.html FOLDER    every frame's view

import { mkdirSync } from "node:fs";
import { join, resolve } from "node:path";

import { Browser } from "../tests/tools/report/browser.mjs";

const [what, file, out] = process.argv.slice(2);
if (!["page", "frames"].includes(what) || !out) {
  throw new Error("usage: node scripts/pictures.mjs page|frames PAGE OUT");
}

const browser = await Browser.launch();
const viewport = { width: 1280, height: 1120 };
const page = await browser.openReady(resolve(file), { viewport });
const last = await page.locator("#slider").getAttribute("max");
if (what === "page") {
  // As it is in a lower window, with more below it.
  await page.addStyleTag({
    content: `.stage { height: 512px !important; }`,
  });
  await page.locator("#slider").fill(last);
  await page.evaluate(() => document.activeElement.blur());
  await browser.settle(page);
  await page.screenshot({ path: out });
} else {
  mkdirSync(out, { recursive: true });
  await page.locator("#show-crossings").uncheck();
  // Only the stage, as large as the window.
  await page.addStyleTag({
    content: `.stage { position: fixed !important; inset: 0; z-index: 9;
      width: 480px; height: 560px !important; border: 0 !important; }`,
  });
  await page.setViewportSize({ width: 480, height: 560 });
  await page.getByRole("button", { name: /Reset/ }).dispatchEvent("click");
  for (let frame = 1; frame <= Number(last); ++frame) {
    await page.locator("#slider").fill(String(frame));
    await browser.settle(page);
    await page.locator("#view").screenshot({
      path: join(out, `${String(frame).padStart(4, "0")}.png`),
    });
  }
}
await browser.close();
