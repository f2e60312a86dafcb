// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Colours of muscles and bones. The first eight are at least 20 (CIE76) from each
// other, all of them at least 12, to normal eyes and as the colour-blind see them
// (protan, deutan and tritan by Machado et al. 2009); so they are from bones,
// white, and the reds of crossings.
export const muscleColors = [
  "#cc6677",
  "#5c6ac4",
  "#f0bc6e",
  "#88d6f0",
  "#6e3a6e",
  "#a2a2f0",
  "#a26ea2",
  "#883a3a",
  "#3440a6",
  "#9ac4c4",
  "#5e3a88",
  "#945270",
  "#a6b87c",
  "#bee858",
  "#2e94f4",
  "#409a4c",
  "#a6ee9a",
  "#8e7cc4",
  "#caa69a",
  "#6a52d0",
  "#ca769a",
  "#b29ac4",
  "#82589a",
  "#f4a628",
];

// Of the stages of a frame, in their order; they repeat.
export function stageColor(stage: number): string {
  const hue = (stage * 137.5) % 360; // the golden angle: neighbours differ
  return `hsl(${hue} 55% ${45 + 15 * (stage % 2)}%)`;
}

export const boneColor = "#e6dcc3";
export const crossingColor = "#ff0000";

// "gluteus medius r" of "gluteus_medius_r".
export function readable(name: string): string {
  return name.replaceAll("_", " ");
}
