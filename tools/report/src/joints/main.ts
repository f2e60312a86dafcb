// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The page musclewarp-articulate writes: bones, the joints found on them, and
// their coordinates.

import { button, element, icon, section } from "../dom";
import { key, listenToKeys, viewKeys } from "../keyboard";
import { boneColor, readable } from "../palette";
import {
  boneNotes,
  meshGroup,
  opaqueButton,
  simplificationOf,
} from "../panels/meshes";
import { pickedLabel } from "../panels/pointer";
import { viewButtons } from "../panels/views";
import { listenToClicks, noView, startPage } from "../start";
import { Store } from "../state";
import { toggleTheme } from "../theme";
import { childColor, parentColor, shapeColor } from "./colors";
import { JointsData, JointsFile, coordinatesOf, readJointsData } from "./data";
import { jointList, qualityOf } from "./joint_list";
import { JointsViewer } from "./joints_viewer";
import { JointsState, initialJointsState, rangeOf, scanValues } from "./state";
import { withFollowers } from "./kinematics";
import { Overlay } from "../viewer/overlay";

type JointsStore = Store<JointsState>;

// "5 joints: 3 good, 1 weak, 1 failed".
function counts({ joints }: JointsFile): string {
  const parts = ["good", "weak", "failed", "given"].flatMap((quality) => {
    const count = joints.filter((each) => qualityOf(each) === quality).length;
    return count > 0 ? [`${count} ${quality}`] : [];
  });
  const joint = joints.length === 1 ? "joint" : "joints";
  return `${joints.length} ${joint}: ${parts.join(", ")}`;
}

// As near to 0 as the ranges allow.
function zeroValues(file: JointsFile): Record<string, number> {
  return Object.fromEntries(
    coordinatesOf(file).map((coordinate) => {
      const [lowest, highest] = rangeOf(coordinate);
      return [coordinate.name, Math.min(highest, Math.max(lowest, 0))];
    }),
  );
}

function toggle(
  label: string,
  what: "shapes" | "axes",
  store: JointsStore,
): HTMLElement {
  const box = element("input", {
    type: "checkbox",
    id: `show-${what}`,
    onchange: () => store.set({ [what]: box.checked }),
  });
  store.subscribe((state) => (box.checked = state[what]));
  return element("label", {}, box, element("span", {}, label));
}

function legend(): HTMLElement {
  const entries = [
    [shapeColor, "fitted shape"],
    [parentColor, "bone that carries the chosen joint"],
    [childColor, "bone that it moves"],
  ];
  return element(
    "div",
    { class: "plot-legend" },
    ...entries.map(([color, text]) => {
      const swatch = element("i", { class: "swatch" });
      swatch.style.background = color;
      return element("span", {}, swatch, text);
    }),
  );
}

function stage(): { root: HTMLElement; canvas: HTMLCanvasElement } {
  const canvas = element("canvas", {
    id: "view",
    tabindex: 0,
    "aria-label":
      "3D view of bones and joints; drag to turn, wheel to zoom, ? for keys",
  });
  return { root: element("div", { class: "stage" }, canvas), canvas };
}

function notesSection(notes: string[]): HTMLElement[] {
  if (notes.length === 0) return [];
  const items = notes.map((note) => element("li", {}, note));
  const list = element("ul", { class: "reasons" }, ...items);
  return [section("Notes", "notes", list)];
}

function bonesSection({ bones }: JointsData, store: JointsStore): HTMLElement {
  const simplification = simplificationOf(bones);
  return section(
    "Bones",
    "bones",
    meshGroup("Bones", boneNotes(bones), () => boneColor, store),
    opaqueButton(store),
    element(
      "p",
      { class: "note" },
      (simplification ? `${simplification}; ` : "") +
        "shapes are fitted to the full meshes.",
    ),
  );
}

function jointsSection(data: JointsData, store: JointsStore): HTMLElement {
  const { file } = data;
  return section(
    "Joints",
    "joint-list",
    element(
      "div",
      { class: "views", role: "group", "aria-label": "Pose" },
      button("pose of the scan", "All coordinates as in the scan", () =>
        store.set({ values: scanValues(file) }),
      ),
      button("zero", "All coordinates 0, or as near as they go", () =>
        store.set({ values: withFollowers(file, zeroValues(file)) }),
      ),
    ),
    element(
      "div",
      { class: "toggles" },
      toggle("fitted shapes", "shapes", store),
      toggle("axes and centres", "axes", store),
    ),
    jointList(file, store),
  );
}

function nextJoint(file: JointsFile, store: JointsStore): void {
  const names = [null, ...file.joints.map(({ name }) => name)];
  const at = names.indexOf(store.state.selected);
  store.set({ selected: names[(at + 1) % names.length] });
}

function build(data: JointsData): void {
  const { file } = data;
  const store: JointsStore = new Store(initialJointsState(file));
  const { root, canvas } = stage();
  const picked = pickedLabel();
  root.append(picked);
  // The viewer measures its canvas, which must be in the page by then.
  let viewer: JointsViewer | null = null;
  const views = Object.keys(data.views);
  const help = element("span", {});
  const theme = button(icon("theme"), "Light or dark (T)", toggleTheme, {
    id: "theme",
  });
  document.title = `${data.name}: musclewarp`;
  document.getElementById("page")!.replaceChildren(
    element(
      "header",
      { class: "page" },
      element("h1", {}, data.name),
      element("p", {}, counts(file)),
      element("div", { class: "controls" }, theme, help),
    ),
    element(
      "main",
      {},
      element(
        "div",
        { class: "work of-joints" },
        element(
          "div",
          { class: "seen" },
          viewButtons(views, () => viewer),
          root,
          legend(),
        ),
        element(
          "aside",
          { "aria-label": "Joints and bones" },
          jointsSection(data, store),
          ...notesSection(file.notes),
          bonesSection(data, store),
        ),
      ),
    ),
  );
  try {
    viewer = new JointsViewer(canvas, data, store);
  } catch (error) {
    root.replaceChildren(noView(error));
    return;
  }
  help.append(
    listenToKeys([
      ...viewKeys(views, viewer),
      key("j", "J", "next joint", () => nextJoint(file, store)),
      key("t", "T", "light or dark", toggleTheme),
    ]),
  );
  const shown = viewer;
  listenToClicks(canvas, (x, y) => {
    picked.textContent = readable(shown.pick(x, y) ?? "");
  });
  const overlay = new Overlay(data.views, viewer.camera);
  root.append(overlay.root);
  viewer.onDrawn(() => overlay.draw(canvas.clientHeight, null));
}

startPage(readJointsData, build, "musclewarp-articulate --html");
