// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/named_lines.h"

namespace musclewarp {

std::vector<std::string> NamedLines::Names() const {
  std::vector<std::string> names;
  for (const auto& entry : poses_file.lines) names.push_back(entry.first);
  if (!model) return names;
  for (const ModelMuscle& muscle : model->muscles) names.push_back(muscle.name);
  return names;
}

}  // namespace musclewarp
