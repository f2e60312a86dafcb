// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/export_osim.h"

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/base/portable_path.h"
#include "musclewarp/base/text.h"
#include "musclewarp/exchange/osim_file.h"
#include "musclewarp/exchange/run_paths.h"
#include "musclewarp/program/program.h"
#include "musclewarp/settings/checked_settings.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

void CheckFlags(const std::string& out, const OsimExportOptions& options) {
  if (fs::path(out).extension() != ".osim") {
    throw InputError("--out=" + out,
                     "is not an .osim file",
                     "use for example --out=model.osim");
  }
  CheckSettings(options);
}

// Throws InputError if the output would replace the delivered model.
void CheckIsOther(const std::string& out, const std::string& model) {
  if (fs::exists(out) && fs::equivalent(out, model)) {
    throw InputError(
        "--out=" + out, "is the model that is read", "give another name");
  }
}

std::string FolderOf(const std::string& file) {
  const fs::path folder = fs::path(file).parent_path();
  return folder.empty() ? "." : folder.string();
}

OrderedJson FitJson(const PathFit& fit, const RunPaths& paths, size_t samples) {
  OrderedJson names = OrderedJson::array();
  for (const int k : fit.coordinates) names.push_back(paths.coordinates[k]);
  return {{"coordinates", names},
          {"order", fit.length.order},
          {"samples", samples},
          {"length_error_max_mm", fit.errors.length_max},
          {"length_error_rms_mm", fit.errors.length_rms},
          {"arm_error_max_mm", fit.errors.arm_max},
          {"arm_error_rms_mm", fit.errors.arm_rms},
          {"within_bounds", fit.within_bounds}};
}

void PrintFit(const std::string& name,
              const PathFit& fit,
              std::ostream& screen) {
  char line[200];
  std::snprintf(
      line,
      sizeof line,
      "%-20s order %d of %d coordinates, length max %.4f rms %.4f mm, "
      "arm max %.4f rms %.4f mm%s\n",
      name.c_str(),
      fit.length.order,
      fit.length.dimension,
      fit.errors.length_max,
      fit.errors.length_rms,
      fit.errors.arm_max,
      fit.errors.arm_rms,
      fit.within_bounds ? "" : "  ABOVE THE BOUND");
  screen << line;
}

}  // namespace

int ExportOsim(const std::string& runs,
               const std::string& out,
               const OsimExportOptions& options,
               std::ostream& screen) {
  CheckFlags(out, options);
  const RunPaths paths = ReadRunPaths(Split(runs, ','), options.model);
  CheckIsOther(out, paths.model.path);
  std::map<std::string, PathFit> fits;
  OrderedJson lines = OrderedJson::object();
  bool is_fine = true;
  for (const auto& item : paths.lines) {
    const PathFit fit = FitPath(item.first, item.second, options.fit);
    is_fine = is_fine && fit.within_bounds;
    OrderedJson json = FitJson(fit, paths, item.second.size());
    const auto beyond = paths.beyond.find(item.first);
    json["beyond_muscle_mm"] =
        beyond == paths.beyond.end() ? 0 : beyond->second;
    lines[item.first] = std::move(json);
    fits[item.first] = fit;
  }
  const std::string text = WithFunctionPaths(
      ReadFile(paths.model.path), paths.model.path, paths.coordinates, fits);
  OrderedJson dirs = OrderedJson::array();
  for (const std::string& dir : Split(runs, ',')) {
    dirs.push_back(PathFrom(FolderOf(out), dir));
  }
  const OrderedJson record = {
      {"model", PathFrom(FolderOf(out), paths.model.path)},
      {"runs", dirs},
      {"max_length_error_mm", options.fit.max_length_error},
      {"max_arm_error_mm", options.fit.max_arm_error},
      {"within_bounds", is_fine},
      {"lines_left_out", paths.lines_without_muscle},
      {"muscles", lines}};
  WriteTextAtomically(fs::path(out).replace_extension(".fit.json").string(),
                      record.dump(2) + "\n");
  WriteTextAtomically(out, text);
  for (const std::string& line : paths.lines_without_muscle) {
    screen << "warning: the line \"" << line << "\" is not a muscle of "
           << paths.model.path << " and is left out\n";
  }
  for (const auto& item : fits) PrintFit(item.first, item.second, screen);
  if (!paths.beyond.empty()) {
    screen << paths.beyond.size()
           << " paths go on beyond their muscles, as through a tendon: these "
              "parts are as long as at rest in all poses\n";
  }
  screen << "wrote " << out << ": " << fits.size()
         << " muscles have a path function (OpenSim 4.5 or later)\n";
  return is_fine ? kExitUsable : kExitNotUsable;
}

}  // namespace musclewarp
