// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Show, hide and fade each mesh.

import { BoneShape } from "../data/page_parts";
import { Run } from "../data/run";
import { button, element, section } from "../dom";
import { readable } from "../palette";
import { MeshLookStore, Store } from "../state";

function meshRow(
  name: string,
  color: string,
  note: string,
  store: MeshLookStore,
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

// Of several meshes, and what to say of each.
export function meshGroup(
  title: string,
  notes: Map<string, string>,
  colorOf: (name: string) => string,
  store: MeshLookStore,
): HTMLElement {
  const names = [...notes.keys()];
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
    element(
      "ul",
      { class: "meshes" },
      ...[...notes].map(([name, note]) =>
        meshRow(name, colorOf(name), note, store),
      ),
    ),
  );
}

export function opaqueButton(store: MeshLookStore): HTMLElement {
  return button("all opaque", "Take back all fading", () =>
    store.set({ opacity: {} }),
  );
}

// By name.
export function boneNotes(bones: BoneShape[]): Map<string, string> {
  return new Map(
    bones.map((bone) => {
      const shown = bone.triangles.length / 3;
      return [
        bone.name,
        shown < bone.trianglesInFiles
          ? `simplified for view: ${shown} of ${bone.trianglesInFiles} triangles, within ${bone.viewError.toFixed(2)} mm`
          : `${shown} triangles`,
      ];
    }),
  );
}

// How far the bones are from what they were, or nothing if they are not.
export function simplificationOf(bones: BoneShape[]): string {
  const isSimplified = bones.some(
    (bone) => bone.triangles.length / 3 < bone.trianglesInFiles,
  );
  const worst = Math.max(0, ...bones.map((bone) => bone.viewError));
  return isSimplified
    ? `Bones are simplified for view, within ${worst.toFixed(2)} mm`
    : "";
}

export function meshesPanel(
  runs: Run[],
  colors: Map<string, string>,
  store: Store,
): HTMLElement {
  const muscles = runs.flatMap((run) => run.muscles);
  const bones = runs.flatMap((run) => run.bones);
  const colorOf = (name: string) => colors.get(name)!;
  const simplification = simplificationOf(bones);
  return section(
    "Meshes",
    "meshes",
    meshGroup(
      "Muscles",
      new Map(muscles.map(({ name }) => [name, ""])),
      colorOf,
      store,
    ),
    meshGroup("Bones", boneNotes(bones), colorOf, store),
    opaqueButton(store),
    element(
      "p",
      { class: "note" },
      (simplification
        ? `${simplification}; counts and gaps are of the full meshes. `
        : "") +
        `Positions are rounded to ${runs[0].step.toPrecision(1)} mm for view.`,
    ),
  );
}
