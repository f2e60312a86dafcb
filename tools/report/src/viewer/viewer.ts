// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The canvas: one pane a run, beside each other, or above each other where it
// is narrow.

import { Box3, Plane, Raycaster, Sphere, Vector2, Vector3 } from "three";

import { PageData } from "../data/run";
import { Moment } from "../data/timeline";
import { State, Store } from "../state";
import { LinkedCamera } from "./camera";
import { VertexScale, vertexScale } from "./coloring";
import { DrawnCanvas } from "./drawn_canvas";
import { RunScene } from "./run_scene";

interface Pane {
  left: number;
  bottom: number;
  width: number;
  height: number;
}

export interface Picked {
  name: string;
  text: string;
}

export class Viewer extends DrawnCanvas {
  readonly camera: LinkedCamera;
  readonly scenes: RunScene[];
  private readonly planes: Plane[] = [];
  private readonly plane = new Plane(new Vector3(1, 0, 0), 0);
  private readonly everything: Sphere; // of everything in all poses
  private readonly muscleBox: Box3; // the same of the muscles
  private state: State;
  private scale: VertexScale | null = null;

  constructor(
    canvas: HTMLCanvasElement,
    private readonly data: PageData,
    private readonly timeline: Moment[],
    colors: Map<string, string>,
    store: Store,
  ) {
    super(canvas);
    this.state = store.state;
    this.renderer.localClippingEnabled = true;
    this.renderer.autoClear = false;
    this.scenes = data.runs.map(
      (run) =>
        new RunScene(run, colors, this.planes, this.plane, this.renderer),
    );
    for (const scene of this.scenes) scene.addHeadlight(this.headlight());
    [this.everything, this.muscleBox] = this.measure();
    this.camera = new LinkedCamera(canvas, data.views, () => this.request());
    this.start();
    this.reset(false);
    store.subscribe((state) => {
      this.state = state;
      this.refresh();
    });
  }

  reset(fly = true): void {
    this.view("lateral", fly);
  }

  view(name: string, fly = true): void {
    this.camera.showFrom(name, this.muscleBox, fly);
  }

  // What is under a point of the canvas (CSS pixels), if anything.
  pick(x: number, y: number): Picked | null {
    const panes = this.panes();
    const { width, height } = this.canvas.getBoundingClientRect();
    const at = new Vector2(x / width, 1 - y / height);
    const i = panes.findIndex(
      (pane) =>
        at.x >= pane.left &&
        at.x <= pane.left + pane.width &&
        at.y >= pane.bottom &&
        at.y <= pane.bottom + pane.height,
    );
    const pose = this.timeline[this.state.moment].poses[i];
    if (i < 0 || pose === null) return null;
    const pane = panes[i];
    const caster = new Raycaster();
    caster.setFromCamera(
      new Vector2(
        (2 * (at.x - pane.left)) / pane.width - 1,
        (2 * (at.y - pane.bottom)) / pane.height - 1,
      ),
      this.camera.camera,
    );
    const { muscles, bones } = this.scenes[i];
    const meshes = [...muscles, ...bones].map((surface) => surface.mesh);
    const hit = caster
      .intersectObjects(
        meshes.filter((mesh) => mesh.visible && mesh.parent!.visible),
        false,
      )
      .find(
        ({ point }) =>
          this.planes.length === 0 || this.plane.distanceToPoint(point) >= 0,
      );
    if (!hit) return null;
    const muscle = muscles.find((surface) => surface.mesh === hit.object);
    const text =
      muscle && this.scale && hit.face
        ? this.scale.say(this.scale.values(muscle.muscle, pose)[hit.face.a])
        : "";
    return { name: hit.object.name, text };
  }

  // By run: parts of the canvas, from its lower left corner.
  panes(): Pane[] {
    const count = this.scenes.length;
    const { clientWidth, clientHeight } = this.canvas;
    const isWide = clientWidth >= clientHeight;
    return this.scenes.map((_, i) =>
      isWide
        ? { left: i / count, bottom: 0, width: 1 / count, height: 1 }
        : { left: 0, bottom: 1 - (i + 1) / count, width: 1, height: 1 / count },
    );
  }

  private measure(): [Sphere, Box3] {
    const all = new Box3();
    const muscles = new Box3();
    for (const { poses } of this.timeline) {
      poses.forEach((pose, i) => {
        if (pose === null) return;
        const scene = this.scenes[i];
        for (const bone of scene.bones) bone.setPose(pose);
        all.union(scene.box(pose));
        for (const { muscle } of scene.muscles) {
          muscles.union(new Box3().setFromArray(muscle.pointsAt(pose)));
        }
      });
    }
    return [all.getBoundingSphere(new Sphere()), muscles];
  }

  protected isPlaying(): boolean {
    return this.state.playing;
  }

  protected bounds(): Sphere {
    return this.everything;
  }

  protected aspect(width: number, height: number): number {
    const [pane] = this.panes();
    return (width * pane.width) / (height * pane.height);
  }

  protected drawScenes(size: Vector2): void {
    const { renderer } = this;
    renderer.setScissorTest(false);
    renderer.clear();
    renderer.setScissorTest(true);
    this.panes().forEach((pane, i) => {
      const rectangle = [
        pane.left * size.x,
        pane.bottom * size.y,
        pane.width * size.x,
        pane.height * size.y,
      ] as const;
      renderer.setViewport(...rectangle);
      renderer.setScissor(...rectangle);
      renderer.render(this.scenes[i].scene, this.camera.camera);
    });
  }

  protected updateScenes(): void {
    this.placePlane();
    this.scale = vertexScale(this.state.coloring, this.data.runs);
    const { poses } = this.timeline[this.state.moment];
    this.scenes.forEach((scene, i) =>
      scene.update(this.state, poses[i], this.scale, this.everything),
    );
  }

  private placePlane(): void {
    const { section, sectionPlace, sectionFlipped } = this.state;
    this.planes.length = 0;
    if (section === "off") return;
    const { center, radius } = this.everything;
    const toward = new Vector3(...this.data.views[section].toward_viewer);
    const height = toward.dot(center) + radius * (2 * sectionPlace - 1);
    // What is on the viewer's side is cut away.
    this.plane.set(toward.negate(), height);
    if (sectionFlipped) this.plane.negate();
    this.planes.push(this.plane);
  }
}
