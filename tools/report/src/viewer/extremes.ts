// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Few points that stand for many where only their extent matters.

const axis = [-1, 0, 1];
// To the faces, edges and corners of a cube.
const directions = axis
  .flatMap((x) => axis.flatMap((y) => axis.map((z) => [x, y, z])))
  .filter((direction) => direction.some((each) => each !== 0));

// The farthest of the points (three coordinates each) in each direction.
export function extremesOf(points: Float32Array): Float32Array {
  const extremes = new Float32Array(3 * directions.length);
  directions.forEach(([x, y, z], i) => {
    let farthest = 0;
    let most = -Infinity;
    for (let p = 0; p < points.length; p += 3) {
      const height = x * points[p] + y * points[p + 1] + z * points[p + 2];
      if (height <= most) continue;
      most = height;
      farthest = p;
    }
    extremes.set(points.subarray(farthest, farthest + 3), 3 * i);
  });
  return extremes;
}

export function joined(parts: Float32Array[]): Float32Array {
  const all = new Float32Array(
    parts.reduce((sum, part) => sum + part.length, 0),
  );
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
