// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Colours of a muscle's vertices by a figure, and the legend that explains
// them. Scales are readable for the colour-blind and in grey.

import {
  interpolateCividis,
  interpolatePuOr,
  interpolateViridis,
} from "d3-scale-chromatic";
import { Color } from "three";

import { Muscle, Run } from "../data/run";
import { Coloring } from "../state";

// What a coloured muscle is coloured by: a value a vertex, and how each value
// is shown. Positions on the scale go from 0 to 1.
export interface VertexScale {
  title: string;
  unit: string;
  values(muscle: Muscle, pose: number): Float32Array;
  place(value: number): number;
  color(place: number): string;
  ticks: [number, string][]; // place, text
  say(value: number): string;
}

const insideColor = "#ff8c1a";

// Of bodies, after Okabe and Ito, "Color universal design", 2008.
const bodyColors = [
  "#d55e00",
  "#0072b2",
  "#009e73",
  "#cc79a7",
  "#e69f00",
  "#56b4e9",
];

// Of the vertices from rest, mm.
function displacements(muscle: Muscle, pose: number): Float32Array {
  const rest = muscle.pointsAt(0);
  const points = muscle.pointsAt(pose);
  return new Float32Array(muscle.vertices).map((_, v) =>
    Math.hypot(
      points[3 * v] - rest[3 * v],
      points[3 * v + 1] - rest[3 * v + 1],
      points[3 * v + 2] - rest[3 * v + 2],
    ),
  );
}

function areasAround(muscle: Muscle, points: Float32Array): Float32Array {
  const areas = new Float32Array(muscle.vertices);
  const { triangles } = muscle;
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [
      3 * triangles[t],
      3 * triangles[t + 1],
      3 * triangles[t + 2],
    ];
    const ux = points[b] - points[a];
    const uy = points[b + 1] - points[a + 1];
    const uz = points[b + 2] - points[a + 2];
    const vx = points[c] - points[a];
    const vy = points[c + 1] - points[a + 1];
    const vz = points[c + 2] - points[a + 2];
    const area = Math.hypot(
      uy * vz - uz * vy,
      uz * vx - ux * vz,
      ux * vy - uy * vx,
    );
    for (let k = 0; k < 3; ++k) areas[triangles[t + k]] += area;
  }
  return areas;
}

// Area of the triangles around a vertex to that at rest, as "area_stretch" of
// the .vtp files.
function stretches(muscle: Muscle, pose: number): Float32Array {
  const rest = areasAround(muscle, muscle.pointsAt(0));
  return areasAround(muscle, muscle.pointsAt(pose)).map((area, v) =>
    rest[v] > 0 ? area / rest[v] : 1,
  );
}

// A round number at least as large: 1, 2 or 5 times a power of ten.
function roundedUp(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * [1, 2, 5, 10].find((factor) => factor * power >= value)!;
}

// The largest displacement of all frames ends the scale, so that colours mean
// the same in all of them, and in both runs.
function displacementScale(runs: Run[]): VertexScale {
  const largest = Math.max(
    1e-3,
    ...runs.flatMap((run) =>
      run.frames.flatMap((frame) =>
        frame.muscles.map((muscle) => muscle.max_displacement_mm),
      ),
    ),
  );
  const end = roundedUp(largest);
  return {
    title: "displacement from rest",
    unit: "mm",
    values: displacements,
    place: (value) => value / end,
    color: interpolateViridis,
    ticks: [0, 0.5, 1].map((place) => [place, String(place * end)]),
    say: (value) => `${value.toFixed(1)} mm from rest`,
  };
}

const stretchScale: VertexScale = {
  title: "area, to that at rest",
  unit: "",
  values: stretches,
  place: (value) => 0.5 + Math.log2(Math.max(value, 1e-6)) / 2,
  color: (place) => interpolatePuOr(1 - place),
  ticks: [
    [0, "½"],
    [0.5, "1"],
    [1, "2"],
  ],
  say: (value) => `area ${value.toFixed(2)} of that at rest`,
};

const threeDigits = (value: number) => String(Number(value.toPrecision(3)));

// A gap with a digit more than a hundredth of the limit has.
const millimetres = (value: number, limit: number) =>
  value.toFixed(Math.max(2, 2 - Math.floor(Math.log10(limit))));

// Colours end where gaps no longer matter: at 2 mm in a human, in whom they are
// looked for up to 5.
const endOfGapColors = 0.4;

function gapScale(limit: number): VertexScale {
  const end = endOfGapColors * limit;
  return {
    title: `gap to the nearest mesh, looked for up to ${threeDigits(limit)} mm`,
    unit: "mm",
    values: (muscle, pose) => muscle.gapsAt(pose),
    // A tenth of the scale is for what is inside another mesh.
    place: (value) => (value < 0 ? 0 : 0.1 + (0.9 * value) / end),
    color: (place) =>
      place < 0.1 ? insideColor : interpolateCividis((place - 0.1) / 0.9),
    ticks: [
      [0.05, "inside"],
      [0.1 + 0.9 / 4, threeDigits(end / 4)],
      [0.55, threeDigits(end / 2)],
      [1, `${threeDigits(end)} or more`],
    ],
    say: (value) =>
      value < 0
        ? `${millimetres(-value, limit)} mm inside another mesh`
        : value >= limit
          ? `${threeDigits(limit)} mm or more to the next mesh`
          : `${millimetres(value, limit)} mm to the next mesh`,
  };
}

function contactScale({ contactGap, gapLimit }: Run): VertexScale {
  const color = (place: number) =>
    place < 1 / 3 ? insideColor : place < 2 / 3 ? "#3b73b9" : "#c8c8c8";
  return {
    title: "contact",
    unit: "",
    values: (muscle, pose) => muscle.gapsAt(pose),
    place: (value) => (value < 0 ? 1 / 6 : value <= contactGap ? 1 / 2 : 5 / 6),
    color,
    ticks: [
      [1 / 6, "inside"],
      [1 / 2, `within ${contactGap} mm`],
      [5 / 6, "apart"],
    ],
    say: gapScale(gapLimit).say,
  };
}

// Grey where a muscle is not attached, and a colour for each body.
function attachmentScale(runs: Run[]): VertexScale {
  const bodies = [
    ...new Set(
      runs.flatMap((run) =>
        run.muscles.flatMap(({ attached }) => attached.map(({ body }) => body)),
      ),
    ),
  ].sort();
  const count = bodies.length + 1;
  const middle = (value: number) => (value + 0.5) / count;
  return {
    title: "attached to",
    unit: "",
    values: (muscle) => {
      const values = new Float32Array(muscle.vertices);
      for (const { body, vertices } of muscle.attached) {
        for (const v of vertices) values[v] = 1 + bodies.indexOf(body);
      }
      return values;
    },
    place: middle,
    color: (place) => {
      const area = Math.min(count - 1, Math.floor(place * count));
      return area === 0
        ? "#c8c8c8"
        : bodyColors[(area - 1) % bodyColors.length];
    },
    ticks: ["nothing", ...bodies].map((text, area) => [middle(area), text]),
    say: (value) =>
      value === 0 ? "not attached" : `attached to ${bodies[value - 1]}`,
  };
}

// Null for "name", where each muscle has its own colour.
export function vertexScale(
  coloring: Coloring,
  runs: Run[],
): VertexScale | null {
  switch (coloring) {
    case "name":
      return null;
    case "displacement":
      return displacementScale(runs);
    case "stretch":
      return stretchScale;
    case "gap":
      return gapScale(runs[0].gapLimit);
    case "contact":
      return contactScale(runs[0]);
    case "attachment":
      return attachmentScale(runs);
  }
}

// Linear RGB, three to a vertex, written to `colors`.
export function colorize(
  scale: VertexScale,
  muscle: Muscle,
  pose: number,
  colors: Float32Array,
): void {
  const steps = 255;
  const table = new Float32Array(3 * (steps + 1));
  for (let i = 0; i <= steps; ++i) {
    new Color(scale.color(i / steps)).toArray(table, 3 * i);
  }
  scale.values(muscle, pose).forEach((value, v) => {
    const place = Math.min(1, Math.max(0, scale.place(value)));
    const entry = 3 * Math.round(steps * place);
    colors.set(table.subarray(entry, entry + 3), 3 * v);
  });
}
