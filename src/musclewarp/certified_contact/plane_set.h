// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/certified_contact/contact_step.h"
#include "musclewarp/certified_contact/plane_owner.h"
#include "musclewarp/certified_contact/separating_planes.h"
#include "musclewarp/certified_contact/step_options.h"
#include "musclewarp/proximity/half_space.h"

namespace musclewarp {

// The separating planes of one step, seen from the vertices: which half-spaces
// each of them has to stay in, where the planes between muscles lie at the
// moment, and where a point goes if it has to be in the half-spaces of a
// vertex.
//
//   PlaneSet planes(options, step);
//   planes.Add(FindSeparatingPlanes(options, step, &trees));
//   planes.UpdateLevels(unprojected, points, /*is_first=*/true);
//   planes.FindNear(muscle, v, p);
//   points[muscle].row(v) = planes.Projected(muscle, v, p);
//
// FindNear() and Projected() may be called for different muscles at the same
// time. Nothing depends on the order of the muscles but rounding.
class PlaneSet {
 public:
  // Keeps references.
  PlaneSet(const StepOptions& options, const ContactStep& step);

  // Adds planes. A vertex that is carried more than RelaxationOptions::max_push
  // beyond the plane of a bone cannot come back to it and is left out.
  void Add(const std::vector<SeparatingPlane>& planes);

  // Places the planes between muscles (and sheets of one) half way between
  // where the two sides want to go, `unprojected`, or where an attached side
  // wants to go: the other one gives way. Unless this is the first
  // time in a run of sweeps, a side that did not get there in `points`, as
  // something else holds it, shifts the plane by what it lacks: the other side
  // has to go farther. #V x 3 each, mm.
  void UpdateLevels(const std::vector<Points>& unprojected,
                    const std::vector<Points>& points,
                    bool is_first);

  // Chooses the planes of a vertex that Projected() looks at: those from which
  // `point` is not farther than the reach.
  void FindNear(int muscle, int vertex, const Eigen::RowVector3d& point);

  // Returns the point nearest to `point` in the half-spaces of a vertex. If
  // there is none within the reach, a place between them: another muscle gives
  // way by UpdateLevels(), but a bone does not, and has the last word.
  Eigen::RowVector3d Projected(int muscle,
                               int vertex,
                               const Eigen::RowVector3d& point) const;

  // Returns, for each of `vertices` that is near a plane at `points` (#V x 3,
  // mm), the half-space in which its target (`targets`) lies deepest on the
  // wrong side, or that it is nearest to. These are the rows of the coarse
  // solve.
  OwnedHalfSpaces MostViolated(int muscle,
                               const std::vector<int>& vertices,
                               const Points& points,
                               const Points& targets) const;

  // Returns by how much a vertex is on the wrong side of a plane against
  // another surface, at most, mm.
  double WorstViolation(const std::vector<Points>& points) const;

 private:
  // A plane. That of a bone has no half gap, as its level includes the gap.
  struct Plane {
    Eigen::RowVector3d normal;
    double level;  // mm; of a plane between muscles as it is at the moment
    double half_gap;
  };
  // What else there is to know of a plane, in an array of its own: the sweeps
  // read planes more often than anything else.
  struct PlaneOrigin {
    int moving;       // index in moving_; -1 - b: of bone b, which stays
    double distance;  // of what it separates, before the step, mm
  };
  // A plane between muscles, which muscles move, and how far it was shifted to
  // make room.
  struct MovingPlane {
    int plane;
    PlaneOwner owner;
    int shared_corner;  // as in SeparatingPlane
    double shift = 0;   // mm
  };
  // The half-space of a vertex above plane p is p, that of one below it is ~p.
  using Side = int;
  struct VertexSide {
    int vertex;
    Side side;
  };

  void AddPlane(const SeparatingPlane& plane);

  // Returns how many corners of a triangle are attached, as a share.
  double AttachedShare(int muscle, const Eigen::RowVector3i& corners) const;

  // Sorts the sides of each vertex, those in `added` (by muscle) included.
  void SortSides(const std::vector<std::vector<VertexSide>>& added);
  bool ComesBefore(Side a, Side b) const;

  static int NumberOf(Side side) { return side < 0 ? ~side : side; }
  HalfSpace SpaceOf(Side side) const;
  bool IsWithinOneMuscle(Side side) const;
  PlaneOwner CarrierOf(Side side) const;
  void UpdateLevel(const std::vector<Points>& unprojected,
                   const std::vector<Points>& points,
                   bool is_first,
                   MovingPlane* moving);

  const StepOptions& options_;
  const ContactStep& step_;
  std::vector<Plane> planes_;
  std::vector<PlaneOrigin> origins_;  // of planes_
  std::vector<MovingPlane> moving_;

  // By muscle, by vertex: those of vertex v begin at first_sides_[v].
  std::vector<std::vector<Side>> sides_;
  std::vector<std::vector<int>> first_sides_;

  // By muscle: of the sides of a vertex those that are near; the first
  // num_near_[v] from first_sides_[v] on.
  std::vector<std::vector<Side>> near_;
  std::vector<std::vector<int>> num_near_;
};

}  // namespace musclewarp
