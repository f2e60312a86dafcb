// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The canvas: one pane a run, beside each other, or above each other where it
// is narrow.

import { Plane, Raycaster, Sphere, Vector2, Vector3 } from "three";

import { PageData } from "../data/run";
import { Moment } from "../data/timeline";
import { MeshColors } from "../mesh_colors";
import { SectionAxis, State, Store } from "../state";
import { LinkedCamera } from "./camera";
import { vertexScale } from "./coloring";
import { DrawnCanvas } from "./drawn_canvas";
import { Extent, rangeAlong } from "./extent";
import { joined } from "./extremes";
import { Outline } from "./outline";
import { RunScene } from "./run_scene";
import { SurfacePlace, nearestCorner, placeOnSurface } from "./surface_place";

interface Pane {
  left: number;
  bottom: number;
  width: number;
  height: number;
}

export class Viewer extends DrawnCanvas {
  readonly camera: LinkedCamera;
  readonly scenes: RunScene[];
  private readonly planes: Plane[] = [];
  private readonly plane = new Plane(new Vector3(1, 0, 0), 0);
  private readonly extent: Extent;
  private readonly everything: Sphere;
  private state: State;

  constructor(
    canvas: HTMLCanvasElement,
    private readonly data: PageData,
    private readonly timeline: Moment[],
    colors: MeshColors,
    private readonly store: Store,
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
    this.extent = new Extent(data, timeline);
    this.everything = this.extent.sphere();
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

  // Shows all that is not hidden, as large as the canvas allows.
  view(name: string, fly = true): void {
    this.camera.showFrom(name, this.kept(), fly);
  }

  // Turns a section on, in the middle of what is seen, and faces it.
  startSection(section: SectionAxis): void {
    if (section === "off") return this.store.set({ section });
    const [lowest, highest] = this.sectionRange(section);
    this.store.set({ section, sectionPlace: (lowest + highest) / 2 });
    this.view(section);
  }

  // Of what is seen, along the axis that points to the view's viewer, mm.
  sectionRange(section: Exclude<SectionAxis, "off">): [number, number] {
    return rangeAlong(this.toward(section), this.extent.seen(this.state));
  }

  // By run: what the section cuts.
  outlines(): Outline[][] {
    this.updateScenes();
    return this.scenes.map((scene) =>
      scene.isShown && this.planes.length > 0 ? scene.outlines() : [],
    );
  }

  // What is under a point of the canvas (CSS pixels), if anything.
  pick(x: number, y: number): SurfacePlace | null {
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
    if (i < 0 || !this.scenes[i].isShown) return null;
    const pane = panes[i];
    const caster = new Raycaster();
    caster.setFromCamera(
      new Vector2(
        (2 * (at.x - pane.left)) / pane.width - 1,
        (2 * (at.y - pane.bottom)) / pane.height - 1,
      ),
      this.camera.camera,
    );
    const hit = caster
      .intersectObjects(this.scenes[i].shownMeshes(), false)
      .find(
        ({ point }) =>
          this.planes.length === 0 || this.plane.distanceToPoint(point) >= 0,
      );
    return hit ? placeOnSurface(i, hit) : null;
  }

  // The value at a place in the frame shown, as the muscles are coloured.
  say(place: SurfacePlace): string {
    const scale = vertexScale(this.state.coloring, this.data.runs);
    const { muscles } = this.scenes[place.run];
    const surface = muscles.find(({ mesh }) => mesh === place.mesh);
    const pose = this.timeline[this.state.moment].poses[place.run];
    if (!scale || !surface || pose === null) return "";
    return scale.say(scale.values(surface.muscle, pose)[nearestCorner(place)]);
  }

  // A point in space on the canvas of a run (CSS pixels).
  project(point: Vector3, run: number): [number, number] {
    const pane = this.panes()[run];
    const { clientWidth, clientHeight } = this.canvas;
    const at = point.clone().project(this.camera.camera);
    return [
      clientWidth * (pane.left + (pane.width * (at.x + 1)) / 2),
      clientHeight * (1 - pane.bottom - (pane.height * (at.y + 1)) / 2),
    ];
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
    const scale = vertexScale(this.state.coloring, this.data.runs);
    const { poses } = this.timeline[this.state.moment];
    this.scenes.forEach((scene, i) =>
      scene.update(this.state, poses[i], scale, this.everything),
    );
  }

  // Where the section cuts in the frame shown; without one, all that is seen.
  private kept(): Float32Array {
    const { section } = this.state;
    const cuts = section === "off" ? [] : this.outlines().flat();
    return cuts.length > 0
      ? joined(cuts.map(({ segments }) => segments))
      : this.extent.seen(this.state);
  }

  private toward(section: Exclude<SectionAxis, "off">): Vector3 {
    return new Vector3(...this.data.views[section].toward_viewer);
  }

  private placePlane(): void {
    const { section, sectionPlace, sectionFlipped } = this.state;
    this.planes.length = 0;
    if (section === "off") return;
    // What is on the viewer's side is cut away.
    this.plane.set(this.toward(section).negate(), sectionPlace);
    if (sectionFlipped) this.plane.negate();
    this.planes.push(this.plane);
  }
}
