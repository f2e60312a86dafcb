// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/bones_file.h"

#include "musclewarp/base/output_file.h"
#include "musclewarp/scene/json_fields.h"

namespace musclewarp {

void WriteBonesFile(const std::string& path, const BoneMotions& bones) {
  auto motions = nlohmann::ordered_json::object();
  for (const auto& [name, motion] : bones) {
    auto rows = nlohmann::ordered_json::array();
    for (int i = 0; i < 4; ++i) {
      rows.push_back({motion(i, 0), motion(i, 1), motion(i, 2), motion(i, 3)});
    }
    motions[name] = rows;
  }
  const nlohmann::ordered_json file = {{"units", "mm"}, {"bones", motions}};
  // Names of an .osim may not be UTF-8.
  const auto on_error = nlohmann::ordered_json::error_handler_t::replace;
  WriteTextAtomically(path, file.dump(-1, ' ', false, on_error) + "\n");
}

BoneMotions ReadBonesFile(const std::string& path) {
  const JsonField bones = JsonField::ParseFile(path).At("bones");
  bones.CheckObject();
  BoneMotions motions;
  for (const std::string& member : bones.Keys()) {
    motions[member] = bones.At(member).AsRigidTransform();
  }
  return motions;
}

}  // namespace musclewarp
