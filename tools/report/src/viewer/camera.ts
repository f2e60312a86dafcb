// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The camera of all panes, so that they always show the same view.

import { Box3, PerspectiveCamera, Sphere, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

import { View } from "../data/page_parts";

const flightMs = 400;
// Of what is shown, to the edge of the picture.
const margin = 1.05;

interface Place {
  position: Vector3;
  target: Vector3;
}

export class LinkedCamera {
  readonly camera = new PerspectiveCamera(25);
  private readonly controls: OrbitControls;
  private flight: { from: Place; to: Place; start: number } | null = null;

  constructor(
    canvas: HTMLElement,
    private readonly views: Record<string, View>,
    private readonly requestRender: () => void,
  ) {
    this.camera.up.set(...views.anterior.up);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", requestRender);
    this.controls.addEventListener("start", () => (this.flight = null));
  }

  setAspect(aspect: number): void {
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
  }

  // Shows the box from one of the views.
  showFrom(view: string, box: Box3, fly: boolean): void {
    const { toward_viewer, up } = this.views[view];
    // Straight along the axis it turns around, the controls would not know
    // which way is up.
    const direction = new Vector3(...toward_viewer)
      .addScaledVector(new Vector3(...up), -1e-3)
      .normalize();
    this.show(box, direction, fly);
  }

  // Flies to a place, seen from `direction` or from where the camera is now.
  flyTo(box: Box3, direction?: Vector3): void {
    this.show(box, direction ?? this.direction(), true);
  }

  // To be called before each picture; true while a flight goes on.
  advance(now: number): boolean {
    if (!this.flight) return false;
    const { from, to, start } = this.flight;
    const part = Math.min(1, (now - start) / flightMs);
    const eased = part * part * (3 - 2 * part);
    this.camera.position.lerpVectors(from.position, to.position, eased);
    this.controls.target.lerpVectors(from.target, to.target, eased);
    if (part === 1) this.flight = null;
    this.controls.update();
    return this.flight !== null;
  }

  turn(horizontal: number, vertical: number): void {
    this.controls.rotateLeft(horizontal);
    this.controls.rotateUp(vertical);
    this.controls.update();
  }

  zoom(factor: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    this.camera.position
      .copy(this.controls.target)
      .addScaledVector(offset, factor);
    this.controls.update();
  }

  private direction(): Vector3 {
    return this.camera.position.clone().sub(this.controls.target).normalize();
  }

  // From there all corners of the box are in the picture.
  private distanceTo(box: Box3, direction: Vector3): number {
    const center = box.getCenter(new Vector3());
    const right = new Vector3()
      .crossVectors(this.camera.up, direction)
      .normalize();
    const up = new Vector3().crossVectors(direction, right);
    const slope = Math.tan((this.camera.fov / 2) * (Math.PI / 180));
    let distance = 0;
    for (let i = 0; i < 8; ++i) {
      const corner = new Vector3(
        (i & 1 ? box.max : box.min).x,
        (i & 2 ? box.max : box.min).y,
        (i & 4 ? box.max : box.min).z,
      ).sub(center);
      const aside = Math.max(
        Math.abs(corner.dot(up)),
        Math.abs(corner.dot(right)) / this.camera.aspect,
      );
      distance = Math.max(distance, aside / slope + corner.dot(direction));
    }
    return distance;
  }

  private show(box: Box3, direction: Vector3, fly: boolean): void {
    const center = box.getCenter(new Vector3());
    const distance = margin * this.distanceTo(box, direction);
    const to = {
      position: center.clone().addScaledVector(direction, distance),
      target: center,
    };
    const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (fly && !calm) {
      const from = {
        position: this.camera.position.clone(),
        target: this.controls.target.clone(),
      };
      this.flight = { from, to, start: performance.now() };
    } else {
      this.flight = null;
      this.camera.position.copy(to.position);
      this.controls.target.copy(to.target);
      this.controls.update();
    }
    this.requestRender();
  }

  // Near and far around everything, which lies in the sphere.
  enclose(sphere: Sphere): void {
    const distance = this.camera.position.distanceTo(sphere.center);
    this.camera.near = Math.max(
      sphere.radius / 200,
      distance - 1.2 * sphere.radius,
    );
    this.camera.far = distance + 1.2 * sphere.radius;
    this.camera.updateProjectionMatrix();
  }
}
