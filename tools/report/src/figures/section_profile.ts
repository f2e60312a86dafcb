// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The area of a muscle's sections along it: by planes at right angles to the
// mean of its lines, of which the piece counts that is nearest to that mean.
// musclewarp-export --format=csv has the largest of them (run_table.h).

import { Plane, Vector3 } from "three";

import { Muscle } from "../data/run";
import { areaWithin, cutPieces } from "../viewer/outline";

const pointsOfMean = 50;
const stations = 50;

export interface SectionProfile {
  along: number[]; // mm from the first end
  areas: number[]; // mm2
}

// Points of a polyline (three coordinates each) at equal distances.
function resampled(line: Float32Array, count: number): Vector3[] {
  const points = Array.from({ length: line.length / 3 }, (_, i) =>
    new Vector3().fromArray(line, 3 * i),
  );
  const places = [0];
  for (let i = 1; i < points.length; ++i) {
    places.push(places[i - 1] + points[i].distanceTo(points[i - 1]));
  }
  const length = places.at(-1)!;
  let piece = 0;
  return Array.from({ length: count }, (_, i) => {
    const at = (length * i) / (count - 1);
    while (piece + 2 < points.length && places[piece + 1] < at) ++piece;
    const [from, to] = [places[piece], places[piece + 1]];
    const part = to > from ? Math.min(1, (at - from) / (to - from)) : 0;
    return points[piece].clone().lerp(points[piece + 1], part);
  });
}

// Of the lines in a pose; nothing for a muscle without lines of some length.
function meanLine({ lines }: Muscle, pose: number): Vector3[] {
  const all = lines.at(pose);
  const mean = Array.from({ length: pointsOfMean }, () => new Vector3());
  let from = 0;
  let count = 0;
  for (const points of lines.counts) {
    const line = all.subarray(3 * from, 3 * (from + points));
    from += points;
    if (points < 2) continue;
    ++count;
    resampled(line, pointsOfMean).forEach((point, i) => mean[i].add(point));
  }
  for (const point of mean) point.divideScalar(Math.max(1, count));
  return mean[0].distanceTo(mean.at(-1)!) > 0 ? mean : [];
}

export function sectionProfile(
  muscle: Muscle,
  pose: number,
): SectionProfile | null {
  const mean = meanLine(muscle, pose);
  if (mean.length === 0) return null;
  const points = muscle.pointsAt(pose);
  const flat = new Float32Array(mean.flatMap((point) => point.toArray()));
  const places = resampled(flat, stations);
  const profile: SectionProfile = { along: [], areas: [] };
  let along = 0;
  places.forEach((place, i) => {
    if (i > 0) along += place.distanceTo(places[i - 1]);
    const normal = places[Math.min(i + 1, stations - 1)]
      .clone()
      .sub(places[Math.max(0, i - 1)])
      .normalize();
    const plane = new Plane().setFromNormalAndCoplanarPoint(normal, place);
    const pieces = cutPieces(points, muscle.triangles, plane);
    const distance = (piece: Float32Array) => {
      let least = Infinity;
      for (let e = 0; e < piece.length; e += 3) {
        const end = new Vector3().fromArray(piece, e);
        least = Math.min(least, end.distanceToSquared(place));
      }
      return least;
    };
    const nearest = pieces
      .map((piece) => ({ piece, at: distance(piece) }))
      .reduce<{ piece: Float32Array; at: number } | null>(
        (best, each) => (best && best.at <= each.at ? best : each),
        null,
      );
    profile.along.push(along);
    profile.areas.push(nearest ? areaWithin(nearest.piece, normal) : 0);
  });
  return profile;
}
