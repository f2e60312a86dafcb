// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/export_mjcf.h"

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "musclewarp/base/output_file.h"
#include "musclewarp/base/text.h"
#include "musclewarp/mujoco/mjcf_of_run.h"
#include "musclewarp/program/program.h"
#include "musclewarp/run/output_folder.h"
#include "musclewarp/run/output_lock.h"
#include "musclewarp/settings/checked_settings.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

OrderedJson CouplingsJson(const MjcfTree& tree) {
  OrderedJson couplings = OrderedJson::array();
  for (const MjcfCoupling& coupling : tree.couplings) {
    couplings.push_back({{"joint", coupling.joint},
                         {"of", coupling.of},
                         {"coefficients", coupling.coefficients},
                         {"largest_error", coupling.largest_error}});
  }
  return couplings;
}

OrderedJson TendonsJson(const MjcfModel& mjcf) {
  OrderedJson tendons = OrderedJson::object();
  for (const MjcfMuscle& muscle : mjcf.muscles) {
    tendons[muscle.name] = {{"sites", muscle.path.sites.size()},
                            {"length_error_mean_mm", muscle.path.length_mean},
                            {"length_error_max_mm", muscle.path.length_largest},
                            {"arm_error_median_mm", muscle.path.arm_median},
                            {"arm_error_max_mm", muscle.path.arm_largest}};
  }
  return tendons;
}

OrderedJson SkinsJson(const MjcfModel& mjcf) {
  OrderedJson skins = OrderedJson::object();
  for (const MjcfSkin& skin : mjcf.skins) {
    OrderedJson bodies = OrderedJson::array();
    for (const MjcfSkinBone& bone : skin.bones) bodies.push_back(bone.body);
    skins[skin.name] = {{"bodies", bodies},
                        {"slides", skin.num_slides},
                        {"distance_mean_mm", skin.skin.mean_distance},
                        {"distance_max_mm", skin.skin.largest_distance}};
  }
  return skins;
}

void PrintModel(const MjcfModel& mjcf, std::ostream& screen) {
  char line[300];
  for (const std::string& note : mjcf.tree.notes) {
    screen << "warning: " << note << "\n";
  }
  for (const MjcfCoupling& coupling : mjcf.tree.couplings) {
    if (coupling.largest_error == 0) continue;
    std::snprintf(line,
                  sizeof line,
                  "joint %s follows %s to %.2g (rad or m)\n",
                  coupling.joint.c_str(),
                  coupling.of.c_str(),
                  coupling.largest_error);
    screen << line;
  }
  for (const MjcfMuscle& muscle : mjcf.muscles) {
    std::snprintf(line,
                  sizeof line,
                  "tendon %-24s %d sites; from its function: length %.2f mm, "
                  "largest %.2f; arm median %.2f mm, largest %.2f\n",
                  muscle.name.c_str(),
                  static_cast<int>(muscle.path.sites.size()),
                  muscle.path.length_mean,
                  muscle.path.length_largest,
                  muscle.path.arm_median,
                  muscle.path.arm_largest);
    screen << line;
  }
  for (const MjcfSkin& skin : mjcf.skins) {
    std::snprintf(line,
                  sizeof line,
                  "skin %-24s %d bodies and %d slides; from its frames: %.2f "
                  "mm, largest %.2f\n",
                  skin.name.c_str(),
                  static_cast<int>(skin.bones.size()) - skin.num_slides,
                  skin.num_slides,
                  skin.skin.mean_distance,
                  skin.skin.largest_distance);
    screen << line;
  }
}

void WriteModel(const std::string& out,
                const MjcfModel& mjcf,
                const Model& model,
                const OrderedJson& record) {
  const fs::path assets = fs::path(out) / "assets";
  MakeFolder(out);
  MakeFolder(assets.string());
  for (const MjcfBone& bone : mjcf.bones) {
    WriteTextAtomically((assets / (bone.name + ".obj")).string(),
                        MeshText(bone.mesh));
  }
  for (const MjcfSkin& skin : mjcf.skins) {
    WriteTextAtomically((assets / (skin.name + ".skn")).string(),
                        SknBytes(skin));
  }
  WriteTextAtomically((fs::path(out) / "model.fit.json").string(),
                      record.dump(2) + "\n");
  WriteTextAtomically((fs::path(out) / "model.xml").string(),
                      MjcfText(mjcf, model));
}

}  // namespace

int ExportMjcf(const std::string& runs,
               const std::string& out,
               const PathExportOptions& options,
               std::ostream& screen) {
  CheckSettings(options);
  CheckWritable(out);
  const std::vector<std::string> dirs = Split(runs, ',');
  const RunPaths paths =
      ReadRunPaths(dirs, options.model, options.paths_per_muscle);
  const FittedPaths fitted = FitPaths(paths, options.bounds);
  const MjcfModel mjcf = MjcfOfRun(dirs[0],
                                   paths,
                                   fitted,
                                   options.max_skin_distance,
                                   [&](const std::string& what) {
                                     screen << "fitting: " << what << std::endl;
                                   });
  const std::string model_file = (fs::path(out) / "model.xml").string();
  OrderedJson record =
      PathRecord(runs, model_file, paths, fitted, options.bounds);
  record["joints"] = CouplingsJson(mjcf.tree);
  record["tendons"] = TendonsJson(mjcf);
  record["skins"] = SkinsJson(mjcf);
  const OutputLock lock(out);
  WriteModel(out, mjcf, paths.model, record);
  PrintFits(paths, fitted, screen);
  PrintModel(mjcf, screen);
  screen << "wrote " << model_file << ": " << mjcf.tree.bodies.size()
         << " bodies, " << mjcf.muscles.size() << " muscles, "
         << mjcf.skins.size() << " skins; m, kg and rad\n";
  return fitted.AreWithinBounds() ? kExitUsable : kExitNotUsable;
}

}  // namespace musclewarp
