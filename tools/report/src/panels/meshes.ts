// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Show, hide and fade each mesh.

import { BoneShape } from "../data/page_parts";
import { Run } from "../data/run";
import { button, element, section } from "../dom";
import { MeshColors } from "../mesh_colors";
import { readable } from "../palette";
import { MeshLookStore, Store } from "../state";

function meshRow(
  name: string,
  color: string,
  note: string,
  store: MeshLookStore,
  more: Node[] = [],
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
    ...more,
    fade,
  );
}

function setHidden(names: string[], isHidden: boolean, store: MeshLookStore) {
  const all = Object.fromEntries(names.map((name) => [name, isHidden]));
  store.set({ hidden: { ...store.state.hidden, ...all } });
}

function onOff(title: string, names: string[], store: MeshLookStore): Node[] {
  return [
    button("all", `Show all ${title.toLowerCase()}`, () =>
      setHidden(names, false, store),
    ),
    button("none", `Hide all ${title.toLowerCase()}`, () =>
      setHidden(names, true, store),
    ),
  ];
}

// One row for all bones, which unfolds to a row for each.
function boneRow(
  notes: Map<string, string>,
  colorOf: (name: string) => string,
  store: MeshLookStore,
): HTMLElement {
  const names = [...notes.keys()];
  const box = element("input", {
    type: "checkbox",
    "aria-label": "All bones",
    onchange: () => setHidden(names, !box.checked, store),
  });
  const fade = element("input", {
    type: "range",
    class: "fade",
    min: 0.1,
    max: 1,
    step: 0.05,
    "aria-label": "Opacity of all bones",
    title: "Opacity",
    oninput: () => {
      const all = names.map((name) => [name, Number(fade.value)] as const);
      store.set({
        opacity: { ...store.state.opacity, ...Object.fromEntries(all) },
      });
    },
  });
  store.subscribe((state) => {
    const shown = names.filter((name) => !state.hidden[name]).length;
    box.checked = shown > 0;
    box.indeterminate = shown > 0 && shown < names.length;
    const opacities = names.map((name) => state.opacity[name] ?? 1);
    fade.value = String(Math.max(...opacities));
  });
  return element(
    "div",
    { class: "group bones" },
    element(
      "details",
      {},
      element("summary", {}, `Bones (${names.length})`),
      element(
        "ul",
        { class: "meshes" },
        ...[...notes].map(([name, note]) =>
          meshRow(name, colorOf(name), note, store),
        ),
      ),
    ),
    element("div", { class: "of-all" }, box, fade),
  );
}

const fewMuscles = 6;

// With a search where there are many, and for each a button that hides the
// others and shows it large.
function muscleGroup(
  names: string[],
  colorOf: (name: string) => string,
  store: MeshLookStore,
  showLarge: () => void,
): HTMLElement {
  const only = (name: string) => {
    const others = names.map((other) => [other, other !== name] as const);
    store.set({
      hidden: { ...store.state.hidden, ...Object.fromEntries(others) },
    });
    showLarge();
  };
  const rows = names.map((name) =>
    meshRow(name, colorOf(name), "", store, [
      button("only", `Show only ${readable(name)} of the muscles`, () =>
        only(name),
      ),
    ]),
  );
  const nothing = element(
    "p",
    { class: "note", hidden: true },
    "No such muscle",
  );
  const search = element("input", {
    type: "search",
    placeholder: "Find a muscle",
    "aria-label": "Find a muscle",
    oninput: () => {
      const words = readable(search.value).toLowerCase().split(/\s+/);
      names.forEach((name, i) => {
        const text = readable(name).toLowerCase();
        rows[i].hidden = !words.every((word) => text.includes(word));
      });
      nothing.hidden = rows.some((row) => !row.hidden);
    },
  });
  return element(
    "div",
    { class: "group" },
    element("h3", {}, "Muscles", " ", ...onOff("muscles", names, store)),
    ...(names.length > fewMuscles ? [search] : []),
    element("ul", { class: "meshes" }, ...rows),
    nothing,
  );
}

// Of several meshes, and what to say of each.
export function meshGroup(
  title: string,
  notes: Map<string, string>,
  colorOf: (name: string) => string,
  store: MeshLookStore,
): HTMLElement {
  return element(
    "div",
    { class: "group" },
    element("h3", {}, title, " ", ...onOff(title, [...notes.keys()], store)),
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
  colors: MeshColors,
  store: Store,
  showLarge: () => void,
): HTMLElement {
  const muscles = runs.flatMap((run) => run.muscles);
  const bones = runs.flatMap((run) => run.bones);
  const colorOf = (name: string) => colors.get(name)!;
  const simplification = simplificationOf(bones);
  const largestError = Math.max(...runs.map((run) => run.positionError));
  return section(
    "Meshes",
    "meshes",
    muscleGroup(
      [...new Set(muscles.map(({ name }) => name))],
      colorOf,
      store,
      showLarge,
    ),
    boneRow(boneNotes(bones), colorOf, store),
    opaqueButton(store),
    element(
      "p",
      { class: "note" },
      (simplification
        ? `${simplification}; counts and gaps are of the full meshes. `
        : "") + `Muscles are shown within ${largestError.toPrecision(2)} mm.`,
    ),
  );
}
