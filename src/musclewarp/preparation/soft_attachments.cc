// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/soft_attachments.h"

#include <utility>

#include "musclewarp/base/infinity.h"
#include "musclewarp/fibres/attachment_outline.h"
#include "musclewarp/fibres/distance_outside.h"
#include "musclewarp/fibres/found_attachments.h"

namespace musclewarp {

namespace {

// The part of the tips of a muscle (#P x 3 each) that lies on a surface or in
// it; none of a tip that is farther away than another.
Points PartOnSurface(const std::vector<Points>& tips,
                     const TriangleBvh& surface) {
  Points area;
  double nearest = kInfinity;
  for (const Points& tip : tips) {
    Eigen::VectorXd distances(tip.rows());
    for (Eigen::Index i = 0; i < tip.rows(); ++i) {
      distances[i] = DistanceOutside({&surface}, tip.row(i));
    }
    if (distances.minCoeff() >= nearest) continue;
    nearest = distances.minCoeff();
    std::vector<Eigen::Index> near;
    for (Eigen::Index i = 0; i < tip.rows(); ++i) {
      if (distances[i] <= nearest + kAreaDepth) near.push_back(i);
    }
    area = tip(near, Eigen::all);
  }
  return area;
}

}  // namespace

void AddSoftAttachments(const TriangleSoup& fine,
                        const Surroundings& surroundings,
                        const Scene& scene,
                        const std::vector<int>& tied_to,
                        SceneMuscle* muscle) {
  if (tied_to.empty()) return;
  std::vector<Points> tips;
  for (const FoundAttachment& end :
       FindAttachments(fine, surroundings.bodies(), muscle->lines)) {
    if (!end.is_on_bones) tips.push_back(end.attachment.points);
  }
  for (const int other : tied_to) {
    Attachment attachment;
    attachment.soft_part = scene.muscles[other].name;
    attachment.points = PartOnSurface(tips, surroundings.surface_of(other));
    attachment.radius = kPointsAlone;
    if (attachment.points.rows() == 0) continue;
    muscle->attachments.push_back(std::move(attachment));
  }
}

void AddSoftCarriers(PreparedScene* scene) {
  for (PreparedMuscle& muscle : scene->muscles) {
    MuscleModel& model = muscle.model;
    model.carriers.clear();
    for (size_t a = 0; a < model.attachments.size(); ++a) {
      const Attachment& attachment = model.attachments[a];
      for (const PreparedMuscle& other : scene->muscles) {
        if (attachment.soft_part.empty() ||
            other.model.name != attachment.soft_part) {
          continue;
        }
        model.carriers.emplace(
            static_cast<int>(a),
            CarrierOf(
                attachment.points, other.model.lines, other.model.guides));
      }
    }
  }
}

}  // namespace musclewarp
