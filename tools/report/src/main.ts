// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The page musclewarp-report writes: reads what it holds and puts the parts
// together.

import { keepAddress, moveCameraToAddress, stateFromAddress } from "./address";
import { Run, PageData, readPageData } from "./data/run";
import { frameName, movingCoordinates, timelineOf } from "./data/timeline";
import { button, element, icon } from "./dom";
import { figuresSection } from "./figures/figures";
import { listenToKeys } from "./keyboard";
import { colorsByName } from "./mesh_colors";
import { crossingsPanel } from "./panels/crossings";
import { functionsSection } from "./panels/functions";
import { lookPanel, viewNames } from "./panels/look";
import { meshesPanel } from "./panels/meshes";
import { pictureButtons } from "./panels/picture";
import { listenToPointer, pickedLabel, rulerButton } from "./panels/pointer";
import { sectionPanel } from "./panels/section";
import { endOf, summarySection } from "./panels/summary";
import { transport } from "./panels/transport";
import { Viewed, viewButtons } from "./panels/views";
import { Player } from "./player";
import { runKeys } from "./run_keys";
import { noView, startPage } from "./start";
import { Store, initialState } from "./state";
import { toggleTheme } from "./theme";
import { Overlay } from "./viewer/overlay";
import { StillPicture } from "./viewer/still_picture";
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
      const moving = movingCoordinates([run]);
      const names = bad.slice(0, 5).map((frame) => frameName(frame, moving));
      texts.push(
        `${bad.length} of ${run.frames.length} frames are not usable: ` +
          `${names.join(", ")}${bad.length > 5 ? ", ..." : ""} (${bad[0].stop_reason})`,
        ...(bad[0].shortcomings ?? []).map(
          (text) => `${frameName(bad[0], moving)}: ${text}`,
        ),
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

// Lines of many muscles hide what is behind them.
const mostMusclesWithLines = 6;

function storeOf({ runs }: PageData, moments: number): Store {
  const meshes = runs.flatMap((run) =>
    [...run.muscles, ...run.bones].map(({ name }) => name),
  );
  return new Store({
    ...initialState,
    moment: Math.min(1, moments - 1),
    lines: runs.every(({ muscles }) => muscles.length <= mostMusclesWithLines),
    ...stateFromAddress(location.hash, moments, meshes),
  });
}

function build(data: PageData): void {
  const { runs } = data;
  const timeline = timelineOf(runs);
  const colors = colorsByName(runs);
  const hash = location.hash;
  const store = storeOf(data, timeline.length);
  const player = new Player(store, timeline.length);
  const { root, canvas } = stage(runs);
  const picked = pickedLabel();
  root.append(picked);

  // The viewer measures its canvas, which must be in the page by then.
  let viewer: Viewer | null = null;
  let viewed: Viewed | null = null;
  let overlay: Overlay | null = null;
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
          element(
            "div",
            { class: "tools" },
            viewButtons(
              viewNames.filter((name) => name in data.views),
              () => viewed,
            ),
            rulerButton(store),
            ...pictureButtons(
              runs,
              store,
              () => viewer,
              () => overlay?.root ?? null,
              () =>
                `${runs[0].report.scene}_${timeline[store.state.moment].name}`,
            ),
          ),
          root,
          transport(runs, timeline, store, player),
        ),
        element(
          "aside",
          { "aria-label": "What is shown" },
          lookPanel(runs, store),
          meshesPanel(runs, colors, store, () => viewed?.reset()),
          sectionPanel(runs, data.views, store, () => viewer),
          crossingsPanel(runs, timeline, store, () => viewer),
        ),
      ),
      ...(runs.some((run) => run.frames.length > 0)
        ? [figuresSection(data, timeline, colors, store, player)]
        : []),
      ...(data.functions ? [functionsSection(data.functions)] : []),
      summarySection(runs),
    ),
  );
  try {
    viewer = new Viewer(canvas, data, timeline, colors, store);
  } catch (error) {
    // A picture and the figures can be had without WebGL.
    const still = new StillPicture(data, timeline, colors, store);
    viewed = still;
    root.replaceChildren(still.canvas);
    root.before(noView(error));
    return;
  }
  const shown = viewer;
  viewed = viewer;
  help.append(listenToKeys(runKeys(store, player, shown, timeline.length)));
  overlay = new Overlay(data.views, shown.camera);
  root.append(overlay.root);
  const written = overlay;
  const ruler = listenToPointer(canvas, shown, store, picked);
  shown.onDrawn(() => {
    const [{ height }] = shown.panes();
    written.draw(height * canvas.clientHeight, ruler());
  });
  moveCameraToAddress(hash, shown);
  keepAddress(store, shown);
}

startPage(readPageData, build, "musclewarp-report");
