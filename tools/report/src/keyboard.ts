// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Keys, and the dialog that tells them.

import { button, element } from "./dom";
import { LinkedCamera } from "./viewer/camera";

export interface Key {
  keys: string[]; // as KeyboardEvent.key has them
  shown: string; // empty: told with another key
  does: string;
  act: () => void;
}

export function key(
  name: string,
  shown: string,
  does: string,
  act: () => void,
): Key {
  return { keys: [name, name.toUpperCase()], shown, does, act };
}

const turn = Math.PI / 24;

interface Viewed {
  readonly camera: LinkedCamera;
  view(name: string): void;
  reset(): void;
}

export function viewKeys(names: string[], viewer: Viewed): Key[] {
  return [
    ...names.map((name, i) =>
      key(String(i + 1), String(i + 1), `view from ${name}`, () =>
        viewer.view(name),
      ),
    ),
    key("r", "R", "reset the view", () => viewer.reset()),
    key("a", "A / D", "turn", () => viewer.camera.turn(turn, 0)),
    key("d", "", "", () => viewer.camera.turn(-turn, 0)),
    key("w", "W / S", "tilt", () => viewer.camera.turn(0, turn)),
    key("s", "", "", () => viewer.camera.turn(0, -turn)),
    key("+", "+ / −", "zoom", () => viewer.camera.zoom(0.87)),
    key("-", "", "", () => viewer.camera.zoom(1.15)),
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

// Returns the button that opens the dialog.
export function listenToKeys(keys: Key[]): HTMLButtonElement {
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
        ...keys
          .filter((each) => each.shown)
          .map((each) => [each.shown, each.does]),
      ].flatMap(([shown, does]) => [
        element("dt", {}, element("kbd", {}, shown)),
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
    const pressed = keys.find((each) => each.keys.includes(event.key));
    if (!pressed) return;
    event.preventDefault();
    pressed.act();
  });
  return button("?", "Keys and mouse (?)", open);
}
