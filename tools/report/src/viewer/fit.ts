// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Where a camera must stand for points to fill its picture.

import { Box3, Vector3 } from "three";

// Of the picture, to its edge and what is written there.
const margin = 1.06;

export interface Place {
  position: Vector3;
  target: Vector3;
}

export function cornersOf(box: Box3): Float32Array {
  const corners = new Float32Array(24);
  for (let i = 0; i < 8; ++i) {
    corners[3 * i] = (i & 1 ? box.max : box.min).x;
    corners[3 * i + 1] = (i & 2 ? box.max : box.min).y;
    corners[3 * i + 2] = (i & 4 ? box.max : box.min).z;
  }
  return corners;
}

// The nearest place from which all points (three coordinates each) are seen,
// where the camera looks against `direction`. `slope` is the tangent of half
// the angle that the picture's height takes. Along x, a point at height z
// toward the camera is in a picture taken from (c, D) where
// |x - c| <= slope (D - z): the largest x + slope z and -x + slope z give both
// D and c. Precondition: there is a point.
export function placeToSee(
  points: Float32Array,
  direction: Vector3,
  up: Vector3,
  slope: number,
  aspect: number,
): Place {
  const right = new Vector3().crossVectors(up, direction).normalize();
  const upward = new Vector3().crossVectors(direction, right);
  const slopes = [(slope * aspect) / margin, slope / margin];
  const most = [-Infinity, -Infinity]; // of x + slope z
  const least = [-Infinity, -Infinity]; // of -x + slope z
  let [lowest, highest] = [Infinity, -Infinity];
  const point = new Vector3();
  for (let i = 0; i < points.length; i += 3) {
    point.fromArray(points, i);
    const z = point.dot(direction);
    [right, upward].forEach((axis, k) => {
      const x = point.dot(axis);
      most[k] = Math.max(most[k], x + slopes[k] * z);
      least[k] = Math.max(least[k], -x + slopes[k] * z);
    });
    lowest = Math.min(lowest, z);
    highest = Math.max(highest, z);
  }
  const distance = Math.max(
    ...[0, 1].map((k) => (most[k] + least[k]) / (2 * slopes[k])),
  );
  const middle = (lowest + highest) / 2;
  const at = (z: number) =>
    right
      .clone()
      .multiplyScalar((most[0] - least[0]) / 2)
      .addScaledVector(upward, (most[1] - least[1]) / 2)
      .addScaledVector(direction, z);
  // A single point is seen from some distance, too.
  return { position: at(Math.max(distance, middle + 1)), target: at(middle) };
}
