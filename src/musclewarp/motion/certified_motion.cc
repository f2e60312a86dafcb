// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/certified_motion.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "musclewarp/base/invalid_option.h"
#include "musclewarp/base/option_check.h"
#include "musclewarp/base/parallel_for.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/motion/certified_stepper.h"
#include "musclewarp/motion/contact_samples.h"
#include "musclewarp/motion/motion_context.h"
#include "musclewarp/preparation/memory_limits.h"

namespace musclewarp {
namespace {

std::vector<int> OrderOfNames(const PreparedScene& scene) {
  std::vector<int> order(scene.muscles.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return scene.muscles[a].model.name < scene.muscles[b].model.name;
  });
  return order;
}

// Reorders values by muscle from the order of contact to that of the scene.
// `of_muscles` may be empty.
template <typename T>
std::vector<T> InOrderOfScene(const std::vector<int>& order,
                              std::vector<T> of_muscles) {
  std::vector<T> sorted(of_muscles.size());
  for (size_t i = 0; i < of_muscles.size(); ++i) {
    sorted[order[i]] = std::move(of_muscles[i]);
  }
  return sorted;
}

// Reorders values by muscle from the order of the scene to that of contact.
template <typename T>
std::vector<T> InOrderOfContact(const std::vector<int>& order,
                                const std::vector<T>& of_muscles) {
  std::vector<T> sorted;
  for (const int i : order) sorted.push_back(of_muscles[i]);
  return sorted;
}

// Returns the exempt areas with muscles numbered in the order of contact.
std::vector<ExemptArea> ExemptInOrder(const PreparedScene& scene,
                                      const std::vector<int>& order) {
  std::vector<ExemptArea> exempt = scene.exempt;
  for (ExemptArea& area : exempt) {
    const auto place = std::find(order.begin(), order.end(), area.muscle);
    area.muscle = static_cast<int>(place - order.begin());
  }
  return exempt;
}

// Returns the weight of a contact row of a muscle. By area, a muscle of
// `num_samples` even samples has rows that together weigh as much as those of a
// hull of 200 vertices.
double RowWeight(const CertifiedContactOptions& options,
                 const MuscleModel& model,
                 size_t num_samples) {
  constexpr double kVerticesOfFullWeight = 200;
  if (model.weights == LaplacianWeights::kPaper) return options.coarse_weight;
  return options.coarse_weight *
         std::sqrt(options.samples_per_coarse_vertex * kVerticesOfFullWeight /
                   static_cast<double>(num_samples));
}

void AddSurfaces(const PreparedScene& scene,
                 const std::vector<ExemptArea>& exempt,
                 CertifiedScene* certified) {
  const CertifiedContactOptions& options = certified->options;
  const size_t num_muscles = certified->muscles.size();
  certified->contact.muscles.resize(num_muscles);
  certified->samples.resize(num_muscles);
  certified->row_weights.resize(num_muscles);
  ParallelFor(num_muscles, [&](size_t i) {
    const MuscleModel& model = certified->muscles[i]->model;
    certified->contact.muscles[i] = MakeMuscleSurface(model.fine_rest,
                                                      model.fine_triangles,
                                                      model.rest_volume,
                                                      options.surface);
    certified->samples[i] = ContactSamples(
        model.fine_rest,
        {model.coarse_rest, model.coarse_triangles},
        static_cast<int>(options.samples_per_coarse_vertex *
                         static_cast<double>(model.coarse_rest.rows())));
    certified->row_weights[i] =
        RowWeight(options, model, certified->samples[i].size());
  });
  for (const PreparedBone& bone : scene.bones) {
    const auto trees = TreesOf(bone);
    certified->contact.bones.emplace_back(trees, &trees->mesh.bvh());
  }
  for (const ExemptArea& area : exempt) {
    auto& of_muscle = certified->contact.muscles[area.muscle].exempt;
    of_muscle.resize(scene.bones.size());
    of_muscle[area.bone] = area.triangles;
  }
}

// Adds the rest pose. From here on, attached vertices move with their bodies
// from their positions in it. Before the separation they may have been inside a
// bone.
void AddRest(ContactState rest, CertifiedScene* certified) {
  const size_t num_muscles = certified->muscles.size();
  rest.bone_planes.reset();
  rest.held.clear();
  for (size_t i = 0; i < num_muscles; ++i) {
    const std::vector<int>& vertices = certified->muscles[i]->attached.vertices;
    rest.held.push_back({vertices, rest.points[i](vertices, Eigen::all)});
  }
  certified->rest = std::move(rest);
  certified->extensions.resize(num_muscles);
  ParallelFor(num_muscles, [&](size_t i) {
    certified->extensions[i] = std::make_shared<OffsetExtension>(
        certified->contact.muscles[i],
        certified->muscles[i]->attached.vertices,
        certified->options.step.relaxation.smoothing_length);
  });
}

// Returns the scene without its rest pose.
CertifiedScene BeginScene(const PreparedScene& scene,
                          const std::vector<ExemptArea>& exempt,
                          const CertifiedContactOptions& options) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  CertifiedScene certified;
  certified.options = options;
  certified.order = OrderOfNames(scene);
  for (const int i : certified.order) {
    certified.muscles.push_back(&scene.muscles[i]);
  }
  AddSurfaces(scene, exempt, &certified);
  return certified;
}

// Returns the rest pose as it was prepared, without contact.
ContactState StateAtRest(const MotionContext& context) {
  std::vector<Points> coarse;
  for (const PreparedMuscle* muscle : context.certified.muscles) {
    coarse.push_back(muscle->model.coarse_rest);
  }
  return StateWithoutContact(context.scene,
                             context.certified,
                             RestPose(context.scene.scene),
                             std::move(coarse));
}

// Relaxes the rest pose from a state in which no two meshes cross. Its muscles
// may be crumpled if `unfolds`.
void RelaxRest(const MotionContext& context,
               bool unfolds,
               const ProgressCallback& on_progress,
               ContactState* rest) {
  const CertifiedContactOptions& options = context.certified.options;
  AdvanceOptions advance;
  advance.step = options.step;
  advance.step.sweeps = options.rest_sweeps;
  advance.step.volume.max_move = options.rest_volume_move;
  advance.reach_growth = options.reach_growth;
  advance.max_reach = options.max_reach;
  advance.max_settling_steps = options.max_rest_steps;
  advance.settling_tolerance = options.rest_tolerance;
  advance.relaxes_rest = true;
  advance.step.unfolds = unfolds;
  advance.on_step = options.on_step;
  const ScenePose pose = rest->pose;
  AdvanceToPose(context, advance, pose, /*at=*/1, on_progress, rest);
}

bool IsTimeoutValid(double timeout_s, std::string* error) {
  if (timeout_s >= 0 || timeout_s == CertifiedContactOptions::kNoClock) {
    return true;
  }
  return InvalidOption("CertifiedContactOptions::frame_timeout_s",
                       timeout_s,
                       "0 or above, or -1",
                       error);
}

// By default the clock of the machine has no say.
void SetEnd(const CertifiedContactOptions& options, AdvanceOptions* advance) {
  if (options.frame_timeout_s == CertifiedContactOptions::kNoClock) {
    advance->max_stuck_steps = options.max_stuck_steps;
  } else {
    advance->timeout_s = options.frame_timeout_s;
  }
}

}  // namespace

bool CertifiedContactOptions::IsValid(std::string* error) const {
  return OptionCheck("CertifiedContactOptions", error)
             .IsAbove("margin_in_gaps", margin_in_gaps, 0)
             .IsAbove("samples_per_coarse_vertex", samples_per_coarse_vertex, 0)
             .IsAtLeast("coarse_weight", coarse_weight, 0)
             .IsAtLeast("max_rest_steps", max_rest_steps, 0)
             .IsAtLeast("rest_sweeps", rest_sweeps, 1)
             .IsAbove("rest_tolerance", rest_tolerance, 0)
             .IsAbove("reach_growth", reach_growth, 1)
             .IsAbove("max_reach", max_reach, 0)
             .IsAtLeast("max_settling_steps", max_settling_steps, 0)
             .IsAbove("settling_tolerance", settling_tolerance, 0)
             .IsAbove("full_settling_tolerance", full_settling_tolerance, 0)
             .IsAbove("max_push", max_push, 0)
             .IsWithin("unchecked_fraction", unchecked_fraction, 1e-3, 1)
             .IsWithin("max_halvings", max_halvings, 0, 20)
             .IsAtLeast("max_returns", max_returns, 0)
             .IsAtLeast("max_stuck_steps", max_stuck_steps, 0)
             .is_valid() &&
         IsTimeoutValid(frame_timeout_s, error) && step.IsValid(error) &&
         limits.IsValid(error) && surface.IsValid(error) &&
         separation.IsValid(error);
}

InitialSeparationOptions CertifiedContactOptions::SeparationByGap() const {
  InitialSeparationOptions by_gap = separation;
  by_gap.cell.margin = margin_in_gaps * step.gap;
  return by_gap;
}

CertifiedScene PrepareCertifiedScene(const PreparedScene& scene,
                                     const SceneMeshes& meshes,
                                     const CertifiedContactOptions& options,
                                     const PreRotationOptions& pre_rotation,
                                     const MuscleSolver& solver,
                                     const ProgressCallback& on_progress,
                                     KnownCells* cells) {
  const Stopwatch preparing;
  CheckContactFits(meshes.muscles(),
                   options.separation.cell.voxel_size,
                   options.step.gap + options.step.reach);
  const std::vector<ExemptArea> exempt =
      ExemptInOrder(scene, OrderOfNames(scene));
  CertifiedScene certified = BeginScene(scene, exempt, options);
  std::vector<const SearchableMesh*> muscles, bones;
  for (const int i : certified.order) {
    muscles.push_back(meshes.muscles()[i].mesh);
  }
  for (const NamedMesh& bone : meshes.bones()) bones.push_back(bone.mesh);
  InitialSeparation separation = SeparateInitially(
      muscles,
      bones,
      exempt,
      options.SeparationByGap(),
      [&](int round, int crossing_pairs) {
        if (!on_progress) return;
        on_progress({"separating",
                     round,
                     0,
                     round == 0 ? ""
                                : std::to_string(crossing_pairs) +
                                      " pairs of triangles cross"});
      },
      cells);

  const MotionContext context = {scene, certified, pre_rotation, solver};
  ContactState rest = StateAtRest(context);
  rest.points = std::move(separation.points);
  // Steps need an intersection-free start.
  if (separation.crossing_pairs == 0) {
    RelaxRest(context, /*unfolds=*/true, on_progress, &rest);
  }
  AddRest(std::move(rest), &certified);
  certified.wall_ms = preparing.Milliseconds();
  return certified;
}

CertifiedScene RelaxCertifiedScene(const PreparedScene& scene,
                                   const CertifiedContactOptions& options,
                                   const PreRotationOptions& pre_rotation,
                                   const MuscleSolver& solver,
                                   const MuscleShapes& start,
                                   const ProgressCallback& on_progress) {
  const Stopwatch preparing;
  CertifiedScene certified =
      BeginScene(scene, ExemptInOrder(scene, OrderOfNames(scene)), options);
  const MotionContext context = {scene, certified, pre_rotation, solver};
  ContactState rest = StateAtRest(context);
  rest.coarse = InOrderOfContact(certified.order, start.coarse);
  rest.targets = FineMeshes(certified, rest.coarse);
  rest.points = InOrderOfContact(certified.order, start.fine);
  RelaxRest(context, /*unfolds=*/false, on_progress, &rest);
  AddRest(std::move(rest), &certified);
  certified.wall_ms = preparing.Milliseconds();
  return certified;
}

CertifiedScene RestoreCertifiedScene(const PreparedScene& scene,
                                     const CertifiedContactOptions& options,
                                     ContactState rest) {
  const Stopwatch preparing;
  CertifiedScene certified =
      BeginScene(scene, ExemptInOrder(scene, OrderOfNames(scene)), options);
  AddRest(std::move(rest), &certified);
  certified.wall_ms = preparing.Milliseconds();
  return certified;
}

CertifiedMotion MoveCertified(const PreparedScene& scene,
                              const CertifiedScene& certified,
                              const ScenePose& pose,
                              const PreRotationOptions& pre_rotation,
                              const MuscleSolver& solver,
                              const ContactState& before,
                              Settling settling,
                              const ProgressCallback& on_progress) {
  const MotionContext context = {scene, certified, pre_rotation, solver};
  const CertifiedContactOptions& options = certified.options;
  AdvanceOptions advance;
  advance.step = options.step;
  const double way = WayBetween(scene.scene, before.pose, pose, options.limits);
  advance.length.longest = 1 / std::max(1.0, way);
  advance.length.unchecked =
      1 / std::max(1.0, way / options.unchecked_fraction);
  advance.length.shortest =
      advance.length.unchecked / std::exp2(options.max_halvings);
  advance.length.max_push = options.max_push;
  advance.max_returns = options.max_returns;
  advance.reach_growth = options.reach_growth;
  advance.max_reach = options.max_reach;
  advance.max_settling_steps = options.max_settling_steps;
  advance.always_settles = settling == Settling::kFully;
  advance.settling_tolerance = advance.always_settles
                                   ? options.full_settling_tolerance
                                   : options.settling_tolerance;
  advance.on_step = options.on_step;
  SetEnd(options, &advance);
  CertifiedMotion motion;
  motion.state = before;
  AdvanceSummary advanced = AdvanceToPose(
      context, advance, pose, /*at=*/0, on_progress, &motion.state);
  motion.last_clean = std::move(advanced.last_clean);
  motion.summary.steps = advanced.steps;
  motion.summary.reached = advanced.reached;
  motion.summary.given_up = advanced.given_up;
  motion.summary.summaries =
      InOrderOfScene(certified.order, std::move(advanced.solves));
  return motion;
}

MuscleShapes ShapesOf(const CertifiedScene& certified,
                      const ContactState& state) {
  return {InOrderOfScene(certified.order, state.coarse),
          InOrderOfScene(certified.order, state.points)};
}

MuscleShapes ShapesOf(const PreparedScene& scene, const ContactState& state) {
  const std::vector<int> order = OrderOfNames(scene);
  return {InOrderOfScene(order, state.coarse),
          InOrderOfScene(order, state.points)};
}

MuscleShapes InterpolatedShapesOf(const CertifiedScene& certified,
                                  const ContactState& state) {
  return {InOrderOfScene(certified.order, state.coarse),
          InOrderOfScene(certified.order, state.targets)};
}

std::vector<Points> FreeCoarseOf(const CertifiedScene& certified,
                                 const ContactState& state) {
  return InOrderOfScene(certified.order, state.free_coarse);
}

std::vector<ContactRows> ContactRowsOf(const CertifiedScene& certified,
                                       const ContactState& state) {
  std::vector<ContactRows> contact;
  for (size_t i = 0; i < state.planes.size(); ++i) {
    const OwnedHalfSpaces& planes = state.planes[i];
    contact.push_back({OneSidedRowsOf(planes.spaces, certified.row_weights[i]),
                       planes.owners});
    for (PlaneOwner& owner : contact.back().owners) {
      if (owner.IsBone()) continue;
      owner.muscle_above = certified.order[owner.muscle_above];
      owner.muscle_below = certified.order[owner.muscle_below];
    }
  }
  return InOrderOfScene(certified.order, std::move(contact));
}

}  // namespace musclewarp
