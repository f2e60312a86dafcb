// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// All plots, the choice of their abscissa, and toggles of muscles.

import { Run } from "../data/run";
import { Moment } from "../data/timeline";
import { button, element, labelled, section, select } from "../dom";
import { readable } from "../palette";
import { Player } from "../player";
import { Store } from "../state";
import { csvOf, downloadFigure, svgText } from "./downloads";
import { DrawnPlot, colorOf, drawPlot } from "./plot";
import { Abscissa, Figure, Series, abscissasOf, figuresOf } from "./series";

class FigurePanel {
  readonly root: HTMLElement;
  private readonly place = element("div", { class: "plot" });
  private plot: DrawnPlot | null = null;

  constructor(
    private readonly figure: Figure,
    private readonly runs: Run[],
    private readonly abscissas: Abscissa[],
    private readonly colors: Map<string, string>,
    private readonly isShown: (series: Series) => boolean,
    private readonly onPick: (run: number, frame: number) => void,
  ) {
    const { id, title, note } = figure;
    this.root = element(
      "article",
      { class: "figure", id: `figure-${id}`, "aria-label": title },
      element(
        "header",
        {},
        element("h3", {}, title),
        button("SVG", `Download "${title}" as SVG`, () =>
          downloadFigure(id, "svg", svgText(this.plot!.svg, title)),
        ),
        button("CSV", `Download "${title}" as CSV`, () =>
          downloadFigure(
            id,
            "csv",
            csvOf(this.figure, this.runs, this.abscissas, this.isShown),
          ),
        ),
      ),
      this.place,
      ...(note ? [element("p", { class: "note" }, note)] : []),
    );
  }

  draw(abscissa: Abscissa): void {
    this.plot = drawPlot(
      this.figure,
      {
        runs: this.runs,
        abscissa,
        colors: this.colors,
        isShown: this.isShown,
        width: Math.max(260, this.place.clientWidth),
      },
      this.onPick,
    );
    this.place.replaceChildren(this.plot.svg);
  }

  mark(x: number): void {
    this.plot?.mark(x);
  }
}

function muscleToggles(
  runs: Run[],
  colors: Map<string, string>,
  off: Set<string>,
  onChange: () => void,
): HTMLElement {
  const names = new Set(runs.flatMap((run) => run.muscles.map((m) => m.name)));
  return element(
    "div",
    { class: "chips", role: "group", "aria-label": "Muscles in the plots" },
    ...[...names].map((name) => {
      const box = element("input", {
        type: "checkbox",
        checked: true,
        onchange: () => {
          if (box.checked) off.delete(name);
          else off.add(name);
          onChange();
        },
      });
      const swatch = element("i", { class: "swatch" });
      swatch.style.background = colors.get(name)!;
      return element("label", {}, box, swatch, readable(name));
    }),
  );
}

// What the curves that belong to no muscle, and dashes, mean.
function legend(figures: Figure[], runs: Run[]): HTMLElement {
  const scene = figures
    .flatMap(({ series }) => series)
    .filter(({ muscle, run }) => muscle === "" && run === 0);
  return element(
    "p",
    { class: "plot-legend" },
    ...scene.map((series) => {
      const swatch = element("i", { class: "swatch" });
      swatch.style.background = colorOf(series, new Map());
      return element("span", {}, swatch, series.name);
    }),
    ...(runs.length > 1
      ? [
          element("span", {}, `── ${runs[0].folder}`),
          element("span", {}, `╌╌ ${runs[1].folder}`),
        ]
      : []),
  );
}

export function figuresSection(
  runs: Run[],
  timeline: Moment[],
  colors: Map<string, string>,
  store: Store,
  player: Player,
): HTMLElement {
  const abscissas = abscissasOf(runs);
  let abscissa = abscissas.find(({ id }) => id.startsWith("coordinate"))!;
  abscissa ??= abscissas[abscissas.length - 1];
  const off = new Set<string>();
  const figures = figuresOf(runs);
  const panels = figures.map(
    (figure) =>
      new FigurePanel(
        figure,
        runs,
        abscissas,
        colors,
        ({ muscle }) => !off.has(muscle),
        (run, frame) =>
          player.goTo(
            timeline.findIndex(({ poses }) => poses[run] === frame + 1),
          ),
      ),
  );
  const mark = () => {
    const { poses } = timeline[store.state.moment];
    const run = poses.findIndex((pose) => pose !== null && pose > 0);
    const at = (poses[run] ?? 0) - 1;
    const x = run < 0 ? NaN : abscissa.value(runs[run].frames[at], at);
    for (const panel of panels) panel.mark(x);
  };
  const draw = () => {
    for (const panel of panels) panel.draw(abscissa);
    mark();
  };
  const choice = select(
    "Horizontal axis",
    abscissas.map(({ id, label }) => [id, label]),
    (id) => {
      abscissa = abscissas.find((each) => each.id === id)!;
      draw();
    },
  );
  choice.value = abscissa.id;
  const grid = element(
    "div",
    { class: "figures" },
    ...panels.map((panel) => panel.root),
  );
  let width = 0;
  new ResizeObserver(() => {
    if (grid.clientWidth === width) return;
    width = grid.clientWidth;
    draw();
  }).observe(grid);
  store.subscribe((_, changed) => {
    if (changed.has("moment")) mark();
  });
  return section(
    "Over the motion",
    "over-the-motion",
    element(
      "div",
      { class: "plot-controls" },
      labelled("Horizontal axis", choice),
      muscleToggles(runs, colors, off, draw),
      legend(figures, runs),
    ),
    grid,
  );
}
