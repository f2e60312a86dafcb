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

constexpr auto FieldsOf(Described<SeparationFiles>) {
  using S = SeparationFiles;
  return std::make_tuple(
      Field(&S::out, "out").Text("folder for the separated meshes").Path(),
      Inherited<FormatSettings>(),
      Field(&S::json, "json")
          .Text("also write DIR/separation.json, with all figures"));
}

// What musclewarp-separate is asked for beside the files that may move.
struct SeparateOptions : SeparationSettings,
                         LabelSettings,
                         SeparationFiles,
                         ThreadSettings {
  bool is_terminal = false;  // true if the screen is a terminal
};

// Moves the vertices of meshes as little as it takes for no two of them to
// cross and for each to keep its volume (SeparateRest): the meshes are the
// muscles of a scene that has neither lines of action nor poses. Bones stay
// where they are. They are tested neither against each other nor with
// themselves.
//
// `files` are mesh files and at most one label image (label_image_file.h), of
// which every label becomes a mesh in millimetres and in LPS (label_meshes.h).
//
// Meshes are named by the stems of their files, those of labels by the table,
// and are repaired first. All of them, bones too, are written to
// out/<name>.<format>, and tables of what crossed and what moved to `screen`.
// With `json`, out/separation.json has the same figures under the keys of
// report.json (docs/report.md).
//
// Returns 0 if the certificate of the result has no shortcomings
// (certificate/shortcomings.h; how far meshes move does not count), and 1 if it
// has, or if the program was interrupted (SIGINT, SIGTERM). Throws InputError,
// before anything is written, for files that cannot be read or repaired, two
// files of one name, options that are not allowed, results that would replace a
// file that was read, a label image that cannot be read or has a label of which
// no surface can be made, and meshes that cannot be separated.
int SeparateCommand(const std::vector<std::string>& files,
                    const SeparateOptions& options,
                    std::ostream& screen);

}  // namespace musclewarp
