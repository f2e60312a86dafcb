// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/base/infinity.h"
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
#include "musclewarp/preparation/bare_tendons.h"
#include "musclewarp/preparation/bone_trees.h"
#include "musclewarp/preparation/bones_at_rest.h"
#include "musclewarp/preparation/line_ends.h"
#include "musclewarp/preparation/scene_lines.h"
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

  // If true, RemoveSlivers() removes sliver triangles of muscle meshes.
  bool remove_slivers = false;
  SliverLimits slivers;

  AttachmentKind attachments = AttachmentKind::kAuto;

  // The number of action lines that are made for a muscle without any.
  int auto_lines = 3;

  // How these, and sliding lines of the scene, go in a pose.
  LineCourse made_lines = LineCourse::kTaut;

  // If false, a muscle without lines gets none, and only contact moves it.
  bool makes_lines = true;

  // The fibres of every muscle; none by default.
  FibreOptions fibres;

  // The memory that a run may take, bytes; a scene that needs more is refused
  // before it is prepared (CheckMemory).
  double max_memory = kInfinity;

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

  // The surface area that lies on the bones of each body (VerticesNearBones),
  // mm^2. Detected attachments are parts of it.
  std::map<std::string, double> area_on_bones;

  // The indices of the other muscles through which its lines continue to bones
  // (ContinueLines), such as a tendon on which the muscle ends.
  std::vector<int> lines_through;

  // The indices of those muscles on which it ends itself, and to which it is
  // attached.
  std::vector<int> tied_to;

  // True if other muscles are attached to it: it is a tendon.
  bool is_tendon = false;

  // The ends of its lines if they were made; empty for lines of the scene.
  std::vector<LineEnd> line_ends;

  // The tendons of which there is no mesh, but along which its lines go on.
  std::vector<BareTendon> bare_tendons;

  // A sentence for each side on which its lines end on another bone than
  // anatomy has it (missed_sides.h).
  std::vector<std::string> missed_bones;

  // One sentence per line that contradicts an attachment.
  std::vector<std::string> attachment_warnings;

  // True if the coarse hull encloses the fine mesh, by an exact test.
  bool hull_encloses = false;
  EmbeddedLines lines;   // the action lines, at the skeleton samples
  EmbeddedLines fibres;  // empty by default
  double fibres_ms = 0;  // time to make the fibres
};

// A bone in the rest pose.
struct PreparedBone {
  MeshPreparation mesh;
  std::string body;
  TriangleSoup rest;  // one closed surface or several, which may cross
  std::shared_ptr<const BoneTrees> trees;  // of `rest`; see TreesOf

  // Why the mesh of a model could not be repaired to a closed surface; empty
  // for all bones of a prepared scene.
  std::string left_out = {};

  // The delivered triangles that are missing from `rest`, because the repair
  // left out, moved or replaced them.
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

  double memory_needed = 0;  // bytes, see MemoryNeeded

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
// triangulations of the same or nearly the same surfaces, and prepares the data
// that depend on them. Hulls, lines and attachments are kept, so that nothing
// changes except the density of the meshes and the effect of `options.muscle`
// apart from the hull. Hulls may fail to enclose meshes that extend farther out
// than the previous ones (PreparedMuscle::hull_encloses). Preconditions: there
// is a mesh for every index (CHECKed), and every mesh is a closed manifold.
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
