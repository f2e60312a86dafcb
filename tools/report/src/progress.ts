// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Says how far the page is, and lets the browser show that.
export async function sayProgress(text: string): Promise<void> {
  const place = document.getElementById("loading");
  if (!place) return;
  place.textContent = `Loading: ${text} ...`;
  await new Promise<void>((resolve) => {
    requestAnimationFrame(() => setTimeout(resolve));
    setTimeout(resolve, 100); // in a tab that is not shown
  });
}
