// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What the colours of muscles mean.

import { Run } from "../data/run";
import { element, svg } from "../dom";
import { Store } from "../state";
import { VertexScale, vertexScale } from "../viewer/coloring";

const legendWidth = 262;
const legendHeight = 32;
const steps = 60;
const barHeight = 12;

export function legendTitle({ title, unit }: VertexScale): string {
  return title + (unit ? `, ${unit}` : "");
}

// The bar with its ticks.
export function legendBar(scale: VertexScale): SVGSVGElement {
  const step = legendWidth / steps;
  const last = scale.ticks.length - 1;
  return svg(
    "svg",
    {
      viewBox: `0 0 ${legendWidth} ${legendHeight}`,
      width: legendWidth,
      height: legendHeight,
    },
    ...Array.from({ length: steps }, (_, i) =>
      svg("rect", {
        x: i * step,
        y: 0,
        width: step + 0.5,
        height: barHeight,
        fill: scale.color(i / (steps - 1)),
      }),
    ),
    ...scale.ticks.map(([place, text], i) =>
      svg(
        "text",
        {
          x: legendWidth * place,
          y: barHeight + 15,
          "font-size": 12,
          fill: "currentColor",
          "text-anchor":
            i === last && place > 0.9
              ? "end"
              : i === 0 && place < 0.1
                ? "start"
                : "middle",
        },
        text,
      ),
    ),
  );
}

export function legend(runs: Run[], store: Store): HTMLElement {
  const made = element("figure", { class: "legend", "aria-live": "polite" });
  store.subscribe((state, changed) => {
    if (!changed.has("coloring")) return;
    const scale = vertexScale(state.coloring, runs);
    made.hidden = scale === null;
    if (!scale) return;
    made.replaceChildren(
      element("figcaption", {}, legendTitle(scale)),
      legendBar(scale),
    );
  });
  return made;
}
