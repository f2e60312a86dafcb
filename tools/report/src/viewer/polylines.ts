// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Lines of action and fibres.

import {
  Group,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  Plane,
} from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";

import { Polylines } from "../data/run";
import { lineOrder } from "./render_order";

// Points of polylines, doubled where two segments meet.
function segments(polylines: Polylines, pose: number): Float32Array {
  const points = polylines.at(pose);
  const pieces = polylines.counts.reduce(
    (sum, n) => sum + Math.max(0, n - 1),
    0,
  );
  const ends = new Float32Array(6 * pieces);
  let from = 0;
  let to = 0;
  for (const count of polylines.counts) {
    for (let i = 0; i + 1 < count; ++i, to += 6) {
      ends.set(points.subarray(from + 3 * i, from + 3 * i + 6), to);
    }
    from += 3 * count;
  }
  return ends;
}

// How far the ends of these segments are from the last point of their polyline,
// mm: dashes of polylines that meet there lie on each other.
function distancesFromLast(
  { counts }: Polylines,
  ends: Float32Array,
): Float32Array {
  const distances = new Float32Array(ends.length / 3);
  let first = 0;
  for (const count of counts) {
    const last = first + Math.max(0, count - 1);
    let along = 0;
    for (let s = last - 1; s >= first; --s) {
      const [ax, ay, az, bx, by, bz] = ends.subarray(6 * s, 6 * s + 6);
      distances[2 * s + 1] = along;
      along += Math.hypot(bx - ax, by - ay, bz - az);
      distances[2 * s] = along;
    }
    first = last;
  }
  return distances;
}

export interface LineLook {
  color: string;
  width: number; // pixels
  // Seen through what is in front, with a light rim to stand out from it.
  isOnTop?: boolean;
  // Otherwise: drawn as if it were nearer to the viewer, mm. It is seen through
  // as much of the muscle that it is in, and hidden by what is farther in front.
  lift?: number;
  isDashed?: boolean;
}

const dash = 4; // mm, and as much between dashes

const rimColor = "#ffffff";
const rimWidth = 1.5;

// Depth is that of a point nearer to the viewer.
const liftedDepth = `gl_Position = clip;
  vec4 lifted = projectionMatrix *
    vec4(0.0, 0.0, (position.y < 0.5 ? start : end).z + lift, 1.0);
  if (lifted.w > 0.0)
    gl_Position.z = max(lifted.z / lifted.w, -1.0) * clip.w;`;

function lineMaterial(
  look: LineLook,
  linewidth: number,
  clippingPlanes: Plane[],
): LineMaterial {
  const { color, lift = 0, isOnTop = false, isDashed = false } = look;
  const material = new LineMaterial({
    color,
    linewidth,
    transparent: isOnTop,
    depthTest: !isOnTop,
    clippingPlanes,
    dashed: isDashed,
    dashSize: dash,
    gapSize: dash,
  });
  material.uniforms.lift = { value: lift };
  material.vertexShader =
    "uniform float lift;\n" +
    material.vertexShader.replace("gl_Position = clip;", liftedDepth);
  return material;
}

export class PolylineObject {
  readonly object = new Group();
  private readonly geometry = new LineSegmentsGeometry();

  constructor(
    private readonly polylines: Polylines,
    private readonly look: LineLook,
    clippingPlanes: Plane[],
  ) {
    const add = (look: LineLook, width: number, renderOrder: number) => {
      const line = new LineSegments2(
        this.geometry,
        lineMaterial(look, width, clippingPlanes),
      );
      line.frustumCulled = false;
      line.renderOrder = renderOrder;
      this.object.add(line);
    };
    const { isOnTop, width } = look;
    if (isOnTop) {
      add({ ...look, color: rimColor }, width + 2 * rimWidth, lineOrder);
    }
    add(look, width, isOnTop ? lineOrder + 1 : 0);
  }

  get isEmpty(): boolean {
    return this.polylines.counts.length === 0;
  }

  setPose(pose: number): void {
    if (this.isEmpty) return;
    const ends = segments(this.polylines, pose);
    this.geometry.setPositions(ends);
    if (!this.look.isDashed) return;
    const distances = new InstancedInterleavedBuffer(
      distancesFromLast(this.polylines, ends),
      2,
      1,
    );
    for (const [name, offset] of [
      ["instanceDistanceStart", 0],
      ["instanceDistanceEnd", 1],
    ] as const) {
      this.geometry.setAttribute(
        name,
        new InterleavedBufferAttribute(distances, 1, offset),
      );
    }
  }
}
