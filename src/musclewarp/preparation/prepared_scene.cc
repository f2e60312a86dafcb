// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/prepared_scene.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "musclewarp/base/invalid_option.h"
#include "musclewarp/base/memory.h"
#include "musclewarp/base/parallel_for.h"
#include "musclewarp/base/stage_times.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/geometry/outer_hull.h"
#include "musclewarp/preparation/exempt_areas.h"
#include "musclewarp/preparation/memory_need.h"
#include "musclewarp/preparation/missed_sides.h"
#include "musclewarp/preparation/muscle_interior.h"
#include "musclewarp/preparation/repaired_meshes.h"
#include "musclewarp/preparation/scene_lines.h"
#include "musclewarp/preparation/scene_warnings.h"
#include "musclewarp/preparation/soft_attachments.h"
#include "musclewarp/preparation/surroundings.h"

namespace musclewarp {
namespace {

void AddBones(const std::vector<PreparedBone>& bones,
              Surroundings* surroundings) {
  for (const PreparedBone& bone : bones) {
    surroundings->AddBone(bone.mesh.name, bone.body, TreesOf(bone));
  }
}

// Returns all meshes of a scene, of which the muscles need no models yet.
Surroundings SurroundingsOf(const std::vector<PreparedBone>& bones,
                            const std::vector<TriangleSoup>& muscles) {
  Surroundings surroundings;
  AddBones(bones, &surroundings);
  for (const TriangleSoup& muscle : muscles) surroundings.AddMuscle(muscle);
  return surroundings;
}

// Returns all meshes of a scene whose muscles have models.
Surroundings SurroundingsOf(const PreparedScene& scene) {
  Surroundings surroundings;
  AddBones(scene.bones, &surroundings);
  for (const PreparedMuscle& muscle : scene.muscles) {
    surroundings.AddMuscle(
        {muscle.model.fine_rest, muscle.model.fine_triangles});
  }
  return surroundings;
}

// Prepares all data that depends on the mesh of a muscle, except its hull and
// attachments: `hull` is the coarse mesh, and `muscle` has the attachments of
// the scene or the detected ones.
void PrepareModel(const Surroundings& surroundings,
                  const PrepareOptions& options,
                  const SceneMuscle& muscle,
                  bool names_attachments,
                  const TriangleSoup& fine,
                  const TriangleSoup& hull,
                  PreparedMuscle* prepared) {
  prepared->hull_encloses = Encloses(hull, fine);
  MuscleModelOptions model_options = options.muscle;
  if (options.attachments == AttachmentKind::kNone) {
    model_options.attachment_weight = 0;
  }
  const std::vector<BodySurface> bodies = surroundings.BodiesOf(muscle);
  const KnownEnds ends = EndsOfFibres(fine, bodies, muscle, names_attachments);
  MuscleInterior interior;
  if (!muscle.lines.empty()) {
    std::vector<const TriangleSoup*> beyond;
    for (const int other : BesideTendons(
             options.made_lines, prepared->lines_through, prepared->tied_to)) {
      beyond.push_back(&surroundings.muscle(other));
    }
    interior = InteriorOf(fine, bodies, ends, beyond, options.fibres);
    interior.points.is_tendon = prepared->is_tendon;
  }
  prepared->model = PrepareMuscle(muscle, fine, hull, interior, model_options);
  if (options.attachments != AttachmentKind::kNone) {
    prepared->attached =
        FindAttachedVertices(prepared->model.attachments, fine.points);
  }
  prepared->area_on_bones = AreaOnBones(fine, surroundings.bodies());
  prepared->lines =
      CarryActionLines(prepared->model, model_options.sample_spacing);
  if (options.fibres.fibres > 0) {
    const Stopwatch stopwatch;
    prepared->fibres =
        EmbedLines(MakeFibres(fine, bodies, ends, options.fibres),
                   hull.points,
                   hull.triangles);
    prepared->fibres_ms = stopwatch.Milliseconds();
  }
}

// Prepares all data that depends on the mesh of muscle `m`.
void PrepareFromMesh(const Surroundings& surroundings,
                     const PrepareOptions& options,
                     const Scene& scene,
                     int m,
                     const TriangleSoup& fine,
                     PreparedMuscle* prepared) {
  SceneMuscle muscle = scene.muscles[m];
  std::vector<FoundAttachment> found;
  if (options.attachments == AttachmentKind::kAuto &&
      (muscle.attachments.empty() || !prepared->tied_to.empty())) {
    found = FindAttachments(fine, surroundings.BodiesOf(muscle), muscle.lines);
  }
  std::vector<Attachment> soft;
  for (const int other : prepared->tied_to) {
    auto attachment = TakeSoftAttachment(
        surroundings.surface_of(other), scene.muscles[other].name, &found);
    if (attachment) soft.push_back(*std::move(attachment));
  }
  muscle.attachments = ChooseAttachments(options.attachments,
                                         muscle,
                                         scene.poses,
                                         fine,
                                         found,
                                         surroundings.bodies(),
                                         surroundings.MusclesBeside(m),
                                         scene.body_size,
                                         &prepared->attachment_warnings);
  muscle.attachments.insert(muscle.attachments.end(), soft.begin(), soft.end());
  const TriangleSoup hull = OuterHull(fine, options.muscle.hull);
  PrepareModel(surroundings,
               options,
               muscle,
               !scene.muscles[m].attachments.empty(),
               fine,
               hull,
               prepared);
}

// Removes the bones that could not be repaired from the scene.
void LeaveOutBones(PreparedScene* prepared) {
  std::vector<SceneBone> bones;
  for (size_t i = 0; i < prepared->bones.size(); ++i) {
    SceneBone& bone = prepared->scene.bones[i];
    const std::string& why = prepared->bones[i].left_out;
    if (why.empty()) {
      bones.push_back(std::move(bone));
      continue;
    }
    prepared->scene.warnings.push_back(
        bone.name + ": a mesh that the model shows" +
        (bone.mesh_path.empty() ? "" : ", " + bone.mesh_path + ",") +
        " is left out, and muscles may cross it: " + why);
  }
  prepared->scene.bones = std::move(bones);
  const auto is_left_out = [](const PreparedBone& bone) {
    return !bone.left_out.empty();
  };
  prepared->bones.erase(
      std::remove_if(
          prepared->bones.begin(), prepared->bones.end(), is_left_out),
      prepared->bones.end());
}

// Makes lines for the muscles that have none, and finds what holds those that
// slide.
void AddLines(const Surroundings& surroundings,
              const PrepareOptions& options,
              PreparedScene* prepared,
              const std::function<void(size_t, size_t)>& on_item) {
  std::vector<MadeLines> made =
      MakeSceneLines(surroundings,
                     {options.auto_lines, options.made_lines},
                     on_item,
                     prepared->scene);
  for (size_t m = 0; m < made.size(); ++m) {
    SceneMuscle& muscle = prepared->scene.muscles[m];
    if (made[m].lines.empty()) continue;
    if (!muscle.lines.empty()) {
      muscle.lines = std::move(made[m].lines);
      continue;
    }
    for (const int other : made[m].tied_to) {
      const std::string& carrier = prepared->scene.muscles[other].name;
      prepared->muscles[other].is_tendon = true;
      prepared->scene.notes.push_back(muscle.name + " ends on " + carrier +
                                      ", and its lines go on through it to a "
                                      "bone (\"ends_on\" in the scene "
                                      "overrides this)");
    }
    muscle.lines = std::move(made[m].lines);
    prepared->muscles[m].bare_tendons = std::move(made[m].bare_tendons);
    prepared->muscles[m].line_ends =
        LineEndsOf(muscle.lines, surroundings.bodies());
    prepared->muscles[m].missed_bones =
        MissedBones(muscle, muscle.lines, surroundings);
    prepared->muscles[m].lines_through = std::move(made[m].through);
    prepared->muscles[m].tied_to = std::move(made[m].tied_to);
  }
}

bool MakesLines(const PrepareOptions& options, const Scene& scene) {
  return options.makes_lines && NeedsLines(scene, options.made_lines);
}

// Finds crossing bones, and poses that dislocate joints.
void CheckBones(PreparedScene* prepared) {
  std::vector<std::shared_ptr<const BoneTrees>> trees;
  std::vector<BoneAtRest> bones;
  for (const PreparedBone& bone : prepared->bones) {
    trees.push_back(TreesOf(bone));
    bones.push_back({bone.mesh.name, bone.body, trees.back()->mesh});
  }
  prepared->bone_crossings = BoneCrossings(bones);
  prepared->warnings = BoneMoveWarnings(prepared->scene, bones);
}

// Returns a function that reports how many of the steps of a preparation are
// done, and which part of the scene the next one is about.
std::function<void(size_t, const std::string&)> SayingProgress(
    size_t num_steps, const ProgressCallback& on_progress) {
  return [=](size_t done, const std::string& item) {
    if (!on_progress) return;
    on_progress({"preparing",
                 static_cast<int>(done),
                 static_cast<int>(num_steps),
                 item});
  };
}

// Returns the name of a mesh by its number; bones come first.
const std::string& NameOfMesh(const Scene& scene, size_t i) {
  return i < scene.bones.size() ? scene.bones[i].name
                                : scene.muscles[i - scene.bones.size()].name;
}

}  // namespace

bool PrepareOptions::IsValid(std::string* error) const {
  if (auto_lines < 1) {
    return InvalidOption(
        "PrepareOptions::auto_lines", auto_lines, "1 or above", error);
  }
  if (!(scale_warning_ratio >= 1)) {
    return InvalidOption("PrepareOptions::scale_warning_ratio",
                         scale_warning_ratio,
                         "1 or above",
                         error);
  }
  return muscle.IsValid(error) && repair.IsValid(error) &&
         slivers.IsValid(error) && fibres.IsValid(error);
}

void ReplaceMuscleMeshes(const PrepareOptions& options,
                         const std::vector<int>& muscles,
                         std::vector<TriangleSoup> meshes,
                         PreparedScene* prepared) {
  CHECK_EQ(muscles.size(), meshes.size());
  const Surroundings surroundings = SurroundingsOf(*prepared);
  ParallelFor(meshes.size(), [&](size_t k) {
    PreparedMuscle& muscle = prepared->muscles[muscles[k]];
    if (options.remove_slivers) {
      muscle.mesh.slivers = RemoveSlivers(options.slivers, &meshes[k]);
    }
    PrepareFromMesh(
        surroundings, options, prepared->scene, muscles[k], meshes[k], &muscle);
  });
  AddSoftCarriers(prepared);
  prepared->exempt = ExemptAreas(*prepared);
}

void RetriangulateMuscles(const PrepareOptions& options,
                          const std::vector<int>& muscles,
                          const std::vector<TriangleSoup>& meshes,
                          PreparedScene* prepared) {
  CHECK_EQ(muscles.size(), meshes.size());
  const Surroundings surroundings = SurroundingsOf(*prepared);
  ParallelFor(meshes.size(), [&](size_t k) {
    PreparedMuscle& prepared_muscle = prepared->muscles[muscles[k]];
    const MuscleModel model = std::move(prepared_muscle.model);
    SceneMuscle muscle = prepared->scene.muscles[muscles[k]];
    muscle.attachments = model.attachments;
    PrepareModel(surroundings,
                 options,
                 muscle,
                 !prepared->scene.muscles[muscles[k]].attachments.empty(),
                 meshes[k],
                 {model.coarse_rest, model.coarse_triangles},
                 &prepared_muscle);
  });
  AddSoftCarriers(prepared);
  prepared->exempt = ExemptAreas(*prepared);
}

PreparedScene PrepareScene(const Scene& scene,
                           PrepareOptions options,
                           const ProgressCallback& on_progress) {
  const Stopwatch stopwatch;
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  options.repair.body_size = scene.body_size;
  PreparedScene prepared;
  prepared.scene = scene;
  prepared.bones.resize(scene.bones.size());
  prepared.muscles.resize(scene.muscles.size());
  const size_t num_bones = scene.bones.size();
  const size_t num_muscles = scene.muscles.size();
  const size_t num_meshes = num_bones + num_muscles;
  const bool makes_lines = MakesLines(options, scene);
  const size_t num_steps = num_meshes + (makes_lines ? 2 : 1) * num_muscles;
  const auto say_progress = SayingProgress(num_steps, on_progress);
  // Bones come first, as their meshes are the largest.
  std::vector<TriangleSoup> fine(num_muscles);
  const auto repair = [&](size_t i) {
    if (i < num_bones) {
      prepared.bones[i] = RepairBone(options, scene.bones[i]);
      return;
    }
    const size_t m = i - num_bones;
    fine[m] = RepairMuscle(options, scene.muscles[m], &prepared.muscles[m]);
  };
  if (num_meshes > 0) say_progress(0, "mesh of " + NameOfMesh(scene, 0));
  const ScopedStage repairing("reading and repair");
  ParallelFor(num_meshes, repair, [&](size_t i, size_t done) {
    say_progress(done, "mesh of " + NameOfMesh(scene, i));
  });
  LeaveOutBones(&prepared);
  prepared.memory_needed = CheckedMemory(options, fine, prepared);
  say_progress(num_meshes, "about " + MemoryText(prepared.memory_needed));
  AddBoneTrees(&prepared.bones);
  const ScopedStage modelling("models of muscles");
  const Surroundings surroundings = SurroundingsOf(prepared.bones, fine);
  if (makes_lines) {
    AddLines(surroundings, options, &prepared, [&](size_t m, size_t done) {
      say_progress(num_meshes + done, "lines of " + scene.muscles[m].name);
    });
  }
  const auto prepare = [&](size_t m) {
    PrepareFromMesh(surroundings,
                    options,
                    prepared.scene,
                    static_cast<int>(m),
                    fine[m],
                    &prepared.muscles[m]);
  };
  ParallelFor(num_muscles, prepare, [&](size_t m, size_t done) {
    say_progress(num_steps - num_muscles + done,
                 "model of " + scene.muscles[m].name);
  });
  say_progress(num_steps, "attachments and bones");
  AddSoftCarriers(&prepared);
  prepared.exempt = ExemptAreas(prepared);
  CheckBones(&prepared);
  AddSceneWarnings(options, &prepared);
  prepared.wall_ms = stopwatch.Milliseconds();
  return prepared;
}

}  // namespace musclewarp
