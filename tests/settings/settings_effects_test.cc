// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Perturbs every setting of a Deformer on the embedded scene: the mark in the
// list says whether the frame changes, and caches of preparations and resumed
// runs trust it.

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "musclewarp/base/content_hash.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/certificate/shortcomings.h"
#include "musclewarp/deformer/deformer.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/settings/checked_settings.h"
#include "musclewarp/settings/deformer_settings.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using Change = std::function<void(DeformerSettings*)>;

// Where a setting matters.
enum class Where {
  kScene,    // the embedded scene, with its first muscle
  kCut,      // a plate cuts the muscle, so that its surface is reconstructed
  kHole,     // the muscle has a hole
  kNoLines,  // the muscle has no lines
  kVerdict,  // the requirements on frames alone

  // Where a random ray of the inside test meets an edge, and where triangles
  // cross after the first round of a step: not on this scene.
  kRarely,
};

struct Perturbation {
  Change change;
  Change context = [](DeformerSettings* s) { s->contact = "none"; };
  Where where = Where::kScene;
};

void Certified(DeformerSettings* /*settings*/) {}
void Paper(DeformerSettings* settings) { settings->contact = "paper"; }

const std::map<std::string, Perturbation>& Perturbations() {
  using S = DeformerSettings*;
  static const std::map<std::string, Perturbation> kAll = {
      {"contact", {[](S s) { s->contact = "paper"; }}},
      {"gap", {[](S s) { s->gap = 0.2; }, Certified}},
      {"remake", {[](S s) { s->remake = "never"; }, Certified, Where::kCut}},
      {"max_hole", {[](S s) { s->max_hole = 0; }, Certified, Where::kHole}},
      {"max_loss", {[](S s) { s->max_loss = 0; }, Certified, Where::kVerdict}},
      {"max_lost_area",
       {[](S s) { s->max_lost_area = 0; }, Certified, Where::kVerdict}},
      {"max_lost_extent",
       {[](S s) { s->max_lost_extent = 0; }, Certified, Where::kVerdict}},
      {"max_torn_patch",
       {[](S s) { s->max_torn_patch = 1; }, Certified, Where::kVerdict}},
      {"solver", {[](S s) { s->solver = "reference"; }}},
      {"attachments", {[](S s) { s->attachments = "none"; }}},
      {"auto_lines",
       {[](S s) { s->auto_lines = 2; },
        [](S s) { s->contact = "none"; },
        Where::kNoLines}},
      {"made_lines",
       {[](S s) { s->made_lines = "guided"; },
        [](S s) { s->contact = "none"; },
        Where::kNoLines}},
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
      {"bone_push", {[](S s) { s->bone_push = false; }}},
      {"max_rounds",
       {[](S s) { s->max_rounds = 1; }, Certified, Where::kRarely}},
      {"max_step_turn", {[](S s) { s->max_step_turn = 2; }, Certified}},
      {"max_step_move", {[](S s) { s->max_step_move = 2; }, Certified}},
      {"frame_timeout_s", {[](S s) { s->frame_timeout_s = 1e-6; }, Certified}},
      {"max_iterations", {[](S s) { s->max_iterations = 1; }}},
      {"contact_level", {[](S s) { s->contact_level = "fine"; }, Paper}},
      {"bone_coarse_vertices",
       {[](S s) { s->bone_coarse_vertices = 300; }, Paper}},
      {"seed", {[](S s) { s->seed = 2; }, Paper, Where::kRarely}},
      {"cache", {[](S s) { s->cache = TestTempDir() + "/cache"; }, Certified}},
      {"max_memory_gib", {[](S s) { s->max_memory_gib = 4; }}}};
  return kAll;
}

// Leaves the lines of the muscle among the targets of poses.
void KeepTargetsOf(const SceneMuscle& muscle, Scene* scene) {
  std::set<std::string> names;
  for (const ActionLine& line : muscle.lines) names.insert(line.name);
  for (ScenePose& pose : scene->poses) {
    const std::map<std::string, Points> all = pose.lines;
    for (const auto& line : all) {
      if (names.count(line.first) == 0) pose.lines.erase(line.first);
    }
  }
}

// Returns a mesh without its triangles near a vertex.
TriangleSoup WithHole(const TriangleSoup& mesh) {
  constexpr double kReach = 4;  // mm
  std::vector<int> kept;
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = mesh.points.row(mesh.triangles(t, 0));
    if ((corner - mesh.points.row(0)).norm() >= kReach) kept.push_back(t);
  }
  TriangleSoup open = mesh;
  open.triangles.resize(kept.size(), 3);
  for (size_t i = 0; i < kept.size(); ++i) {
    open.triangles.row(i) = mesh.triangles.row(kept[i]);
  }
  return open;
}

Scene SceneFor(Where where) {
  Scene scene = ReadScene(
      std::string(MUSCLEWARP_EMBEDDED_DATA) + "/phantom/motion.json", "");
  scene.muscles.resize(1);
  SceneMuscle& muscle = scene.muscles[0];
  TriangleSoup mesh = ReadTriangleSoup(muscle.mesh_path);
  if (where == Where::kCut) {
    TriangleSoup plate = Box(60, 60, 3);
    plate.points.rowwise() +=
        (mesh.points.colwise().mean() - plate.points.colwise().mean()).eval();
    scene.bones.push_back({"plate", plate.points, plate.triangles, "pelvis"});
  } else if (where == Where::kNoLines) {
    muscle.lines.clear();
  } else if (where == Where::kHole) {
    mesh = WithHole(mesh);
    muscle.mesh_path.clear();
    muscle.points = mesh.points;
    muscle.triangles = mesh.triangles;
  }
  KeepTargetsOf(muscle, &scene);
  return scene;
}

// Returns the verdict on a muscle that has lost some of its volume, surface and
// length, each by what is allowed by default, and is torn.
std::string VerdictOf(const DeformerOptions& options) {
  JudgedMuscle muscle;
  muscle.num_triangles = 1000;
  muscle.figures.volume_ratio = 0.97;
  muscle.figures.torn_patch.area = 10;
  muscle.reconstruction.is_done = true;
  muscle.reconstruction.gone_area = 50;
  muscle.reconstruction.lost_extent = 2;
  std::string verdict;
  for (const std::string& sentence :
       Shortcomings(options.frames.requirements, {}, {muscle})) {
    verdict += sentence + "\n";
  }
  return verdict;
}

// Returns all of a frame but its times, or why there is none.
std::string ResultOf(const DeformerSettings& settings, Where where) {
  const DeformerOptions options = OptionsOf(settings);
  if (where == Where::kVerdict) return VerdictOf(options);
  const Scene scene = SceneFor(where);
  try {
    Deformer deformer(scene, options);
    const Frame frame = deformer.SolveAlone(scene.poses.back());
    ContentHash hash;
    std::string result = deformer.contact().name + "\n";
    for (const MuscleFrame& muscle : frame.muscles) {
      hash.Add(std::string(reinterpret_cast<const char*>(muscle.points.data()),
                           muscle.points.size() * sizeof(double)));
      result += std::to_string(muscle.fibre_lengths.size()) + " fibres\n";
    }
    for (const std::string& shortcoming : frame.shortcomings) {
      result += shortcoming + "\n";
    }
    return result + hash.Hex();
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(SettingsEffects, AreAsTheListSays) {
  std::map<std::pair<Where, std::string>, std::string> unperturbed;
  VisitFields(DeformerSettings(), [&](const auto& field, const auto& /*v*/) {
    const auto found = Perturbations().find(field.key);
    ASSERT_NE(found, Perturbations().end())
        << field.key << ": say here how to perturb it";
    const Perturbation& perturbation = found->second;
    DeformerSettings settings;
    perturbation.context(&settings);
    const std::pair key(perturbation.where, KeyOf(settings));
    if (unperturbed.count(key) == 0) {
      unperturbed[key] = ResultOf(settings, perturbation.where);
    }
    perturbation.change(&settings);
    const std::string result = ResultOf(settings, perturbation.where);
    if (perturbation.where == Where::kRarely) return;
    if (field.effect == Effect::kNothing) {
      EXPECT_EQ(result, unperturbed[key]) << field.key;
    } else {
      EXPECT_NE(result, unperturbed[key]) << field.key;
    }
  });
}

}  // namespace
}  // namespace musclewarp
