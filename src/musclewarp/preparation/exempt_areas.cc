// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/exempt_areas.h"

#include <utility>

#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/scene/attachment_area.h"

namespace musclewarp {

std::vector<ExemptArea> ExemptAreas(const PreparedScene& scene) {
  std::vector<ExemptArea> areas;
  for (size_t m = 0; m < scene.muscles.size(); ++m) {
    const MuscleModel& model = scene.muscles[m].model;
    for (size_t b = 0; b < scene.bones.size(); ++b) {
      ExemptArea area;
      area.muscle = static_cast<int>(m);
      area.bone = static_cast<int>(b);
      area.vertices.assign(model.fine_rest.rows(), false);
      bool is_any = false;
      for (const Attachment& attachment : model.attachments) {
        if (!attachment.may_penetrate ||
            attachment.body != scene.bones[b].body) {
          continue;
        }
        for (const int v : VerticesInArea(attachment, model.fine_rest)) {
          area.vertices[v] = is_any = true;
        }
      }
      if (!is_any) continue;
      for (Eigen::Index f = 0; f < model.fine_triangles.rows(); ++f) {
        const auto t = model.fine_triangles.row(f);
        area.triangles.push_back(area.vertices[t[0]] || area.vertices[t[1]] ||
                                 area.vertices[t[2]]);
      }
      areas.push_back(std::move(area));
    }
  }
  return areas;
}

}  // namespace musclewarp
