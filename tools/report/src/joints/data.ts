// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Joints as src/musclewarp/page/joints_page.cc hands them over. Lengths in mm,
// in the frame of the bones; angles in degrees.

import {
  BoneShape,
  BoneShapeJson,
  Vector,
  View,
  boneShapeFrom,
  readParts,
} from "../data/page_parts";

export interface Coordinate {
  name: string;
  axis_in_joint: Vector;
  scan_deg: number;
  range_deg: [number, number];
  follows?: Follows;
}

// How a coordinate follows another one: linear between points, constant beyond.
export interface Follows {
  coordinate: string;
  at_deg: number[]; // ascending
  values_deg: number[];
}

export interface Shape {
  what: string;
  body: string;
  shape: "sphere" | "cylinder" | "axis";
  center_mm: Vector;
  axis?: Vector;
  radius_mm: number;
  spread_mm: number;
  coverage?: number; // of a sphere, as a share
  angle_deg?: number; // of the others
}

// Of a joint that was found: rows of the axes of its frames on both bodies.
export interface Frames {
  center_mm: Vector;
  parent_axes: [Vector, Vector, Vector];
  child_axes: [Vector, Vector, Vector];
  coordinates: Coordinate[];
}

export interface Joint extends Partial<Frames> {
  name: string;
  parent: string;
  child: string;
  quality: "good" | "weak" | "failed";
  given: boolean;
  reasons: string[];
  shapes: Shape[];
}

export type FoundJoint = Joint & Frames;

export function isFound(joint: Joint): joint is FoundJoint {
  return joint.center_mm !== undefined;
}

// joints.json, as far as the page needs it.
export interface JointsFile {
  axes: string;
  joints: Joint[];
  bodies: string[]; // each after the one that carries it
  welds: { parent: string; child: string }[];
  notes: string[];
}

interface PageJson {
  name: string;
  views: Record<string, View>;
  joints_file: JointsFile;
  step_mm: number;
  bones: (BoneShapeJson & { body: string })[];
}

export interface JointBone extends BoneShape {
  body: string;
}

export interface JointsData {
  name: string;
  views: Record<string, View>;
  file: JointsFile;
  bones: JointBone[];
}

export async function readJointsData(): Promise<JointsData> {
  const { json, packed } = await readParts<PageJson>("joints");
  return {
    name: json.name,
    views: json.views,
    file: json.joints_file,
    bones: json.bones.map((bone) => ({
      ...boneShapeFrom(bone, json.step_mm, packed),
      body: bone.body,
    })),
  };
}

export function foundJoints(file: JointsFile): FoundJoint[] {
  return file.joints.filter(isFound);
}

export function coordinatesOf(file: JointsFile): Coordinate[] {
  return foundJoints(file).flatMap((joint) => joint.coordinates);
}
