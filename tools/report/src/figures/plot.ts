// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// One figure as an SVG plot, linked to the frame that is shown.

import * as Plot from "@observablehq/plot";

import { Run, isOfDesign } from "../data/run";
import { MeshColors } from "../mesh_colors";
import { readable } from "../palette";
import { MeasuredCurve, measuredMarks, measuredPoints } from "./measured";
import { Abscissa, Figure, Series } from "./series";

interface Point {
  x: number;
  y: number;
  key: string;
  color: string;
  dashed: boolean;
  frame: number; // of the run, from 0
  run: number;
  ofDesign: boolean; // no line goes through it
  text: string;
}

export interface PlotOptions {
  runs: Run[];
  abscissa: Abscissa;
  colors: MeshColors;
  measured: MeasuredCurve[];
  isShown: (series: Series) => boolean;
  width: number;
}

const sceneStyles: Record<string, string> = {
  all: "var(--text)",
  moving: "#3b73b9",
  counting: "#e39256",
};

export function colorOf(series: Series, colors: MeshColors): string {
  return series.color ?? colors.get(series.muscle) ?? sceneStyles[series.name];
}

// Six digits, without those that say nothing.
export function figureText(value: number): string {
  return Number.isFinite(value) ? String(Number(value.toPrecision(6))) : "–";
}

function pointsOf(figure: Figure, options: PlotOptions): Point[] {
  const { runs, abscissa, colors } = options;
  return figure.series.filter(options.isShown).flatMap((series) => {
    const { frames, folder } = runs[series.run];
    const ofDesign = isOfDesign(runs[series.run]);
    const run = runs.length > 1 ? ` (${folder})` : "";
    return series.values.map((y, frame) => {
      const x = abscissa.value(frames[frame], frame);
      return {
        x,
        y,
        frame,
        run: series.run,
        ofDesign,
        key: `${series.run} ${series.muscle} ${series.name}`,
        color: colorOf(series, colors),
        dashed: series.run > 0,
        text: `${readable(series.name)}${run}\n${abscissa.label} ${figureText(x)}: ${figureText(y)}`,
      };
    });
  });
}

// The plot, and how to mark a frame in it.
export interface DrawnPlot {
  svg: SVGSVGElement;
  mark(x: number): void;
}

export function drawPlot(
  figure: Figure,
  options: PlotOptions,
  onPick: (run: number, frame: number) => void,
): DrawnPlot {
  const points = pointsOf(figure, options);
  const { colors } = options;
  const finite = points.filter(({ x, y }) => Number.isFinite(x + y));
  const line = (dashed: boolean) =>
    Plot.line(
      points.filter((point) => point.dashed === dashed && !point.ofDesign),
      {
        x: "x",
        y: "y",
        z: "key",
        stroke: "color",
        strokeWidth: 1.6,
        strokeDasharray: dashed ? "5 3" : undefined,
        defined: (point: Point) => Number.isFinite(point.x + point.y),
      } as Plot.LineOptions,
    );
  const svg = Plot.plot({
    width: options.width,
    height: 220,
    marginLeft: 62,
    marginBottom: 36,
    style: { background: "transparent", color: "inherit", fontSize: "12px" },
    ariaLabel: figure.title,
    ariaDescription: figure.note,
    x: {
      label: options.abscissa.label,
      ticks: 6,
      // There is no frame one and a half.
      tickFormat: (value: number) =>
        options.abscissa.id === "frame" && !Number.isInteger(value)
          ? ""
          : figureText(value),
    },
    y: {
      label: figure.label,
      grid: true,
      nice: true,
      ticks: 5,
      // "1.5e-9", and plain digits where they do.
      tickFormat: (value: number) => String(Number(value.toPrecision(4))),
    },
    color: { type: "identity" },
    marks: [
      ...measuredMarks(options.measured, colors),
      line(false),
      line(true),
      Plot.dot(finite, { x: "x", y: "y", fill: "color", r: 1.5 }),
      Plot.tip(
        [...finite, ...measuredPoints(options.measured, colors)],
        Plot.pointer({
          x: "x",
          y: "y",
          title: "text",
          fill: "var(--surface)",
          stroke: "var(--line)",
          pointerSize: 0,
        }),
      ),
    ],
  }) as SVGSVGElement & Plot.Plot;
  const scale = svg.scale("x")!;
  const [top, bottom] = svg.scale("y")!.range as [number, number];

  const cursor = document.createElementNS(svg.namespaceURI, "line");
  cursor.setAttribute("class", "cursor");
  cursor.setAttribute("y1", String(Math.min(top, bottom)));
  cursor.setAttribute("y2", String(Math.max(top, bottom)));
  svg.prepend(cursor);

  svg.addEventListener("click", (event) => {
    const shown = svg.value as Partial<Point> | null;
    const picked =
      shown?.frame === undefined ? nearest(finite, scale, svg, event) : shown;
    if (picked) onPick(picked.run!, picked.frame!);
  });
  return {
    svg,
    mark: (x) => {
      const place = Number.isFinite(x) ? Number(scale.apply(x)) : NaN;
      cursor.toggleAttribute("hidden", !Number.isFinite(place));
      if (!Number.isFinite(place)) return;
      cursor.setAttribute("x1", String(place));
      cursor.setAttribute("x2", String(place));
    },
  };
}

function nearest(
  points: Point[],
  scale: Plot.Scale,
  svg: SVGSVGElement,
  event: MouseEvent,
): Point | null {
  const box = svg.getBoundingClientRect();
  const at =
    ((event.clientX - box.left) / box.width) * svg.viewBox.baseVal.width;
  const distance = (point: Point) =>
    Math.abs(Number(scale.apply(point.x)) - at);
  return points.reduce<Point | null>(
    (best, point) => (!best || distance(point) < distance(best) ? point : best),
    null,
  );
}
