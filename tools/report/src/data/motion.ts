// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Positions in all poses, packed by src/musclewarp/page/packed_motion.cc: those
// of the first pose and a weighted sum of modes, corrected where that is not
// near enough.

import { NumbersRef, PackedNumbers } from "./numbers";

export interface MotionJson {
  coordinates: number; // in a pose
  step_mm: number; // of the first pose, and of modes
  weight_step: number;
  correction_step_mm: number;
  first: NumbersRef;
  modes: number;
  shapes: NumbersRef; // by mode, then coordinate
  weights: NumbersRef; // by mode, then pose after the first
  // Pairs: how far from the coordinate corrected before (or from the first
  // coordinate), and by how many steps.
  corrections: NumbersRef;
  corrections_by_pose: NumbersRef;
}

interface Unpacked {
  first: Int32Array;
  shapes: Float32Array[]; // mm
  weights: Int32Array;
  corrections: Int32Array;
  begins: number[]; // of a pose's corrections, in pairs
}

function scaled(numbers: Int32Array, step: number): Float32Array {
  const result = new Float32Array(numbers.length);
  for (let i = 0; i < numbers.length; ++i) result[i] = numbers[i] * step;
  return result;
}

function unpack(json: MotionJson, packed: PackedNumbers): Unpacked {
  const { coordinates } = json;
  const shapes = packed.at(json.shapes);
  const begins = [0];
  for (const count of packed.at(json.corrections_by_pose)) {
    begins.push(begins.at(-1)! + count);
  }
  return {
    first: packed.at(json.first),
    shapes: Array.from({ length: json.modes }, (_, mode) =>
      scaled(
        shapes.subarray(mode * coordinates, (mode + 1) * coordinates),
        json.step_mm,
      ),
    ),
    weights: packed.at(json.weights),
    corrections: packed.at(json.corrections),
    begins,
  };
}

// Returns what gives the coordinates in a pose, mm, unpacked when that is first
// asked for.
export function motionFrom(
  json: MotionJson,
  packed: PackedNumbers,
): (pose: number) => Float32Array {
  let unpacked: Unpacked | null = null;
  return (pose) => {
    unpacked ??= unpack(json, packed);
    const { first, shapes, weights, corrections, begins } = unpacked;
    const points = scaled(first, json.step_mm);
    if (pose === 0) return points;
    const poses = begins.length - 1; // after the first
    shapes.forEach((shape, mode) => {
      const weight = weights[mode * poses + pose - 1] * json.weight_step;
      for (let i = 0; i < points.length; ++i) points[i] += weight * shape[i];
    });
    let at = 0;
    for (let pair = begins[pose - 1]; pair < begins[pose]; ++pair) {
      at += corrections[2 * pair];
      points[at] += corrections[2 * pair + 1] * json.correction_step_mm;
    }
    return points;
  };
}
