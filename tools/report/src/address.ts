// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The address of the page keeps what is seen, so that it can be sent on:
// #frame=3&colour=gap&camera=...; what it says wrongly is passed over.

import { Vector3 } from "three";

import { colorings } from "./panels/look";
import { SectionAxis, State, Store } from "./state";
import { Viewer } from "./viewer/viewer";

const sections: SectionAxis[] = ["anterior", "lateral", "superior"];
const pauseMs = 300; // browsers refuse many changes a second

function cameraText(viewer: Viewer): string {
  const { position, target } = viewer.camera.place;
  return [...position.toArray(), ...target.toArray()]
    .map((value) => value.toFixed(2))
    .join(",");
}

function addressOf(state: State, viewer: Viewer): string {
  const words = new URLSearchParams({ frame: String(state.moment) });
  words.set("colour", state.coloring);
  const hidden = Object.keys(state.hidden).filter((name) => state.hidden[name]);
  if (hidden.length > 0) words.set("hidden", hidden.join(","));
  if (state.lines) words.set("lines", "1");
  if (state.section !== "off") {
    words.set("section", state.section);
    words.set("place", state.sectionPlace.toFixed(1));
  }
  words.set("camera", cameraText(viewer));
  return `#${words}`;
}

// What the address asks of the state. Precondition: `moments` is not 0.
export function stateFromAddress(
  hash: string,
  moments: number,
  meshes: string[],
): Partial<State> {
  const words = new URLSearchParams(hash.replace(/^#/, ""));
  if (!words.has("frame")) return {};
  const asked: Partial<State> = { lines: words.get("lines") === "1" };
  const moment = Number(words.get("frame"));
  if (Number.isInteger(moment) && moment >= 0 && moment < moments) {
    asked.moment = moment;
  }
  const coloring = colorings.find(([name]) => name === words.get("colour"));
  if (coloring) asked.coloring = coloring[0];
  const hidden = (words.get("hidden") ?? "").split(",");
  asked.hidden = Object.fromEntries(
    meshes.filter((name) => hidden.includes(name)).map((name) => [name, true]),
  );
  const section = sections.find((name) => name === words.get("section"));
  const place = Number(words.get("place"));
  if (section && Number.isFinite(place)) {
    asked.section = section;
    asked.sectionPlace = place;
  }
  return asked;
}

export function moveCameraToAddress(hash: string, viewer: Viewer): void {
  const words = new URLSearchParams(hash.replace(/^#/, ""));
  const numbers = (words.get("camera") ?? "").split(",").map(Number);
  if (numbers.length !== 6 || !numbers.every(Number.isFinite)) return;
  const position = new Vector3().fromArray(numbers);
  const target = new Vector3().fromArray(numbers, 3);
  if (position.distanceTo(target) > 0) {
    viewer.camera.moveTo({ position, target });
  }
}

// From now on.
export function keepAddress(store: Store, viewer: Viewer): void {
  let timer = 0;
  const write = () =>
    history.replaceState(null, "", addressOf(store.state, viewer));
  viewer.onDrawn(() => {
    clearTimeout(timer);
    timer = window.setTimeout(write, pauseMs);
  });
}
