// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/base/progress.h"
#include "musclewarp/base/stage_times.h"
#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/fibres/fibres.h"
#include "musclewarp/figures/surface_reconstruction.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh_repair/repair.h"
#include "musclewarp/mesh_repair/self_crossing_removal.h"
#include "musclewarp/mesh_repair/sliver_removal.h"
#include "musclewarp/preparation/attachment_choice.h"
#include "musclewarp/preparation/attachments.h"
#include "musclewarp/preparation/bones_at_rest.h"
#include "musclewarp/preparation/line_ends.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "musclewarp/scene/exempt_area.h"
#include "musclewarp/scene/scene.h"
#include "musclewarp/solver/embedded_lines.h"
#include "musclewarp/solver/muscle_model.h"

namespace musclewarp {

// Options of PrepareScene: repair, hulls, attachments, lines and fibres.
struct PrepareOptions {
  MuscleModelOptions muscle;
  RepairOptions repair;

  // If true, RemoveSelfCrossings() remeshes the parts of a mesh around its
  // self-crossings. Certified contact requires this, and Deformer enables it.
  // If false, meshes keep their triangles.
  bool remove_self_crossings = false;

  // The same for sliver triangles of muscle meshes.
  bool remove_slivers = false;
  SliverLimits slivers;

  AttachmentKind attachments = AttachmentKind::kAuto;

  // The number of action lines that are made for a muscle without any.
  int auto_lines = 3;

  // If false, a muscle without lines gets none, and only contact moves it.
  bool makes_lines = true;

  // The fibres of every muscle; none by default.
  FibreOptions fibres;

  // Two meshes whose diagonals differ by more than this factor cause a warning,
  // as their units probably differ.
  double scale_warning_ratio = 100;

  PrepareOptions() { fibres.fibres = 0; }

  // Also checks the nested options.
  bool IsValid(std::string* error) const;
};

// The defects of a delivered mesh, and all changes to it.
struct MeshPreparation {
  std::string name;
  std::string path;  // of its file; empty if given in memory
  MeshDefects defects;
  RepairReport repairs;
  SelfCrossingRemoval self_crossings;
  SliverRemovals slivers;
  SurfaceReconstruction reconstruction;

  // The triangles removed because the separation of the rest pose had drawn
  // them out (frame_solvers/rest_retriangulation.h).
  int drawn_out_triangles = 0;

  // The volume after repair, with that of the pieces it left out, before any
  // further change, mm^3; or SceneMuscle::delivered_volume if given.
  double delivered_volume = 0;

  // Remarks of the reader for the user; also among the warnings of the scene.
  std::vector<std::string> notes;
};

// A muscle with all data that is independent of the pose.
struct PreparedMuscle {
  MeshPreparation mesh;
  MuscleModel model;
  AttachedVertices attached;

  // By body: how much of the surface lies on its bones (VerticesNearBones),
  // mm^2. An attachment that was found is a part of that.
  std::map<std::string, double> area_on_bones;

  // The indices of the other muscles through which its lines go on to bones
  // (ContinueLines), as those of a muscle that ends on a tendon do.
  std::vector<int> lines_through;

  // The indices of those on which it ends itself, and to which it is attached.
  std::vector<int> tied_to;

  // The ends of lines that were made; none of lines that the scene has.
  std::vector<LineEnd> line_ends;

  // One sentence per line that contradicts an attachment.
  std::vector<std::string> attachment_warnings;

  // True if the coarse hull encloses the fine mesh, by an exact test.
  bool hull_encloses = false;
  EmbeddedLines lines;   // the action lines, at the skeleton samples
  EmbeddedLines fibres;  // empty by default
  double fibres_ms = 0;  // to make them
};

// A bone in the rest pose.
struct PreparedBone {
  MeshPreparation mesh;
  std::string body;
  TriangleSoup rest;  // one closed surface or several, which may cross

  // Why no closed surface could be made of the mesh of a model; empty for all
  // bones that a prepared scene has.
  std::string left_out = {};

  // The triangles that were delivered and `rest` does not have: those that the
  // repair left out, moved or replaced.
  TriangleSoup delivered_only;
};

// A scene ready for solvers: its meshes are repaired and analysed, and every
// muscle has action lines if PrepareOptions::makes_lines is true. Constant
// after preparation.
struct PreparedScene {
  Scene scene;
  std::vector<PreparedMuscle> muscles;
  std::vector<PreparedBone> bones;
  std::vector<ExemptArea> exempt;  // attachment areas that may penetrate
  std::vector<BoneCrossing> bone_crossings;
  std::vector<std::string> warnings;

  // The intersections before the first reconstruction of a mesh, if any.
  std::optional<SceneIntersections> as_delivered;

  // True if the scene was read from disk (preparation_cache.h).
  bool is_cached = false;
  double wall_ms = 0;

  // The times of all stages of the preparation, including contact, if
  // DeformerOptions::record_stages is true.
  std::vector<StageTime> stages;
};

// Replaces the meshes of muscles of a prepared scene, given by index, and
// prepares these muscles again. Their lines are kept. Preconditions: there is a
// mesh for every muscle (CHECKed), and every mesh is a closed manifold.
void ReplaceMuscleMeshes(const PrepareOptions& options,
                         const std::vector<int>& muscles,
                         std::vector<TriangleSoup> meshes,
                         PreparedScene* prepared);

// Replaces the meshes of muscles of a prepared scene, given by index, by other
// triangulations of the same surfaces, or of nearly the same, and prepares what
// follows from them. Hulls, lines and attachments are kept, so that nothing but
// the density of the meshes, and `options.muscle` apart from the hull, changes.
// Hulls need not enclose meshes that lie farther out than those before
// (PreparedMuscle::hull_encloses). Preconditions: there is a mesh for every
// index (CHECKed), and every mesh is a closed manifold.
void RetriangulateMuscles(const PrepareOptions& options,
                          const std::vector<int>& muscles,
                          const std::vector<TriangleSoup>& meshes,
                          PreparedScene* prepared);

// Prepares a scene, several meshes at a time. Throws InputError if a mesh
// cannot be read or repaired. `on_progress` may be empty; it is called on the
// calling thread. Precondition (CHECKed): the options are valid.
PreparedScene PrepareScene(const Scene& scene,
                           PrepareOptions options,
                           const ProgressCallback& on_progress = {});

}  // namespace musclewarp
