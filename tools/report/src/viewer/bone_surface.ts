// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The surface of a bone: loaded once, moved by a matrix.

import {
  BufferAttribute,
  BufferGeometry,
  Mesh,
  MeshLambertMaterial,
  Plane,
} from "three";

import { Bone } from "../data/run";

export class BoneSurface {
  readonly mesh: Mesh<BufferGeometry, MeshLambertMaterial>;

  constructor(
    readonly bone: Bone,
    readonly color: string,
    clippingPlanes: Plane[],
  ) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(bone.points, 3));
    geometry.setIndex(new BufferAttribute(bone.triangles, 1));
    geometry.computeVertexNormals();
    this.mesh = new Mesh(
      geometry,
      new MeshLambertMaterial({ color, clippingPlanes }),
    );
    this.mesh.name = bone.name;
    this.mesh.matrixAutoUpdate = false;
  }

  setPose(pose: number): void {
    const rows = [...this.bone.poses[pose], 0, 0, 0, 1];
    this.mesh.matrix.fromArray(rows).transpose(); // three.js has columns
    this.mesh.updateMatrixWorld(true);
  }
}
