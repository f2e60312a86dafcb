// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/export_osim.h"

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/base/portable_path.h"
#include "musclewarp/base/text.h"
#include "musclewarp/exchange/osim_bands.h"
#include "musclewarp/exchange/osim_file.h"
#include "musclewarp/exchange/run_paths.h"
#include "musclewarp/program/program.h"
#include "musclewarp/settings/checked_settings.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

void CheckFlags(const std::string& out,
                const std::string& extension,
                const PathExportOptions& options) {
  if (fs::path(out).extension() != extension) {
    throw InputError("--out=" + out,
                     "is not an " + extension + " file",
                     "use for example --out=model" + extension);
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

// Removes the paths that the model does not have as muscles, and returns their
// names.
std::vector<std::string> DropLinesWithoutMuscle(RunPaths* paths) {
  std::vector<std::string> names = paths->lines_without_arms;
  std::vector<MeasuredPath> kept;
  for (MeasuredPath& path : paths->paths) {
    if (!path.replaces.empty()) {
      kept.push_back(std::move(path));
    } else {
      names.push_back(path.name);
    }
  }
  paths->paths = std::move(kept);
  if (paths->paths.empty()) {
    throw InputError("{in}",
                     "has no line that is a muscle of " + paths->model.path,
                     "check {model} and the \"lines\" of the scene");
  }
  return names;
}

// The muscles of bands of fibres, for the record.
OrderedJson BandsJson(const std::vector<BandMuscle>& bands) {
  OrderedJson json = OrderedJson::object();
  for (const BandMuscle& band : bands) {
    json[band.name] = {{"like", band.like},
                       {"replaces", band.replaces},
                       {"force_n", band.force},
                       {"tendon_mm", band.tendon}};
  }
  return json;
}

void PrintBands(const std::vector<BandMuscle>& bands, std::ostream& screen) {
  std::set<std::string> replaced;
  for (const BandMuscle& band : bands) {
    replaced.insert(band.replaces.begin(), band.replaces.end());
    if (band.tendon == kShortestTendon) {
      screen << "warning: " << band.name << " is so much shorter than "
             << band.like << " that no tendon is left; it has one of "
             << kShortestTendon << " mm, and its fibres work at shorter "
             << "lengths\n";
    }
  }
  screen << bands.size() << " bands of fibres replace " << replaced.size()
         << " muscles, with the forces of these by numbers of fibres\n";
}

std::string FolderOf(const std::string& file) {
  const fs::path folder = fs::path(file).parent_path();
  return folder.empty() ? "." : folder.string();
}

int ExitCodeOf(const FittedPaths& fitted) {
  return fitted.AreWithinBounds() ? kExitUsable : kExitNotUsable;
}

}  // namespace

OrderedJson PathRecord(const std::string& runs,
                       const std::string& out,
                       const RunPaths& paths,
                       const FittedPaths& fitted,
                       const PathBounds& bounds) {
  OrderedJson dirs = OrderedJson::array();
  for (const std::string& dir : Split(runs, ',')) {
    dirs.push_back(PathFrom(FolderOf(out), dir));
  }
  OrderedJson record = {{"model", PathFrom(FolderOf(out), paths.model.path)},
                        {"runs", dirs}};
  record.update(FitJson(paths, fitted, bounds));
  return record;
}

int ExportFit(const std::string& runs,
              const std::string& out,
              const PathExportOptions& options,
              std::ostream& screen) {
  CheckFlags(out, ".json", options);
  const RunPaths paths =
      ReadRunPaths(Split(runs, ','), options.model, options.paths_per_muscle);
  const FittedPaths fitted = FitPaths(paths, options.bounds);
  WriteTextAtomically(
      out, PathRecord(runs, out, paths, fitted, options.bounds).dump(2) + "\n");
  PrintFits(paths, fitted, screen);
  screen << "wrote " << out << "\n";
  return ExitCodeOf(fitted);
}

int ExportOsim(const std::string& runs,
               const std::string& out,
               const PathExportOptions& options,
               std::ostream& screen) {
  CheckFlags(out, ".osim", options);
  RunPaths paths =
      ReadRunPaths(Split(runs, ','), options.model, options.paths_per_muscle);
  CheckIsOther(out, paths.model.path);
  const std::vector<std::string> left_out = DropLinesWithoutMuscle(&paths);
  const FittedPaths fitted = FitPaths(paths, options.bounds);
  std::map<std::string, PathFunction> functions;
  for (const FittedPath& one : fitted.paths) {
    functions[one.path->name] = one.fit.path;
  }
  OrderedJson record = PathRecord(runs, out, paths, fitted, options.bounds);
  std::string text = ReadFile(paths.model.path);
  std::vector<BandMuscle> bands;
  if (options.paths_per_muscle > 0) {
    bands = BandMusclesOf(paths);
    text = WithBandMuscles(text, paths.model.path, bands);
    record["bands"] = BandsJson(bands);
  }
  text =
      WithFunctionPaths(text, paths.model.path, paths.coordinates, functions);
  record["lines_left_out"] = left_out;
  WriteTextAtomically(fs::path(out).replace_extension(".fit.json").string(),
                      record.dump(2) + "\n");
  WriteTextAtomically(out, text);
  for (const std::string& line : left_out) {
    screen << "warning: the line \"" << line << "\" is not a muscle of "
           << paths.model.path << " and is left out\n";
  }
  PrintFits(paths, fitted, screen);
  if (!bands.empty()) PrintBands(bands, screen);
  screen << "wrote " << out << ": " << functions.size()
         << " muscles have a path function (OpenSim 4.5 or later)\n";
  return ExitCodeOf(fitted);
}

}  // namespace musclewarp
