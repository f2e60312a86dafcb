// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// A picture without WebGL: triangles seen from afar, drawn from the farthest
// to the nearest. It follows the frame and what is hidden, and cannot be turned
// but to the views.

import { Matrix4, Vector3 } from "three";

import { View } from "../data/page_parts";
import { PageData } from "../data/run";
import { Moment } from "../data/timeline";
import { MeshColors } from "../mesh_colors";
import { Store } from "../state";
import { poseMatrix } from "./extent";

const margin = 0.05; // of the picture
const ambient = 0.35;

interface Face {
  depth: number;
  path: number[]; // x and y of three corners
  color: string;
}

function channels(color: string): number[] {
  return [1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16));
}

// Triangles that face the viewer. `turn` takes z toward them.
function facesOf(
  points: Float32Array,
  triangles: Uint32Array,
  turn: Matrix4,
  color: string,
): Face[] {
  const seen = new Float32Array(points.length);
  const point = new Vector3();
  for (let i = 0; i < points.length; i += 3) {
    point.fromArray(points, i).applyMatrix4(turn).toArray(seen, i);
  }
  const rgb = channels(color);
  const faces: Face[] = [];
  const [u, v] = [new Vector3(), new Vector3()];
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * triangles[t + k]);
    u.set(
      seen[b] - seen[a],
      seen[b + 1] - seen[a + 1],
      seen[b + 2] - seen[a + 2],
    );
    v.set(
      seen[c] - seen[a],
      seen[c + 1] - seen[a + 1],
      seen[c + 2] - seen[a + 2],
    );
    const normal = u.cross(v);
    if (normal.z <= 0) continue;
    const light = ambient + (1 - ambient) * (normal.z / normal.length());
    faces.push({
      depth: seen[a + 2] + seen[b + 2] + seen[c + 2],
      path: [a, b, c].flatMap((at) => [seen[at], seen[at + 1]]),
      color: `rgb(${rgb.map((each) => Math.round(each * light)).join()})`,
    });
  }
  return faces;
}

export class StillPicture {
  readonly canvas = document.createElement("canvas");
  private name = "lateral";

  constructor(
    private readonly data: PageData,
    private readonly timeline: Moment[],
    private readonly colors: MeshColors,
    private readonly store: Store,
  ) {
    this.canvas.className = "still";
    store.subscribe((state, changed) => {
      if (state.playing) return;
      if (
        ["moment", "playing", "hidden"].some((key) => changed.has(key as never))
      )
        this.draw();
    });
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  view(name: string): void {
    this.name = name;
    this.draw();
  }

  reset(): void {
    this.view("lateral");
  }

  private turn({ toward_viewer, up }: View): Matrix4 {
    const z = new Vector3(...toward_viewer);
    const y = new Vector3(...up);
    return new Matrix4()
      .makeBasis(new Vector3().crossVectors(y, z), y, z)
      .transpose();
  }

  // Of the first run: one picture is enough to know what the page is about.
  private faces(): Face[] {
    const pose = this.timeline[this.store.state.moment].poses[0];
    if (pose === null) return [];
    const turn = this.turn(this.data.views[this.name]);
    const { muscles, bones } = this.data.runs[0];
    const { hidden } = this.store.state;
    return [
      ...muscles.map((muscle) => ({
        ...muscle,
        points: muscle.pointsAt(pose),
        turn,
      })),
      ...bones.map((bone) => ({
        ...bone,
        turn: turn.clone().multiply(poseMatrix(bone, pose)),
      })),
    ]
      .filter(({ name }) => !hidden[name])
      .flatMap((mesh) =>
        facesOf(
          mesh.points,
          mesh.triangles,
          mesh.turn,
          this.colors.get(mesh.name)!,
        ),
      )
      .sort((a, b) => a.depth - b.depth);
  }

  private draw(): void {
    const { canvas } = this;
    const context = canvas.getContext("2d");
    if (!context || canvas.clientWidth === 0) return;
    canvas.width = 2 * canvas.clientWidth;
    canvas.height = 2 * canvas.clientHeight;
    const faces = this.faces();
    let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
    for (const { path } of faces) {
      for (let i = 0; i < 6; i += 2) {
        [left, right] = [Math.min(left, path[i]), Math.max(right, path[i])];
        [low, high] = [Math.min(low, path[i + 1]), Math.max(high, path[i + 1])];
      }
    }
    const scale =
      (1 - 2 * margin) *
      Math.min(canvas.width / (right - left), canvas.height / (high - low));
    const [x, y] = [(left + right) / 2, (low + high) / 2];
    for (const { path, color } of faces) {
      context.beginPath();
      for (let i = 0; i < 6; i += 2) {
        context.lineTo(
          canvas.width / 2 + scale * (path[i] - x),
          canvas.height / 2 - scale * (path[i + 1] - y),
        );
      }
      context.closePath();
      context.fillStyle = context.strokeStyle = color;
      context.fill();
      context.stroke(); // no gaps between triangles
    }
  }
}
