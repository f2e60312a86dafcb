// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The view of the bones and their joints.

import {
  Box3,
  Group,
  HemisphereLight,
  Matrix4,
  Raycaster,
  Scene,
  Sphere,
  Vector2,
  Vector3,
} from "three";

import { boneColor } from "../palette";
import { Store } from "../state";
import { BoneMesh, boneMesh } from "../viewer/bone_surface";
import { LinkedCamera } from "../viewer/camera";
import { DrawnCanvas } from "../viewer/drawn_canvas";
import { cornersOf } from "../viewer/fit";
import { showMesh } from "../viewer/mesh_look";
import { childColor, parentColor } from "./colors";
import { JointBone, JointsData, isFound } from "./data";
import { JointMarks } from "./joint_marks";
import { posesOf } from "./kinematics";
import { JointsState } from "./state";

const jointSurroundings = 75; // mm, of a joint to which the camera goes
const firstView = "anterior";

interface ShownBone {
  bone: JointBone;
  mesh: BoneMesh;
  box: Box3; // in the pose of the scan
}

export class JointsViewer extends DrawnCanvas {
  readonly camera: LinkedCamera;
  private readonly scene = new Scene();
  private readonly bodies = new Map<string, Group>();
  private readonly bones: ShownBone[];
  private readonly marks: JointMarks[];
  private state: JointsState;
  private poses = new Map<string, Matrix4>();

  constructor(
    canvas: HTMLCanvasElement,
    private readonly data: JointsData,
    store: Store<JointsState>,
  ) {
    super(canvas);
    this.state = store.state;
    this.bones = data.bones.map((bone) => {
      const mesh = boneMesh(bone, boneColor, []);
      this.bodyGroup(bone.body).add(mesh);
      return { bone, mesh, box: new Box3().setFromArray(bone.points) };
    });
    const pointsOf = (body: string) =>
      data.bones
        .filter((bone) => bone.body === body)
        .map(({ points }) => points);
    this.marks = data.file.joints.map(
      (joint) => new JointMarks(joint, pointsOf),
    );
    for (const marks of this.marks) {
      for (const { body, object } of marks.shapes) {
        this.bodyGroup(body).add(object);
      }
      this.scene.add(marks.axes);
    }
    const light = this.headlight();
    this.scene.add(light, light.target);
    this.scene.add(new HemisphereLight("#ffffff", "#b9b4ad", 1.6));
    this.camera = new LinkedCamera(canvas, data.views, () => this.request());
    this.updateScenes();
    this.start();
    this.reset(false);
    store.subscribe((state, changed) => {
      const isNewJoint = state.selected !== this.state.selected;
      this.state = state;
      if (changed.has("values") || isNewJoint) this.updateScenes();
      if (isNewJoint) this.camera.flyTo(this.focus());
      this.refresh();
    });
  }

  // Shows everything.
  reset(fly = true): void {
    this.camera.showFrom(firstView, cornersOf(this.everything()), fly);
  }

  // Shows what is selected, or everything.
  view(name: string): void {
    this.camera.showFrom(name, cornersOf(this.focus()), true);
  }

  // The bone under a point of the canvas (CSS pixels), if any.
  pick(x: number, y: number): string | null {
    const { width, height } = this.canvas.getBoundingClientRect();
    const caster = new Raycaster();
    caster.setFromCamera(
      new Vector2((2 * x) / width - 1, 1 - (2 * y) / height),
      this.camera.camera,
    );
    const meshes = this.bones.map(({ mesh }) => mesh);
    const [hit] = caster.intersectObjects(
      meshes.filter((mesh) => mesh.visible),
      false,
    );
    return hit ? hit.object.name : null;
  }

  protected isPlaying(): boolean {
    return false;
  }

  protected bounds(): Sphere {
    return this.everything()
      .expandByScalar(jointSurroundings)
      .getBoundingSphere(new Sphere());
  }

  protected aspect(width: number, height: number): number {
    return width / height;
  }

  protected updateScenes(): void {
    const { selected, values, shapes, axes } = this.state;
    this.poses = posesOf(this.data.file, values);
    for (const [body, group] of this.bodies) {
      group.matrix.copy(this.poseOf(body));
    }
    const joint = this.data.file.joints.find(({ name }) => name === selected);
    for (const { bone, mesh } of this.bones) {
      mesh.material.color.set(
        bone.body === joint?.parent
          ? parentColor
          : bone.body === joint?.child
            ? childColor
            : boneColor,
      );
      showMesh(mesh, this.state);
    }
    for (const marks of this.marks) {
      marks.setPose(this.poseOf(marks.joint.parent), values);
      const isOther = selected !== null && marks.joint.name !== selected;
      marks.show(shapes, axes, isOther);
    }
    this.scene.updateMatrixWorld(true);
  }

  protected drawScenes(): void {
    this.renderer.render(this.scene, this.camera.camera);
  }

  private poseOf(body: string): Matrix4 {
    return this.poses.get(body) ?? new Matrix4();
  }

  private bodyGroup(body: string): Group {
    let group = this.bodies.get(body);
    if (!group) {
      group = new Group();
      group.matrixAutoUpdate = false;
      this.bodies.set(body, group);
      this.scene.add(group);
    }
    return group;
  }

  private boxOf(isWanted: (bone: JointBone) => boolean): Box3 {
    const box = new Box3();
    for (const { bone, box: atScan } of this.bones) {
      if (!isWanted(bone)) continue;
      box.union(atScan.clone().applyMatrix4(this.poseOf(bone.body)));
    }
    return box;
  }

  private everything(): Box3 {
    return this.boxOf(() => true);
  }

  // What the camera looks at: around the joint that is selected, or its bones
  // if it was not found.
  private focus(): Box3 {
    const { selected } = this.state;
    const joint = this.data.file.joints.find(({ name }) => name === selected);
    if (!joint) return this.everything();
    if (isFound(joint)) {
      const center = new Vector3(...joint.center_mm);
      center.applyMatrix4(this.poseOf(joint.parent));
      return new Box3(center.clone(), center).expandByScalar(jointSurroundings);
    }
    const box = this.boxOf(
      ({ body }) => body === joint.parent || body === joint.child,
    );
    return box.isEmpty() ? this.everything() : box;
  }
}
