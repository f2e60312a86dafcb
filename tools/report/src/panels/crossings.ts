// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Where meshes cross in the frame shown; a click flies there.

import { Box3, Vector3 } from "three";

import { CrossingPlace, crossingPlaces } from "../crossing_places";
import { Run } from "../data/run";
import { Moment } from "../data/timeline";
import { element, section } from "../dom";
import { readable } from "../palette";
import { Store } from "../state";
import { Viewer } from "../viewer/viewer";

const mostPlaces = 40;

function fly(place: CrossingPlace, viewer: Viewer): void {
  const normal = new Vector3(...place.normal);
  const size = 2 * Math.max(8, 1.2 * place.radius);
  viewer.camera.flyTo(
    new Box3().setFromCenterAndSize(
      new Vector3(...place.center),
      new Vector3(size, size, size),
    ),
    normal.length() > 0 ? normal.normalize() : undefined,
  );
}

function placeItem(place: CrossingPlace, go: () => void): HTMLElement {
  return element(
    "li",
    {},
    element(
      "button",
      { type: "button", class: "place", onclick: go },
      `${readable(place.a)} × ${readable(place.b)}: ${place.triangles} ${
        place.triangles === 1 ? "triangle" : "triangles"
      }`,
    ),
  );
}

function runCrossings(
  run: Run,
  pose: number | null,
  go: (place: CrossingPlace) => void,
): HTMLElement[] {
  if (pose === null) return [element("p", {}, "This run has no such frame.")];
  const pairs = run.crossings[pose];
  if (pairs.length === 0) return [element("p", {}, "Nothing crosses.")];
  const total = pairs.reduce((sum, pair) => sum + pair.triangle_pairs, 0);
  const inside = pairs.reduce((sum, pair) => sum + pair.vertices_inside, 0);
  const depth = Math.max(...pairs.map((pair) => pair.max_depth_mm));
  const places = crossingPlaces(run, pose);
  const more = places.length - mostPlaces;
  return [
    element(
      "p",
      {},
      `${total} crossing triangle pairs, ${inside} vertices inside, ` +
        `${depth.toFixed(2)} mm deep at most, in ${places.length} ` +
        (places.length === 1 ? "place." : "places."),
    ),
    element(
      "ol",
      { class: "places" },
      ...places
        .slice(0, mostPlaces)
        .map((place) => placeItem(place, () => go(place))),
    ),
    ...(more > 0 ? [element("p", {}, `and ${more} smaller ones`)] : []),
  ];
}

export function crossingsPanel(
  runs: Run[],
  timeline: Moment[],
  store: Store,
  viewer: () => Viewer | null,
): HTMLElement {
  const content = element("div", {});
  const names = runs.flatMap((run) =>
    [...run.muscles, ...run.bones].map(({ name }) => name),
  );
  const go = (place: CrossingPlace) => {
    // What is in front would hide it.
    const opacity = Object.fromEntries(names.map((name) => [name, 0.15]));
    store.set({
      playing: false,
      crossings: true,
      hidden: { ...store.state.hidden, [place.a]: false, [place.b]: false },
      opacity: { ...opacity, [place.a]: 1, [place.b]: 0.4 },
    });
    const view = viewer();
    if (view) fly(place, view);
  };
  store.subscribe((state, changed) => {
    if (!changed.has("moment") && !changed.has("playing")) return;
    if (state.playing) {
      content.replaceChildren(element("p", {}, "Pause to see where."));
      return;
    }
    const { poses } = timeline[state.moment];
    content.replaceChildren(
      ...runs.flatMap((run, i) => [
        ...(runs.length > 1 ? [element("h3", {}, run.folder)] : []),
        ...runCrossings(run, poses[i], go),
      ]),
    );
  });
  return section("Crossings", "crossings", content);
}
