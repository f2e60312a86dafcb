// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Colours of muscles and bones. Each of the muscles' is at least 20 (CIE76) from
// the others, the bones, white and the red of crossings, to normal eyes and as
// the colour-blind see them (protan, deutan and tritan by Machado et al. 2009).

const muscleColors = [
  "#cc6677",
  "#5c6ac4",
  "#f0bc6e",
  "#88d6f0",
  "#6e3a6e",
  "#a2a2f0",
  "#a26ea2",
  "#883a3a",
];

// Of the stages of a frame, in their order; they repeat.
export function stageColor(stage: number): string {
  const hue = (stage * 137.5) % 360; // the golden angle: neighbours differ
  return `hsl(${hue} 55% ${45 + 15 * (stage % 2)}%)`;
}

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
