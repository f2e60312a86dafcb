// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What is drawn over what, of all that is transparent. Section planes take the
// orders from 1 on, one a mesh.
export const crossingOrder = 1000;
export const lineOrder = 1001;
