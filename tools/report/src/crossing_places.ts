// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Where meshes cross: the crossing triangles of a pair, grouped by the vertices
// they share.

import { Crossing, Run } from "./data/run";

export interface CrossingPlace {
  a: string;
  b: string;
  triangles: number; // of a
  center: [number, number, number];
  radius: number; // mm
  normal: [number, number, number]; // of a there, about
}

// Triangles in groups that are connected by vertices.
function groups(triangles: Int32Array, corners: Uint32Array): number[][] {
  const parent = new Map<number, number>();
  const root = (v: number): number => {
    let at = v;
    while (parent.get(at) !== at) at = parent.get(at)!;
    parent.set(v, at);
    return at;
  };
  for (const t of triangles) {
    const vertices = corners.subarray(3 * t, 3 * t + 3);
    for (const v of vertices) if (!parent.has(v)) parent.set(v, v);
    for (const v of vertices) parent.set(root(v), root(vertices[0]));
  }
  const byRoot = new Map<number, number[]>();
  for (const t of triangles) {
    const key = root(corners[3 * t]);
    if (!byRoot.has(key)) byRoot.set(key, []);
    byRoot.get(key)!.push(t);
  }
  return [...byRoot.values()];
}

function placeOf(
  crossing: Crossing,
  triangles: number[],
  corners: Uint32Array,
  points: Float32Array,
): CrossingPlace {
  const center = [0, 0, 0];
  const normal = [0, 0, 0];
  for (const t of triangles) {
    const [a, b, c] = [0, 1, 2].map((k) => {
      const v = 3 * corners[3 * t + k];
      return [points[v], points[v + 1], points[v + 2]];
    });
    for (let i = 0; i < 3; ++i) {
      center[i] += (a[i] + b[i] + c[i]) / (3 * triangles.length);
      const [j, k] = [(i + 1) % 3, (i + 2) % 3];
      normal[i] +=
        (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
    }
  }
  let radius = 0;
  for (const t of triangles) {
    const v = 3 * corners[3 * t];
    radius = Math.max(
      radius,
      Math.hypot(
        points[v] - center[0],
        points[v + 1] - center[1],
        points[v + 2] - center[2],
      ),
    );
  }
  return {
    a: crossing.a,
    b: crossing.b,
    triangles: triangles.length,
    center: center as CrossingPlace["center"],
    radius,
    normal: normal as CrossingPlace["normal"],
  };
}

// Largest first.
export function crossingPlaces(run: Run, pose: number): CrossingPlace[] {
  return run.crossings[pose]
    .flatMap((crossing) => {
      const muscle = run.muscles.find(({ name }) => name === crossing.a)!;
      const points = muscle.pointsAt(pose);
      return groups(crossing.trianglesOfA, muscle.triangles).map((triangles) =>
        placeOf(crossing, triangles, muscle.triangles, points),
      );
    })
    .sort((p, q) => q.triangles - p.triangles);
}
