// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What the muscles are coloured by, what else is shown, the section plane.

import { Run } from "../data/run";
import { button, element, labelled, section, select } from "../dom";
import { Coloring, SectionAxis, State, Store } from "../state";
import { vertexScale } from "../viewer/coloring";

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

function legend(runs: Run[], store: Store): HTMLElement {
  const made = element("figure", { class: "legend", "aria-live": "polite" });
  store.subscribe((state, changed) => {
    if (!changed.has("coloring")) return;
    const scale = vertexScale(state.coloring, runs);
    made.hidden = scale === null;
    if (!scale) return;
    const steps = Array.from({ length: 60 }, (_, i) => i / 59);
    const bar = element("div", { class: "bar" });
    bar.style.background = `linear-gradient(to right, ${steps.map(
      (place, i) => `${scale.color(place)} ${i / 0.6}% ${(i + 1) / 0.6}%`,
    )})`;
    const ticks = scale.ticks.map(([place, text]) => {
      const tick = element("span", {}, text);
      tick.style.left = `${100 * place}%`;
      return tick;
    });
    made.replaceChildren(
      element(
        "figcaption",
        {},
        scale.title + (scale.unit ? `, ${scale.unit}` : ""),
      ),
      bar,
      element("div", { class: "ticks" }, ...ticks),
    );
  });
  return made;
}

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

export function sectionPanel(store: Store): HTMLElement {
  const axis = select<SectionAxis>(
    "Section plane",
    [
      ["off", "none"],
      ["anterior", "coronal"],
      ["lateral", "sagittal"],
      ["superior", "transverse"],
    ],
    (chosen) => store.set({ section: chosen }),
  );
  axis.id = "section-axis";
  const place = element("input", {
    type: "range",
    id: "section-place",
    min: 0,
    max: 1,
    step: 0.002,
    "aria-label": "Place of the section plane",
    oninput: () => store.set({ sectionPlace: Number(place.value) }),
  });
  const flip = button("flip", "Keep the other side", () =>
    store.set({ sectionFlipped: !store.state.sectionFlipped }),
  );
  store.subscribe((state) => {
    axis.value = state.section;
    place.value = String(state.sectionPlace);
    place.disabled = flip.disabled = state.section === "off";
  });
  return section(
    "Section",
    "section",
    labelled("Plane", axis),
    labelled("Place", place),
    flip,
  );
}
