// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The surface of a muscle, its triangles that cross others in red.

import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  DynamicDrawUsage,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Plane,
} from "three";

import { Muscle } from "../data/run";
import { crossingColor } from "../palette";
import { VertexScale, colorize } from "./coloring";
import { crossingOrder } from "./render_order";

export class MuscleSurface {
  readonly group = new Group();
  readonly mesh: Mesh<BufferGeometry, MeshLambertMaterial>;
  private readonly red: Mesh[];
  private readonly crossing: BufferAttribute;
  private readonly points: BufferAttribute;
  private readonly colors: BufferAttribute;

  constructor(
    readonly muscle: Muscle,
    readonly color: string,
    clippingPlanes: Plane[],
  ) {
    const geometry = new BufferGeometry();
    this.points = new BufferAttribute(muscle.pointsAt(0), 3);
    this.colors = new BufferAttribute(new Float32Array(3 * muscle.vertices), 3);
    for (const attribute of [this.points, this.colors]) {
      attribute.setUsage(DynamicDrawUsage);
    }
    geometry.setAttribute("position", this.points);
    geometry.setAttribute("color", this.colors);
    geometry.setIndex(new BufferAttribute(muscle.triangles, 1));
    this.mesh = new Mesh(
      geometry,
      new MeshLambertMaterial({ color, clippingPlanes }),
    );
    this.mesh.name = muscle.name;

    // Drawn on the surface, and faintly through whatever hides it.
    const redGeometry = new BufferGeometry();
    redGeometry.setAttribute("position", this.points);
    this.crossing = new BufferAttribute(
      new Uint32Array(muscle.triangles.length),
      1,
    );
    this.crossing.setUsage(DynamicDrawUsage);
    redGeometry.setIndex(this.crossing);
    const look = { color: crossingColor, side: DoubleSide, clippingPlanes };
    this.red = [
      new Mesh(
        redGeometry,
        new MeshBasicMaterial({
          ...look,
          polygonOffset: true,
          polygonOffsetFactor: -1,
          polygonOffsetUnits: -1,
        }),
      ),
      new Mesh(
        redGeometry,
        new MeshBasicMaterial({
          ...look,
          transparent: true,
          opacity: 0.35,
          depthTest: false,
          depthWrite: false,
        }),
      ),
    ];
    this.red[1].renderOrder = crossingOrder;
    this.group.add(this.mesh, ...this.red);
    // Bounds would have to follow every pose; there is little to cull.
    this.group.traverse((object) => (object.frustumCulled = false));
  }

  setPose(pose: number): void {
    this.points.copyArray(this.muscle.pointsAt(pose));
    this.points.needsUpdate = true;
    this.mesh.geometry.computeVertexNormals();
    this.mesh.geometry.boundingSphere = null; // made anew when picked
  }

  // Null: in the colour of its name.
  setColors(scale: VertexScale | null, pose: number): void {
    const { material } = this.mesh;
    const byVertex = scale !== null;
    if (byVertex) {
      colorize(scale, this.muscle, pose, this.colors.array as Float32Array);
      this.colors.needsUpdate = true;
    }
    if (material.vertexColors !== byVertex) {
      material.vertexColors = byVertex;
      material.needsUpdate = true;
    }
    material.color.set(byVertex ? "#ffffff" : this.color);
  }

  // The triangles to show in red, by number.
  setCrossing(triangles: Set<number>): void {
    let corners = 0;
    for (const t of triangles) {
      for (let k = 0; k < 3; ++k) {
        this.crossing.setX(corners++, this.muscle.triangles[3 * t + k]);
      }
    }
    this.crossing.clearUpdateRanges();
    this.crossing.addUpdateRange(0, corners);
    this.crossing.needsUpdate = true;
    this.red[0].geometry.setDrawRange(0, corners);
    for (const mesh of this.red) mesh.visible = corners > 0;
  }
}
