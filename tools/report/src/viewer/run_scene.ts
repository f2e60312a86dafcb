// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Everything of one run that is drawn.

import {
  Color,
  DirectionalLight,
  Group,
  HemisphereLight,
  Mesh,
  Plane,
  Scene,
  Sphere,
  WebGLRenderer,
} from "three";

import { Muscle, Run } from "../data/run";
import { MeshColors } from "../mesh_colors";
import { State } from "../state";
import { BoneSurface } from "./bone_surface";
import { VertexScale } from "./coloring";
import { showMesh } from "./mesh_look";
import { MuscleSurface } from "./muscle_surface";
import { PolylineObject } from "./polylines";
import { Outline, outlineOf } from "./outline";
import { Section } from "./section";

// Muscles are seen through while their fibres are shown.
const opacityAroundFibres = 0.35;
// Of a muscle's colour, to stand out from its surface.
const lineShade = 0.4;
// Of the surface; the rest may be far from the lines, as attachments are.
const surfaceShare = 0.95;

// How far the surface of a muscle is from its lines at rest, mm.
function thicknessAround({ lines, vertices, pointsAt }: Muscle): number {
  const along = lines.at(0);
  const points = pointsAt(0);
  const distances = Float32Array.from({ length: vertices }, (_, v) => {
    let nearest = Infinity;
    for (let p = 0; p < along.length; p += 3) {
      const distance = Math.hypot(
        along[p] - points[3 * v],
        along[p + 1] - points[3 * v + 1],
        along[p + 2] - points[3 * v + 2],
      );
      nearest = Math.min(nearest, distance);
    }
    return nearest;
  }).sort();
  const thickness = distances[Math.floor(surfaceShare * (vertices - 1))];
  return Number.isFinite(thickness) ? thickness : 0;
}

export class RunScene {
  readonly scene = new Scene();
  readonly muscles: MuscleSurface[];
  readonly bones: BoneSurface[];
  private readonly content = new Group();
  private readonly lines: PolylineObject[];
  private readonly tendons: PolylineObject[];
  private readonly fibres: PolylineObject[];
  private readonly section: Section;
  private pose = -1;

  // `planes` is empty or holds the section plane: shared by all materials, and
  // changed in place.
  constructor(
    readonly run: Run,
    colors: MeshColors,
    private readonly planes: Plane[],
    private readonly plane: Plane,
    renderer: WebGLRenderer,
  ) {
    const colorOf = (name: string) => colors.get(name)!;
    this.muscles = run.muscles.map(
      (muscle) => new MuscleSurface(muscle, colorOf(muscle.name), planes),
    );
    this.bones = run.bones.map(
      (bone) => new BoneSurface(bone, colorOf(bone.name), planes),
    );
    this.lines = run.muscles.map(
      (muscle) =>
        new PolylineObject(
          muscle.lines,
          {
            color: new Color(colorOf(muscle.name))
              .multiplyScalar(lineShade)
              .getStyle(),
            width: 1.5,
            lift: thicknessAround(muscle),
          },
          planes,
        ),
    );
    this.tendons = run.muscles.map(
      (muscle) =>
        new PolylineObject(
          muscle.tendons,
          {
            color: new Color(colorOf(muscle.name))
              .multiplyScalar(lineShade)
              .getStyle(),
            width: 1.5,
            isDashed: true,
          },
          planes,
        ),
    );
    this.fibres = run.muscles.map(
      (muscle) =>
        new PolylineObject(
          muscle.fibres,
          {
            color: new Color(colorOf(muscle.name))
              .lerp(new Color("#ffffff"), 0.3)
              .getStyle(),
            width: 1.2,
          },
          planes,
        ),
    );
    this.section = new Section(
      plane,
      [...this.bones, ...this.muscles],
      renderer,
    );
    this.content.add(
      ...this.bones.map((bone) => bone.mesh),
      ...this.muscles.map((muscle) => muscle.group),
      ...this.lines.map((line) => line.object),
      ...this.tendons.map((tendon) => tendon.object),
      ...this.fibres.map((fibre) => fibre.object),
      this.section.group,
    );
    const sky = new HemisphereLight("#ffffff", "#b9b4ad", 1.6);
    this.scene.add(this.content, sky);
  }

  // The light comes from beside the viewer: one for all runs would belong to
  // one scene only.
  addHeadlight(light: DirectionalLight): void {
    this.scene.add(light, light.target);
  }

  // Null: the run has no such frame, and nothing is shown. The bounds are of
  // everything in all poses.
  update(
    state: State,
    pose: number | null,
    scale: VertexScale | null,
    bounds: Sphere,
  ): void {
    this.content.visible = pose !== null;
    if (pose === null) return;
    const moved = pose !== this.pose;
    this.pose = pose;
    const crossing = state.crossings
      ? this.crossingTriangles(pose)
      : new Map<string, Set<number>>();
    this.bones.forEach((bone) => {
      if (moved) bone.setPose(pose);
      showMesh(bone.mesh, state);
    });
    this.muscles.forEach((surface, i) => {
      const { name } = surface.muscle;
      if (moved) surface.setPose(pose);
      surface.setColors(scale, pose);
      surface.setCrossing(crossing.get(name) ?? new Set());
      const hasFibres = state.fibres && !this.fibres[i].isEmpty;
      showMesh(surface.mesh, state, hasFibres ? opacityAroundFibres : 1);
      const visible = !state.hidden[name];
      surface.group.visible = visible;
      for (const [polylines, isOn] of [
        [this.lines[i], state.lines],
        [this.tendons[i], state.lines],
        [this.fibres[i], state.fibres],
      ] as const) {
        polylines.object.visible = visible && isOn && !polylines.isEmpty;
        if (moved) polylines.setPose(pose);
      }
    });
    this.content.updateMatrixWorld(true);
    this.section.update(this.planes.length > 0, bounds);
  }

  get isShown(): boolean {
    return this.content.visible;
  }

  shownMeshes(): Mesh[] {
    return [...this.muscles, ...this.bones]
      .map(({ mesh }) => mesh)
      .filter((mesh) => mesh.visible && mesh.parent!.visible);
  }

  // What the plane cuts of the meshes that are shown, as it is now.
  outlines(): Outline[] {
    return [...this.muscles, ...this.bones]
      .filter(({ mesh }) => mesh.visible && mesh.parent!.visible)
      .map(({ mesh, color }) => outlineOf(mesh, color, this.plane))
      .filter(({ segments }) => segments.length > 0);
  }

  private crossingTriangles(pose: number): Map<string, Set<number>> {
    const byMuscle = new Map<string, Set<number>>();
    const add = (name: string, triangles: Int32Array) => {
      const set = byMuscle.get(name) ?? new Set();
      triangles.forEach((t) => set.add(t));
      byMuscle.set(name, set);
    };
    for (const pair of this.run.crossings[pose]) {
      add(pair.a, pair.trianglesOfA);
      if (pair.trianglesOfB) add(pair.b, pair.trianglesOfB);
    }
    return byMuscle;
  }
}
