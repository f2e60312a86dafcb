// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

import { button, element } from "../dom";

export interface Viewed {
  view(name: string): void;
  reset(): void;
}

// A button for each view, which also has its number as a key.
export function viewButtons(
  names: string[],
  viewer: () => Viewed | null,
): HTMLElement {
  return element(
    "div",
    { class: "views", role: "group", "aria-label": "View from" },
    ...names.map((name, i) =>
      button(name, `View from ${name} (${i + 1})`, () => viewer()?.view(name)),
    ),
    button("reset", "Reset the view (R)", () => viewer()?.reset()),
  );
}
