// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Everything of one run that is drawn.

import {
  Box3,
  Color,
  DirectionalLight,
  Group,
  HemisphereLight,
  Plane,
  Scene,
  Sphere,
  WebGLRenderer,
} from "three";

import { Run } from "../data/run";
import { State } from "../state";
import { BoneSurface } from "./bone_surface";
import { VertexScale } from "./coloring";
import { showMesh } from "./mesh_look";
import { MuscleSurface } from "./muscle_surface";
import { PolylineObject } from "./polylines";
import { Section } from "./section";

// Muscles are seen through while their fibres are shown.
const opacityAroundFibres = 0.35;

export class RunScene {
  readonly scene = new Scene();
  readonly muscles: MuscleSurface[];
  readonly bones: BoneSurface[];
  private readonly content = new Group();
  private readonly lines: PolylineObject[];
  private readonly fibres: PolylineObject[];
  private readonly section: Section;
  private pose = -1;

  // `planes` is empty or holds the section plane: shared by all materials, and
  // changed in place.
  constructor(
    readonly run: Run,
    colors: Map<string, string>,
    private readonly planes: Plane[],
    plane: Plane,
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
          { color: "#202020", width: 2, isOnTop: true },
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
            isOnTop: false,
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
        [this.fibres[i], state.fibres],
      ] as const) {
        polylines.object.visible = visible && isOn && !polylines.isEmpty;
        if (moved) polylines.setPose(pose);
      }
    });
    this.content.updateMatrixWorld(true);
    this.section.update(this.planes.length > 0, bounds);
  }

  // Of muscles and bones in a pose.
  box(pose: number): Box3 {
    const box = new Box3();
    for (const { muscle } of this.muscles) {
      box.union(new Box3().setFromArray(muscle.pointsAt(pose)));
    }
    for (const { bone, mesh } of this.bones) {
      box.union(new Box3().setFromArray(bone.points).applyMatrix4(mesh.matrix));
    }
    return box;
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
