// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/rest_remaking.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <iomanip>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/option_check.h"
#include "musclewarp/certified_contact/cell_surface.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

// The muscles, by number, whose meshes have to be made anew. What crosses a
// bone holds up the muscles around it, and a muscle may cross itself or be far
// from where it was as long as it crosses others: so these come only if there
// is nothing worse, or in the last attempt, which takes all.
std::vector<int> UncleanMuscles(const PreparedScene& scene,
                                const ContactReport& contact,
                                bool is_last_attempt) {
  const SceneIntersections& rest = *contact.rest;
  std::map<std::string, int> numbers;
  std::set<int> beside_bones, beside_muscles, by_themselves;
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    const int number = static_cast<int>(i);
    numbers[scene.muscles[i].model.name] = number;
    if (rest.self_pairs_of_muscles[i] > 0) by_themselves.insert(number);
  }
  for (const PairIntersection& pair : rest.pairs) {
    if (pair.triangle_pairs + pair.vertices_inside == 0) continue;
    const auto a = numbers.find(pair.a), b = numbers.find(pair.b);
    const bool are_muscles = a != numbers.end() && b != numbers.end();
    for (const auto& muscle : {a, b}) {
      if (muscle == numbers.end()) continue;
      (are_muscles ? beside_muscles : beside_bones).insert(muscle->second);
    }
  }
  const std::set<int> displaced(contact.displaced_at_rest.begin(),
                                contact.displaced_at_rest.end());
  std::set<int> unclean;
  for (const std::set<int>& worst :
       {beside_bones, beside_muscles, by_themselves, displaced}) {
    if (unclean.empty() || is_last_attempt) {
      unclean.insert(worst.begin(), worst.end());
    }
  }
  return {unclean.begin(), unclean.end()};
}

// The places, a clause each.
std::string Describe(const PreparedScene& scene,
                     const SceneIntersections& rest) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1);
  const char* separator = "";
  for (const PairIntersection& pair : rest.pairs) {
    if (pair.triangle_pairs + pair.vertices_inside == 0) continue;
    text << separator << pair.a << " crosses " << pair.b << " around ("
         << pair.place.x() << ", " << pair.place.y() << ", " << pair.place.z()
         << "), " << pair.max_depth_mm << " mm deep";
    separator = "; ";
  }
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    if (rest.self_pairs_of_muscles[i] == 0) continue;
    text << separator << scene.muscles[i].model.name << " crosses itself in "
         << rest.self_pairs_of_muscles[i] << " pairs of triangles";
    separator = "; ";
  }
  return text.str();
}

CellSurfaceOptions SurfaceOptions(const RestRemakingOptions& options,
                                  const MedialCellOptions& cell,
                                  const PreparedScene& scene,
                                  const std::vector<int>& unclean) {
  CellSurfaceOptions surface;
  surface.cell = cell;
  surface.spacing = options.max_spacing;
  for (const int i : unclean) {
    surface.spacing = std::min(
        surface.spacing,
        std::max(options.min_spacing,
                 options.spacing_share *
                     TypicalEdge(scene.muscles[i].model.fine_rest,
                                 scene.muscles[i].model.fine_triangles)));
  }
  return surface;
}

// Halves the spacing of the samples until there are several across a thin
// muscle: twice its volume by its area is what a plate of its thickness has.
double SpacingWithin(const RestRemakingOptions& options,
                     const MuscleModel& muscle,
                     double spacing) {
  const double thickness = 2 * muscle.rest_volume /
                           SurfaceArea(muscle.fine_rest, muscle.fine_triangles);
  const double largest =
      std::max(options.min_spacing, thickness / options.samples_across);
  while (spacing > largest) spacing /= 2;
  return spacing;
}

// Makes a surface that crosses no bone, with as large a margin as that takes: a
// bone may have details between the samples of a surface. Where a thin muscle
// would lose too much by the margin, such details are left to the separation of
// the new surfaces.
TriangleSoup SurfaceBesideBones(
    const RestRemakingOptions& options,
    CellSurfaceOptions surface_options,
    int attempt,
    const SolidDistance& muscle,
    const std::vector<const SolidDistance*>& others,
    const std::vector<const SolidDistance*>& bones) {
  surface_options.cell.margin *= std::pow(options.margin_growth, attempt);
  TriangleSoup before;
  double least_volume = 0;
  for (int growth = 0;; ++growth) {
    TriangleSoup surface = CellSurface(surface_options, muscle, others, bones);
    const double volume = SignedVolume(surface.points, surface.triangles);
    VLOG(1) << "cell with a margin of " << surface_options.cell.margin
            << " mm: " << volume << " mm3";
    if (growth > 0 && volume < least_volume) return before;
    if (surface.triangles.rows() == 0 || growth == options.max_growths) {
      return surface;
    }
    if (growth == 0) {
      least_volume = (1 - options.max_loss_by_margin) * volume;
    }
    const TriangleBvh tree(surface.points, surface.triangles);
    const bool crosses =
        std::any_of(bones.begin(), bones.end(), [&](const SolidDistance* bone) {
          return !IntersectingTriangles(tree, bone->mesh().bvh()).empty();
        });
    if (!crosses) return surface;
    before = std::move(surface);
    surface_options.cell.margin *= options.margin_growth;
    // A cell is bounded by what is in range of its margin.
    surface_options.cell.range =
        std::max(surface_options.cell.range, 2 * surface_options.cell.margin);
  }
}

// Compares the new surface of a muscle with the old one.
Remaking Compare(const SearchableMesh& before, const TriangleSoup& after) {
  Remaking remaking;
  remaking.is_done = true;
  remaking.volume_before = SignedVolume(before.points(), before.triangles());
  remaking.volume_after = SignedVolume(after.points, after.triangles);
  const TriangleBvh tree(after.points, after.triangles);
  for (Eigen::Index f = 0; f < before.triangles().rows(); ++f) {
    const Corners t = CornersOf(before.points(), before.triangles().row(f));
    const Eigen::RowVector3d middle = t.colwise().mean();
    const double edge = (t.row(1) - t.row(0)).norm();
    const double distance =
        tree.ClosestPoint(middle, std::numeric_limits<double>::infinity())
            .distance;
    remaking.farthest = std::max(remaking.farthest, distance);
    if (distance <= edge) continue;
    const double area = AreaVector(t).norm() / 2;
    remaking.lost_area += area;
    remaking.place += area * middle;
  }
  if (remaking.lost_area > 0) remaking.place /= remaking.lost_area;
  return remaking;
}

std::string Warning(const std::string& name, const Remaking& remaking) {
  std::ostringstream text;
  text
      << std::fixed << std::setprecision(1) << name
      << " could not be separated by moving its vertices, so its mesh was made "
         "anew: "
      << remaking.volume_before / 1000 << " cm3 before, "
      << remaking.volume_after / 1000 << " cm3 after; "
      << remaking.lost_area / 100 << " cm2 of the old surface were left";
  if (remaking.lost_area > 0) {
    text << ", around (" << remaking.place.x() << ", " << remaking.place.y()
         << ", " << remaking.place.z() << "), by " << remaking.farthest
         << " mm at most";
  }
  return text.str();
}

// The signed distances to all meshes, in scene order.
class Solids {
 public:
  explicit Solids(const SceneMeshes& meshes) {
    for (const NamedMesh& muscle : meshes.muscles()) {
      muscles_.push_back(&all_.emplace_back(*muscle.mesh));
    }
    for (const NamedMesh& bone : meshes.bones()) {
      bones_.push_back(&all_.emplace_back(*bone.mesh));
    }
  }
  const SolidDistance& muscle(int i) const { return *muscles_[i]; }
  const std::vector<const SolidDistance*>& bones() const { return bones_; }
  std::vector<const SolidDistance*> MusclesBut(int i) const {
    std::vector<const SolidDistance*> others = muscles_;
    others.erase(others.begin() + i);
    return others;
  }

 private:
  std::deque<SolidDistance> all_;
  std::vector<const SolidDistance*> muscles_, bones_;
};

// Makes the surface of a muscle anew from its cell among the solids.
TriangleSoup SurfaceOf(const RestRemakingOptions& options,
                       CellSurfaceOptions surface_options,
                       int attempt,
                       const MuscleModel& muscle,
                       int number,
                       const Solids& solids) {
  surface_options.spacing =
      SpacingWithin(options, muscle, surface_options.spacing);
  const TriangleSoup surface = SurfaceBesideBones(options,
                                                  surface_options,
                                                  attempt,
                                                  solids.muscle(number),
                                                  solids.MusclesBut(number),
                                                  solids.bones());
  if (surface.triangles.rows() == 0) return surface;
  const double typical = TypicalEdge(muscle.fine_rest, muscle.fine_triangles);
  return WithEvenTriangles(surface, std::max(surface_options.spacing, typical));
}

// Makes the surfaces of the unclean muscles anew, from the meshes as they were
// delivered. A muscle of which the others and the bones would leave too little
// is made from the meshes where contact has moved them: these hardly overlap,
// and have their volumes.
std::vector<TriangleSoup> NewSurfaces(const RestRemakingOptions& options,
                                      const MedialCellOptions& cell,
                                      const std::vector<int>& unclean,
                                      int attempt,
                                      const PreparedScene& scene,
                                      const std::vector<Points>& separated) {
  const CellSurfaceOptions surface_options =
      SurfaceOptions(options, cell, scene, unclean);
  SceneMeshes meshes(scene);
  std::optional<Solids> solids(meshes);
  std::vector<TriangleSoup> surfaces;
  std::vector<size_t> too_small;
  for (const int i : unclean) {
    const MuscleModel& muscle = scene.muscles[i].model;
    const TriangleSoup& surface = surfaces.emplace_back(
        SurfaceOf(options, surface_options, attempt, muscle, i, *solids));
    if (SignedVolume(surface.points, surface.triangles) <
        options.least_share_as_delivered * muscle.rest_volume) {
      too_small.push_back(surfaces.size() - 1);
    }
  }
  if (too_small.empty()) return surfaces;
  std::vector<Points> bones;
  for (const PreparedBone& bone : scene.bones) {
    bones.push_back(bone.rest.points);
  }
  meshes.MoveTo(separated, bones);
  solids.emplace(meshes);
  for (const size_t k : too_small) {
    const int i = unclean[k];
    surfaces[k] = SurfaceOf(
        options, surface_options, attempt, scene.muscles[i].model, i, *solids);
  }
  return surfaces;
}

void Remake(const RestRemakingOptions& options,
            const PrepareOptions& prepare,
            const std::vector<int>& unclean,
            std::vector<TriangleSoup> surfaces,
            PreparedScene* scene) {
  const SceneMeshes meshes(*scene);
  for (size_t k = 0; k < unclean.size(); ++k) {
    const int i = unclean[k];
    const std::string name = scene->muscles[i].model.name;
    Remaking remaking = Compare(*meshes.muscles()[i].mesh, surfaces[k]);
    if (remaking.volume_after <
        options.least_volume_share * remaking.volume_before) {
      throw InputError(
          name,
          "only " +
              std::to_string(static_cast<int>(100 * remaking.volume_after /
                                              remaking.volume_before)) +
              " % of the muscle are outside bones and other muscles",
          "check that the meshes are in one frame, or correct them");
    }
    ReplaceMuscleMesh(prepare, i, std::move(surfaces[k]), scene);
    // Without slivers, which take a little volume with them.
    remaking.volume_after = scene->muscles[i].model.rest_volume;
    if (scene->muscles[i].mesh.remaking.is_done) {
      remaking.volume_before = scene->muscles[i].mesh.remaking.volume_before;
    }
    scene->muscles[i].mesh.remaking = remaking;
  }
}

// The vertices of all muscles where contact has moved them in the rest pose.
std::vector<Points> SeparatedPoints(const PreparedScene& scene,
                                    const SceneState& rest) {
  std::vector<Points> points;
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    points.push_back(FinePoints(scene.muscles[i].model, rest.muscles[i]));
  }
  return points;
}

}  // namespace

bool RestRemakingOptions::IsValid(std::string* error) const {
  return OptionCheck("RestRemakingOptions", error)
      .IsAtLeast("margin_growth", margin_growth, 1)
      .IsAtLeast("max_growths", max_growths, 0)
      .IsAtLeast("max_attempts", max_attempts, 1)
      .IsWithin("max_loss_by_margin", max_loss_by_margin, 0, 1)
      .IsAbove("spacing_share", spacing_share, 0)
      .IsAbove("min_spacing", min_spacing, 0)
      .IsAtLeast("max_spacing", max_spacing, min_spacing)
      .IsAtLeast("samples_across", samples_across, 1)
      .IsWithin("least_share_as_delivered", least_share_as_delivered, 0, 1)
      .IsWithin("least_volume_share", least_volume_share, 0, 1)
      .is_valid();
}

std::unique_ptr<FrameSolver> MakeCleanFrameSolver(
    const RestRemakingOptions& remaking,
    const PrepareOptions& prepare,
    const FrameSolverOptions& options,
    const MuscleSolvers& solvers,
    const ProgressCallback& on_progress,
    PreparedScene* scene) {
  std::string error;
  CHECK(remaking.IsValid(&error)) << error;
  for (int attempt = 0;; ++attempt) {
    auto solver = MakeFrameSolver(*scene,
                                  options,
                                  solvers,
                                  std::make_shared<SceneMeshes>(*scene),
                                  on_progress);
    if (options.contact != ContactKind::kCertified) return solver;
    const SceneIntersections& rest = *solver->contact().rest;
    const std::vector<int> unclean = UncleanMuscles(
        *scene, solver->contact(), attempt + 1 == remaking.max_attempts);
    const bool is_over =
        remaking.kind == RemakeKind::kNever || attempt == remaking.max_attempts;
    if (unclean.empty() ||
        (is_over && rest.IsClean() && rest.self_pairs == 0)) {
      for (const PreparedMuscle& muscle : scene->muscles) {
        if (!muscle.mesh.remaking.is_done) continue;
        scene->warnings.push_back(
            Warning(muscle.model.name, muscle.mesh.remaking));
        LOG(WARNING) << scene->warnings.back();
      }
      return solver;
    }
    if (is_over) {
      throw InputError(
          scene->scene.name,
          "the meshes cannot be separated in the rest pose: " +
              Describe(*scene, rest),
          remaking.kind == RemakeKind::kNever
              ? "let their surfaces be made anew (--remake=auto), or correct "
                "the meshes there"
              : "correct the meshes there");
    }
    if (!scene->as_delivered) {
      scene->as_delivered = solver->RestFrame().intersections;
    }
    if (on_progress) on_progress({"remaking", attempt, 0});
    Remake(remaking,
           prepare,
           unclean,
           NewSurfaces(remaking,
                       options.certified.separation.cell,
                       unclean,
                       attempt,
                       *scene,
                       SeparatedPoints(*scene, solver->StartOfMotion(solvers))),
           scene);
  }
}

}  // namespace musclewarp
