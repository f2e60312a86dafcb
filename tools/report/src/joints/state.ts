// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What the visitor has chosen on the page of joints.

import { MeshLook } from "../state";
import { JointsFile, coordinatesOf } from "./data";
import { Values } from "./kinematics";

export interface JointsState extends MeshLook {
  selected: string | null; // a joint
  values: Values;
  shapes: boolean;
  axes: boolean;
}

export function scanValues(file: JointsFile): Values {
  return Object.fromEntries(
    coordinatesOf(file).map(({ name, scan_deg }) => [name, scan_deg]),
  );
}

// Ranges of the sliders have the pose of the scan in them.
export function rangeOf(coordinate: {
  range_deg: [number, number];
  scan_deg: number;
}): [number, number] {
  const { range_deg, scan_deg } = coordinate;
  return [Math.min(range_deg[0], scan_deg), Math.max(range_deg[1], scan_deg)];
}

export function initialJointsState(file: JointsFile): JointsState {
  return {
    selected: null,
    values: scanValues(file),
    shapes: true,
    axes: true,
    opacity: {},
    hidden: {},
  };
}
