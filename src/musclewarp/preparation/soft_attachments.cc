// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/soft_attachments.h"

#include <algorithm>
#include <utility>

#include "musclewarp/base/infinity.h"
#include "musclewarp/fibres/attachment_outline.h"
#include "musclewarp/fibres/distance_outside.h"
#include "musclewarp/fibres/found_attachments.h"

namespace musclewarp {

std::vector<Attachment> SoftAttachments(const TriangleSoup& fine,
                                        const std::vector<BodySurface>& bodies,
                                        const std::vector<ActionLine>& lines,
                                        const TriangleBvh& surface,
                                        const std::string& name) {
  Points area;
  Eigen::VectorXd distances;
  double nearest = kInfinity;
  for (const FoundAttachment& end : FindAttachments(fine, bodies, lines)) {
    if (end.is_on_bones) continue;
    const Points& points = end.attachment.points;
    Eigen::VectorXd here(points.rows());
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      here[i] = DistanceOutside({&surface}, points.row(i));
    }
    if (here.minCoeff() >= nearest) continue;
    nearest = here.minCoeff();
    area = points;
    distances = std::move(here);
  }
  std::vector<int> on_surface;
  for (Eigen::Index i = 0; i < area.rows(); ++i) {
    if (distances[i] <= nearest + kAreaDepth) {
      on_surface.push_back(static_cast<int>(i));
    }
  }
  if (on_surface.empty()) return {};
  Attachment attachment;
  attachment.soft_part = name;
  attachment.points = area(on_surface, Eigen::all);
  attachment.radius = kPointsAlone;
  return {attachment};
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
