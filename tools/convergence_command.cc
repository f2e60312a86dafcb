// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/convergence_command.h"

#include <charconv>
#include <filesystem>
#include <functional>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/base/text.h"
#include "musclewarp/build_info/build_info.h"
#include "musclewarp/program/program.h"
#include "musclewarp/report/screen_report.h"
#include "musclewarp/run/output_folder.h"
#include "musclewarp/run/paths_in_json.h"
#include "musclewarp/run/report_json.h"
#include "musclewarp/scene/frame_selection.h"
#include "musclewarp/studies/convergence_run.h"
#include "musclewarp/studies/convergence_table.h"
#include "musclewarp/studies/mesh_density.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

// Returns the numbers of a flag. Throws InputError, which states what is
// `allowed`, for a number for which `is_allowed` is false.
template <typename Number>
std::vector<Number> ParseNumbers(const std::string& flag,
                                 const std::string& text,
                                 const std::function<bool(Number)>& is_allowed,
                                 const std::string& allowed) {
  std::vector<Number> numbers;
  for (const std::string& word : Split(text, ',')) {
    Number number = 0;
    const char* end = word.data() + word.size();
    const auto [rest, error] = std::from_chars(word.data(), end, number);
    if (error != std::errc() || rest != end || !is_allowed(number)) {
      throw InputError(flag + "=" + text,
                       "\"" + word + "\" is not a value of this study",
                       "allowed: " + allowed);
    }
    numbers.push_back(number);
  }
  return numbers;
}

// Throws InputError if no study has values or an option is not allowed.
void CheckOptions(const ConvergenceOptions& options) {
  CheckSceneOptions(options.deform);
  const StudyValues& values = options.values;
  if (values.vertices.empty() && values.spacings.empty() &&
      values.densities.empty()) {
    throw InputError("--convergence",
                     "has nothing to vary",
                     "give --convergence_vertices, --convergence_spacing or "
                     "--convergence_density a list of values");
  }
}

// Returns the options, with the repairs that the kind of contact needs.
DeformerOptions CompletedOptions(DeformerOptions options) {
  const bool is_certified = options.frames.contact == ContactKind::kCertified;
  options.prepare.remove_self_crossings |= is_certified;
  options.prepare.remove_slivers |= is_certified;
  return options;
}

std::string DescribeAll(const Discretisation& discretisation) {
  std::string text;
  for (const StudyKind kind :
       {StudyKind::kVertices, StudyKind::kSpacing, StudyKind::kDensity}) {
    text += (text.empty() ? "" : ", ") +
            Describe(kind, ValueOf(kind, discretisation));
  }
  return text;
}

StudiedFrames StudiedFramesOf(const PreparedScene& scene,
                              const std::vector<int>& selected) {
  StudiedFrames studied;
  studied.frames = selected;
  for (const int index : selected) {
    studied.poses.push_back(scene.scene.poses[index].name);
  }
  for (const PreparedMuscle& muscle : scene.muscles) {
    studied.muscles.push_back(muscle.model.name);
  }
  return studied;
}

std::vector<ConvergenceRow> RunStudies(const ConvergenceOptions& options,
                                       const DeformerOptions& deformer,
                                       const PreparedScene& base,
                                       const std::vector<int>& selected,
                                       std::ostream& screen) {
  const Discretisation as_set = DiscretisationOf(deformer.prepare);
  const std::vector<ConvergenceStudy> studies =
      StudiesOf(options.values, as_set);
  std::vector<DiscretisationResult> results;
  for (const Discretisation& discretisation :
       AllDiscretisations(studies, as_set)) {
    const Stopwatch stopwatch;
    screen << DescribeAll(discretisation) << ": " << std::flush;
    results.push_back(
        SolveDiscretisation(deformer, base, discretisation, selected));
    screen << (results.back().failure.empty() ? "solved in " : "failed after ")
           << static_cast<int>(stopwatch.Milliseconds()) << " ms" << std::endl;
  }
  std::vector<ConvergenceRow> rows;
  for (const ConvergenceStudy& study : studies) {
    for (ConvergenceRow& row :
         RowsOf(study, results, as_set, StudiedFramesOf(base, selected))) {
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

void WriteStudies(const DeformOptions& options,
                  const PreparedScene& scene,
                  const std::vector<ConvergenceRow>& rows) {
  const Discretisation as_set = DiscretisationOf(options.deformer.prepare);
  OrderedJson json = {{"scene", scene.scene.name},
                      {"command", options.command},
                      {"contact", ToString(options.deformer.frames.contact)},
                      {"machine", MachineJson()},
                      {"version", kVersion},
                      {"as_set",
                       {{"coarse_vertices", as_set.coarse_vertices},
                        {"sample_spacing_mm", as_set.sample_spacing},
                        {"density", as_set.density}}},
                      {"rows", ConvergenceJson(rows)}};
  MakeFolder(options.out);
  AdaptTexts(options.out, &json);
  const std::filesystem::path out = options.out;
  WriteTextAtomically((out / "convergence.csv").string(), ConvergenceCsv(rows));
  WriteTextAtomically(
      (out / "convergence.json").string(),
      json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n");
}

}  // namespace

StudyValues StudyValuesOf(const ConvergenceSettings& settings) {
  const auto is_hull = [](int number) {
    OuterHullOptions options;
    options.coarse_vertices = number;
    std::string error;
    return options.IsValid(&error);
  };
  const auto is_spacing = [](double number) {
    MuscleModelOptions options;
    options.sample_spacing = number;
    std::string error;
    return options.IsValid(&error);
  };
  StudyValues values;
  values.vertices =
      ParseNumbers<int>("--convergence_vertices",
                        settings.convergence_vertices,
                        is_hull,
                        "whole numbers from 20 to 5000, with commas");
  values.spacings = ParseNumbers<double>("--convergence_spacing",
                                         settings.convergence_spacing,
                                         is_spacing,
                                         "0.01 mm or above, with commas");
  values.densities = ParseNumbers<double>("--convergence_density",
                                          settings.convergence_density,
                                          IsDensity,
                                          "0.25, 1, 4 and 16, with commas");
  return values;
}

ContactKind ParseConvergenceContact(const std::string& text) {
  if (text == ToString(ContactKind::kNone)) return ContactKind::kNone;
  if (text == ToString(ContactKind::kCertified)) return ContactKind::kCertified;
  throw InputError("--contact=" + text,
                   "cannot be used with --convergence",
                   "allowed: none, certified");
}

int ConvergenceCommand(const ConvergenceOptions& options,
                       std::ostream& screen) {
  const DeformOptions& deform = options.deform;
  CheckOptions(options);
  if (!deform.out.empty()) CheckWritable(deform.out);
  UseThreads(deform);
  const Scene scene = ReadScene(deform.scene, deform.data_root, deform.sources);
  const std::vector<int> selected = SelectFrames(deform.frames, scene.poses);
  const DeformerOptions deformer = CompletedOptions(deform.deformer);
  const PreparedScene base = PrepareScene(scene, deformer.prepare);
  ContactReport contact;
  contact.kind = deformer.frames.contact;
  contact.name = ToString(contact.kind);
  PrintPreparation(base, contact, screen);
  screen << "\n";
  const std::vector<ConvergenceRow> rows =
      RunStudies(options, deformer, base, selected, screen);
  PrintConvergence(rows, screen);
  screen << "\n";
  if (!deform.out.empty()) {
    WriteStudies(deform, base, rows);
    screen << "written: " << deform.out
           << "/convergence.csv, convergence.json\n\n";
  }
  PrintErrors(rows, screen);
  return kExitUsable;
}

}  // namespace musclewarp
