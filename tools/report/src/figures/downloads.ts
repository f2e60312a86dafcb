// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// A figure as a file of its own.

import { Run } from "../data/run";
import { download } from "../dom";
import { Abscissa, Figure, Series } from "./series";

// Quoted where commas, quotes or line ends would be taken for others; what a
// spreadsheet would take for a formula is given as text.
function csvField(value: string | number): string {
  if (typeof value === "number")
    return Number.isFinite(value) ? String(value) : "";
  const text = /^[=+\-@\t]/.test(value) ? `'${value}` : value;
  return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

// The curves of a figure that runs have in common, named apart.
function columnsOf(
  series: Series[],
): (Pick<Series, "muscle" | "name"> & { label: string })[] {
  const first = series.filter(
    ({ muscle, name }, i) =>
      i ===
      series.findIndex((each) => each.muscle === muscle && each.name === name),
  );
  return first.map(({ muscle, name }) => {
    const isOnlyOne = first.filter((each) => each.name === name).length === 1;
    return { muscle, name, label: isOnlyOne ? name : `${muscle} ${name}` };
  });
}

export function csvText(rows: (string | number)[][]): string {
  return rows.map((row) => row.map(csvField).join(",")).join("\n") + "\n";
}

// A row a frame; columns are the abscissas, then the curves that are shown.
export function csvOf(
  figure: Figure,
  runs: Run[],
  abscissas: Abscissa[],
  isShown: (series: Series) => boolean,
): string {
  const series = figure.series.filter(isShown);
  const columns = columnsOf(series);
  const header = [
    "run",
    "name",
    ...abscissas.map(({ label }) => label),
    ...columns.map(({ label }) => label),
  ];
  const rows = runs.flatMap((run, i) =>
    run.frames.map((frame, at) => [
      run.folder,
      frame.name,
      ...abscissas.map(({ value }) => value(frame, at)),
      ...columns.map(({ muscle, name }) => {
        const curve = series.find(
          (each) =>
            each.run === i && each.muscle === muscle && each.name === name,
        );
        return curve?.values[at] ?? NaN;
      }),
    ]),
  );
  return csvText([header, ...rows]);
}

// The colours of the page do not go with the file.
export function svgFileText(svg: SVGSVGElement, title: string): string {
  const copy = svg.cloneNode(true) as SVGSVGElement;
  copy.querySelector(".cursor")?.remove();
  copy.querySelectorAll("[aria-label=tip]").forEach((tip) => tip.remove());
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("font-family", "sans-serif");
  copy.style.color = "#222";
  copy.style.background = "#fff";
  const name = document.createElementNS(copy.namespaceURI, "title");
  name.textContent = title;
  copy.prepend(name);
  // Few other programs know the page's variables.
  return new XMLSerializer()
    .serializeToString(copy)
    .replaceAll("var(--text)", "#222");
}

export function downloadFigure(
  name: string,
  type: "svg" | "csv",
  text: string,
) {
  const mime = type === "svg" ? "image/svg+xml" : "text/csv";
  const content = new Blob([text], { type: `${mime};charset=utf-8` });
  download(`${name}.${type}`, content);
}
