// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Perturbs every setting of a Deformer on the embedded scene: the mark in the
// list says whether the frame changes, and caches of preparations and resumed
// runs trust it.

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <sstream>
#include <string>

#include "musclewarp/base/content_hash.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/deformer/deformer.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/settings/checked_settings.h"
#include "musclewarp/settings/deformer_settings.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using Change = std::function<void(DeformerSettings*)>;

// The scene in which a setting matters.
enum class Setting {
  kAsIs,
  kCut,   // a plate cuts a muscle, so that its surface is reconstructed
  kHole,  // a muscle has a hole
  kNoLines,
};

struct Perturbation {
  Change change;
  Change context = [](DeformerSettings* s) { s->contact = "none"; };
  Setting scene = Setting::kAsIs;
};

void Certified(DeformerSettings* /*settings*/) {}
void Paper(DeformerSettings* settings) { settings->contact = "paper"; }

const std::map<std::string, Perturbation>& Perturbations() {
  using S = DeformerSettings*;
  static const std::map<std::string, Perturbation> kAll = {
      {"contact", {[](S s) { s->contact = "paper"; }}},
      {"gap", {[](S s) { s->gap = 0.2; }, Certified}},
      {"remake", {[](S s) { s->remake = "never"; }, Certified, Setting::kCut}},
      {"max_hole", {[](S s) { s->max_hole = 0; }, Certified, Setting::kHole}},
      {"max_loss", {[](S s) { s->max_loss = 0; }, Certified, Setting::kCut}},
      {"max_lost_area",
       {[](S s) { s->max_lost_area = 0; }, Certified, Setting::kCut}},
      {"max_lost_extent",
       {[](S s) { s->max_lost_extent = 0; }, Certified, Setting::kCut}},
      {"max_torn_patch", {[](S s) { s->max_torn_patch = 1e-9; }, Certified}},
      {"solver", {[](S s) { s->solver = "reference"; }}},
      {"attachments", {[](S s) { s->attachments = "none"; }}},
      {"auto_lines",
       {[](S s) { s->auto_lines = 2; },
        [](S s) { s->contact = "none"; },
        Setting::kNoLines}},
      {"fibres", {[](S s) { s->fibres = 5; }}},
      {"coarse_vertices", {[](S s) { s->coarse_vertices = 150; }}},
      {"laplacian", {[](S s) { s->laplacian = "paper"; }}},
      {"laplacian_length", {[](S s) { s->laplacian_length = 5; }}},
      {"lines", {[](S s) { s->lines = "fixed"; }}},
      {"sample_spacing", {[](S s) { s->sample_spacing = 5; }}},
      {"skeleton_weight", {[](S s) { s->skeleton_weight = 2; }}},
      {"attachment_weight", {[](S s) { s->attachment_weight = 1; }}},
      {"bending_weight", {[](S s) { s->bending_weight = 0; }}},
      {"body_twist", {[](S s) { s->body_twist = false; }}},
      {"max_rounds", {[](S s) { s->max_rounds = 1; }, Certified}},
      {"max_step_turn", {[](S s) { s->max_step_turn = 2; }, Certified}},
      {"max_step_move", {[](S s) { s->max_step_move = 2; }, Certified}},
      {"frame_timeout_s", {[](S s) { s->frame_timeout_s = 1e-6; }, Certified}},
      {"max_iterations", {[](S s) { s->max_iterations = 1; }}},
      {"contact_level", {[](S s) { s->contact_level = "fine"; }, Paper}},
      {"bone_coarse_vertices",
       {[](S s) { s->bone_coarse_vertices = 300; }, Paper}},
      {"seed", {[](S s) { s->seed = 2; }, Paper}},
      {"cache", {[](S s) { s->cache = TestTempDir() + "/cache"; }, Certified}}};
  return kAll;
}

Scene SceneFor(Setting setting) {
  Scene scene = ReadScene(
      std::string(MUSCLEWARP_EMBEDDED_DATA) + "/phantom/motion.json", "");
  SceneMuscle& muscle = scene.muscles[0];
  TriangleSoup mesh = ReadTriangleSoup(muscle.mesh_path);
  const Eigen::RowVector3d centre = mesh.points.colwise().mean();
  if (setting == Setting::kCut) {
    TriangleSoup plate = Box(60, 60, 3);
    plate.points.rowwise() += centre - plate.points.colwise().mean().eval();
    scene.bones.push_back({"plate", plate.points, plate.triangles, "pelvis"});
  } else if (setting == Setting::kNoLines) {
    muscle.lines.clear();
  } else if (setting == Setting::kHole) {
    // All triangles near a vertex.
    const Eigen::RowVector3d place = mesh.points.row(0);
    std::vector<int> kept;
    for (int t = 0; t < mesh.triangles.rows(); ++t) {
      const bool is_near =
          (mesh.points.row(mesh.triangles(t, 0)) - place).norm() < 4;
      if (!is_near) kept.push_back(t);
    }
    Triangles triangles(kept.size(), 3);
    for (size_t i = 0; i < kept.size(); ++i) {
      triangles.row(i) = mesh.triangles.row(kept[i]);
    }
    muscle.mesh_path.clear();
    muscle.points = mesh.points;
    muscle.triangles = triangles;
  }
  return scene;
}

// Returns all of a frame but its times, or why there is none.
std::string ResultOf(const DeformerSettings& settings, Setting setting) {
  const Scene scene = SceneFor(setting);
  try {
    Deformer deformer(scene, OptionsOf(settings));
    const Frame frame = deformer.SolveAlone(scene.poses.back());
    std::ostringstream result;
    ContentHash hash;
    for (const MuscleFrame& muscle : frame.muscles) {
      hash.Add(std::string(reinterpret_cast<const char*>(muscle.points.data()),
                           muscle.points.size() * sizeof(double)));
      result << muscle.fibre_lengths.size() << " fibres\n";
    }
    result << hash.Hex() << "\n" << deformer.contact().name << "\n";
    for (const std::string& shortcoming : frame.shortcomings) {
      result << shortcoming << "\n";
    }
    return result.str();
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(SettingsEffects, AreAsTheListSays) {
  std::map<std::pair<Setting, std::string>, std::string> unperturbed;
  VisitFields(DeformerSettings(), [&](const auto& field, const auto& /*v*/) {
    const auto found = Perturbations().find(field.key);
    ASSERT_NE(found, Perturbations().end())
        << field.key << ": say here how to perturb it";
    const Perturbation& perturbation = found->second;
    DeformerSettings settings;
    perturbation.context(&settings);
    const std::pair key(perturbation.scene, settings.contact);
    if (unperturbed.count(key) == 0) {
      unperturbed[key] = ResultOf(settings, perturbation.scene);
    }
    perturbation.change(&settings);
    const std::string result = ResultOf(settings, perturbation.scene);
    if (field.effect == Effect::kNothing) {
      EXPECT_EQ(result, unperturbed[key]) << field.key;
    } else {
      EXPECT_NE(result, unperturbed[key]) << field.key;
    }
  });
}

}  // namespace
}  // namespace musclewarp
