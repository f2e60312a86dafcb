// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/base/progress.h"
#include "musclewarp/base/stage_times.h"
#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/fibres/fibres.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh_repair/repair.h"
#include "musclewarp/mesh_repair/self_crossing_removal.h"
#include "musclewarp/mesh_repair/sliver_removal.h"
#include "musclewarp/preparation/attachment_choice.h"
#include "musclewarp/preparation/attachments.h"
#include "musclewarp/preparation/bones_at_rest.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "musclewarp/scene/exempt_area.h"
#include "musclewarp/scene/scene.h"
#include "musclewarp/solver/embedded_lines.h"
#include "musclewarp/solver/muscle_model.h"

namespace musclewarp {

// How the meshes of a scene are repaired and analysed.
struct PrepareOptions {
  MuscleModelOptions muscle;
  RepairOptions repair;

  // If true, the places where a mesh crosses itself are remade. Certified
  // contact needs that, and Deformer sees to it. If false, meshes keep their
  // triangles.
  bool remove_self_crossings = false;

  // The same for sliver triangles of muscle meshes.
  bool remove_slivers = false;
  SliverLimits slivers;

  AttachmentKind attachments = AttachmentKind::kAuto;

  // The number of action lines that are made for a muscle which has none.
  int auto_lines = 3;

  // If false, such a muscle stays without lines, and nothing but contact moves
  // it.
  bool makes_lines = true;

  // The fibres that every muscle carries; none by default.
  FibreOptions fibres;

  // A warning is given if the diagonals of two meshes differ by more than this
  // factor, as one of them is likely in other units.
  double scale_warning_ratio = 100;

  // A muscle without fibres that follows its attachments. With an attachment
  // weight of 1 the coarse meshes leave them to the offsets of the fine ones,
  // by up to 11 mm (thigh, flexion by 45 degrees); with 8 by 4 mm at most,
  // where no tendon is in the way.
  PrepareOptions() {
    fibres.fibres = 0;
    muscle.attachment_weight = 8;
  }

  // Also checks the options within.
  bool IsValid(std::string* error) const;
};

// Why the mesh of a muscle was made anew: what was still the case once its
// vertices had been moved. The worst comes first.
enum class ReconstructionReason {
  kCrossesBone,
  kCrossesMuscle,
  kCrossesItself,
  kDisplaced,  // farther than the requirements on frames allow
};

// "crosses_bone", "crosses_muscle", "crosses_itself" or "displaced": the text
// of reports.
std::string ToString(ReconstructionReason reason);

// How the mesh of a muscle was made anew, because it could not be separated
// from others as it was (frame_solvers/rest_separation.h).
struct SurfaceReconstruction {
  bool is_done = false;

  // Of the first time, if that was done more than once.
  ReconstructionReason reason = ReconstructionReason::kCrossesBone;
  double volume_before = 0, volume_after = 0;  // mm^3

  // What of the old surface the new one leaves by more than a triangle's edge:
  // how much (mm^2), its middle, and by how much at most (mm).
  double lost_area = 0;
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
  double farthest = 0;
};

// A mesh as it was delivered, and what was done to it.
struct MeshPreparation {
  std::string name;
  std::string path;  // of its file; empty if it was given in memory
  MeshDefects defects;
  RepairReport repairs;
  SelfCrossingRemoval self_crossings;
  SliverRemovals slivers;
  SurfaceReconstruction reconstruction;

  // mm^3: of the mesh after repair, before anything else was done to it, or
  // what the scene says (SceneMuscle::delivered_volume).
  double delivered_volume = 0;

  // What the user has to know of how the file was read; among the warnings of
  // the scene.
  std::vector<std::string> notes;
};

// A muscle with everything that does not change with the pose.
struct PreparedMuscle {
  MeshPreparation mesh;
  MuscleModel model;
  AttachedVertices attached;

  // Lines that contradict the attachments, a sentence each.
  std::vector<std::string> attachment_warnings;

  // True if the coarse hull encloses the fine mesh, by an exact test.
  bool hull_encloses = false;
  EmbeddedLines lines;   // the action lines, at the skeleton samples
  EmbeddedLines fibres;  // none unless asked for
  double fibres_ms = 0;  // for making them
};

// A bone in the rest pose.
struct PreparedBone {
  MeshPreparation mesh;
  std::string body;
  TriangleSoup rest;
};

// A scene whose meshes have been read, repaired and analysed, with action lines
// for every muscle if PrepareOptions::makes_lines says so. Constant once it is
// prepared.
struct PreparedScene {
  Scene scene;
  std::vector<PreparedMuscle> muscles;
  std::vector<PreparedBone> bones;
  std::vector<ExemptArea> exempt;  // attachment areas that may penetrate
  std::vector<BoneCrossing> bone_crossings;
  std::vector<std::string> warnings;

  // What crossed before meshes were made anew, if any was.
  std::optional<SceneIntersections> as_delivered;

  // True if all of this was read from disk (preparation_cache.h).
  bool is_cached = false;
  double wall_ms = 0;

  // Where the time of all preparation went, contact included, if
  // DeformerOptions::record_stages asked for it.
  std::vector<StageTime> stages;
};

// Gives muscles of a prepared scene, by number, other meshes, with which
// everything about them is prepared again. Their lines stay. Precondition
// (CHECKed): there is a mesh for every muscle, and it is a closed manifold.
void ReplaceMuscleMeshes(const PrepareOptions& options,
                         const std::vector<int>& muscles,
                         std::vector<TriangleSoup> meshes,
                         PreparedScene* prepared);

// Prepares a scene, several meshes at a time. Throws InputError if a mesh
// cannot be read or repaired. `on_progress` may be empty, and is called by the
// calling thread. Precondition (CHECKed): the options are valid.
PreparedScene PrepareScene(const Scene& scene,
                           const PrepareOptions& options,
                           const ProgressCallback& on_progress = {});

}  // namespace musclewarp
