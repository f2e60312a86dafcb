// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Takes the pictures of README and docs from pages of musclewarp-report.
//
// usage: node scripts/pictures.mjs page PAGE.html OUT.png
//            the page at its last frame
//        node scripts/pictures.mjs contact PAGE.html OUT.png RUN RUN [FRAME
//            [VIEW]]
//            the views of two runs at a frame (a number, by default the last),
//            lateral or as VIEW says; RUN is the folder of a run, in the order
//            of the page
//        node scripts/pictures.mjs frames PAGE.html FOLDER
//            the view of every frame, one picture each

import { mkdirSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";

import { Browser } from "../tests/tools/report/browser.mjs";

const [what, file, out, ...rest] = process.argv.slice(2);
const runs = rest.slice(0, 2);
const [chosenFrame, view = "lateral"] = rest.slice(2);
const runsNeeded = { page: 0, contact: 2, frames: 0 }[what];
if (!out || runs.length !== runsNeeded) {
  throw new Error("usage: see the head of scripts/pictures.mjs");
}

// Lays only the stage over the page, below a band for captions.
function fillWindow(page, { width, height }, band) {
  return page.addStyleTag({
    content: `.stage { position: fixed !important; z-index: 9;
        top: ${band}px; left: 0; width: ${width}px;
        height: ${height - band}px !important; border: 0 !important;
        overflow: visible !important; box-shadow: 0 0 0 100vmax white; }
      .pane-labels { inset: -${band - 8}px 0 auto !important; }
      .pane-labels div { padding: 0 !important; text-align: center;
        font-size: 18px; line-height: 24px; }`,
  });
}

// What the frame of a run says about crossing triangles.
function caption(run) {
  const report = JSON.parse(readFileSync(join(run, "report.json"), "utf8"));
  const pairs = report.frames.at(frame).intersections.triangle_pairs;
  const cross = pairs ? `${pairs} triangle pairs cross` : "no triangles cross";
  return report.contact === "none"
    ? `Without contact: ${cross}`
    : `With ${report.contact} contact: ${cross}`;
}

async function takeContact(page, viewport) {
  await page.locator("#show-lines").uncheck();
  await fillWindow(page, viewport, 40);
  await page.locator(".pane-labels div").evaluateAll((labels, texts) => {
    labels.forEach((label, i) => (label.textContent = texts[i]));
  }, runs.map(caption));
  await page
    .getByRole("button", { name: new RegExp(`^View from ${view}`) })
    .dispatchEvent("click");
  await browser.settle(page);
  await page.screenshot({ path: out });
}

async function takeFrames(page, viewport, last) {
  mkdirSync(out, { recursive: true });
  await fillWindow(page, viewport, 0);
  await page.getByRole("button", { name: /Reset/ }).dispatchEvent("click");
  for (let frame = 1; frame <= last; ++frame) {
    await page.locator("#slider").fill(String(frame));
    await browser.settle(page);
    await page.locator("#view").screenshot({
      path: join(out, `${String(frame).padStart(4, "0")}.png`),
    });
  }
}

const viewport = {
  page: { width: 1280, height: 1120 },
  contact: { width: 1080, height: 640 },
  frames: { width: 480, height: 560 },
}[what];
const browser = await Browser.launch();
const page = await browser.openReady(resolve(file), { viewport });
// The slider begins with the scene as it came, before the first frame.
const last = await page.locator("#slider").getAttribute("max");
const frame = Number(chosenFrame ?? last - 1);
await page.locator("#slider").fill(String(frame + 1));
await page.evaluate(() => document.activeElement.blur());
if (what === "page") {
  // As the page is in a lower window, with more below it.
  await page.addStyleTag({ content: `.stage { height: 512px !important; }` });
  await browser.settle(page);
  await page.screenshot({ path: out });
} else if (what === "contact") {
  await takeContact(page, viewport);
} else {
  await takeFrames(page, viewport, Number(last));
}
await browser.close();
