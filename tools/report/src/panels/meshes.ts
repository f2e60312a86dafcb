// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Show, hide and fade each mesh.

import { Run } from "../data/run";
import { button, element, section } from "../dom";
import { readable } from "../palette";
import { Store } from "../state";

function meshRow(
  name: string,
  color: string,
  note: string,
  store: Store,
): HTMLElement {
  const box = element("input", {
    type: "checkbox",
    onchange: () =>
      store.set({
        hidden: { ...store.state.hidden, [name]: !box.checked },
      }),
  });
  const fade = element("input", {
    type: "range",
    class: "fade",
    min: 0.1,
    max: 1,
    step: 0.05,
    "aria-label": `Opacity of ${readable(name)}`,
    title: "Opacity",
    oninput: () =>
      store.set({
        opacity: { ...store.state.opacity, [name]: Number(fade.value) },
      }),
  });
  store.subscribe((state) => {
    box.checked = !state.hidden[name];
    fade.value = String(state.opacity[name] ?? 1);
  });
  const swatch = element("i", { class: "swatch" });
  swatch.style.background = color;
  return element(
    "li",
    { "data-mesh": name, title: note },
    element("label", {}, box, swatch, element("span", {}, readable(name))),
    fade,
  );
}

function group(
  title: string,
  names: string[],
  row: (name: string) => HTMLElement,
  store: Store,
): HTMLElement {
  const setAll = (isHidden: boolean) =>
    store.set({
      hidden: {
        ...store.state.hidden,
        ...Object.fromEntries(names.map((name) => [name, isHidden])),
      },
    });
  return element(
    "div",
    { class: "group" },
    element(
      "h3",
      {},
      title,
      " ",
      button("all", `Show all ${title.toLowerCase()}`, () => setAll(false)),
      button("none", `Hide all ${title.toLowerCase()}`, () => setAll(true)),
    ),
    element("ul", { class: "meshes" }, ...names.map(row)),
  );
}

export function meshesPanel(
  runs: Run[],
  colors: Map<string, string>,
  store: Store,
): HTMLElement {
  const muscles = new Set(
    runs.flatMap((run) => run.muscles.map((m) => m.name)),
  );
  const bones = new Map(
    runs.flatMap((run) =>
      run.bones.map((bone) => {
        const shown = bone.triangles.length / 3;
        return [
          bone.name,
          shown < bone.trianglesInFiles
            ? `simplified for view: ${shown} of ${bone.trianglesInFiles} triangles, within ${bone.viewError.toFixed(2)} mm`
            : `${shown} triangles`,
        ] as [string, string];
      }),
    ),
  );
  const isSimplified = runs.some((run) =>
    run.bones.some((bone) => bone.triangles.length / 3 < bone.trianglesInFiles),
  );
  const worst = Math.max(
    0,
    ...runs.flatMap((run) => run.bones.map((bone) => bone.viewError)),
  );
  const row = (note: (name: string) => string) => (name: string) =>
    meshRow(name, colors.get(name)!, note(name), store);
  return section(
    "Meshes",
    "meshes",
    group(
      "Muscles",
      [...muscles],
      row(() => ""),
      store,
    ),
    group(
      "Bones",
      [...bones.keys()],
      row((name) => bones.get(name)!),
      store,
    ),
    button("all opaque", "Take back all fading", () =>
      store.set({ opacity: {} }),
    ),
    element(
      "p",
      { class: "note" },
      (isSimplified
        ? `Bones are simplified for view, within ${worst.toFixed(2)} mm; counts and gaps are of the full meshes. `
        : "") +
        `Positions are rounded to ${runs[0].step.toPrecision(1)} mm for view.`,
    ),
  );
}
