// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What report.json says of frames: docs/report.md explains it. Written by
// scripts/generated.py from the lists of src/musclewarp/figures.

export interface RunFigures {
  frames: number;
  frames_clean: number;
  worst_volume_error: number;
  worst_folded_triangles: number;
  wall_ms_per_frame_median: number;
  frames_planned: number;
  finished: boolean;
  stopped: string | null;
  usable: boolean;
}

export interface FrameFigures {
  index: number;
  reached_from?: number | null;
  name: string;
  time: number;
  coordinates: Record<string, number>;
  wall_ms: number;
  solve_ms: number;
  certify_ms: number;
  moment_arms_ms: number;
  pose_steps: number;
  iterations: number;
  stop_reason: string;
  usable: boolean;
  shortcomings: string[];
  bone_overlaps: BoneOverlap[];
  delivered_crossings: DeliveredCrossing[];
  muscles: MuscleFigures[];
  path_moment_arms_mm: Record<string, Record<string, number>>;
  moment_arms_converged: boolean;
  intersections: SceneIntersections;
  gaps: MeshGap[];
  smallest_gap_mm: number | null;
  stages?: StageTime[];
}

export interface MuscleFigures {
  name: string;
  volume_mm3: number;
  volume_ratio: number;
  volume_error: number;
  max_step_mm: number;
  max_displacement_mm: number;
  min_gap_mm: number;
  folded_triangles: number;
  self_pairs: number;
  max_bone_push_mm?: number;
  max_contact_displacement_mm: number;
  mean_contact_displacement_mm: number;
  depth_without_contact_mm: number;
  torn_patch_mm2: number;
  torn_patch_place_mm: [number, number, number];
  push_depth_mm: number;
  pushed_by: string[];
  attachments: AttachmentDrift[];
  shape: ShapeMeasures;
  iterations: number;
  solve_ms: number;
  initial_energy_mm2: number;
  final_energy_mm2: number;
  stop_reason: string;
  line_lengths_mm: Record<string, number>;
  path_lengths_mm: Record<string, number>;
  fibre_lengths_mm: number[];
  fibre_stretch_by_fifths: number[];
  line_moment_arms_mm: Record<string, Record<string, number>>;
  fibre_moment_arms_mm: Record<string, number[]>;
}

export interface ShapeMeasures {
  max_stretch: number;
  max_stretch_along: number;
  max_stretch_across: number;
  stretch_place_mm: [number, number, number];
  min_area_ratio: number;
  max_area_ratio: number;
  max_bend_deg: number;
  bend_place_mm: [number, number, number];
  max_change_mm: number;
  change_place_mm: [number, number, number];
  triangle_stretch: StretchMeasures;
}

export interface StretchMeasures {
  mean: number;
  quantile_99: number;
  quantile_999: number;
  largest: number;
  largest_place_mm: [number, number, number];
  area_beyond_1_6_mm2: number;
  area_beyond_2_mm2: number;
  largest_patch_mm2: number;
  patch_place_mm: [number, number, number];
}

export interface AttachmentDrift {
  body: string;
  vertices: number;
  mean_drift_mm: number;
  max_drift_mm: number;
  place_mm: [number, number, number];
}

export interface SceneIntersections {
  triangle_pairs: number;
  vertices_inside: number;
  max_depth_mm: number;
  self_pairs: number;
  exempt_pairs: number;
  pairs: PairFigures[];
}

export interface PairFigures {
  a: string;
  b: string;
  triangle_pairs: number;
  vertices_inside: number;
  max_depth_mm: number;
  exempt_pairs: number;
}

export interface MeshGap {
  a: string;
  b: string;
  at_least_mm: number;
  at_most_mm: number;
  place_mm: [number, number, number];
}

export interface DeliveredCrossing {
  muscle: string;
  bone: string;
  triangle_pairs: number;
  pieces_inside: number;
  place_mm: [number, number, number];
}

export interface BoneOverlap {
  a: string;
  b: string;
  depth_mm: number;
  place_mm: [number, number, number];
}

export interface StageTime {
  name: string;
  ms: number;
  visits: number;
}

export interface SurfaceReconstruction {
  reason: string;
  volume_before_mm3: number;
  volume_after_mm3: number;
  lost_area_mm2: number;
  place_mm: [number, number, number];
  farthest_mm: number;
  gone_area_mm2: number;
  lost_extent_mm: number;
  lost_attachments: string[];
}
