// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The page musclewarp-report writes: reads what it holds and puts the parts
// together.

import { Run, PageData, readPageData } from "./data/run";
import { timelineOf } from "./data/timeline";
import { button, element, icon } from "./dom";
import { figuresSection } from "./figures/figures";
import { listenToKeys } from "./keyboard";
import { colorsByName } from "./palette";
import { crossingsPanel } from "./panels/crossings";
import { lookPanel, sectionPanel, viewNames } from "./panels/look";
import { meshesPanel } from "./panels/meshes";
import { endOf, summarySection } from "./panels/summary";
import { transport } from "./panels/transport";
import { viewButtons } from "./panels/views";
import { Player } from "./player";
import { runKeys } from "./run_keys";
import { noView, sayWhatIsClicked, startPage } from "./start";
import { Store, initialState } from "./state";
import { toggleTheme } from "./theme";
import { Viewer } from "./viewer/viewer";

function runTitle(run: Run): string {
  return `${run.folder}: contact ${run.report.contact}, ${run.report.solver}`;
}

function header(runs: Run[], controls: HTMLElement[]): HTMLElement {
  const scenes = [...new Set(runs.map((run) => run.report.scene))];
  return element(
    "header",
    { class: "page" },
    element("h1", {}, scenes.join(", ")),
    element("p", {}, runs.map(runTitle).join("  |  ")),
    element("div", { class: "controls" }, ...controls),
  );
}

// What the visitor must know before looking.
function notices(runs: Run[]): HTMLElement[] {
  const prefix = (run: Run) => (runs.length > 1 ? `${run.folder}: ` : "");
  return runs.flatMap((run) => {
    const texts: string[] = [];
    if (!run.report.summary.finished) texts.push(endOf(run));
    const bad = run.frames.filter((frame) => !frame.usable);
    if (bad.length > 0) {
      const names = bad.slice(0, 5).map((frame) => frame.name);
      texts.push(
        `${bad.length} of ${run.frames.length} frames are not usable: ` +
          `${names.join(", ")}${bad.length > 5 ? ", ..." : ""} (${bad[0].stop_reason})`,
      );
    }
    texts.push(...run.warnings);
    return texts.map((text) =>
      element("p", { class: "notice", role: "status" }, prefix(run) + text),
    );
  });
}

function stage(runs: Run[]): { root: HTMLElement; canvas: HTMLCanvasElement } {
  const canvas = element("canvas", {
    id: "view",
    tabindex: 0,
    "aria-label":
      "3D view of muscles and bones; drag to turn, wheel to zoom, ? for keys",
  });
  const labels = runs.map((run) => element("div", {}, runTitle(run)));
  const root = element(
    "div",
    { class: "stage" },
    canvas,
    ...(runs.length > 1
      ? [element("div", { class: "pane-labels" }, ...labels)]
      : []),
  );
  return { root, canvas };
}

function build(data: PageData): void {
  const { runs } = data;
  const timeline = timelineOf(runs);
  const colors = colorsByName(runs);
  const store = new Store({
    ...initialState,
    moment: Math.min(1, timeline.length - 1),
  });
  const player = new Player(store, timeline.length);
  const { root, canvas } = stage(runs);
  const picked = element("output", { class: "picked", "aria-live": "polite" });
  root.append(picked);

  // The viewer measures its canvas, which must be in the page by then.
  let viewer: Viewer | null = null;
  const help = element("span", {});
  document.title = `${runs[0].report.scene}: musclewarp`;
  document.getElementById("page")!.replaceChildren(
    header(runs, [
      button(icon("theme"), "Light or dark (T)", toggleTheme, { id: "theme" }),
      help,
    ]),
    ...notices(runs),
    element(
      "main",
      {},
      element(
        "div",
        { class: "work" },
        element(
          "div",
          { class: "seen" },
          viewButtons(
            viewNames.filter((name) => name in data.views),
            () => viewer,
          ),
          root,
          transport(runs, timeline, store, player),
        ),
        element(
          "aside",
          { "aria-label": "What is shown" },
          lookPanel(runs, store),
          meshesPanel(runs, colors, store),
          sectionPanel(store),
          crossingsPanel(runs, timeline, store, () => viewer),
        ),
      ),
      ...(runs.some((run) => run.frames.length > 0)
        ? [figuresSection(runs, timeline, colors, store, player)]
        : []),
      summarySection(runs),
    ),
  );
  try {
    viewer = new Viewer(canvas, data, timeline, colors, store);
  } catch (error) {
    // The figures can be read without WebGL.
    root.replaceChildren(noView(error));
    return;
  }
  help.append(listenToKeys(runKeys(store, player, viewer, timeline.length)));
  const shown = viewer;
  sayWhatIsClicked(canvas, (x, y) => shown.pick(x, y), picked);
}

startPage(readPageData, build, "musclewarp-report");
