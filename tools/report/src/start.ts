// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What all pages do alike.

import { element } from "./dom";
import { sayProgress } from "./progress";
import { startTheme } from "./theme";

// What to do where there is no 3D view.
export function noView(error: unknown): HTMLElement {
  return element(
    "p",
    { class: "notice", role: "alert" },
    `No 3D view (${error}): this browser gives the page no WebGL. ` +
      "Switch on hardware acceleration in its settings and start it again, or " +
      "open this file in a current Chromium, Firefox or Safari. " +
      "Without it, all but turning, sections and pictures works.",
  );
}

function showError(error: unknown, program: string): void {
  const text = error instanceof Error ? error.message : String(error);
  document
    .getElementById("page")!
    .replaceChildren(
      element(
        "p",
        { class: "notice", role: "alert" },
        `This page cannot be shown: ${text} ` +
          `Write it again with ${program}, and open it in a current browser with WebGL.`,
      ),
    );
}

// Calls the listener with the place in the canvas (CSS pixels) of each click
// that ends where it began.
export function listenToClicks(
  canvas: HTMLCanvasElement,
  listener: (x: number, y: number) => void,
): void {
  let from: [number, number] = [0, 0];
  canvas.addEventListener("pointerdown", (event) => {
    from = [event.clientX, event.clientY];
  });
  canvas.addEventListener("click", (event) => {
    if (Math.hypot(event.clientX - from[0], event.clientY - from[1]) > 4)
      return;
    const box = canvas.getBoundingClientRect();
    listener(event.clientX - box.left, event.clientY - box.top);
  });
}

// Reads the data of the page and builds it, or says why that does not work.
export function startPage<Data>(
  read: () => Promise<Data>,
  build: (data: Data) => void,
  program: string,
): void {
  startTheme();
  sayProgress("unpacking figures")
    .then(read)
    .then(async (data) => {
      await sayProgress("making the view");
      build(data);
    })
    .then(() => (document.documentElement.dataset.ready = ""))
    .catch((error) => {
      showError(error, program);
      console.error(error);
    });
}
