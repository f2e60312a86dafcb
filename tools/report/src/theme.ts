// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Light or dark: as the system has it, until the visitor chooses.

export function isDark(): boolean {
  const chosen = document.documentElement.dataset.theme;
  return chosen
    ? chosen === "dark"
    : matchMedia("(prefers-color-scheme: dark)").matches;
}

export function toggleTheme(): void {
  document.documentElement.dataset.theme = isDark() ? "light" : "dark";
}
