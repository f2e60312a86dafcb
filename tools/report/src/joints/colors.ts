// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Colours of what joints are made of.

// Of coordinates, in the order in which they turn.
export const turnColors = ["#c2410c", "#15803d", "#4338ca"];

export const shapeColor = "#0e9aa7";
export const parentColor = "#a9c1e0"; // bones of the joint that is selected
export const childColor = "#f0b96b";
