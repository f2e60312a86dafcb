// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/run/attachments_file.h"
#include "musclewarp/run/recorded_pose.h"

namespace musclewarp {

// The surfaces of a frame are made for other purposes than finite elements:
// those of bones are finer than contact needs, and the triangles of muscles are
// of the size and shape that segmentation gave them. The functions below
// replace them. Lengths are in mm.

// Finds the triangles of bones to which a muscle comes near in one of several
// poses, and simplifies the bones elsewhere, once for all poses:
//
//   BoneCoarsening coarsening(reach);
//   for (...) coarsening.AddPose(pose);
//   coarsening.Coarsen(tolerance, pose);
//   for (...) coarsening.Apply(&pose);
//
// The triangles within `reach` of a muscle stay, and with them every gap up to
// `reach`, which must be above the tolerance for muscles not to meet the bones
// elsewhere. The vertices that are left are those of the run, bit for bit.
class BoneCoarsening {
 public:
  explicit BoneCoarsening(double reach) : reach_(reach) {}

  // Keeps the triangles that are near muscles in this pose.
  void AddPose(const RecordedPose& pose);

  // Simplifies the bones, in any of the poses, so that no point is farther than
  // `tolerance` from the new surface. Returns the largest distance of a vertex
  // to it. Precondition (CHECKed): there is a pose.
  double Coarsen(double tolerance, const RecordedPose& pose);

  // Replaces the bones of a pose.
  void Apply(RecordedPose* pose) const;

 private:
  struct CoarseBone {
    std::vector<int> vertices;  // of the run
    Triangles triangles;
  };
  double reach_;
  std::vector<std::vector<bool>> is_kept_;  // by bone and vertex
  std::vector<CoarseBone> coarse_;
};

struct MuscleRemeshing {
  // The largest distance of an old vertex to the new surface of its muscle.
  double max_error = 0;

  // The muscles that keep their triangles, as new ones would cross each other.
  std::vector<std::string> unchanged;
};

// Gives muscles triangles with edges of about `edge_length`
// (RemeshedWithoutCrossings), and moves them apart where they then cross each
// other or bones (SeparateInitially). Attachments go to the new vertices that
// are nearest to attached ones. `body_size`: Scene::body_size of the run.
MuscleRemeshing RemeshMuscles(double edge_length,
                              double body_size,
                              const RecordedNames& names,
                              RecordedPose* pose,
                              RecordedAttachments* attachments);

}  // namespace musclewarp
