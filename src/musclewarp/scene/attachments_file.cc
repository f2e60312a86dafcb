// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/attachments_file.h"

#include "musclewarp/scene/json_fields.h"

namespace musclewarp {

std::map<std::string, std::vector<Attachment>> ReadAttachmentsFile(
    const std::string& path,
    const std::map<std::string, std::string>& bodies,
    double radius) {
  const JsonField root = JsonField::ParseFile(path).InItsUnits();
  std::map<std::string, std::vector<Attachment>> attachments;
  const JsonField muscles = root.At("muscles");
  muscles.CheckObject();
  for (const std::string& member : muscles.Keys()) {
    const JsonField muscle = muscles.At(member);
    muscle.CheckObject();
    for (const auto& [key, body] : bodies) {
      if (!muscle.Has(key)) continue;
      const JsonField sets = muscle.At(key);
      for (size_t i = 0; i < sets.ArraySize(); ++i) {
        Attachment attachment;
        attachment.body = body;
        attachment.points = sets.At(i).At("points").AsPoints();
        attachment.radius = radius;
        if (attachment.points.rows() == 0) {
          sets.At(i).At("points").Fail("is empty", "give at least one point");
        }
        attachments[member].push_back(std::move(attachment));
      }
    }
  }
  return attachments;
}

}  // namespace musclewarp
