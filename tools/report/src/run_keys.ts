// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The keys of the page of a run.

import { Key, key, viewKeys } from "./keyboard";
import { colorings, viewNames } from "./panels/look";
import { Player } from "./player";
import { SectionAxis, Store } from "./state";
import { toggleTheme } from "./theme";
import { Viewer } from "./viewer/viewer";

const sections: SectionAxis[] = ["off", "anterior", "lateral", "superior"];

function next<T>(all: T[], current: T): T {
  return all[(all.indexOf(current) + 1) % all.length];
}

export function runKeys(
  store: Store,
  player: Player,
  viewer: Viewer,
  moments: number,
): Key[] {
  const flip = (what: "lines" | "fibres" | "crossings") => () =>
    store.set({ [what]: !store.state[what] });
  return [
    key(" ", "space", "play or pause", () => player.toggle()),
    key("ArrowLeft", "←", "frame before", () => player.step(-1)),
    key("ArrowRight", "→", "next frame", () => player.step(1)),
    key("Home", "Home", "rest", () => player.goTo(0)),
    key("End", "End", "last frame", () => player.goTo(moments - 1)),
    ...viewKeys(viewNames, viewer),
    key("c", "C", "next colouring", () =>
      store.set({
        coloring: next(
          colorings.map(([coloring]) => coloring),
          store.state.coloring,
        ),
      }),
    ),
    key("p", "P", "next section plane", () =>
      viewer.startSection(next(sections, store.state.section)),
    ),
    key("l", "L", "action lines", flip("lines")),
    key("f", "F", "fibres", flip("fibres")),
    key("x", "X", "crossing triangles", flip("crossings")),
    key("m", "M", "ruler: distance between two clicks", () =>
      store.set({ measuring: !store.state.measuring }),
    ),
    key("t", "T", "light or dark", toggleTheme),
  ];
}
