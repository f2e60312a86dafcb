// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What of report.json the page shows (docs/report.md says what each key is).
// musclewarp-report checks what the page cannot do without; the rest is
// optional here.

export interface PairRecord {
  a: string;
  b: string;
  triangle_pairs: number;
  vertices_inside: number;
  max_depth_mm: number;
}

export interface IntersectionsRecord {
  triangle_pairs: number;
  vertices_inside: number;
  max_depth_mm: number;
  self_pairs: number;
  pairs: PairRecord[];
}

// What a pose does to the shape of a muscle, where it is largest.
export interface ShapeRecord {
  max_stretch: number;
  max_stretch_along: number;
  max_stretch_across: number;
  min_area_ratio: number;
  max_area_ratio: number;
  max_bend_deg: number;
  max_change_mm: number;
  triangle_stretch?: StretchRecord; // earlier reports lack it
}

// How far the triangles of a muscle are stretched; quantiles are by area.
export interface StretchRecord {
  quantile_99: number;
  quantile_999: number;
  largest: number;
  area_beyond_1_6_mm2: number;
  largest_patch_mm2: number;
}

export interface AttachmentRecord {
  body: string;
  mean_drift_mm: number;
  max_drift_mm: number;
}

export interface MuscleRecord {
  name: string;
  volume_ratio: number;
  volume_error?: number; // earlier reports lack it
  min_gap_mm: number;
  max_displacement_mm: number;
  folded_triangles: number;
  iterations: number;
  stop_reason: string;
  line_lengths_mm: Record<string, number>;
  path_lengths_mm: Record<string, number>;
  attachments?: AttachmentRecord[]; // since 0.1.0
  shape?: ShapeRecord; // since 0.1.0
}

export interface StageRecord {
  name: string;
  ms: number;
  visits: number;
}

export interface FrameRecord {
  index: number;
  name: string;
  time: number;
  coordinates: Record<string, number>;
  wall_ms: number;
  certify_ms: number;
  stages?: StageRecord[]; // with --profile
  iterations: number;
  stop_reason: string;
  usable: boolean;
  muscles: MuscleRecord[];
  path_moment_arms_mm: Record<string, Record<string, number>>;
  intersections: IntersectionsRecord;
}

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
  motion?: { model: string; file: string; coordinates: Coordinate[] } | null;
  prepare: {
    wall_ms: number;
    notes?: string[];
    warnings: string[];
    muscles: MeshReport[];
    bones: MeshReport[];
  };
  rest: {
    intersections: IntersectionsRecord;
    after_initial_fix?: IntersectionsRecord;
  };
  warnings?: string[]; // since 0.1.0
  summary: {
    finished: boolean;
    usable: boolean;
    frames_planned?: number;
    stopped?: string | null;
  };
}

export function isClean(intersections: IntersectionsRecord): boolean {
  return (
    intersections.triangle_pairs === 0 && intersections.vertices_inside === 0
  );
}
