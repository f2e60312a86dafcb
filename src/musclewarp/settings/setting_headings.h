// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The headings under which programs list the settings of each struct. A struct
// of a program's own has its heading beside its list of fields.

#include "musclewarp/base/described.h"

namespace musclewarp {

struct ArticulationSettings;
struct DeformerSettings;
struct FileSettings;
struct FormatSettings;
struct LabelSettings;
struct RestSettings;
struct SceneSettings;
struct SeparationSettings;
struct ThreadSettings;
struct UnitSettings;

constexpr const char* HeadingOf(Described<ArticulationSettings>) {
  return "Joints";
}
constexpr const char* HeadingOf(Described<DeformerSettings>) {
  return "Deformation and contact";
}
constexpr const char* HeadingOf(Described<FileSettings>) {
  return "Mesh files";
}
constexpr const char* HeadingOf(Described<FormatSettings>) {
  return "Mesh files";
}
constexpr const char* HeadingOf(Described<LabelSettings>) {
  return "Label images and mesh files that come in";
}
constexpr const char* HeadingOf(Described<RestSettings>) {
  return "Repair and separation at rest";
}
constexpr const char* HeadingOf(Described<SceneSettings>) {
  return "Scene and poses";
}
constexpr const char* HeadingOf(Described<SeparationSettings>) {
  return "Repair and separation at rest";
}
constexpr const char* HeadingOf(Described<ThreadSettings>) {
  return "Processor";
}
constexpr const char* HeadingOf(Described<UnitSettings>) {
  return "Label images and mesh files that come in";
}

}  // namespace musclewarp
