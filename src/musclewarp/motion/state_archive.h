// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Serialization of the states of a scene by cereal, bit for bit: for the log of
// a resumable run, the cache of preparations and recorded steps.

#include <cereal/types/map.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <cstdint>
#include <memory>
#include <utility>

#include "musclewarp/base/archived_fields.h"
#include "musclewarp/frames/scene_state.h"

namespace cereal {

template <class Archive, class T, int R, int C, int O, int MR, int MC>
void save(Archive& archive, const Eigen::Matrix<T, R, C, O, MR, MC>& matrix) {
  archive(static_cast<std::int64_t>(matrix.rows()),
          static_cast<std::int64_t>(matrix.cols()),
          binary_data(matrix.data(), matrix.size() * sizeof(T)));
}

template <class Archive, class T, int R, int C, int O, int MR, int MC>
void load(Archive& archive, Eigen::Matrix<T, R, C, O, MR, MC>& matrix) {
  std::int64_t rows, columns;
  archive(rows, columns);
  matrix.resize(rows, columns);
  archive(binary_data(matrix.data(), matrix.size() * sizeof(T)));
}

// A pointer to something constant, or null.
template <class Archive, class T>
void save(Archive& archive, const std::shared_ptr<const T>& pointer) {
  archive(pointer != nullptr);
  if (pointer != nullptr) archive(*pointer);
}

template <class Archive, class T>
void load(Archive& archive, std::shared_ptr<const T>& pointer) {
  bool is_there;
  archive(is_there);
  pointer.reset();
  if (!is_there) return;
  T value;
  archive(value);
  pointer = std::make_shared<const T>(std::move(value));
}

}  // namespace cereal

namespace musclewarp {

MUSCLEWARP_ARCHIVE(SolvedLines, bodies, points)
MUSCLEWARP_ARCHIVE(ScenePose,
                   name,
                   time,
                   coordinates,
                   bodies,
                   lines,
                   taut_lines,
                   pushes,
                   model_values,
                   path_lengths)

MUSCLEWARP_ARCHIVE(HalfSpace, normal, level)
MUSCLEWARP_ARCHIVE(VertexHalfSpace, vertex, space)
MUSCLEWARP_ARCHIVE(
    PlaneOwner, bone, muscle_above, muscle_below, above, below, share_above)
MUSCLEWARP_ARCHIVE(OwnedHalfSpaces, spaces, owners)
MUSCLEWARP_ARCHIVE(AttachedPoints, vertices, positions)
MUSCLEWARP_ARCHIVE(
    GuardedTriangle, triangle, corners, radius, first_space, num_spaces)
MUSCLEWARP_ARCHIVE_WITHOUT(KeptPlanes, (clearances), triangles, spaces)
MUSCLEWARP_ARCHIVE(ContactState,
                   pose,
                   bones_from_rest,
                   free_coarse,
                   coarse,
                   targets,
                   points,
                   held,
                   planes,
                   withheld,
                   bone_planes)

MUSCLEWARP_ARCHIVE(HeldVertices, vertices, positions)
MUSCLEWARP_ARCHIVE(VertexCorrections, fine_offset, held_coarse, held_fine)
MUSCLEWARP_ARCHIVE(MuscleState, coarse, corrections)
MUSCLEWARP_ARCHIVE(SceneState, pose, muscles, contact)

}  // namespace musclewarp
