// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// All plots, the choice of their abscissa, and toggles of muscles.

import { MeasuredArm, PageData, Run, isOfDesign } from "../data/run";
import { Moment } from "../data/timeline";
import { button, element, labelled, section, select } from "../dom";
import { MeshColors } from "../mesh_colors";
import { readable } from "../palette";
import { Player } from "../player";
import { Store } from "../state";
import { csvOf, downloadFigure, svgFileText } from "./downloads";
import { measuredIn } from "./measured";
import { DrawnPlot, colorOf, drawPlot } from "./plot";
import { ProfilePanel } from "./profile_panel";
import {
  Abscissa,
  Figure,
  FigureGroup,
  Series,
  abscissasOf,
  figureGroups,
  figuresOf,
} from "./series";

// What is drawn for itself in a group.
interface Panel {
  root: HTMLElement;
  draw(abscissa: Abscissa): void;
  mark(x: number): void;
}

function isOpen({ root }: Panel): boolean {
  return root.closest("details")?.open ?? true;
}

class FigurePanel implements Panel {
  readonly root: HTMLElement;
  private readonly place = element("div", { class: "plot" });
  private plot: DrawnPlot | null = null;

  constructor(
    private readonly figure: Figure,
    private readonly runs: Run[],
    private readonly abscissas: Abscissa[],
    private readonly colors: MeshColors,
    private readonly measured: MeasuredArm[],
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
        element("h4", {}, title),
        button("SVG", `Download "${title}" as SVG`, () => {
          // It is drawn a moment after its part of the page is opened.
          if (!this.plot) return;
          downloadFigure(id, "svg", svgFileText(this.plot.svg, title));
        }),
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
        measured: measuredIn(
          this.figure,
          abscissa,
          this.measured,
          this.isShown,
        ),
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

const fewMuscles = 8;

// All muscles, one, or some.
function muscleChoice(
  runs: Run[],
  colors: MeshColors,
  off: Set<string>,
  onChange: () => void,
): HTMLElement[] {
  const names = [
    ...new Set(runs.flatMap((run) => run.muscles.map(({ name }) => name))),
  ];
  const boxes = new Map<string, HTMLInputElement>();
  const show = () => {
    for (const [name, box] of boxes) box.checked = !off.has(name);
    onChange();
  };
  const chips = names.map((name) => {
    const box = element("input", {
      type: "checkbox",
      checked: true,
      onchange: () => {
        if (box.checked) off.delete(name);
        else off.add(name);
        one.value = off.size === 0 ? "" : "some";
        onChange();
      },
    });
    boxes.set(name, box);
    const swatch = element("i", { class: "swatch" });
    swatch.style.background = colors.get(name)!;
    return element("label", {}, box, swatch, readable(name));
  });
  const one = select(
    "Muscles in the plots",
    [
      ["", "all"],
      ["some", "as chosen"],
      ...names.map((name) => [name, readable(name)] as [string, string]),
    ],
    (chosen) => {
      if (chosen === "some") return;
      off.clear();
      for (const name of names) {
        if (chosen !== "" && name !== chosen) off.add(name);
      }
      show();
    },
  );
  one.id = "plotted-muscle";
  return [
    labelled("Muscles", one),
    element(
      "details",
      { open: names.length <= fewMuscles },
      element("summary", {}, "choose"),
      element(
        "div",
        { class: "chips", role: "group", "aria-label": "Muscles in the plots" },
        ...chips,
      ),
    ),
  ];
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

// Figures of the solver are for those who look for them.
function figureGroup(
  group: FigureGroup,
  panels: Panel[],
  onOpen: () => void,
): HTMLElement {
  const grid = element(
    "div",
    { class: "figures" },
    ...panels.map((panel) => panel.root),
  );
  const title = element("h3", {}, group);
  const isFolded = group === "Solver";
  const made = element(
    "details",
    { class: "figure-group", open: !isFolded, hidden: panels.length === 0 },
    element("summary", {}, title),
    grid,
  );
  made.addEventListener("toggle", onOpen);
  return made;
}

export function figuresSection(
  { runs, measured }: PageData,
  timeline: Moment[],
  colors: MeshColors,
  store: Store,
  player: Player,
): HTMLElement {
  const abscissas = abscissasOf(runs);
  let abscissa = abscissas.find(({ id }) => id.startsWith("coordinate"))!;
  abscissa ??= abscissas[abscissas.length - 1];
  const off = new Set<string>();
  const figures = figuresOf(runs);
  const figurePanels = figures.map(
    (figure) =>
      new FigurePanel(
        figure,
        runs,
        abscissas,
        colors,
        measured?.arms ?? [],
        ({ muscle }) => !off.has(muscle),
        (run, frame) =>
          player.goTo(
            timeline.findIndex(({ poses }) => poses[run] === frame + 1),
          ),
      ),
  );
  const profiles = new ProfilePanel(
    runs,
    timeline,
    colors,
    store,
    (muscle) => !off.has(muscle),
  );
  const panels: Panel[] = [...figurePanels, profiles];
  const groups: FigureGroup[] = [
    ...figures.map(({ group }) => group),
    "Stretch and volume",
  ];
  const mark = () => {
    const { poses } = timeline[store.state.moment];
    const run = poses.findIndex((pose) => pose !== null && pose > 0);
    const at = (poses[run] ?? 0) - 1;
    const x = run < 0 ? NaN : abscissa.value(runs[run].frames[at], at);
    for (const panel of panels) panel.mark(x);
  };
  // One after the other, so that the page answers meanwhile.
  let turn = 0;
  const draw = () => {
    const mine = ++turn;
    delete made.dataset.drawn;
    const waiting = panels.filter(isOpen);
    const next = () => {
      if (mine !== turn) return;
      const panel = waiting.shift();
      if (!panel) {
        made.dataset.drawn = "";
        return mark();
      }
      panel.draw(abscissa);
      setTimeout(next);
    };
    next();
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
  const madeGroups = figureGroups.map((group) =>
    figureGroup(
      group,
      panels.filter((_, i) => groups[i] === group),
      draw,
    ),
  );
  const made = section(
    runs.every(isOfDesign) ? "Over the postures" : "Over the motion",
    "over-the-motion",
    element(
      "div",
      { class: "plot-controls" },
      labelled("Horizontal axis", choice),
      ...muscleChoice(runs, colors, off, draw),
      legend(figures, runs),
    ),
    ...(measured ? [element("p", { class: "note" }, `${measured.note}.`)] : []),
    ...madeGroups,
  );
  let width = 0;
  new ResizeObserver(() => {
    if (made.clientWidth === width) return;
    width = made.clientWidth;
    draw();
  }).observe(made);
  store.subscribe((_, changed) => {
    if (changed.has("moment")) mark();
  });
  return made;
}
