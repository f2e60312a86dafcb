// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Measured moment arms in the plots: a point with its spread for each value, a
// line for values of one study that belong together, a band from the lowest to
// the highest where studies overlap. What holds for no certain angle is a line
// across.

import * as Plot from "@observablehq/plot";

import { MeasuredArm } from "../data/run";
import { MeshColors } from "../mesh_colors";
import { readable } from "../palette";
import { Abscissa, Figure, Series } from "./series";

// Of one study and one muscle of the run.
export interface MeasuredCurve {
  muscle: string;
  arms: (MeasuredArm & { angle: number })[]; // by angle
  anywhere: MeasuredArm[]; // that hold for no certain angle
}

interface Band {
  x: number;
  low: number;
  high: number;
  color: string;
}

export interface MeasuredPoint {
  x: number;
  y: number;
  low: number;
  high: number;
  color: string;
  key: string;
  text: string;
}

// What belongs in a figure: of its coordinate, of muscles that are shown, where
// it is laid out by that coordinate.
export function measuredIn(
  figure: Figure,
  abscissa: Abscissa,
  arms: MeasuredArm[],
  isShown: (series: Series) => boolean,
): MeasuredCurve[] {
  if (abscissa.id !== `coordinate ${figure.measured}`) return [];
  const curves = new Map<string, MeasuredCurve>();
  const muscles = new Set(
    figure.series.filter(isShown).map(({ muscle }) => muscle),
  );
  for (const arm of arms) {
    if (arm.coordinate !== figure.measured) continue;
    for (const muscle of arm.muscles.filter((name) => muscles.has(name))) {
      const key = [muscle, arm.measured, arm.source, arm.detail].join("\n");
      const curve = curves.get(key) ?? { muscle, arms: [], anywhere: [] };
      curves.set(key, curve);
      if (arm.angle === null) curve.anywhere.push(arm);
      else curve.arms.push({ ...arm, angle: arm.angle });
    }
  }
  for (const { arms: some } of curves.values()) {
    some.sort((a, b) => a.angle - b.angle);
  }
  return [...curves.values()];
}

function textOf(arm: MeasuredArm): string {
  const at = arm.angle === null ? "at no certain angle" : `at ${arm.angle}°`;
  const spread = arm.sd_mm === null ? "" : ` ± ${arm.sd_mm}`;
  const sign = arm.turned ? ", signs turned" : "";
  return (
    `${arm.source} (${readable(arm.measured)}${sign})\n` +
    `${arm.arm_mm}${spread} mm ${at}\n${arm.detail}`
  );
}

export function measuredPoints(
  curves: MeasuredCurve[],
  colors: MeshColors,
): MeasuredPoint[] {
  return curves.flatMap(({ muscle, arms }, i) =>
    arms.map((arm) => ({
      x: arm.angle,
      y: arm.arm_mm,
      low: arm.arm_mm - (arm.sd_mm ?? 0),
      high: arm.arm_mm + (arm.sd_mm ?? 0),
      color: colors.get(muscle)!,
      key: String(i),
      text: textOf(arm),
    })),
  );
}

// On the straight lines between the values; nothing beyond them.
function valueAt({ arms }: MeasuredCurve, angle: number): number[] {
  const after = arms.findIndex((arm) => arm.angle >= angle);
  if (after < 0) return [];
  const [b, a] = [arms[after], arms[Math.max(0, after - 1)]];
  if (b.angle === angle) return [b.arm_mm];
  if (after === 0) return [];
  const part = (angle - a.angle) / (b.angle - a.angle);
  return [a.arm_mm + part * (b.arm_mm - a.arm_mm)];
}

function bands(curves: MeasuredCurve[], colors: MeshColors): Band[][] {
  const muscles = [...new Set(curves.map(({ muscle }) => muscle))];
  return muscles.flatMap((muscle) => {
    const own = curves.filter(
      (curve) => curve.muscle === muscle && curve.arms.length > 1,
    );
    const angles = own.flatMap(({ arms }) => arms.map(({ angle }) => angle));
    const sorted = [...new Set(angles)].sort((a, b) => a - b);
    const parts: Band[][] = [[]];
    for (const x of sorted) {
      const values = own.flatMap((curve) => valueAt(curve, x));
      if (values.length < 2) {
        parts.push([]);
        continue;
      }
      const [low, high] = [Math.min(...values), Math.max(...values)];
      parts.at(-1)!.push({ x, low, high, color: colors.get(muscle)! });
    }
    return parts.filter((part) => part.length > 1);
  });
}

export function measuredMarks(
  curves: MeasuredCurve[],
  colors: MeshColors,
): Plot.Markish[] {
  const points = measuredPoints(curves, colors);
  const anywhere = curves.flatMap(({ muscle, anywhere: arms }) =>
    arms.map((arm) => ({
      y: arm.arm_mm,
      color: colors.get(muscle)!,
      text: textOf(arm),
    })),
  );
  return [
    ...bands(curves, colors).map((band) =>
      Plot.areaY(band, {
        x: "x",
        y1: "low",
        y2: "high",
        fill: band[0].color,
        fillOpacity: 0.15,
      }),
    ),
    Plot.ruleY(anywhere, {
      y: "y",
      stroke: "color",
      strokeOpacity: 0.5,
      strokeDasharray: "1 4",
      title: "text",
    }),
    Plot.line(points, {
      x: "x",
      y: "y",
      z: "key",
      stroke: "color",
      strokeOpacity: 0.5,
      strokeWidth: 1,
      strokeDasharray: "1 3",
    }),
    Plot.ruleX(
      points.filter(({ low, high }) => low < high),
      { x: "x", y1: "low", y2: "high", stroke: "color", strokeOpacity: 0.6 },
    ),
    Plot.dot(points, {
      x: "x",
      y: "y",
      r: 3,
      stroke: "color",
      fill: "var(--surface)",
      className: "measured",
    }),
  ];
}
