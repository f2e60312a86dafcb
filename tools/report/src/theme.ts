// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Light or dark: as the system has it, until the visitor chooses.

const system = matchMedia("(prefers-color-scheme: dark)");
const { dataset } = document.documentElement;
let isChosen = false;

function followSystem(): void {
  if (!isChosen) dataset.theme = system.matches ? "dark" : "light";
}

export function startTheme(): void {
  followSystem();
  system.addEventListener("change", followSystem);
}

export function toggleTheme(): void {
  isChosen = true;
  dataset.theme = dataset.theme === "dark" ? "light" : "dark";
}
