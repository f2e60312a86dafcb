// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/deform_command.h"

#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh/mesh_io.h"
#include "musclewarp/motion/frame.h"
#include "musclewarp/motion/frame_files.h"
#include "musclewarp/report/report_json.h"
#include "musclewarp/report/screen_report.h"
#include "tools/program.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> Split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) {
    parts.push_back(part);
  }
  return parts;
}

int ParseFrameNumber(const std::string& text, const std::string& frames) {
  if (text.empty() || text.size() > 8 ||
      !std::all_of(text.begin(), text.end(), [](unsigned char c) {
        return std::isdigit(c);
      })) {
    throw InputError("--frames=" + frames,
                     "\"" + text + "\" is not a frame number",
                     "allowed: all, last, N, FIRST:LAST, FIRST:LAST:STEP");
  }
  return std::stoi(text);
}

}  // namespace

SolverConfiguration ParseSolver(const std::string& text) {
  if (text != "ceres" && text != "reference") {
    throw InputError(
        "--solver=" + text, "is not a solver", "allowed: ceres, reference");
  }
  return SolverConfigurationNamed(text);
}

DeformContact ParseDeformContact(const std::string& text) {
  if (text == "none") return DeformContact::kNone;
  if (text == "paper") return DeformContact::kPaper;
  throw InputError("--contact=" + text,
                   "is not something this version does",
                   "allowed: none, paper");
}

ContactLevel ParseContactLevel(const std::string& text) {
  if (text == "coarse") return ContactLevel::kCoarse;
  if (text == "fine") return ContactLevel::kFine;
  throw InputError(
      "--contact_level=" + text, "is not a level", "allowed: coarse, fine");
}

std::vector<std::string> ParseFormats(const std::string& text) {
  const std::vector<std::string> formats = Split(text, ',');
  for (const std::string& format : formats) {
    if ((format != "ply" && format != "obj" && format != "vtp") ||
        !IsMeshExtension(format)) {
      throw InputError("--format=" + text,
                       "\"" + format + "\" cannot be written by this build",
                       "allowed: ply, obj, vtp (with VTK), or several with "
                       "commas");
    }
  }
  if (formats.empty()) {
    throw InputError("--format", "is empty", "allowed: ply, obj, vtp");
  }
  return formats;
}

std::vector<int> SelectFrames(const std::string& frames, int count) {
  int first = 0;
  int last = count - 1;
  int step = 1;
  if (frames == "last") {
    first = last;
  } else if (frames != "all") {
    const std::vector<std::string> parts = Split(frames, ':');
    if (parts.empty() || parts.size() > 3 || frames.back() == ':') {
      ParseFrameNumber("", frames);
    }
    first = last = ParseFrameNumber(parts[0], frames);
    if (parts.size() > 1) last = ParseFrameNumber(parts[1], frames);
    if (parts.size() > 2) step = ParseFrameNumber(parts[2], frames);
  }
  if (first > last || last >= count || step < 1) {
    throw InputError("--frames=" + frames,
                     "selects no frame or one that is not there",
                     "the scene has frames 0 to " + std::to_string(count - 1));
  }
  std::vector<int> selected;
  for (int frame = first; frame <= last; frame += step) {
    selected.push_back(frame);
  }
  return selected;
}

void CheckSceneOptions(const DeformOptions& options) {
  std::string error;
  if (!options.prepare.muscle.IsValid(&error) ||
      !options.solver.IsValid(&error) ||
      !options.scene_contact.IsValid(&error)) {
    throw InputError("flags", error, "see --help");
  }
  if (options.scene.empty()) {
    throw InputError("--scene", "is missing", "give a scene file");
  }
  if (options.threads < 0) {
    throw InputError("--threads",
                     "is " + std::to_string(options.threads),
                     "allowed: 0 (all cores) or above");
  }
}

void CheckWritable(const std::string& dir) {
  if (dir.empty()) {
    throw InputError("--out", "is missing", "give the folder for the results");
  }
  fs::path existing = fs::absolute(dir);
  std::error_code error;
  while (!fs::exists(existing, error) && existing.has_relative_path()) {
    existing = existing.parent_path();
  }
  if (!fs::is_directory(existing, error) ||
      access(existing.c_str(), W_OK | X_OK) != 0) {
    throw InputError("--out=" + dir,
                     existing.string() + " is not a folder that can be written",
                     "choose another folder");
  }
}

void MakeFolder(const std::string& dir) {
  std::error_code error;
  fs::create_directories(dir, error);
  if (error) {
    throw InputError("--out=" + dir,
                     "cannot be made (" + error.message() + ")",
                     "choose another folder");
  }
}

int DeformCommand(const DeformOptions& options, std::ostream& screen) {
  CheckSceneOptions(options);
  CheckWritable(options.out);
  if (options.threads > 0) omp_set_num_threads(options.threads);
  const Scene scene = ReadScene(options.scene, options.data_root);
  const std::vector<int> selected =
      SelectFrames(options.frames, static_cast<int>(scene.poses.size()));
  const PreparedScene prepared = PrepareScene(scene, options.prepare);
  std::optional<SceneContact> contact;
  if (options.contact == DeformContact::kPaper) {
    contact = PrepareContact(prepared, options.scene_contact);
  }
  PrintPreparation(prepared, screen);

  MakeFolder(options.out);
  RunRecord run;
  run.solver = options.solver.name;
  if (contact) {
    run.contact = &*contact;
    run.rest_after_fix = RestIntersectionsAfterFix(prepared, *contact);
  }
  run.scene = &prepared;
  run.rest = RestIntersections(prepared);
  const GroupSolver solver = SolverOf(options.solver, contact.has_value());
  for (const int index : selected) {
    run.frames.push_back(SolveFrame(prepared,
                                    contact ? &*contact : nullptr,
                                    index,
                                    options.pre_rotation,
                                    solver));
    WriteFrame(prepared, run.frames.back(), options.formats, options.out);
  }
  if (std::count(options.formats.begin(), options.formats.end(), "vtp")) {
    WritePvd(prepared, selected, options.out);
  }
  const std::string report = (fs::path(options.out) / "report.json").string();
  WriteTextAtomically(report, ReportJson(run).dump(2) + "\n");
  PrintFrames(run, screen);
  screen << "report: " << report << "\n";
  return TotalsOf(run).usable ? kExitUsable : kExitNotUsable;
}

}  // namespace musclewarp
