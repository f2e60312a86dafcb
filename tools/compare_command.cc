// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/compare_command.h"

#include <omp.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/motion/certified_frame.h"
#include "musclewarp/report/screen_report.h"
#include "tools/comparison.h"
#include "tools/frame_selection.h"
#include "tools/program.h"
#include "tools/split.h"

namespace musclewarp {
namespace {

std::string NameOf(DeformContact contact, const DeformOptions& options) {
  if (contact == DeformContact::kNone) return "none";
  if (contact == DeformContact::kCertified) return "certified";
  return "paper/" + ToString(options.scene_contact.group.level);
}

// What the contacts that are compared need.
struct Contacts {
  std::optional<SceneContact> paper;
  std::optional<CertifiedContact> certified;
};

// The frame of a configuration, with the median time of the repeats.
Frame SolveRepeatedly(const PreparedScene& scene,
                      const Contacts& contacts,
                      DeformContact contact,
                      int index,
                      const CompareOptions& options,
                      const SolverConfiguration& configuration,
                      SceneMeshes* meshes) {
  const bool is_paper = contact == DeformContact::kPaper;
  const GroupSolver solver = SolverOf(configuration, is_paper);
  const auto solve = [&] {
    if (contact == DeformContact::kCertified) {
      return SolveCertifiedFrame(scene,
                                 *contacts.certified,
                                 index,
                                 options.deform.frame,
                                 solver,
                                 meshes);
    }
    return SolveFrame(scene,
                      is_paper ? &*contacts.paper : nullptr,
                      index,
                      options.deform.frame,
                      solver,
                      meshes);
  };
  std::vector<double> times;
  std::optional<Frame> frame;
  for (int k = 0; k < options.repeat; ++k) {
    frame = solve();
    times.push_back(frame->solve_ms);
  }
  std::nth_element(
      times.begin(), times.begin() + times.size() / 2, times.end());
  frame->solve_ms = times[times.size() / 2];
  return std::move(*frame);
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

std::vector<DeformContact> ParseContacts(const std::string& text) {
  std::vector<DeformContact> contacts;
  for (const std::string& word : Split(text, ',')) {
    contacts.push_back(ParseDeformContact(word));
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
  if (options.repeat < 1) {
    throw InputError("--repeat",
                     "is " + std::to_string(options.repeat),
                     "allowed: 1 or above");
  }
  if (!deform.out.empty()) CheckWritable(deform.out);
  if (deform.threads > 0) omp_set_num_threads(deform.threads);
  const Scene scene = ReadScene(deform.scene, deform.data_root, deform.motion);
  const std::vector<int> selected = SelectFrames(deform.frames, scene.poses);
  const auto compares = [&](DeformContact contact) {
    return std::count(
               options.contacts.begin(), options.contacts.end(), contact) > 0;
  };
  PrepareOptions prepare = deform.prepare;
  prepare.remove_slivers = compares(DeformContact::kCertified);
  const PreparedScene prepared = PrepareScene(scene, prepare);
  const SolverConfiguration plain = SolverConfigurationNamed("ceres");
  Contacts contacts;
  if (compares(DeformContact::kPaper)) {
    contacts.paper = PrepareContact(prepared, deform.scene_contact);
  }
  if (compares(DeformContact::kCertified)) {
    contacts.certified = PrepareCertifiedContact(prepared,
                                                 deform.certified_contact,
                                                 deform.frame.pre_rotation,
                                                 SolverOf(plain, false));
  }
  PrintPreparation(prepared, screen);

  SceneMeshes meshes(prepared);
  std::vector<ComparisonRow> rows;
  for (const int index : selected) {
    const Frame without_contact = SolveFrame(prepared,
                                             nullptr,
                                             index,
                                             deform.frame,
                                             SolverOf(plain, false),
                                             &meshes);
    for (const DeformContact contact : options.contacts) {
      std::optional<Frame> reference;
      for (const SolverConfiguration& configuration : options.configurations) {
        std::string error;
        ComparisonRow row;
        if (!configuration.IsValid(&error)) {
          row = RowOfFailure(prepared.scene.poses[index], index, error);
        } else {
          Frame frame = SolveRepeatedly(prepared,
                                        contacts,
                                        contact,
                                        index,
                                        options,
                                        configuration,
                                        &meshes);
          const bool is_reference = configuration.is_reference && !reference;
          row = RowOf(frame,
                      is_reference ? &frame
                      : reference  ? &*reference
                                   : nullptr,
                      &without_contact,
                      prepared,
                      contact == DeformContact::kPaper);
          if (is_reference) reference = std::move(frame);
        }
        row.configuration = configuration.name;
        row.contact = NameOf(contact, deform);
        rows.push_back(std::move(row));
      }
    }
  }
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
