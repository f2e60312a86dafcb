// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The moments the slider goes through: rest, then every frame that one of the
// runs has.

import { FrameFigures } from "./report";
import { Run } from "./run";

export interface Moment {
  name: string; // by its coordinates where few move, or as the motion has it
  frame: FrameFigures | null; // of the first run that has it; null at rest
  poses: (number | null)[]; // by run; null where a run does not have it
}

const mostCoordinatesInName = 3;

// Names and units.
export function movingCoordinates(runs: Run[]): Map<string, string> {
  return new Map(
    runs
      .flatMap((run) => run.report.motion?.coordinates ?? [])
      .filter(({ moves }) => moves)
      .map(({ name, unit }) => [name, unit]),
  );
}

// "hip_flexion_r 5 degrees", or the name that the frame has in its motion.
export function frameName(
  frame: FrameFigures,
  moving: Map<string, string>,
): string {
  const values = [...moving].filter(([name]) => name in frame.coordinates);
  if (values.length === 0 || values.length > mostCoordinatesInName) {
    return frame.name;
  }
  return values
    .map(([name, unit]) => {
      const value = Number(frame.coordinates[name].toFixed(2));
      return `${name} ${value} ${unit}`.trim();
    })
    .join(", ");
}

export function timelineOf(runs: Run[]): Moment[] {
  const moments: Moment[] = [
    { name: "rest", frame: null, poses: runs.map(() => 0) },
  ];
  const moving = movingCoordinates(runs);
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
      name: frameName(frame, moving),
      frame,
      poses: places.map((place) => (place < 0 ? null : place + 1)),
    });
  }
  return moments;
}
