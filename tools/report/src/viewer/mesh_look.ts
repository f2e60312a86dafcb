// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Meshes as the visitor wants them: hidden, faded.

import { MeshLook } from "../state";
import { BoneMesh } from "./bone_surface";

// The factor scales the opacity.
export function showMesh(mesh: BoneMesh, look: MeshLook, factor = 1): void {
  const opacity = factor * (look.opacity[mesh.name] ?? 1);
  mesh.visible = !look.hidden[mesh.name] && opacity > 0;
  mesh.material.opacity = opacity;
  const transparent = opacity < 1;
  if (mesh.material.transparent === transparent) return;
  mesh.material.transparent = transparent;
  mesh.material.depthWrite = !transparent;
  mesh.material.needsUpdate = true;
}
