// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "tools/export_elements.h"
#include "tools/export_osim.h"

#include "musclewarp/settings/thread_settings.h"

namespace musclewarp {

// The settings of musclewarp-export.
struct ExportRequest : ThreadSettings {
  std::string in;
  std::string out;
  std::string format;
  std::string frames = "all";  // see SelectFrames in frame_selection.h
  std::string mesh_format = "ply";
  std::vector<std::string> files;  // meshes in place of a run; for crossings
  ElementOptions elements;
  PathExportOptions paths;
};

constexpr auto FieldsOf(Described<ExportRequest>) {
  using S = ExportRequest;
  return std::make_tuple(
      Field(&S::in, "in")
          .Text("folder written by musclewarp-deform; for fit, mjcf and osim "
                "several with commas")
          .Path(),
      Field(&S::out, "out")
          .Text("the file (csv, fit, glb, osim) or the folder (else) to write")
          .Path(),
      Field(&S::format, "format")
          .Text("crossings: places where meshes cross; csv: one table of "
                "lengths, moment arms, volumes and sections; fit: lengths and "
                "moment arms as functions (.json); glb: glTF 2.0; mjcf: "
                "a model for MuJoCo with muscles and their skins; pc2: .obj "
                "and point caches for Blender; osim: the OpenSim model "
                "with path functions; inp, feb, msh and with VTK vtu: finite "
                "elements, several with commas")
          .OneOf("crossings, csv, fit, glb, mjcf, osim, pc2, feb, inp, msh, "
                 "vtu; commas"),
      Field(&S::frames, "frames")
          .Text("which frames: all, last, N, FIRST:LAST, FIRST:LAST:STEP, "
                "PART/PARTS; "
                "FIRST and LAST may be times (0.1s)"),
      Field(&S::mesh_format, "mesh_format")
          .Text("of crossings: ply, obj, and with VTK vtp")
          .OneOf("ply, obj, vtp"),
      Inherited<ThreadSettings>(),
      NotWritten(&S::files),
      NotWritten(&S::elements),
      NotWritten(&S::paths));
}

// Returns the values of --format in this build, separated by commas.
std::string ExportFormats();

// Writes a run for other programs (docs/export.md), and lists the written files
// on `screen`. Returns an exit code. Throws InputError, naming the flag or the
// file, before anything is written.
int ExportCommand(const ExportRequest& request, std::ostream& screen);

}  // namespace musclewarp
