// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What the muscles are coloured by, and what else is shown.

import { Run } from "../data/run";
import { element, labelled, section, select } from "../dom";
import { Coloring, State, Store } from "../state";
import { legend } from "./legend";

export const colorings: [Coloring, string][] = [
  ["name", "name"],
  ["displacement", "displacement"],
  ["stretch", "area stretch"],
  ["gap", "gap"],
  ["contact", "contact"],
  ["attachment", "attachment"],
];

export const viewNames = [
  "anterior",
  "posterior",
  "lateral",
  "medial",
  "superior",
];

function toggle(
  label: string,
  key: "lines" | "fibres" | "crossings",
  store: Store,
): HTMLElement {
  const box = element("input", {
    type: "checkbox",
    id: `show-${key}`,
    onchange: () => store.set({ [key]: box.checked } as Partial<State>),
  });
  store.subscribe((state) => (box.checked = state[key]));
  return element("label", {}, box, element("span", {}, label));
}

export function lookPanel(runs: Run[], store: Store): HTMLElement {
  const by = select("Colour muscles by", colorings, (coloring) =>
    store.set({ coloring }),
  );
  by.id = "coloring";
  store.subscribe((state) => (by.value = state.coloring));
  const hasFibres = runs.some((run) =>
    run.muscles.some((muscle) => muscle.fibres.counts.length > 0),
  );
  return section(
    "Look",
    "look",
    labelled("Colour muscles by", by),
    legend(runs, store),
    element(
      "div",
      { class: "toggles" },
      toggle("action lines", "lines", store),
      ...(hasFibres ? [toggle("fibres", "fibres", store)] : []),
      toggle("crossing triangles, red", "crossings", store),
    ),
  );
}
