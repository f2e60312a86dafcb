// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/base/described.h"
#include "musclewarp/base/stage_times.h"
#include "musclewarp/figures/bone_findings.h"
#include "musclewarp/figures/intersections.h"
#include "musclewarp/figures/muscle_figures.h"
#include "musclewarp/figures/totals.h"

namespace musclewarp {

constexpr auto FieldsOf(Described<StageTime>) {
  using F = StageTime;
  return std::make_tuple(
      Field(&F::name, "name").Text("name of the stage"),
      Field(&F::ms, "ms", "ms")
          .Text("its time. A stage within another one counts for itself alone, "
                "so that the times add up"),
      Field(&F::visits, "visits").Text("how often it was entered"),
      NotWritten(&F::processor_ms),
      NotWritten(&F::work));
}

// Every number that is known of a scene in one pose; the list below says what
// each is. `Muscle` is MuscleFigures or what has them as its base.
template <class Muscle>
struct FiguresOfFrame {
  int index = -1;  // of the pose in its scene, or -1
  std::optional<int> reached_from;
  std::string name;
  double time = 0;
  std::map<std::string, double> coordinates;
  double wall_ms = 0;
  double solve_ms = 0;
  double certify_ms = 0;
  double moment_arms_ms = 0;
  std::vector<StageTime> stages;  // with DeformerOptions::record_stages
  int pose_steps = 1;
  std::vector<std::string> shortcomings;  // certificate/shortcomings.h
  std::vector<BoneOverlap> bone_overlaps;
  std::vector<DeliveredCrossing> delivered_crossings;
  std::vector<Muscle> muscles;  // in the order of the scene
  std::map<std::string, std::map<std::string, double>> path_moment_arms;
  bool moment_arms_converged = true;
  SceneIntersections intersections;  // counted on these very points

  // True if every solve converged and there are no shortcomings.
  bool IsUsable() const {
    return shortcomings.empty() && FirstNotConverged() == nullptr;
  }

  // Solver iterations of all muscles together.
  int iterations() const {
    int sum = 0;
    for (const Muscle& muscle : muscles) sum += muscle.solver.iterations;
    return sum;
  }

  // "converged", or the reason and the muscle whose solve did not converge.
  std::string stop_reason() const {
    const Muscle* muscle = FirstNotConverged();
    if (!muscle) return ToString(StopReason::kConverged);
    return ToString(muscle->solver.stop_reason) + " (" + muscle->name + ")";
  }

  // True if nothing crosses, bones as they were delivered included.
  bool IsClean() const {
    return intersections.IsClean() && delivered_crossings.empty();
  }

  // The largest |volume_error| of a muscle.
  double WorstVolumeError() const {
    return LargestOf(muscles, &MuscleFigures::volume_error);
  }

  // Of two meshes, mm, proved; none if all are above kMeshGapLimit.
  std::optional<double> SmallestGap() const {
    return intersections.SmallestGap();
  }

 private:
  const Muscle* FirstNotConverged() const {
    for (const Muscle& muscle : muscles) {
      if (!muscle.solver.IsSolutionUsable()) return &muscle;
    }
    return nullptr;
  }
};

// The figures of a frame that are kept once its meshes are written: an entry of
// "frames" in report.json.
using FrameFigures = FiguresOfFrame<MuscleFigures>;

template <class Muscle>
constexpr auto FieldsOf(Described<FiguresOfFrame<Muscle>>) {
  using F = FiguresOfFrame<Muscle>;
  return std::make_tuple(
      Field(&F::index, "index").Text("the number of the pose in its motion"),
      Field(&F::reached_from, "reached_from")
          .Text("of a design of postures: the number of the frame from which "
                "it was reached, -1 for the rest pose; null of other frames")
          .Later(),
      Field(&F::name, "name").Text("name of the pose"),
      Field(&F::time, "time", "s").Text("time of the pose"),
      Field(&F::coordinates, "coordinates")
          .Text("the coordinates that the motion gives, in the units of "
                "`motion`"),
      Field(&F::wall_ms, "wall_ms", "ms").Text("time for moving the scene"),
      Field(&F::solve_ms, "solve_ms", "ms")
          .Text("the part of it that was spent in the solver"),
      Field(&F::certify_ms, "certify_ms", "ms")
          .Text("time for counting intersections and folded triangles and for "
                "measuring gaps"),
      Field(&F::moment_arms_ms, "moment_arms_ms", "ms")
          .Text("time for all moment arms of the frame, which is not part of "
                "the other times"),
      Field(&F::pose_steps, "pose_steps")
          .Text("number of solves on the way from the frame before")
          .AtLeast(0),
      Field(&F::iterations, "iterations")
          .Text("the sum over the muscles (with contact they iterate together, "
                "and each counts)"),
      Field(&F::stop_reason, "stop_reason")
          .Text("`converged`, or why not and for which muscle"),
      Field(&F::IsUsable, "usable").Text("whether the frame is usable (below)"),
      Field(&F::shortcomings, "shortcomings")
          .Text("what the frame does not hold, one sentence each; empty if it "
                "holds everything"),
      Field(&F::bone_overlaps, "bone_overlaps")
          .Text("with `{contact}=certified`, where the frame has shortcomings "
                "or a muscle leaves a bone by more than 2 mm: bones of two "
                "bodies that lie in each other. Muscles between them have no "
                "room there; the worst of each pair is a warning"),
      Field(&F::delivered_crossings, "delivered_crossings")
          .Text("what muscles have in common with triangles of a bone as it "
                "was delivered that its repaired mesh does not have. Each "
                "entry is a shortcoming with `{contact}=certified`. "
                "`intersections` does not count them"),
      Field(&F::muscles, "muscles").Text("the figures of each muscle"),
      Field(&F::path_moment_arms, "path_moment_arms_mm", "mm/rad")
          .Text("-dl/dq of straight paths by line and coordinate (mm/m for "
                "translations), for every coordinate of "
                "[moment_arms.sto](motion.md#files)"),
      Field(&F::moment_arms_converged, "moment_arms_converged")
          .Text("false if the shape of a muscle could not be differentiated, "
                "which happens where its solve did not converge; its moment "
                "arms then mean nothing"),
      Field(&F::intersections, "intersections")
          .Text("what crosses, muscle x muscle and muscle x bone"),
      Field(Inner(&F::intersections, &SceneIntersections::gaps), "gaps")
          .Text("the pairs of two muscles, or of a muscle and a bone, that are "
                "at most 2 mm (times `body_size`) apart. Every other pair is "
                "proved to be farther apart. Attachment areas that may "
                "penetrate do not count"),
      Field(&F::SmallestGap, "smallest_gap_mm", "mm")
          .Text("the smallest `at_least_mm`; null if there are no `gaps`"),
      Field(&F::stages, "stages")
          .Text("with `{profile}`: where the time of the frame went, in the "
                "order of the first visit ([performance.md](performance.md) "
                "says what each stage does)")
          .UnlessEmpty());
}

// Returns the figures of a frame without its meshes, lists of triangles and
// histories of solves. `Frame` has FiguresOfFrame as its base.
template <class Muscle>
FrameFigures FiguresOf(const FiguresOfFrame<Muscle>& frame) {
  FrameFigures figures;
  CopyFields(frame, &figures);
  figures.intersections.DropLists();
  for (MuscleFigures& muscle : figures.muscles) muscle.solver.history.clear();
  return figures;
}

}  // namespace musclewarp
