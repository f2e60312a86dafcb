// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// A headless browser, and what can be seen in its pictures.

import { mkdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const require = createRequire(
  new URL("../../../tools/report/package.json", import.meta.url),
);
const { chromium } = require("playwright-core");

const screenshots = process.env.MUSCLEWARP_SCREENSHOTS;

export class Browser {
  static async launch() {
    const made = new Browser();
    made.browser = await chromium.launch({
      executablePath: process.env.MUSCLEWARP_CHROMIUM,
      args: [
        "--no-sandbox", // tests may run as root
        "--disable-gpu",
        "--enable-unsafe-swiftshader", // WebGL without a graphics card
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
      ],
    });
    // Decodes pictures.
    made.eye = await made.browser.newPage();
    made.contexts = [];
    return made;
  }

  async closePages() {
    await Promise.all(this.contexts.splice(0).map((each) => each.close()));
  }

  close() {
    return this.browser.close();
  }

  // Opens a page from disk. What it says on the console, throws or asks the
  // network for is in `complaints`.
  async open(file, options = {}, hash = "", before = () => {}) {
    const context = await this.browser.newContext({
      viewport: { width: 1280, height: 800 },
      reducedMotion: "reduce",
      acceptDownloads: true,
      ...options,
    });
    this.contexts.push(context);
    // Without a graphics card, beside other tests, pictures take their time.
    context.setDefaultTimeout(180_000);
    const page = await context.newPage();
    const address = pathToFileURL(file).href;
    page.complaints = [];
    page.on("console", (message) => {
      // Drivers complain of pictures being read, which only tests do.
      const isOurs = !message.text().includes("GL Driver Message");
      if (["error", "warning"].includes(message.type()) && isOurs) {
        page.complaints.push(message.text());
      }
    });
    page.on("pageerror", (error) => page.complaints.push(String(error)));
    page.on("request", (request) => {
      const url = request.url();
      if (url.replace(/#.*/, "") !== address && !/^(data|blob):/.test(url)) {
        page.complaints.push(`request of ${url}`);
      }
    });
    page.on("dialog", (dialog) => {
      page.complaints.push(`dialog ${dialog.message()}`);
      void dialog.dismiss();
    });
    await page.addInitScript(before);
    await page.goto(address + hash);
    return page;
  }

  // The same, ready to be used.
  async openReady(file, options = {}, hash = "") {
    const page = await this.open(file, options, hash);
    await page.waitForSelector("html[data-ready]");
    await this.settle(page);
    await this.drawn(page);
    return page;
  }

  // The same in a browser that has no WebGL.
  async openFlat(file) {
    const page = await this.open(file, {}, "", () => {
      const getContext = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
        return kind.startsWith("webgl")
          ? null
          : getContext.call(this, kind, ...more);
      };
    });
    await page.waitForSelector("html[data-ready]");
    return page;
  }

  // Until all plots are.
  async drawn(page) {
    if ((await page.locator("#over-the-motion").count()) === 0) return;
    await page.waitForSelector("#over-the-motion[data-drawn]");
  }

  // Until the last picture is drawn, in its final resolution.
  async settle(page) {
    await page.waitForSelector("#view[data-still]");
    await page.evaluate(() => new Promise(requestAnimationFrame));
  }

  async keep(page, name, options = {}) {
    if (!screenshots) return;
    mkdirSync(screenshots, { recursive: true });
    await page.screenshot({
      path: join(screenshots, `${name}.png`),
      ...options,
    });
  }

  // The canvas as { width, height, data: RGBA }.
  async look(page) {
    await this.settle(page);
    return this.lookAt(page, "#view");
  }

  async lookAt(page, selector) {
    return this.decode(await page.locator(selector).screenshot());
  }

  // A PNG, likewise.
  async decode(png) {
    const { width, height, data } = await this.eye.evaluate(async (base64) => {
      const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes]));
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = canvas.getContext("2d");
      context.drawImage(bitmap, 0, 0);
      const image = context.getImageData(0, 0, bitmap.width, bitmap.height);
      let text = "";
      for (let i = 0; i < image.data.length; i += 8192) {
        text += String.fromCharCode(...image.data.subarray(i, i + 8192));
      }
      return { width: bitmap.width, height: bitmap.height, data: btoa(text) };
    }, png.toString("base64"));
    return { width, height, data: Buffer.from(data, "base64") };
  }

  // The PNG of a picture.
  async encode({ width, height, data }) {
    const png = await this.eye.evaluate(
      async ({ width, height, base64 }) => {
        const bytes = Uint8ClampedArray.from(atob(base64), (c) =>
          c.charCodeAt(0),
        );
        const canvas = new OffscreenCanvas(width, height);
        const context = canvas.getContext("2d", { alpha: false });
        context.putImageData(new ImageData(bytes, width, height), 0, 0);
        const blob = await canvas.convertToBlob();
        const written = new Uint8Array(await blob.arrayBuffer());
        return btoa(String.fromCharCode(...written));
      },
      { width, height, base64: data.toString("base64") },
    );
    return Buffer.from(png, "base64");
  }
}

// Pixels that are the colour [r, g, b] in more or less light: shading scales
// the three alike.
export function countOf(picture, color) {
  const largest = Math.max(...color);
  const { data } = picture;
  let count = 0;
  for (let i = 0; i < data.length; i += 4) {
    const brightest = Math.max(data[i], data[i + 1], data[i + 2]);
    if (brightest < 60) continue;
    const isAlike = [0, 1, 2].every(
      (k) => Math.abs(data[i + k] / brightest - color[k] / largest) < 0.06,
    );
    if (isAlike) ++count;
  }
  return count;
}

// The red of crossing triangles, where nothing shines through.
export const countRed = (picture) => countOf(picture, [255, 0, 0]);

export function differentPixels(a, b) {
  let count = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    if ([0, 1, 2].some((k) => Math.abs(a.data[i + k] - b.data[i + k]) > 8)) {
      ++count;
    }
  }
  return count;
}

// A part of a picture, as large as the part of a pane.
export function cut(picture, left, top, width, height) {
  const data = Buffer.alloc(4 * width * height);
  for (let y = 0; y < height; ++y) {
    const from = 4 * ((top + y) * picture.width + left);
    picture.data.copy(data, 4 * y * width, from, from + 4 * width);
  }
  return { width, height, data };
}
