// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Bones of an arm, turned on a lathe, in the axes of an image: x to the left of
// the body, y to the back, z up; mm.

import { writeFileSync } from "node:fs";

const around = 48; // steps

// A closed surface about a vertical axis: `profile` has the radius and the
// height of its rings, from top to bottom.
function writeTurned(file, [x, y], profile) {
  const lines = [];
  for (const [radius, z] of profile) {
    for (let i = 0; i < around; ++i) {
      const angle = (2 * Math.PI * i) / around;
      const at = [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
      lines.push(`v ${at.join(" ")} ${z}`);
    }
  }
  const first = 1 + profile.length * around;
  lines.push(`v ${x} ${y} ${profile[0][1]}`);
  lines.push(`v ${x} ${y} ${profile.at(-1)[1]}`);
  const at = (ring, i) => 1 + ring * around + (i % around);
  for (let i = 0; i < around; ++i) {
    lines.push(`f ${first} ${at(0, i)} ${at(0, i + 1)}`);
    for (let ring = 0; ring + 1 < profile.length; ++ring) {
      lines.push(`f ${at(ring, i)} ${at(ring + 1, i)} ${at(ring, i + 1)}`);
      lines.push(
        `f ${at(ring, i + 1)} ${at(ring + 1, i)} ${at(ring + 1, i + 1)}`,
      );
    }
    const last = profile.length - 1;
    lines.push(`f ${first + 1} ${at(last, i + 1)} ${at(last, i)}`);
  }
  writeFileSync(file, lines.join("\n") + "\n");
}

export const headRadius = 24;

// A humerus of the right arm: a ball with a shaft below it.
export function writeHumerus(file) {
  const profile = [];
  for (let degrees = 4; degrees <= 150; degrees += 4) {
    const angle = (degrees * Math.PI) / 180;
    profile.push([headRadius * Math.sin(angle), headRadius * Math.cos(angle)]);
  }
  for (let z = -30; z >= -280; z -= 10) profile.push([12, z]);
  writeTurned(file, [-150, 0], profile);
}

// A rod beside it.
export function writeRod(file, x, top, bottom) {
  const profile = [];
  for (let z = top; z >= bottom; z -= 10) profile.push([9, z]);
  writeTurned(file, [x, 0], profile);
}
