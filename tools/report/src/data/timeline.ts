// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The moments the slider goes through: rest, then every frame that one of the
// runs has.

import { FrameFigures } from "./report";
import { Run } from "./run";

export interface Moment {
  name: string;
  frame: FrameFigures | null; // of the first run that has it; null at rest
  poses: (number | null)[]; // by run; null where a run does not have it
}

export function timelineOf(runs: Run[]): Moment[] {
  const moments: Moment[] = [
    { name: "rest", frame: null, poses: runs.map(() => 0) },
  ];
  const indices = new Set(
    runs.flatMap((run) => run.frames.map((frame) => frame.index)),
  );
  for (const index of [...indices].sort((a, b) => a - b)) {
    const places = runs.map((run) =>
      run.frames.findIndex((frame) => frame.index === index),
    );
    const first = places.findIndex((place) => place >= 0);
    const frame = runs[first].frames[places[first]];
    moments.push({
      name: frame.name,
      frame,
      poses: places.map((place) => (place < 0 ? null : place + 1)),
    });
  }
  return moments;
}
