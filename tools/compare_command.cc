// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/compare_command.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/base/text.h"
#include "musclewarp/deformer/deformer.h"
#include "musclewarp/program/program.h"
#include "musclewarp/report/screen_report.h"
#include "musclewarp/run/output_folder.h"
#include "musclewarp/scene/frame_selection.h"
#include "musclewarp/settings/checked_settings.h"
#include "musclewarp/studies/comparison.h"

namespace musclewarp {
namespace {

// Returns the frame of a configuration, with the median time of the repeats.
Frame SolveRepeatedly(FrameSolver* frame_solver,
                      const SolverConfiguration& configuration,
                      const ScenePose& pose,
                      int repeat) {
  const MuscleSolvers solvers = SolversOf(configuration);
  std::vector<double> times;
  Frame frame;
  for (int k = 0; k < repeat; ++k) {
    frame = frame_solver->Solve(solvers, pose, nullptr, {}).frame;
    times.push_back(frame.solve_ms);
  }
  std::nth_element(
      times.begin(), times.begin() + times.size() / 2, times.end());
  frame.solve_ms = times[times.size() / 2];
  return frame;
}

ComparisonRow RowOfFailure(const ScenePose& pose,
                           int index,
                           const std::string& why) {
  ComparisonRow row;
  row.frame = index;
  row.pose = pose.name;
  row.stop_reason = "failed: " + why;
  return row;
}

bool Compares(const CompareOptions& options, ContactKind contact) {
  return std::count(options.contacts.begin(), options.contacts.end(), contact) >
         0;
}

FrameSolverOptions FramesWith(const CompareOptions& options,
                              ContactKind contact) {
  FrameSolverOptions frames = options.deform.deformer.frames;
  frames.contact = contact;
  return frames;
}

// Returns a frame solver for each kind of contact that is compared, in their
// order. Certified contact comes first: it may reconstruct meshes of the scene,
// and all solvers use the same scene.
std::vector<std::shared_ptr<FrameSolver>> FrameSolversOf(
    const CompareOptions& options,
    const PrepareOptions& prepare,
    PreparedScene* scene) {
  const DeformerOptions& deformer = options.deform.deformer;
  std::optional<RestResult> rest;
  if (Compares(options, ContactKind::kCertified)) {
    RestSeparationOptions separation = RestSeparationOptionsOf(deformer);
    separation.prepare = prepare;
    rest = SeparateRest(
        separation, SolversOf(SolverConfiguration()).single, {}, scene);
  }
  const auto meshes = std::make_shared<SceneMeshes>(*scene);
  std::vector<std::shared_ptr<FrameSolver>> frame_solvers;
  for (const ContactKind contact : options.contacts) {
    frame_solvers.push_back(
        MakeFrameSolver(*scene, FramesWith(options, contact), meshes, rest));
  }
  return frame_solvers;
}

// Returns the rows of one pose and one kind of contact. Displacements by
// contact are relative to `without_contact`.
std::vector<ComparisonRow> RowsOf(const CompareOptions& options,
                                  const PreparedScene& scene,
                                  int index,
                                  FrameSolver* frame_solver,
                                  const Frame& without_contact) {
  std::vector<ComparisonRow> rows;
  std::optional<Frame> reference;
  for (const SolverConfiguration& configuration : options.configurations) {
    const ScenePose& pose = scene.scene.poses[index];
    std::string error;
    ComparisonRow row;
    if (!configuration.IsValid(&error)) {
      row = RowOfFailure(pose, index, error);
    } else {
      Frame frame =
          SolveRepeatedly(frame_solver, configuration, pose, options.repeat);
      frame.index = index;
      const bool is_reference = configuration.is_reference && !reference;
      row = RowOf(frame,
                  is_reference ? &frame
                  : reference  ? &*reference
                               : nullptr,
                  &without_contact,
                  frame_solver->contact().is_solved_together);
      if (is_reference) reference = std::move(frame);
    }
    row.configuration = configuration.name;
    row.contact = frame_solver->contact().name;
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<ComparisonRow> CompareFrames(const CompareOptions& options,
                                         const PrepareOptions& prepare,
                                         const std::vector<int>& selected,
                                         PreparedScene* prepared,
                                         std::ostream& screen) {
  const auto frame_solvers = FrameSolversOf(options, prepare, prepared);
  const PreparedScene& scene = *prepared;
  PrintPreparation(scene, frame_solvers.back()->contact(), screen);
  const auto free_solver =
      MakeFrameSolver(scene,
                      FramesWith(options, ContactKind::kNone),
                      std::make_shared<SceneMeshes>(scene));
  std::vector<ComparisonRow> rows;
  for (const int index : selected) {
    const Frame without_contact = SolveRepeatedly(free_solver.get(),
                                                  SolverConfiguration(),
                                                  scene.scene.poses[index],
                                                  /*repeat=*/1);
    for (const auto& frame_solver : frame_solvers) {
      for (ComparisonRow& row :
           RowsOf(options, scene, index, frame_solver.get(), without_contact)) {
        rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

}  // namespace

std::vector<SolverConfiguration> ParseConfigurations(const std::string& text) {
  const auto& names = SolverConfigurationNames();
  std::vector<SolverConfiguration> configurations;
  if (text == "all") {
    for (const std::string& name : names) {
      configurations.push_back(SolverConfigurationNamed(name));
    }
    return configurations;
  }
  for (const std::string& word : Split(text, ',')) {
    if (std::count(names.begin(), names.end(), word) == 0) {
      std::string allowed = "all";
      for (const std::string& name : names) allowed += ", " + name;
      throw InputError("--configurations=" + text,
                       "\"" + word + "\" is not a configuration",
                       "allowed: " + allowed);
    }
    configurations.push_back(SolverConfigurationNamed(word));
  }
  if (configurations.empty()) {
    throw InputError("--configurations", "is empty", "name one, or all");
  }
  return configurations;
}

std::vector<ContactKind> ParseContacts(const std::string& text) {
  std::vector<ContactKind> contacts;
  for (const std::string& word : Split(text, ',')) {
    CheckChoice("contact", word, "certified, paper, none");
    contacts.push_back(Named(
        word,
        {ContactKind::kNone, ContactKind::kPaper, ContactKind::kCertified}));
  }
  if (contacts.empty()) {
    throw InputError("--contact",
                     "is empty",
                     "allowed: none, paper, certified, or several with commas");
  }
  return contacts;
}

int CompareCommand(const CompareOptions& options, std::ostream& screen) {
  const DeformOptions& deform = options.deform;
  CheckSceneOptions(deform);
  CheckNumber("repeat", options.repeat, {1});
  if (!deform.out.empty()) CheckWritable(deform.out);
  UseThreads(deform);
  const Scene scene = ReadScene(deform.scene, deform.data_root, deform.sources);
  const std::vector<int> selected = SelectFrames(deform.frames, scene.poses);
  PrepareOptions prepare = deform.deformer.prepare;
  prepare.remove_self_crossings = prepare.remove_slivers =
      Compares(options, ContactKind::kCertified);
  PreparedScene prepared = PrepareScene(scene, prepare);
  const std::vector<ComparisonRow> rows =
      CompareFrames(options, prepare, selected, &prepared, screen);
  PrintComparison(rows, screen);
  if (!deform.out.empty()) {
    MakeFolder(deform.out);
    const std::filesystem::path out = deform.out;
    WriteTextAtomically((out / "comparison.csv").string(), ComparisonCsv(rows));
    WriteTextAtomically((out / "history.csv").string(),
                        HistoryCsv(rows, prepared));
    WriteTextAtomically((out / "comparison.json").string(),
                        ComparisonJson(rows, prepared).dump(2) + "\n");
    screen << "written: " << out.string()
           << "/comparison.csv, comparison.json, history.csv\n";
  }
  return kExitUsable;
}

}  // namespace musclewarp
