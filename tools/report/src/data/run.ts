// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// A run as src/musclewarp/page/page_contents.cc hands it over. "Poses" are rest,
// then the frames. Lengths in mm.

import { MotionJson, motionFrom } from "./motion";
import { NumbersRef, PackedNumbers } from "./numbers";
import {
  BoneShape,
  BoneShapeJson,
  View,
  boneShapeFrom,
  readParts,
} from "./page_parts";
import { FrameFigures, PairFigures, Report } from "./report";

interface PolylinesJson {
  counts: number[];
  motion: MotionJson;
}

interface MuscleJson {
  name: string;
  vertices: number;
  triangles: NumbersRef;
  motion: MotionJson;
  gaps: NumbersRef;
  attached: { body: string; vertices: NumbersRef }[];
  lines: PolylinesJson & { names: string[] };
  fibres: PolylinesJson;
  tendons: PolylinesJson;
}

interface BoneJson extends BoneShapeJson {
  poses: number[][];
}

interface CrossingJson extends PairFigures {
  a_triangles: NumbersRef;
  b_triangles?: NumbersRef;
}

// Over the frames, by muscle and line: -dl/dq of the lines as carried, where
// one coordinate moves.
export interface CarriedMomentArms {
  coordinate: string;
  muscles: Record<string, Record<string, number[]>>;
}

interface RunJson {
  folder: string;
  report: Report;
  frames: FrameFigures[];
  step_mm: number;
  position_error_mm: number;
  gap_step_mm: number;
  contact_gap_mm: number;
  muscles: MuscleJson[];
  bones: BoneJson[];
  crossings: CrossingJson[][];
  carried_moment_arms_mm: CarriedMomentArms | null;
  warnings: string[];
}

// Someone's moment arm, in the sense in which the run counts the coordinate.
export interface MeasuredArm {
  coordinate: string;
  muscles: string[]; // of the run
  measured: string; // as its source has joint, coordinate and muscle
  turned: boolean; // the source counts the coordinate the other way
  angle: number | null; // degrees; null where the source tells none
  arm_mm: number;
  sd_mm: number | null;
  source: string;
  detail: string;
}

export interface Measured {
  arms: MeasuredArm[];
  note: string;
}

interface PageJson {
  views: Record<string, View>;
  measured: Measured | null;
  functions: PathTable | null;
  runs: RunJson[];
}

// Polylines one after the other, with the same numbers of points in each pose.
export interface Polylines {
  counts: number[];
  // Coordinates in a pose, three to a point.
  at(pose: number): Float32Array;
}

export interface Muscle {
  name: string;
  vertices: number;
  triangles: Uint32Array;
  pointsAt(pose: number): Float32Array;
  // To the nearest other mesh, negative inside it, at most 5.
  gapsAt(pose: number): Float32Array;
  // The areas that follow bodies; no vertex is in two.
  attached: { body: string; vertices: Int32Array }[];
  lines: Polylines & { names: string[] };
  fibres: Polylines;
  // Where lines go on to a bone without a mesh.
  tendons: Polylines;
}

export interface Bone extends BoneShape {
  poses: number[][]; // rows of 3 x 4 matrices, from rest
}

// Two meshes that cross in a pose: the triangles of those that are muscles.
export interface Crossing extends PairFigures {
  trianglesOfA: Int32Array;
  trianglesOfB?: Int32Array;
}

// Of errors at postures that a function does not know, mm.
type ErrorFigures = [mean: number, quantile95: number, largest: number];

// What src/musclewarp/page/path_table.cc says of a fit.json.
export interface PathTable {
  file: string;
  frames: number;
  frames_doubtful: number;
  frames_left_out: number;
  microseconds: number;
  bounds_mm: [length: number, arm: number, largestArm: number];
  rows: {
    name: string;
    muscle: string;
    coordinates: string[];
    terms: number;
    length_mm: ErrorFigures | null;
    arm_mm: ErrorFigures | null;
    lines: number;
    jumps: number;
    with_sign_change: number;
    within_bounds: boolean;
  }[];
}

export interface Run {
  folder: string;
  report: Report;
  frames: FrameFigures[];
  gapLimit: number; // up to which gaps were looked for, mm
  contactGap: number;
  positionError: number; // of muscles, by which they are off, at most; mm
  muscles: Muscle[];
  bones: Bone[];
  crossings: Crossing[][];
  carriedMomentArms: CarriedMomentArms | null;
  warnings: string[];
}

export interface PageData {
  views: Record<string, View>;
  measured: Measured | null;
  functions: PathTable | null;
  runs: Run[];
}

// Whether the frames are postures all over the ranges of the joints, which are
// no sequence in time.
export function isOfDesign(run: Run): boolean {
  return !!run.report.motion?.design;
}

// Numbers in rows of a pose each, scaled; unpacked when they are first asked for.
function rows(
  ref: NumbersRef,
  stride: number,
  scale: number,
  packed: PackedNumbers,
) {
  let numbers: Int32Array | null = null;
  return (pose: number): Float32Array => {
    numbers ??= packed.at(ref);
    const row = new Float32Array(stride);
    const first = pose * stride;
    for (let i = 0; i < stride; ++i) row[i] = numbers[first + i] * scale;
    return row;
  };
}

function polylinesFrom(json: PolylinesJson, packed: PackedNumbers): Polylines {
  return { counts: json.counts, at: motionFrom(json.motion, packed) };
}

function muscleFrom(
  json: MuscleJson,
  run: RunJson,
  packed: PackedNumbers,
): Muscle {
  return {
    name: json.name,
    vertices: json.vertices,
    triangles: new Uint32Array(packed.at(json.triangles)),
    pointsAt: motionFrom(json.motion, packed),
    gapsAt: rows(json.gaps, json.vertices, run.gap_step_mm, packed),
    attached: json.attached.map(({ body, vertices }) => ({
      body,
      vertices: packed.at(vertices),
    })),
    lines: { ...polylinesFrom(json.lines, packed), names: json.lines.names },
    fibres: polylinesFrom(json.fibres, packed),
    tendons: polylinesFrom(json.tendons, packed),
  };
}

function boneFrom(json: BoneJson, run: RunJson, packed: PackedNumbers): Bone {
  return { ...boneShapeFrom(json, run.step_mm, packed), poses: json.poses };
}

function runFrom(json: RunJson, packed: PackedNumbers): Run {
  return {
    folder: json.folder,
    report: json.report,
    frames: json.frames,
    gapLimit: 100 * json.gap_step_mm,
    contactGap: json.contact_gap_mm,
    positionError: json.position_error_mm,
    muscles: json.muscles.map((muscle) => muscleFrom(muscle, json, packed)),
    bones: json.bones.map((bone) => boneFrom(bone, json, packed)),
    crossings: json.crossings.map((pairs) =>
      pairs.map((pair) => ({
        ...pair,
        trianglesOfA: packed.at(pair.a_triangles),
        trianglesOfB: pair.b_triangles && packed.at(pair.b_triangles),
      })),
    ),
    carriedMomentArms: json.carried_moment_arms_mm,
    warnings: json.warnings,
  };
}

export async function readPageData(): Promise<PageData> {
  const { json, packed } = await readParts<PageJson>("runs");
  return {
    views: json.views,
    measured: json.measured,
    functions: json.functions,
    runs: json.runs.map((run) => runFrom(run, packed)),
  };
}
