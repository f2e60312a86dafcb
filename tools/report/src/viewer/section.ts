// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// A plane that cuts everything on one side of it away. Where it cuts a mesh the
// cut is filled in the mesh's colour (half transparent, so that it shows what
// lies inside what) and outlined.

import {
  AlwaysStencilFunc,
  BackSide,
  BufferAttribute,
  BufferGeometry,
  Color,
  DecrementWrapStencilOp,
  DoubleSide,
  FrontSide,
  Group,
  IncrementWrapStencilOp,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  NotEqualStencilFunc,
  Plane,
  PlaneGeometry,
  ReplaceStencilOp,
  Sphere,
  WebGLRenderer,
} from "three";

import { segmentsInPlane } from "./outline";

// Counts, along each ray behind the plane, how often it leaves a mesh more than
// it enters it: not zero where the plane is inside the mesh.
function stencilMeshes(geometry: BufferGeometry, plane: Plane): Mesh[] {
  const counts = [
    { side: BackSide, operation: IncrementWrapStencilOp },
    { side: FrontSide, operation: DecrementWrapStencilOp },
  ] as const;
  return counts.map(({ side, operation }) => {
    const material = new MeshBasicMaterial({
      side,
      clippingPlanes: [plane],
      // Sorted with the caps, which are transparent.
      transparent: true,
      colorWrite: false,
      depthWrite: false,
      depthTest: false,
      stencilWrite: true,
      stencilFunc: AlwaysStencilFunc,
      stencilFail: operation,
      stencilZFail: operation,
      stencilZPass: operation,
    });
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false;
    return mesh;
  });
}

class Cut {
  readonly stencils: Mesh[];
  readonly cap: Mesh<PlaneGeometry, MeshBasicMaterial>;
  readonly outline: LineSegments<BufferGeometry, LineBasicMaterial>;

  constructor(
    readonly mesh: Mesh,
    color: string,
    order: number,
    plane: Plane,
    renderer: WebGLRenderer,
  ) {
    this.stencils = stencilMeshes(mesh.geometry, plane);
    mesh.add(...this.stencils);
    this.cap = new Mesh(
      new PlaneGeometry(1, 1),
      new MeshBasicMaterial({
        color,
        side: DoubleSide,
        transparent: true,
        opacity: 0.8,
        depthWrite: false,
        stencilWrite: true,
        stencilRef: 0,
        stencilFunc: NotEqualStencilFunc,
        stencilFail: ReplaceStencilOp,
        stencilZFail: ReplaceStencilOp,
        stencilZPass: ReplaceStencilOp,
      }),
    );
    this.cap.onAfterRender = () => renderer.clearStencil();
    this.outline = new LineSegments(
      new BufferGeometry(),
      new LineBasicMaterial({
        color: new Color(color).multiplyScalar(0.35),
        depthTest: false,
        transparent: true,
      }),
    );
    this.outline.frustumCulled = false;
    for (const stencil of this.stencils) stencil.renderOrder = order;
    this.cap.renderOrder = order + 0.5;
    this.outline.renderOrder = order + 0.6;
  }

  setVisible(visible: boolean): void {
    for (const object of [...this.stencils, this.cap, this.outline]) {
      object.visible = visible;
    }
  }
}

export class Section {
  readonly group = new Group();
  private readonly cuts: Cut[];

  constructor(
    private readonly plane: Plane,
    meshes: { mesh: Mesh; color: string }[],
    renderer: WebGLRenderer,
  ) {
    // One after the other: each cap clears the counts it was cut out by.
    this.cuts = meshes.map(
      ({ mesh, color }, i) => new Cut(mesh, color, i + 1, plane, renderer),
    );
    for (const cut of this.cuts) this.group.add(cut.cap, cut.outline);
  }

  // Follows the plane and the meshes.
  update(isOn: boolean, bounds: Sphere): void {
    this.group.visible = isOn;
    for (const cut of this.cuts) {
      cut.setVisible(isOn && cut.mesh.visible);
      if (!isOn || !cut.mesh.visible) continue;
      this.plane.projectPoint(bounds.center, cut.cap.position);
      cut.cap.scale.setScalar(2 * bounds.radius);
      cut.cap.lookAt(cut.cap.position.clone().sub(this.plane.normal));
      cut.outline.geometry.setAttribute(
        "position",
        new BufferAttribute(segmentsInPlane(cut.mesh, this.plane), 3),
      );
    }
  }
}
