// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// A canvas that is drawn only when something has changed, in what resolution
// the machine can.

import {
  DirectionalLight,
  Sphere,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";

import { LinkedCamera } from "./camera";
import { Resolution } from "./resolution";

export abstract class DrawnCanvas {
  abstract readonly camera: LinkedCamera;
  protected readonly renderer: WebGLRenderer;
  private readonly lights: DirectionalLight[] = [];
  private readonly listeners: (() => void)[] = [];
  private isPending = false;
  private isStale = true; // the scenes, not only the view
  private readonly resolution = new Resolution(() => this.request());

  constructor(protected readonly canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({
      canvas,
      antialias: !this.resolution.isSoftware,
      alpha: true,
      stencil: true,
    });
  }

  request(): void {
    delete this.canvas.dataset.still;
    if (this.isPending) return;
    this.isPending = true;
    requestAnimationFrame((now) => this.draw(now));
  }

  // The same where more than the view has changed.
  refresh(): void {
    this.isStale = true;
    this.request();
  }

  // Calls the listener after each picture, from now on.
  onDrawn(listener: () => void): void {
    this.listeners.push(listener);
    this.request();
  }

  // Draws a picture with so many pixels to a CSS pixel, and hands it over
  // before the browser takes it away.
  takePicture(pixelRatio: number, use: (canvas: HTMLCanvasElement) => void) {
    const before = this.renderer.getPixelRatio();
    this.renderer.setPixelRatio(pixelRatio);
    this.updateScenes();
    this.drawScenes(this.renderer.getSize(new Vector2()));
    use(this.canvas);
    this.renderer.setPixelRatio(before);
    this.request();
  }

  // To be called once, when there is a camera.
  protected start(): void {
    new ResizeObserver(() => this.resize()).observe(this.canvas.parentElement!);
    this.canvas.addEventListener("webglcontextrestored", () => this.refresh());
    this.resize();
  }

  // A light from beside the viewer.
  protected headlight(): DirectionalLight {
    const light = new DirectionalLight("#ffffff", 1.8);
    this.lights.push(light);
    return light;
  }

  // Something moves by itself.
  protected abstract isPlaying(): boolean;
  // Brings the scenes up to date.
  protected abstract updateScenes(): void;
  // Everything lies in it.
  protected abstract bounds(): Sphere;
  // Of a picture in a canvas of this size (CSS pixels).
  protected abstract aspect(width: number, height: number): number;
  protected abstract drawScenes(size: Vector2): void;

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas.parentElement!;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.setAspect(this.aspect(clientWidth, Math.max(1, clientHeight)));
    this.request();
  }

  private draw(now: number): void {
    this.isPending = false;
    const pixelRatio = this.resolution.next(now, this.isPlaying());
    // Sets the size anew, which costs, even to what it is.
    if (this.renderer.getPixelRatio() !== pixelRatio) {
      this.renderer.setPixelRatio(pixelRatio);
    }
    if (this.isStale) this.updateScenes();
    this.isStale = false;
    const isFlying = this.camera.advance(now);
    this.camera.enclose(this.bounds());
    const { quaternion } = this.camera.camera;
    const side = new Vector3(-0.4, 0.5, 1).applyQuaternion(quaternion);
    for (const light of this.lights) light.position.copy(side);
    this.drawScenes(this.renderer.getSize(new Vector2()));
    for (const listener of this.listeners) listener();
    if (isFlying) this.request();
    // For those who take pictures: this one stays.
    const isStill = this.resolution.isFinal && !this.isPending;
    if (isStill) this.canvas.dataset.still = "";
  }
}
