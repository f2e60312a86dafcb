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

import { BoneShape } from "../data/page_parts";
import { Bone } from "../data/run";
import { poseMatrix } from "./extent";

export type BoneMesh = Mesh<BufferGeometry, MeshLambertMaterial>;

export function boneMesh(
  bone: BoneShape,
  color: string,
  clippingPlanes: Plane[],
): BoneMesh {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(bone.points, 3));
  geometry.setIndex(new BufferAttribute(bone.triangles, 1));
  geometry.computeVertexNormals();
  const mesh = new Mesh(
    geometry,
    new MeshLambertMaterial({ color, clippingPlanes }),
  );
  mesh.name = bone.name;
  mesh.matrixAutoUpdate = false;
  return mesh;
}

export class BoneSurface {
  readonly mesh: BoneMesh;

  constructor(
    readonly bone: Bone,
    readonly color: string,
    clippingPlanes: Plane[],
  ) {
    this.mesh = boneMesh(bone, color, clippingPlanes);
  }

  setPose(pose: number): void {
    this.mesh.matrix.copy(poseMatrix(this.bone, pose));
    this.mesh.updateMatrixWorld(true);
  }
}
