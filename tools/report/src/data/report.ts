// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What of report.json the page shows (docs/report.md says what each key is).
// musclewarp-report checks what the page cannot do without; the rest is
// optional here.

import type { RunFigures, SceneIntersections } from "./figures";

export type {
  FrameFigures,
  MuscleFigures,
  PairFigures,
  SceneIntersections,
} from "./figures";

export interface MeshReport {
  name: string;
  mesh?: string;
  defects: Record<string, number | boolean>;
  repairs: Record<string, number>;
}

export interface Coordinate {
  name: string;
  unit: string;
  moves: boolean;
}

export interface Report {
  scene: string;
  solver: string;
  contact: string;
  contact_options?: Record<string, string | number> | null;
  version: string;
  command: string;
  inputs_hash: string;
  options?: Record<string, string>;
  machine: { processor: string; cores: number; threads?: number };
  motion?: {
    model: string;
    file: string;
    coordinates: Coordinate[];
    design?: object | null;
  } | null;
  prepare: {
    wall_ms: number;
    notes?: string[];
    warnings: string[];
    muscles: MeshReport[];
    bones: MeshReport[];
  };
  rest: {
    intersections: SceneIntersections;
    after_initial_fix?: SceneIntersections;
  };
  warnings?: string[]; // since 0.1.0
  summary: RunFigures;
}

export function isClean(intersections: SceneIntersections): boolean {
  return (
    intersections.triangle_pairs === 0 && intersections.vertices_inside === 0
  );
}
