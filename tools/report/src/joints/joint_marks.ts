// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What is drawn of a joint beside its bones: fitted shapes, axes, centre.

import {
  BufferGeometry,
  ConeGeometry,
  CylinderGeometry,
  DoubleSide,
  FrontSide,
  Group,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Object3D,
  Quaternion,
  SphereGeometry,
  Vector3,
} from "three";

import { LineLook, PolylineObject } from "../viewer/polylines";
import { lineOrder } from "../viewer/render_order";
import { shapeColor, turnColors } from "./colors";
import { FoundJoint, Joint, Shape, isFound } from "./data";
import { Values, turningFrames } from "./kinematics";

const shapeOpacity = 0.45;
const fadedOpacity = 0.12; // while another joint is selected
const onSurface = 2; // mm, off the cylinder: points of the bone that it fits
// Axes have no ends.
const shapeLineLength = 140; // mm
const leastAxisLength = 90; // mm
const axisLength = 4; // radii
const centerRadius = 2; // mm
const tip = { radius: 2.2, length: 8 }; // mm, of axes

const up = new Vector3(0, 1, 0); // the axis of three.js' cylinders and cones

function along(direction: Vector3): Quaternion {
  return new Quaternion().setFromUnitVectors(up, direction);
}

function line(
  center: Vector3,
  direction: Vector3,
  length: number,
  look: LineLook,
): Object3D {
  const ends = [-length / 2, length / 2].flatMap((at) =>
    center.clone().addScaledVector(direction, at).toArray(),
  );
  const made = new PolylineObject(
    { counts: [2], at: () => new Float32Array(ends) },
    look,
    [],
  );
  made.setPose(0);
  return made.object;
}

function onTop(geometry: BufferGeometry, color: string): Mesh {
  const mesh = new Mesh(
    geometry,
    new MeshBasicMaterial({ color, depthTest: false, transparent: true }),
  );
  mesh.renderOrder = lineOrder + 2;
  return mesh;
}

// A cylinder has no ends: it is shown as far as the points of its bone lie on
// it, to both sides of its centre.
function lengthOf(shape: Shape, points: Float32Array[]): [number, number] {
  const { radius_mm: radius } = shape;
  const center = new Vector3(...shape.center_mm);
  const axis = new Vector3(...shape.axis!).normalize();
  const at = new Vector3();
  let [from, to] = [-radius / 2, radius / 2];
  for (const some of points) {
    for (let i = 0; i < some.length; i += 3) {
      at.fromArray(some, i).sub(center);
      const height = at.dot(axis);
      const away = at.addScaledVector(axis, -height).length();
      if (Math.abs(away - radius) > onSurface) continue;
      if (Math.abs(height) > 3 * radius) continue;
      from = Math.min(from, height);
      to = Math.max(to, height);
    }
  }
  return [from, to];
}

function geometryOf(shape: Shape, points: Float32Array[]): BufferGeometry {
  const { radius_mm: radius } = shape;
  if (shape.shape === "sphere") return new SphereGeometry(radius, 48, 32);
  const [from, to] = lengthOf(shape, points);
  const length = to - from;
  const geometry = new CylinderGeometry(radius, radius, length, 64, 1, true);
  return geometry.translate(0, (from + to) / 2, 0);
}

function surfaceOf(
  shape: Shape,
  points: Float32Array[],
): Mesh<BufferGeometry, MeshLambertMaterial> {
  const geometry = geometryOf(shape, points);
  const surface = new Mesh(
    geometry,
    new MeshLambertMaterial({
      color: shapeColor,
      transparent: true,
      opacity: shapeOpacity,
      side: shape.shape === "cylinder" ? DoubleSide : FrontSide, // it is open
      depthWrite: false,
      // It lies on the bone to which it was fitted.
      polygonOffset: true,
      polygonOffsetFactor: -2,
      polygonOffsetUnits: -2,
    }),
  );
  surface.name = shape.what;
  surface.position.set(...shape.center_mm);
  if (shape.axis) {
    surface.quaternion.copy(along(new Vector3(...shape.axis).normalize()));
  }
  return surface;
}

// An axis of a coordinate through the centre, with a tip: the turn is positive
// about it by the rule of the right hand.
function axisOf(direction: Vector3, length: number, color: string): Group {
  const group = new Group();
  const end = onTop(new ConeGeometry(tip.radius, tip.length, 16), color);
  end.position.addScaledVector(direction, length / 2);
  end.quaternion.copy(along(direction));
  const look = { color, width: 2.5, isOnTop: true };
  group.add(line(new Vector3(), direction, length, look), end);
  group.matrixAutoUpdate = false;
  return group;
}

export class JointMarks {
  // Fixed to their bodies, in the frame of the bones.
  readonly shapes: { body: string; object: Object3D }[];
  // In the frame of the ground.
  readonly axes = new Group();
  private readonly turning: Group[] = [];
  private readonly surfaces: Mesh<BufferGeometry, MeshLambertMaterial>[] = [];

  // `pointsOf` has the points of the bones of a body.
  constructor(
    readonly joint: Joint,
    pointsOf: (body: string) => Float32Array[],
  ) {
    this.shapes = joint.shapes.map((shape) => ({
      body: shape.body,
      object: this.objectOf(shape, pointsOf(shape.body)),
    }));
    this.axes.matrixAutoUpdate = false;
    if (isFound(joint)) this.addAxes(joint);
  }

  // `parentPose` is that of the body that carries the joint.
  setPose(parentPose: Matrix4, values: Values): void {
    if (!isFound(this.joint)) return;
    this.axes.matrix.copy(parentPose);
    const frames = turningFrames(this.joint, values);
    this.turning.forEach((group, i) => group.matrix.copy(frames[i]));
  }

  show(shapes: boolean, axes: boolean, isOther: boolean): void {
    for (const { object } of this.shapes) object.visible = shapes;
    for (const { material } of this.surfaces) {
      material.opacity = isOther ? fadedOpacity : shapeOpacity;
    }
    this.axes.visible = axes && !isOther;
  }

  private objectOf(shape: Shape, points: Float32Array[]): Object3D {
    if (shape.shape === "axis") {
      const direction = new Vector3(...shape.axis!).normalize();
      const look = { color: shapeColor, width: 2, isOnTop: true };
      const center = new Vector3(...shape.center_mm);
      return line(center, direction, shapeLineLength, look);
    }
    const surface = surfaceOf(shape, points);
    this.surfaces.push(surface);
    return surface;
  }

  private addAxes(joint: FoundJoint): void {
    const radii = joint.shapes.map((shape) => shape.radius_mm);
    const length = Math.max(
      leastAxisLength,
      axisLength * Math.max(0, ...radii),
    );
    joint.coordinates.forEach(({ axis_in_joint }, i) => {
      const direction = new Vector3(...axis_in_joint).normalize();
      const axis = axisOf(direction, length, turnColors[i % turnColors.length]);
      this.turning.push(axis);
      this.axes.add(axis);
    });
    for (const [radius, color] of [
      [1.35 * centerRadius, "#ffffff"],
      [centerRadius, "#202020"],
    ] as const) {
      const center = onTop(new SphereGeometry(radius, 24, 16), color);
      center.position.set(...joint.center_mm);
      this.axes.add(center);
    }
  }
}
