// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "musclewarp/base/described.h"

namespace musclewarp {

struct PhantomScene;

// How a made-up scene differs from the one that its name and seed make. With
// the default values it does not.
struct Variation {
  // Of the scene "random" only; 0 for numbers that are drawn.
  int num_muscles = 0;
  int num_vertices = 0;
  int num_poses = 0;

  double size = 1;
  double offset = 0;
};

constexpr auto FieldsOf(Described<Variation>) {
  using S = Variation;
  return std::make_tuple(
      Field(&S::num_muscles, "num_muscles")
          .Text("number of muscles of the scene random; 0: drawn from the "
                "seed, 2 to 20")
          .Within(2, 32)
          .Or(0),
      Field(&S::num_vertices, "num_vertices")
          .Text("number of vertices of each muscle of the scene random, about; "
                "0: as the seed has it, at most some 4000")
          .Within(20, 1e6)
          .Or(0),
      Field(&S::num_poses, "num_poses")
          .Text("number of poses of the scene random; 1 is the last of the "
                "motion alone; 0: drawn from the seed, 3 to 5")
          .Within(1, 1e6)
          .Or(0),
      Field(&S::size, "size")
          .Text("factor of all lengths of the scene")
          .Within(1e-6, 1e6),
      Field(&S::offset, "offset", "mm")
          .Text("by how much the scene is moved along each axis, after it has "
                "its size")
          .Within(-1e9, 1e9));
}

// Gives each muscle of a scene about as many vertices: its surface is remeshed
// or simplified. If that would cross itself, the muscle keeps its vertices. Its
// attachments are made anew of points of the mesh; lines stay, and may leave a
// mesh that has become coarse.
void GiveVertices(int num_vertices, PhantomScene* scene);

// Multiplies all lengths of a scene by `size` and moves it by `offset` along
// each axis: meshes, lines, attachments and poses. Precondition (CHECKed): the
// scene has no model, or nothing changes.
void Place(double size, double offset, PhantomScene* scene);

}  // namespace musclewarp
