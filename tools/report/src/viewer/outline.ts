// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What a plane cuts of a mesh: the outline and its area.

import { Mesh, Plane, Vector3 } from "three";

export interface Outline {
  name: string;
  color: string;
  segments: Float32Array; // two ends each, in space, mm
  area: number; // mm2
}

interface Cut {
  ends: number[]; // of the segments, three coordinates each
  edges: number[]; // of the mesh on which the ends lie
}

// Each segment goes from the edge on which the triangle, gone round, rises
// through the plane to that on which it falls, so that closed surfaces give
// closed outlines with one sense.
function cut(
  points: ArrayLike<number>,
  triangles: ArrayLike<number>,
  { normal, constant }: Plane,
): Cut {
  const vertices = points.length / 3;
  const heights = new Float64Array(vertices);
  for (let v = 0; v < vertices; ++v) {
    heights[v] =
      normal.x * points[3 * v] +
      normal.y * points[3 * v + 1] +
      normal.z * points[3 * v + 2] +
      constant;
  }
  const ends: number[] = [];
  const edges: number[] = [];
  for (let t = 0; t < triangles.length; t += 3) {
    const at = ends.length;
    for (let k = 0; k < 3; ++k) {
      const [a, b] = [triangles[t + k], triangles[t + ((k + 1) % 3)]];
      const rises = heights[b] >= 0;
      if (heights[a] >= 0 === rises) continue;
      const part = heights[a] / (heights[a] - heights[b]);
      const end = rises ? 0 : 1;
      edges[at / 3 + end] = Math.min(a, b) * vertices + Math.max(a, b);
      for (let c = 0; c < 3; ++c) {
        const from = points[3 * a + c];
        ends[at + 3 * end + c] = from + part * (points[3 * b + c] - from);
      }
    }
  }
  return { ends, edges };
}

// Two ends of each segment in which a plane cuts triangles.
export function cutSegments(
  points: ArrayLike<number>,
  triangles: ArrayLike<number>,
  plane: Plane,
): Float32Array {
  return new Float32Array(cut(points, triangles, plane).ends);
}

// The same, parted into outlines that hang together. Precondition: the surface
// is closed, and no edge has more than two triangles.
export function cutPieces(
  points: ArrayLike<number>,
  triangles: ArrayLike<number>,
  plane: Plane,
): Float32Array[] {
  const { ends, edges } = cut(points, triangles, plane);
  const beginning = new Map<number, number>(); // at an edge: a segment
  for (let i = 0; i < edges.length; i += 2) beginning.set(edges[i], i);
  const pieces: Float32Array[] = [];
  const isTaken = new Set<number>();
  for (let start = 0; start < edges.length; start += 2) {
    const piece: number[] = [];
    let at: number | undefined = start;
    while (at !== undefined && !isTaken.has(at)) {
      isTaken.add(at);
      piece.push(...ends.slice(3 * at, 3 * at + 6));
      at = beginning.get(edges[at + 1]);
    }
    if (piece.length > 0) pieces.push(new Float32Array(piece));
  }
  return pieces;
}

// Within the outline of a closed surface: inside holes once less.
export function areaWithin(segments: Float32Array, normal: Vector3): number {
  const [p, q] = [new Vector3(), new Vector3()];
  // Near the origin of the numbers, few digits are lost.
  const origin = new Vector3().fromArray(segments);
  const sum = new Vector3();
  for (let i = 0; i < segments.length; i += 6) {
    p.fromArray(segments, i).sub(origin);
    q.fromArray(segments, i + 3).sub(origin);
    sum.add(p.cross(q));
  }
  return segments.length > 0 ? Math.abs(sum.dot(normal)) / 2 : 0;
}

function inSpace(mesh: Mesh): Float32Array {
  const points = mesh.geometry.getAttribute("position");
  const place = new Vector3();
  const world = new Float32Array(3 * points.count);
  for (let v = 0; v < points.count; ++v) {
    place.fromBufferAttribute(points, v).applyMatrix4(mesh.matrixWorld);
    place.toArray(world, 3 * v);
  }
  return world;
}

export function segmentsInPlane(mesh: Mesh, plane: Plane): Float32Array {
  return cutSegments(inSpace(mesh), mesh.geometry.getIndex()!.array, plane);
}

export function outlineOf(mesh: Mesh, color: string, plane: Plane): Outline {
  const segments = segmentsInPlane(mesh, plane);
  return {
    name: mesh.name,
    color,
    segments,
    area: areaWithin(segments, plane.normal),
  };
}
