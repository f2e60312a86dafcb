// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// A place on a mesh, which goes along with it.

import { Intersection, Mesh, Triangle, Vector3 } from "three";

export interface SurfacePlace {
  run: number;
  mesh: Mesh;
  corners: [number, number, number];
  weights: [number, number, number]; // of the corners, which sum to 1
}

function corner(mesh: Mesh, vertex: number): Vector3 {
  return new Vector3().fromBufferAttribute(
    mesh.geometry.getAttribute("position"),
    vertex,
  );
}

export function placeOnSurface(
  run: number,
  hit: Intersection,
): SurfacePlace | null {
  const { face, object } = hit;
  if (!face) return null;
  const mesh = object as Mesh;
  const corners: [number, number, number] = [face.a, face.b, face.c];
  const [a, b, c] = corners.map((vertex) => corner(mesh, vertex));
  const at = mesh.worldToLocal(hit.point.clone());
  const weights = Triangle.getBarycoord(at, a, b, c, new Vector3());
  return weights && { run, mesh, corners, weights: weights.toArray() };
}

// Where the place is now, mm.
export function positionOf({ mesh, corners, weights }: SurfacePlace): Vector3 {
  const sum = new Vector3();
  corners.forEach((vertex, k) =>
    sum.addScaledVector(corner(mesh, vertex), weights[k]),
  );
  return mesh.localToWorld(sum);
}

// The corner of the triangle that is nearest to the place.
export function nearestCorner({ corners, weights }: SurfacePlace): number {
  return corners[weights.indexOf(Math.max(...weights))];
}
