// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace musclewarp {

struct PhantomScene;

// How a made-up scene differs from the one that its name and seed make. With
// the default values it does not.
struct Variation {
  // Of the scene "random" only; 0 for numbers that are drawn.
  int num_muscles = 0;
  int num_vertices = 0;
  int num_poses = 0;

  double size = 1;    // factor of all lengths
  double offset = 0;  // mm, along each axis, after it has its size
};

// Gives each muscle of a scene about as many vertices: its surface is remeshed
// or simplified, twice as finely as long as it would cross itself. Its
// attachments are made anew of points of the mesh; lines stay, and may leave a
// mesh that has become coarse.
void GiveVertices(int num_vertices, PhantomScene* scene);

// Multiplies all lengths of a scene by `size` and moves it by `offset` along
// each axis: meshes, lines, attachments and poses. Precondition (CHECKed): the
// scene has no model, or nothing changes.
void Place(double size, double offset, PhantomScene* scene);

}  // namespace musclewarp
