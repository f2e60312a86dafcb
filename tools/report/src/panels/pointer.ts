// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What clicks in the view do: say what is there, or set the ends of the ruler.
// Both go along with the meshes and follow the colouring.

import { button, element } from "../dom";
import { readable } from "../palette";
import { listenToClicks } from "../start";
import { Store } from "../state";
import { ShownRuler } from "../viewer/overlay";
import { SurfacePlace, positionOf } from "../viewer/surface_place";
import { Viewer } from "../viewer/viewer";

function saidOf(place: SurfacePlace | null, viewer: Viewer): string {
  if (!place) return "";
  const text = viewer.say(place);
  return readable(place.mesh.name) + (text ? `: ${text}` : "");
}

function lengthOf([a, b]: SurfacePlace[]): string {
  if (!b) return "";
  return `${positionOf(a).distanceTo(positionOf(b)).toFixed(1)} mm`;
}

// Writes to the label. Returns the ruler as it is to be drawn.
export function listenToPointer(
  canvas: HTMLCanvasElement,
  viewer: Viewer,
  store: Store,
  label: HTMLElement,
): () => ShownRuler | null {
  let picked: SurfacePlace | null = null;
  let ends: SurfacePlace[] = [];
  const say = () => {
    label.textContent =
      store.state.measuring && ends.length < 2
        ? `Ruler: click at ${ends.length === 0 ? "two places" : "another place"}`
        : (ends.length === 2 ? `${lengthOf(ends)} · ` : "") +
          saidOf(picked, viewer);
  };
  listenToClicks(canvas, (x, y) => {
    picked = viewer.pick(x, y);
    if (store.state.measuring && picked) {
      const goesOn = ends.length === 1 && ends[0].run === picked.run;
      ends = goesOn ? [...ends, picked] : [picked];
      viewer.request();
    }
    say();
  });
  store.subscribe(({ measuring }) => {
    canvas.classList.toggle("measuring", measuring);
    if (!measuring) ends = [];
  });
  viewer.onDrawn(say);
  return () =>
    ends.length === 0
      ? null
      : {
          ends: ends.map((end) => viewer.project(positionOf(end), end.run)),
          text: lengthOf(ends),
        };
}

export function rulerButton(store: Store): HTMLButtonElement {
  const made = button("ruler", "Distance between two clicks (M)", () =>
    store.set({ measuring: !store.state.measuring }),
  );
  store.subscribe(({ measuring }) =>
    made.setAttribute("aria-pressed", String(measuring)),
  );
  return made;
}

// What was clicked at; assistive programs read it aloud.
export function pickedLabel(): HTMLOutputElement {
  return element("output", { class: "picked", "aria-live": "polite" });
}
