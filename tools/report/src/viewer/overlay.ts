// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What is written over the picture: which way the body lies, how long a
// millimetre is, and the ruler.

import { Quaternion, Vector3 } from "three";

import { View } from "../data/page_parts";
import { svg } from "../dom";
import { LinkedCamera } from "./camera";

const arm = 30; // of the axis cross, pixels
const edge = 56; // of the picture, to the middle of the cross
const barLengths: [number, number] = [50, 125]; // pixels

// The axes that the letters tell.
const axes = ["anterior", "lateral", "superior"];

// At the end of an arm, or beside an arm that points to the viewer.
function letterPlace({ x, y }: Vector3): { x: number; y: number } {
  const isShort = Math.hypot(x, y) < 0.35;
  const [right, up] = isShort ? [-0.4, -0.4] : [1.3 * x, 1.3 * y];
  return { x: arm * right, y: -arm * up + 4 };
}

function axisCross(
  views: Record<string, View>,
  turn: Quaternion,
  x: number,
  y: number,
): SVGGElement {
  const known = axes.filter((name) => name in views);
  const ends = known.map((name) => ({
    name,
    end: new Vector3(...views[name].toward_viewer).applyQuaternion(turn),
  }));
  ends.sort((a, b) => a.end.z - b.end.z); // what is nearer is drawn later
  const told = svg("title", {}, `The axes point ${known.join(", ")}`);
  return svg(
    "g",
    { class: "cross", transform: `translate(${x} ${y})` },
    told,
    ...ends.flatMap(({ name, end }) => [
      svg("line", {
        x1: 0,
        y1: 0,
        x2: arm * end.x,
        y2: -arm * end.y,
        stroke: "currentColor",
        "stroke-width": 2,
        "stroke-opacity": end.z < 0 ? 0.5 : 1,
      }),
      svg(
        "text",
        {
          ...letterPlace(end),
          "text-anchor": "middle",
          "font-weight": 600,
          "font-size": 12,
          fill: "currentColor",
          "data-axis": name,
        },
        name[0].toUpperCase(),
      ),
    ]),
  );
}

// The longest of 1, 2, 5, 10, ... mm that is short enough.
function barLength(pixelSize: number): number {
  const most = barLengths[1] * pixelSize;
  const power = 10 ** Math.floor(Math.log10(most));
  return [5, 2, 1].map((factor) => factor * power).find((mm) => mm <= most)!;
}

function scaleBar(pixelSize: number, right: number, y: number): SVGGElement {
  const mm = barLength(pixelSize);
  const left = right - mm / pixelSize;
  return svg(
    "g",
    { class: "scale-bar" },
    svg("title", {}, "At the middle of what is seen"),
    svg("path", {
      d: `M${left} ${y - 5}V${y}H${right}V${y - 5}`,
      fill: "none",
      stroke: "currentColor",
      "stroke-width": 1.5,
    }),
    svg(
      "text",
      {
        x: (left + right) / 2,
        y: y - 5,
        "text-anchor": "middle",
        "font-size": 12,
        fill: "currentColor",
      },
      `${Number(mm.toPrecision(1))} mm`,
    ),
  );
}

// One or two ends on the canvas, and what is written at them.
export interface ShownRuler {
  ends: [number, number][];
  text: string;
}

function rulerMarks({ ends, text }: ShownRuler): SVGGElement {
  const [from, to = from] = ends;
  const middle = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
  return svg(
    "g",
    { class: "ruler" },
    ...["var(--stage)", "currentColor"].map((stroke, i) =>
      svg("line", {
        x1: from[0],
        y1: from[1],
        x2: to[0],
        y2: to[1],
        stroke,
        "stroke-width": i === 0 ? 5 : 2,
      }),
    ),
    ...ends.map(([cx, cy]) =>
      svg("circle", {
        cx,
        cy,
        r: 4,
        fill: "currentColor",
        stroke: "var(--stage)",
        "stroke-width": 1.5,
      }),
    ),
    svg(
      "text",
      {
        x: middle[0],
        y: middle[1] - 10,
        "text-anchor": "middle",
        "font-size": 14,
        "font-weight": 600,
        fill: "currentColor",
        stroke: "var(--stage)",
        "stroke-width": 4,
        "paint-order": "stroke",
      },
      text,
    ),
  );
}

export class Overlay {
  readonly root = svg("svg", { class: "overlay", "aria-hidden": "true" });

  constructor(
    private readonly views: Record<string, View>,
    private readonly camera: LinkedCamera,
  ) {}

  // `paneHeight` is that of one run, CSS pixels.
  draw(paneHeight: number, ruler: ShownRuler | null): void {
    const { clientWidth: width, clientHeight: height } = this.root;
    const turn = this.camera.camera.quaternion.clone().invert();
    const pixelSize = this.camera.pixelSize(paneHeight);
    this.root.replaceChildren(
      axisCross(this.views, turn, width - edge, height - edge),
      scaleBar(pixelSize, width - 2 * edge - 8, height - 14),
      ...(ruler ? [rulerMarks(ruler)] : []),
    );
  }
}
