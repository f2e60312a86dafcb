// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Where bodies are when coordinates have values: matrices that move them there
// from the pose of the scan.

import { Matrix4, Vector3 } from "three";

import {
  Follows,
  Frames,
  JointsFile,
  coordinatesOf,
  foundJoints,
} from "./data";

export type Values = Record<string, number>; // by coordinate, degrees

const degree = Math.PI / 180;

function followed({ at_deg, values_deg }: Follows, value: number): number {
  const next = at_deg.findIndex((at) => at >= value);
  if (next < 0) return values_deg[values_deg.length - 1];
  if (next === 0) return values_deg[0];
  const part = (value - at_deg[next - 1]) / (at_deg[next] - at_deg[next - 1]);
  return (
    values_deg[next - 1] + part * (values_deg[next] - values_deg[next - 1])
  );
}

// The values with those of coordinates that follow others.
export function withFollowers(file: JointsFile, values: Values): Values {
  const all = { ...values };
  for (const { name, follows } of coordinatesOf(file)) {
    if (follows) all[name] = followed(follows, values[follows.coordinate]);
  }
  return all;
}

// A frame at the centre of a joint, of which the rows of the axes are given.
function frame(joint: Frames, [x, y, z]: Frames["parent_axes"]): Matrix4 {
  const [px, py, pz] = joint.center_mm;
  return new Matrix4().set(...x, px, ...y, py, ...z, pz, 0, 0, 0, 1);
}

function turn(axis: [number, number, number], degrees: number): Matrix4 {
  return new Matrix4().makeRotationAxis(new Vector3(...axis), degrees * degree);
}

// The frames in which the coordinates of a joint turn, one after the other, and
// the one that they end in: on a parent in the pose of the scan.
export function turningFrames(joint: Frames, values: Values): Matrix4[] {
  const frames = [frame(joint, joint.parent_axes)];
  for (const { name, axis_in_joint } of joint.coordinates) {
    const last = frames[frames.length - 1];
    frames.push(last.clone().multiply(turn(axis_in_joint, values[name])));
  }
  return frames;
}

// By body; "ground" stands still.
export function posesOf(
  file: JointsFile,
  values: Values,
): Map<string, Matrix4> {
  const joints = new Map(foundJoints(file).map((each) => [each.child, each]));
  const welds = new Map(file.welds.map((each) => [each.child, each.parent]));
  const poses = new Map([["ground", new Matrix4()]]);
  const poseOf = (body: string) => poses.get(body) ?? new Matrix4();
  for (const body of file.bodies) {
    const joint = joints.get(body);
    if (!joint) {
      poses.set(body, poseOf(welds.get(body) ?? "ground").clone());
      continue;
    }
    const fromScan = frame(joint, joint.child_axes).invert();
    const moved = turningFrames(joint, values).at(-1)!;
    poses.set(
      body,
      poseOf(joint.parent).clone().multiply(moved).multiply(fromScan),
    );
  }
  return poses;
}
