// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The camera of all panes, so that they always show the same view.

import { Box3, PerspectiveCamera, Sphere, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

import { View } from "../data/page_parts";
import { Place, cornersOf, placeToSee } from "./fit";

const flightMs = 400;

export class LinkedCamera {
  readonly camera = new PerspectiveCamera(25);
  private readonly controls: OrbitControls;
  // What was last asked for, if the visitor has not moved on since.
  private shown: { points: Float32Array; direction: Vector3 } | null = null;
  private flight: { from: Place; to: Place; start: number } | null = null;

  constructor(
    canvas: HTMLElement,
    private readonly views: Record<string, View>,
    private readonly requestRender: () => void,
  ) {
    this.camera.up.set(...views.anterior.up);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", requestRender);
    this.controls.addEventListener("start", () => {
      this.flight = null;
      this.shown = null;
    });
  }

  // A picture without width, as of a page that is not laid out yet, changes
  // nothing.
  setAspect(aspect: number): void {
    if (aspect === this.camera.aspect || !(aspect > 0)) return;
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
    const { shown } = this;
    if (!shown) return;
    this.show(shown.points, shown.direction, false);
    this.shown = shown;
  }

  // Shows the points (three coordinates each) from one of the views. They stay
  // in the picture when its shape changes, until the visitor moves the camera.
  showFrom(view: string, points: Float32Array, fly: boolean): void {
    const { toward_viewer, up } = this.views[view];
    // Straight along the axis it turns around, the controls would not know
    // which way is up.
    const direction = new Vector3(...toward_viewer)
      .addScaledVector(new Vector3(...up), -1e-3)
      .normalize();
    this.show(points, direction, fly);
    this.shown = { points, direction };
  }

  // Flies to a place, seen from `direction` or from where the camera is now.
  flyTo(box: Box3, direction?: Vector3): void {
    this.show(cornersOf(box), direction ?? this.direction(), true);
  }

  // Where the camera is, or will be when it has arrived.
  get place(): Place {
    return (
      this.flight?.to ?? {
        position: this.camera.position,
        target: this.controls.target,
      }
    );
  }

  moveTo({ position, target }: Place): void {
    this.flight = null;
    this.shown = null;
    this.camera.position.copy(position);
    this.controls.target.copy(target);
    this.controls.update();
    this.requestRender();
  }

  // The height of a CSS pixel at what the camera looks at, mm.
  pixelSize(height: number): number {
    const distance = this.camera.position.distanceTo(this.controls.target);
    return (2 * this.slope * distance) / height;
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
    this.shown = null;
    this.controls.rotateLeft(horizontal);
    this.controls.rotateUp(vertical);
    this.controls.update();
  }

  zoom(factor: number): void {
    this.shown = null;
    const offset = this.camera.position.clone().sub(this.controls.target);
    this.camera.position
      .copy(this.controls.target)
      .addScaledVector(offset, factor);
    this.controls.update();
  }

  private direction(): Vector3 {
    return this.camera.position.clone().sub(this.controls.target).normalize();
  }

  // The tangent of half the angle that the height of the picture takes.
  private get slope(): number {
    return Math.tan((this.camera.fov / 2) * (Math.PI / 180));
  }

  private show(points: Float32Array, direction: Vector3, fly: boolean): void {
    this.shown = null;
    const { up, aspect } = this.camera;
    const to = placeToSee(points, direction, up, this.slope, aspect);
    const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (fly && !calm) {
      const from = {
        position: this.camera.position.clone(),
        target: this.controls.target.clone(),
      };
      this.flight = { from, to, start: performance.now() };
    } else {
      this.moveTo(to);
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
