// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Keys, and the dialog that tells them.

import { button, element } from "./dom";
import { colorings, viewNames } from "./panels/look";
import { Player } from "./player";
import { SectionAxis, Store } from "./state";
import { Viewer } from "./viewer/viewer";

interface Key {
  keys: string[]; // as KeyboardEvent.key has them
  shown: string;
  does: string;
  act: () => void;
}

const turn = Math.PI / 24;
const sections: SectionAxis[] = ["off", "anterior", "lateral", "superior"];

function next<T>(all: T[], current: T): T {
  return all[(all.indexOf(current) + 1) % all.length];
}

function keyTable(
  store: Store,
  player: Player,
  viewer: Viewer,
  moments: number,
  toggleTheme: () => void,
): Key[] {
  const flip = (key: "lines" | "fibres" | "crossings") => () =>
    store.set({ [key]: !store.state[key] });
  const one = (
    key: string,
    shown: string,
    does: string,
    act: () => void,
  ): Key => ({ keys: [key, key.toUpperCase()], shown, does, act });
  return [
    one(" ", "space", "play or pause", () => player.toggle()),
    one("ArrowLeft", "←", "frame before", () => player.step(-1)),
    one("ArrowRight", "→", "next frame", () => player.step(1)),
    one("Home", "Home", "rest", () => player.goTo(0)),
    one("End", "End", "last frame", () => player.goTo(moments - 1)),
    ...viewNames.map((name, i) =>
      one(String(i + 1), String(i + 1), `view from ${name}`, () =>
        viewer.view(name),
      ),
    ),
    one("r", "R", "reset the view", () => viewer.reset()),
    one("a", "A / D", "turn", () => viewer.camera.turn(turn, 0)),
    one("d", "", "", () => viewer.camera.turn(-turn, 0)),
    one("w", "W / S", "tilt", () => viewer.camera.turn(0, turn)),
    one("s", "", "", () => viewer.camera.turn(0, -turn)),
    one("+", "+ / −", "zoom", () => viewer.camera.zoom(0.87)),
    one("-", "", "", () => viewer.camera.zoom(1.15)),
    one("c", "C", "next colouring", () =>
      store.set({
        coloring: next(
          colorings.map(([coloring]) => coloring),
          store.state.coloring,
        ),
      }),
    ),
    one("p", "P", "next section plane", () =>
      store.set({ section: next(sections, store.state.section) }),
    ),
    one("l", "L", "action lines", flip("lines")),
    one("f", "F", "fibres", flip("fibres")),
    one("x", "X", "crossing triangles", flip("crossings")),
    one("t", "T", "light or dark", toggleTheme),
  ];
}

// Where keys mean something to the control that has them.
function belongsToControl(event: KeyboardEvent): boolean {
  const target = event.target as HTMLElement;
  if (target.matches("select, textarea, input:not([type=checkbox])")) {
    return true;
  }
  return event.key === " " && target.matches("button, input, summary, a");
}

export function listenToKeys(
  store: Store,
  player: Player,
  viewer: Viewer,
  moments: number,
  toggleTheme: () => void,
): HTMLButtonElement {
  const keys = keyTable(store, player, viewer, moments, toggleTheme);
  const dialog = element(
    "dialog",
    { id: "help", "aria-label": "Keys and mouse" },
    element("h2", {}, "Keys and mouse"),
    element(
      "dl",
      {},
      ...[
        ["drag", "turn"],
        ["right drag, two fingers", "move"],
        ["wheel, pinch", "zoom"],
        ["click", "say what is there"],
        ...keys.filter((key) => key.shown).map((key) => [key.shown, key.does]),
      ].flatMap(([key, does]) => [
        element("dt", {}, element("kbd", {}, key)),
        element("dd", {}, does),
      ]),
    ),
    element("form", { method: "dialog" }, element("button", {}, "Close")),
  );
  document.body.append(dialog);
  const open = () => dialog.showModal();
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || dialog.open) return;
    if (belongsToControl(event)) return;
    if (event.key === "?") return open();
    const key = keys.find((each) => each.keys.includes(event.key));
    if (!key) return;
    event.preventDefault();
    key.act();
  });
  return button("?", "Keys and mouse (?)", open);
}
