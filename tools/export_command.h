// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "tools/export_elements.h"
#include "tools/export_osim.h"

namespace musclewarp {

// What musclewarp-export is asked for; the fields are its flags.
struct ExportRequest {
  std::string in;                  // a folder written by musclewarp-deform;
                                   // for osim several, with commas
  std::vector<std::string> files;  // mesh files instead; for crossings only
  std::string out;                 // a file or folder, as the format has it
  // One of ExportFormats(); of those for finite elements several, with commas.
  std::string format;
  std::string frames = "all";       // see SelectFrames in frame_selection.h
  std::string mesh_format = "ply";  // of crossings: ply, obj or vtp
  int threads = 0;                  // 0: as many as OpenMP chooses
  ElementOptions elements;
  OsimExportOptions osim;
};

// The values of --format in this build, separated by commas.
std::string ExportFormats();

// Writes a run for other programs (docs/export.md), and says on `screen` what
// was written. Returns an exit code. Throws InputError that names the flag or
// the file; nothing is written then.
int ExportCommand(const ExportRequest& request, std::ostream& screen);

}  // namespace musclewarp
