// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The section plane: where it is, the outlines that it cuts, and their areas.

import { Vector3 } from "three";

import { View } from "../data/page_parts";
import { Run } from "../data/run";
import {
  button,
  download,
  element,
  labelled,
  section,
  select,
  svg,
} from "../dom";
import { csvText, svgFileText } from "../figures/downloads";
import { readable } from "../palette";
import { SectionAxis, State, Store } from "../state";
import { Outline } from "../viewer/outline";
import { Viewer } from "../viewer/viewer";

type Axis = Exclude<SectionAxis, "off">;

const planes: [SectionAxis, string][] = [
  ["off", "none"],
  ["anterior", "coronal"],
  ["lateral", "sagittal"],
  ["superior", "transverse"],
];

const opposites: Record<Axis, string> = {
  anterior: "posterior",
  lateral: "medial",
  superior: "inferior",
};

const drawingMargin = 0.04; // of its size

// "12.0 mm superior of the middle".
function placeText(axis: Axis, place: number, range: [number, number]): string {
  const offset = place - (range[0] + range[1]) / 2;
  const size = Math.abs(offset).toFixed(1);
  if (Number(size) === 0) return "in the middle";
  return `${size} mm ${offset > 0 ? axis : opposites[axis]} of the middle`;
}

// Outlines as seen by who looks against the axis.
function drawing(outlines: Outline[], view: View): SVGSVGElement | null {
  const up = new Vector3(...view.up);
  const right = new Vector3().crossVectors(
    up,
    new Vector3(...view.toward_viewer),
  );
  let [left, top, far, low] = [Infinity, Infinity, -Infinity, -Infinity];
  const paths = outlines.map(({ name, color, segments }) => {
    let d = "";
    for (let i = 0; i < segments.length; i += 3) {
      const end = new Vector3().fromArray(segments, i);
      const [x, y] = [end.dot(right), -end.dot(up)];
      [left, top] = [Math.min(left, x), Math.min(top, y)];
      [far, low] = [Math.max(far, x), Math.max(low, y)];
      d += `${i % 6 === 0 ? "M" : "L"}${x.toFixed(2)} ${y.toFixed(2)}`;
    }
    return svg(
      "path",
      { d, stroke: color, fill: "none", "data-mesh": name },
      svg("title", {}, readable(name)),
    );
  });
  if (paths.length === 0) return null;
  const margin = drawingMargin * Math.max(far - left, low - top);
  const [width, height] = [far - left + 2 * margin, low - top + 2 * margin];
  for (const path of paths) {
    path.setAttribute("stroke-width", String(Math.max(width, height) / 160));
  }
  return svg(
    "svg",
    {
      viewBox: `${left - margin} ${top - margin} ${width} ${height}`,
      class: "outlines",
      role: "img",
      "aria-label": "Outlines of the section",
    },
    ...paths,
  );
}

function areaRows(outlines: Outline[], run: Run): HTMLElement[] {
  const muscles = new Set(run.muscles.map(({ name }) => name));
  return outlines
    .filter(({ name }) => muscles.has(name))
    .map(({ name, color, area }) => {
      const swatch = element("i", { class: "swatch" });
      swatch.style.background = color;
      return element(
        "tr",
        {},
        element("th", { scope: "row" }, swatch, " ", readable(name)),
        element("td", {}, `${area.toFixed(0)} mm²`),
      );
    });
}

// What one run has in the section.
function cutOf(run: Run, outlines: Outline[], view: View, isOne: boolean) {
  const drawn = drawing(outlines, view);
  const rows = areaRows(outlines, run);
  return [
    ...(isOne ? [] : [element("h3", {}, run.folder)]),
    ...(drawn ? [drawn] : [element("p", {}, "Nothing is cut here.")]),
    ...(rows.length > 0
      ? [element("table", { class: "areas" }, element("tbody", {}, ...rows))]
      : []),
  ];
}

export function sectionPanel(
  runs: Run[],
  views: Record<string, View>,
  store: Store,
  viewer: () => Viewer | null,
): HTMLElement {
  const axis = select<SectionAxis>("Section plane", planes, (chosen) =>
    viewer()?.startSection(chosen),
  );
  axis.id = "section-axis";
  const place = element("input", {
    type: "range",
    id: "section-place",
    step: 0.5,
    "aria-label": "Place of the section plane, mm",
    oninput: () => store.set({ sectionPlace: Number(place.value) }),
  });
  const told = element("output", { for: "section-place" });
  const cut = element("div", { class: "cut" });
  const flip = button("flip", "Keep the other side", () =>
    store.set({ sectionFlipped: !store.state.sectionFlipped }),
  );
  const name = () => `section_${store.state.section}`;
  const saveSvg = button("SVG", "Download the outlines as SVG, in mm", () => {
    const drawn = cut.querySelector<SVGSVGElement>(".outlines");
    if (!drawn) return;
    const content = new Blob([svgFileText(drawn, "Section")], {
      type: "image/svg+xml",
    });
    download(`${name()}.svg`, content);
  });
  const saveCsv = button("CSV", "Download the areas as CSV", () => {
    const rows = viewer()!
      .outlines()
      .flatMap((outlines, i) =>
        outlines.map((outline) => [runs[i].folder, outline.name, outline.area]),
      );
    const text = csvText([["run", "mesh", "area_mm2"], ...rows]);
    download(`${name()}.csv`, new Blob([text], { type: "text/csv" }));
  });
  const controls = element(
    "div",
    { class: "section-controls" },
    place,
    told,
    element("div", {}, flip, " ", saveSvg, " ", saveCsv),
    cut,
  );
  let pending = 0;
  const drawCut = () => {
    const view = viewer();
    const { section: chosen, playing } = store.state;
    if (!view || chosen === "off" || playing) return;
    const found = view.outlines();
    cut.replaceChildren(
      ...runs.flatMap((run, i) =>
        cutOf(run, found[i], views[chosen], runs.length === 1),
      ),
    );
  };
  const causes: (keyof State)[] = [
    "moment",
    "playing",
    "section",
    "sectionPlace",
    "hidden",
  ];
  store.subscribe((state, changed) => {
    axis.value = state.section;
    controls.hidden = state.section === "off";
    const view = viewer();
    if (state.section === "off" || !view) return;
    const [low, high] = view.sectionRange(state.section);
    place.min = String(Math.floor(low));
    place.max = String(Math.ceil(high));
    place.value = String(state.sectionPlace);
    told.textContent = placeText(state.section, state.sectionPlace, [
      low,
      high,
    ]);
    place.setAttribute("aria-valuetext", told.textContent);
    if (!causes.some((cause) => changed.has(cause))) return;
    cancelAnimationFrame(pending);
    pending = requestAnimationFrame(drawCut);
  });
  return section("Section", "section", labelled("Plane", axis), controls);
}
