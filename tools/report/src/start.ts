// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What all pages do alike.

import { element } from "./dom";
import { readable } from "./palette";
import { startTheme } from "./theme";

// In place of the 3D view, without which the rest can be read.
export function noView(error: unknown): HTMLElement {
  return element(
    "p",
    { class: "notice", role: "alert" },
    `No 3D view: ${error}`,
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

// Says in the label what was clicked at, where the pointer did not drag.
export function sayWhatIsClicked(
  canvas: HTMLCanvasElement,
  pick: (x: number, y: number) => { name: string; text: string } | null,
  label: HTMLElement,
): void {
  let from: [number, number] = [0, 0];
  canvas.addEventListener("pointerdown", (event) => {
    from = [event.clientX, event.clientY];
  });
  canvas.addEventListener("click", (event) => {
    if (Math.hypot(event.clientX - from[0], event.clientY - from[1]) > 4)
      return;
    const box = canvas.getBoundingClientRect();
    const picked = pick(event.clientX - box.left, event.clientY - box.top);
    label.textContent = picked
      ? readable(picked.name) + (picked.text ? `: ${picked.text}` : "")
      : "";
  });
}

// Reads the data of the page and builds it, or says why that does not work.
export function startPage<Data>(
  read: () => Promise<Data>,
  build: (data: Data) => void,
  program: string,
): void {
  startTheme();
  read()
    .then(build)
    .then(() => (document.documentElement.dataset.ready = ""))
    .catch((error) => {
      showError(error, program);
      console.error(error);
    });
}
