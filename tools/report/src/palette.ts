// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Colours of muscles and bones: P. Tol's "muted" scheme, made for the
// colour-blind, lightened a little so that it stands on dark pages as well.

const muscleColors = [
  "#cc6677",
  "#5c6ac4",
  "#ddcc77",
  "#2f9e5b",
  "#88ccee",
  "#a3457a",
  "#44aa99",
  "#aaaa44",
  "#b06ac2",
  "#e39256",
];

export const boneColor = "#e6dcc3";
export const crossingColor = "#ff0000";

// By order of first appearance: the same name has the same colour in all runs.
export function colorsByName(
  runs: { muscles: { name: string }[]; bones: { name: string }[] }[],
): Map<string, string> {
  const colors = new Map<string, string>();
  for (const run of runs) {
    for (const { name } of run.muscles) {
      if (!colors.has(name)) {
        colors.set(name, muscleColors[colors.size % muscleColors.length]);
      }
    }
  }
  for (const run of runs) {
    for (const { name } of run.bones) {
      if (!colors.has(name)) colors.set(name, boneColor);
    }
  }
  return colors;
}

// "gluteus medius r" of "gluteus_medius_r".
export function readable(name: string): string {
  return name.replaceAll("_", " ");
}
