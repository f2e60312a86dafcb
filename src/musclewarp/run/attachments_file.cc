// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/attachments_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "musclewarp/base/output_file.h"
#include "musclewarp/scene/json_fields.h"

namespace musclewarp {

RecordedAttachments AttachmentsOf(const PreparedScene& scene) {
  RecordedAttachments recorded;
  for (const PreparedMuscle& muscle : scene.muscles) {
    std::map<std::string, std::vector<int>> by_body;
    const AttachedVertices& attached = muscle.attached;
    for (size_t i = 0; i < attached.vertices.size(); ++i) {
      const auto& area = muscle.model.attachments[attached.attachment[i]];
      if (!area.soft_part.empty()) continue;
      by_body[area.body].push_back(attached.vertices[i]);
    }
    auto& areas = recorded.muscles[muscle.model.name];
    for (auto& [body, vertices] : by_body) {
      areas.push_back({body, std::move(vertices)});
    }
  }
  for (const PreparedBone& bone : scene.bones) {
    recorded.bones[bone.mesh.name] = bone.body;
  }
  return recorded;
}

void WriteAttachments(const std::string& path,
                      const RecordedAttachments& attachments) {
  nlohmann::ordered_json muscles = nlohmann::ordered_json::object();
  for (const auto& [name, areas] : attachments.muscles) {
    auto list = nlohmann::ordered_json::array();
    for (const AttachedArea& area : areas) {
      list.push_back({{"body", area.body}, {"vertices", area.vertices}});
    }
    muscles[name] = list;
  }
  const nlohmann::ordered_json all = {{"muscles", muscles},
                                      {"bones", attachments.bones}};
  WriteTextAtomically(path, all.dump() + "\n");
}

RecordedAttachments ReadAttachments(const std::string& path) {
  const JsonField all = JsonField::ParseFile(path);
  RecordedAttachments attachments;
  const JsonField muscles = all.At("muscles");
  muscles.CheckObject();
  for (const std::string& member : muscles.Keys()) {
    const JsonField list = muscles.At(member);
    for (size_t i = 0; i < list.ArraySize(); ++i) {
      AttachedArea area;
      area.body = list.At(i).At("body").AsString();
      const JsonField vertices = list.At(i).At("vertices");
      for (size_t k = 0; k < vertices.ArraySize(); ++k) {
        const double v = vertices.At(k).AsNumber();
        if (!(v >= 0 && v < 1e9 && v == static_cast<int>(v))) {
          vertices.At(k).Fail("is no number of a vertex",
                              "run musclewarp-deform again");
        }
        area.vertices.push_back(static_cast<int>(v));
      }
      attachments.muscles[member].push_back(std::move(area));
    }
  }
  const JsonField bones = all.At("bones");
  bones.CheckObject();
  for (const std::string& member : bones.Keys()) {
    attachments.bones[member] = bones.At(member).AsString();
  }
  return attachments;
}

}  // namespace musclewarp
