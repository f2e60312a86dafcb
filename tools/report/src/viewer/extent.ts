// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// How far the meshes reach over the motion, from a few of its frames.

import { Matrix4, Sphere, Vector3 } from "three";

import { Bone, PageData } from "../data/run";
import { Moment } from "../data/timeline";
import { MeshLook } from "../state";
import { extremesOf, joined } from "./extremes";

// Frames looked at: a motion of hundreds bends no faster than these show.
const mostMoments = 13;

function fewOf(timeline: Moment[]): Moment[] {
  const count = Math.min(mostMoments, timeline.length);
  return Array.from(
    { length: count },
    (_, i) =>
      timeline[
        Math.round((i * (timeline.length - 1)) / Math.max(1, count - 1))
      ],
  );
}

export function poseMatrix(bone: Bone, pose: number): Matrix4 {
  const rows = [...bone.poses[pose], 0, 0, 0, 1];
  return new Matrix4().fromArray(rows).transpose(); // three.js has columns
}

function moved(points: Float32Array, by: Matrix4): Float32Array {
  const result = new Float32Array(points.length);
  const point = new Vector3();
  for (let i = 0; i < points.length; i += 3) {
    point.fromArray(points, i).applyMatrix4(by).toArray(result, i);
  }
  return result;
}

export class Extent {
  private readonly muscles = new Map<string, Float32Array>();
  private readonly bones = new Map<string, Float32Array>();

  constructor(data: PageData, timeline: Moment[]) {
    const moments = fewOf(timeline);
    const add = (
      all: Map<string, Float32Array>,
      name: string,
      points: Float32Array[],
    ) => {
      const known = all.get(name);
      all.set(name, joined(known ? [known, ...points] : points));
    };
    data.runs.forEach((run, i) => {
      const poses = moments
        .map((moment) => moment.poses[i])
        .filter((pose) => pose !== null);
      for (const muscle of run.muscles) {
        add(
          this.muscles,
          muscle.name,
          poses.map((pose) => extremesOf(muscle.pointsAt(pose))),
        );
      }
      for (const bone of run.bones) {
        const extremes = extremesOf(bone.points);
        add(
          this.bones,
          bone.name,
          poses.map((pose) => moved(extremes, poseMatrix(bone, pose))),
        );
      }
    });
  }

  // Of the muscles that are shown; of the bones where no muscle is; of all
  // where nothing is. Bones reach far beyond what a scene is about.
  seen({ hidden }: MeshLook): Float32Array {
    const shown = (all: Map<string, Float32Array>) =>
      joined([...all].filter(([name]) => !hidden[name]).map(([, p]) => p));
    const choices = [shown(this.muscles), shown(this.bones)];
    return choices.find((points) => points.length > 0) ?? this.everything();
  }

  // The sphere holds all meshes in all frames, or nearly.
  sphere(): Sphere {
    const points = this.everything();
    const vectors: Vector3[] = [];
    for (let i = 0; i < points.length; i += 3) {
      vectors.push(new Vector3().fromArray(points, i));
    }
    return new Sphere().setFromPoints(vectors);
  }

  private everything(): Float32Array {
    return joined([...this.muscles.values(), ...this.bones.values()]);
  }
}

// The lowest and highest of points along an axis.
export function rangeAlong(
  axis: Vector3,
  points: Float32Array,
): [number, number] {
  let [lowest, highest] = [Infinity, -Infinity];
  for (let i = 0; i < points.length; i += 3) {
    const height =
      axis.x * points[i] + axis.y * points[i + 1] + axis.z * points[i + 2];
    lowest = Math.min(lowest, height);
    highest = Math.max(highest, height);
  }
  return [lowest, highest];
}
