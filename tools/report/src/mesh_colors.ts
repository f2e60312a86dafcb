// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// A colour for each mesh. Muscles that lie beside each other get colours that
// differ much; the same name has the same colour in all runs.

import { lab } from "d3-color";
import { Box3 } from "three";

import { Bone, Muscle } from "./data/run";
import { boneColor, muscleColors } from "./palette";

const besideMm = 5;
// So many colours are told apart wherever they lie: they come in their order.
const plainColors = 8;

interface Colored {
  box: Box3;
  color: string;
}

function boxOf(muscle: Muscle): Box3 {
  return new Box3().setFromArray(muscle.pointsAt(0));
}

// CIE76.
function difference(a: string, b: string): number {
  const [p, q] = [lab(a), lab(b)];
  return Math.hypot(p.l - q.l, p.a - q.a, p.b - q.b);
}

// The colour that is used least; among those, the one that differs most from
// the colours beside it. The first of the palette where nothing is beside.
function colorBeside(box: Box3, colored: Colored[]): string {
  const near = box.clone().expandByScalar(besideMm);
  const beside = colored.filter((each) => each.box.intersectsBox(near));
  const uses = (color: string) =>
    colored.filter((each) => each.color === color).length;
  const fewest = Math.min(...muscleColors.map(uses));
  const contrast = (color: string) =>
    Math.min(...beside.map((each) => difference(each.color, color)));
  return muscleColors
    .filter((color) => uses(color) === fewest)
    .reduce((best, color) => (contrast(color) > contrast(best) ? color : best));
}

// In the order in which the muscles appear.
export function colorsByName(
  runs: { muscles: Muscle[]; bones: Bone[] }[],
): Map<string, string> {
  const colors = new Map<string, string>();
  const muscles = new Map(
    runs.flatMap((run) =>
      run.muscles.map((muscle) => [muscle.name, muscle] as const),
    ),
  );
  const colored: Colored[] = [];
  for (const [name, muscle] of muscles) {
    const box = boxOf(muscle);
    const color =
      muscles.size <= plainColors
        ? muscleColors[colored.length]
        : colorBeside(box, colored);
    colored.push({ box, color });
    colors.set(name, color);
  }
  for (const { name } of runs.flatMap(({ bones }) => bones)) {
    if (!colors.has(name)) colors.set(name, boneColor);
  }
  return colors;
}

export type MeshColors = ReadonlyMap<string, string>;
