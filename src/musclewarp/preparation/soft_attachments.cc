// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/soft_attachments.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "musclewarp/fibres/attachment_outline.h"
#include "musclewarp/fibres/distance_outside.h"

namespace musclewarp {

std::optional<Attachment> TakeSoftAttachment(
    const TriangleBvh& surface,
    const std::string& name,
    std::vector<FoundAttachment>* found) {
  auto nearest_end = found->end();
  Eigen::VectorXd distances;
  for (auto end = found->begin(); end != found->end(); ++end) {
    const Points& points = end->attachment.points;
    Eigen::VectorXd here(points.rows());
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      here[i] = DistanceOutside({&surface}, points.row(i));
    }
    if (nearest_end != found->end() && here.mean() >= distances.mean()) {
      continue;
    }
    nearest_end = end;
    distances = std::move(here);
  }
  if (nearest_end == found->end()) return std::nullopt;
  std::vector<Eigen::Index> on_surface;
  for (Eigen::Index i = 0; i < distances.size(); ++i) {
    if (distances[i] <= distances.minCoeff() + kAreaDepth) {
      on_surface.push_back(i);
    }
  }
  Attachment attachment;
  attachment.soft_part = name;
  attachment.points = nearest_end->attachment.points(on_surface, Eigen::all);
  attachment.radius = kPointsAlone;
  found->erase(nearest_end);
  return attachment;
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
        model.carriers.emplace(static_cast<int>(a),
                               CarrierOf(attachment.points, other.model));
      }
    }
  }
}

std::vector<std::vector<int>> CarriersFirst(const PreparedScene& scene) {
  std::vector<int> open(scene.muscles.size());
  std::iota(open.begin(), open.end(), 0);
  std::vector<std::vector<int>> groups;
  while (!open.empty()) {
    std::set<std::string> names;
    for (const int i : open) names.insert(scene.muscles[i].model.name);
    std::vector<int> ready, waiting;
    for (const int i : open) {
      const MuscleModel& model = scene.muscles[i].model;
      const bool waits =
          std::any_of(model.carriers.begin(),
                      model.carriers.end(),
                      [&](const auto& carrier) {
                        return names.count(carrier.second.muscle) > 0;
                      });
      (waits ? waiting : ready).push_back(i);
    }
    if (ready.empty()) std::swap(ready, waiting);
    groups.push_back(std::move(ready));
    open = std::move(waiting);
  }
  return groups;
}

}  // namespace musclewarp
