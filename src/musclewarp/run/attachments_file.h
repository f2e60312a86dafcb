// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// The file of a run that says which vertices of its muscles are attached to
// which bodies, and which bones the bodies have.
constexpr char kAttachmentsFile[] = "attachments.json";

// The vertices of a muscle that follow a body.
struct AttachedArea {
  std::string body;
  std::vector<int> vertices;  // ascending
};

struct RecordedAttachments {
  std::map<std::string, std::vector<AttachedArea>> muscles;  // by name
  std::map<std::string, std::string> bones;                  // name to body
};

// Returns the attachments of a scene; areas of a muscle on the same body are
// one.
RecordedAttachments AttachmentsOf(const PreparedScene& scene);

// Writes a file of attachments:
//
//   { "muscles": { "psoas_r": [ { "body": "pelvis", "vertices": [0, 7] } ] },
//     "bones": { "femur_r": "femur_r" } }
void WriteAttachments(const std::string& path,
                      const RecordedAttachments& attachments);

// Reads a file of attachments. Throws InputError that names the file and the
// field.
RecordedAttachments ReadAttachments(const std::string& path);

}  // namespace musclewarp
