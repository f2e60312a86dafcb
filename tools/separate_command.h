// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/settings/file_settings.h"
#include "musclewarp/settings/label_settings.h"
#include "musclewarp/settings/separation_settings.h"
#include "musclewarp/settings/thread_settings.h"

namespace musclewarp {

// The settings of the files that musclewarp-separate writes.
struct SeparationFiles : FormatSettings {
  std::string out;
  bool json = false;
};

constexpr const char* HeadingOf(Described<SeparationFiles>) {
  return "Files of the separation";
}

constexpr auto FieldsOf(Described<SeparationFiles>) {
  using S = SeparationFiles;
  return std::make_tuple(
      Field(&S::out, "out").Text("folder for the separated meshes").Path(),
      Inherited<FormatSettings>(),
      Field(&S::json, "json")
          .Text("also write DIR/separation.json, with all figures"));
}

// The options of musclewarp-separate.
struct SeparateOptions : SeparationSettings,
                         LabelSettings,
                         SeparationFiles,
                         ThreadSettings {
  bool is_terminal = false;  // true if the screen is a terminal
};

// Moves the vertices of meshes as little as possible such that no two meshes
// cross and each keeps its volume (SeparateRest). The meshes are the muscles of
// a scene without action lines and poses. Bones do not move, and are tested
// neither against each other nor against themselves.
//
// `files` are mesh files and at most one label image (label_image_file.h), of
// which every label becomes a mesh in millimetres and in LPS (label_meshes.h).
//
// Meshes have the names of their files without extension, those of labels the
// names of the table; all are repaired first. All of them, bones too, are
// written to out/<name>.<format>, and tables of crossings and displacements to
// `screen`. With `json`, out/separation.json has the same figures under the
// keys of report.json (docs/report.md).
//
// Returns 0 if the result has no shortcomings (certificate/shortcomings.h), and
// 1 if it has any or the program was interrupted (SIGINT, SIGTERM). Throws
// InputError, before anything is written, for files that cannot be read or
// repaired, two meshes of the same name, options that are not allowed, results
// that would replace an input file, a label image that cannot be read or has a
// label without a surface, and meshes that cannot be separated.
int SeparateCommand(const std::vector<std::string>& files,
                    const SeparateOptions& options,
                    std::ostream& screen);

}  // namespace musclewarp
