// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/bare_tendons.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "musclewarp/anatomy/bone_names.h"
#include "musclewarp/anatomy/muscle_facts.h"
#include "musclewarp/base/infinity.h"
#include "musclewarp/base/text.h"
#include "musclewarp/fibres/bodies_along.h"
#include "musclewarp/fibres/tendon_course.h"
#include "musclewarp/preparation/missed_sides.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

using Eigen::Index;
using Eigen::RowVector3d;

// How far from the bone a pulley holds the middle of a tendon, mm: half of its
// thickness, and its sheath.
constexpr double kPulleyHeight = 5;

// Corners of a course that are nearer to each other than this are one, mm.
constexpr double kSamePlace = 1;

// A place on a bone at which a tendon may end.
struct Target {
  std::string landmark;
  LandmarkPoint place;
};

// Returns the point of the bones of a body that is nearest to a point, as a
// guess of where the muscle ends.
Target NearestTarget(const Surroundings& surroundings,
                     const std::string& body,
                     const RowVector3d& point) {
  Target nearest;
  double least = kInfinity;
  for (size_t b = 0; b < surroundings.bones().size(); ++b) {
    if (surroundings.bones()[b].bone.body != body) continue;
    const auto closest = surroundings.surface_of_bone(b).ClosestPoint(point);
    if (closest.distance >= least || closest.distance == 0) continue;
    least = closest.distance;
    nearest.place.bone = b;
    nearest.place.point = closest.point;
    nearest.place.outward = (point - closest.point) / closest.distance;
  }
  nearest.place.evidence = LandmarkEvidence::kGuessed;
  return nearest;
}

// A side of a muscle at which its lines are to go on.
struct Goal {
  bool is_origin = false;
  std::string body;             // for want of landmarks
  std::vector<Target> targets;  // its landmarks

  Target NearestTo(const RowVector3d& point,
                   const Surroundings& surroundings) const {
    if (targets.empty()) return NearestTarget(surroundings, body, point);
    return *std::min_element(
        targets.begin(), targets.end(), [&](const Target& a, const Target& b) {
          return (a.place.point - point).norm() <
                 (b.place.point - point).norm();
        });
  }

  double DistanceTo(const RowVector3d& point,
                    const Surroundings& surroundings) const {
    return (NearestTo(point, surroundings).place.point - point).norm();
  }
};

void Reverse(ActionLine* line) {
  line->rest = Points(line->rest.colwise().reverse());
  std::reverse(line->bodies.begin(), line->bodies.end());
  std::swap(line->bare_begin, line->bare_end);
}

Points AsPoints(const std::vector<RowVector3d>& rows) {
  Points points(static_cast<Index>(rows.size()), 3);
  for (size_t i = 0; i < rows.size(); ++i) points.row(i) = rows[i];
  return points;
}

// Returns the corners of the course from a point to a target, past those
// pulleys that are not behind the point: it has passed a pulley if the next
// corner is nearer to it than to the pulley.
Points CornersTo(const RowVector3d& from,
                 const std::vector<Target>& pulleys,
                 const Target& target) {
  std::vector<RowVector3d> corners;
  for (const Target& pulley : pulleys) {
    corners.emplace_back(pulley.place.point +
                         kPulleyHeight * pulley.place.outward);
  }
  corners.push_back(target.place.point);
  size_t passed = 0;
  for (size_t c = 0; c + 1 < corners.size(); ++c) {
    if ((corners[c + 1] - from).norm() < (corners[c + 1] - corners[c]).norm()) {
      passed = c + 1;
    }
  }
  // The target stays, whatever is beside it.
  std::vector<RowVector3d> course = {from};
  for (size_t c = passed; c < corners.size(); ++c) {
    const bool is_target = c + 1 == corners.size();
    if ((corners[c] - course.back()).norm() > kSamePlace) {
      course.push_back(corners[c]);
    } else if (is_target && course.size() > 1) {
      course.back() = corners[c];
    }
  }
  return AsPoints(course);
}

// Returns the line without what turns to the tip of the mesh, which may be the
// edge of a cut: the tendon leaves the middle of the muscle.
Points WithoutTip(const Points& line) {
  constexpr double kTipShare = 0.1;
  constexpr double kShortestTip = 10, kLongestTip = 30;  // mm
  constexpr double kMostOfLine = 0.3;
  const double length = PolylineLength(line);
  const double tip =
      std::min(std::clamp(kTipShare * length, kShortestTip, kLongestTip),
               kMostOfLine * length);
  const Eigen::VectorXd along = length * SharesAlong(line);
  Index kept = 1;
  while (kept < line.rows() && along[kept] < length - tip) ++kept;
  return line.topRows(kept);
}

// Lets a line go on at its end.
void GoOn(const Surroundings& surroundings,
          const std::vector<Target>& pulleys,
          const Target& target,
          ActionLine* line) {
  const Points inside = WithoutTip(line->rest);
  const double tip = PolylineLength(line->rest) - PolylineLength(inside);
  const Points corners =
      CornersTo(inside.row(inside.rows() - 1), pulleys, target);
  if (corners.rows() < 2) return;
  const Points course = TendonCourse(corners, surroundings.SurfacesOfBones());
  Points rest(inside.rows() + course.rows() - 1, 3);
  rest << inside, course.bottomRows(course.rows() - 1);
  line->rest = std::move(rest);
  line->bare_end = std::max(PolylineLength(course) - tip, 0.0);
  line->bodies = BodiesAlong(line->rest,
                             line->bodies.front(),
                             surroundings.bones()[target.place.bone].bone.body,
                             surroundings.bodies());
}

// Returns true if the first point of a line is on the side of the origin, as
// told by the bodies that the scene names, or by the sides at which lines go
// on: an origin may run along most of a bone, and says less.
bool BeginsAtOrigin(const Surroundings& surroundings,
                    const std::vector<Goal>& goals,
                    const std::vector<std::string>& end_bodies,
                    const ActionLine& line) {
  if (!end_bodies.empty()) return line.bodies.front() == end_bodies.front();
  double forward = 0, backward = 0;
  for (const Goal& goal : goals) {
    const double from_first = goal.DistanceTo(line.rest.row(0), surroundings);
    const double from_last =
        goal.DistanceTo(line.rest.row(line.rest.rows() - 1), surroundings);
    forward += goal.is_origin ? from_first : from_last;
    backward += goal.is_origin ? from_last : from_first;
  }
  return forward <= backward;
}

// Lets the lines go on at the side of `goal`, and returns the tendon there.
// `are_forward`: which lines begin at the origin.
BareTendon GoOnAtSide(const Goal& goal,
                      const std::vector<bool>& are_forward,
                      const Surroundings& surroundings,
                      const std::vector<Target>& pulleys,
                      std::vector<ActionLine>* lines) {
  BareTendon tendon;
  tendon.is_at_origin = goal.is_origin;
  for (size_t i = 0; i < lines->size(); ++i) {
    ActionLine& line = (*lines)[i];
    const bool reverses = are_forward[i] == goal.is_origin;
    if (reverses) Reverse(&line);
    const Target target =
        goal.NearestTo(line.rest.row(line.rest.rows() - 1), surroundings);
    GoOn(surroundings, pulleys, target, &line);
    tendon.length += line.bare_end / static_cast<double>(lines->size());
    if (reverses) Reverse(&line);
    const Bone& bone = surroundings.bones()[target.place.bone].bone;
    tendon.body = bone.body;
    tendon.bone = bone.name;
    tendon.landmark = target.landmark;
    tendon.evidence = std::max(tendon.evidence, target.place.evidence);
  }
  return tendon;
}

std::string PlaceOf(const BareTendon& tendon) {
  if (tendon.landmark.empty()) return "its nearest point";
  std::string words = tendon.landmark;
  std::replace(words.begin(), words.end(), '_', ' ');
  return "the landmark \"" + words + "\"";
}

}  // namespace

std::vector<BareTendon> AddBareTendons(const SceneMuscle& muscle,
                                       const Surroundings& surroundings,
                                       const Eigen::Matrix3d& image,
                                       std::vector<ActionLine>* lines) {
  const std::optional<Side> side = SideOfName(muscle.name);
  const auto targets_of = [&](const std::vector<AnatomicalEnd>& ends) {
    std::vector<Target> targets;
    for (const AnatomicalEnd& end : ends) {
      const auto place =
          FindLandmark(end.places, surroundings.bones(), side, image);
      if (place) targets.push_back({end.landmark, *place});
    }
    return targets;
  };
  std::vector<Goal> goals;
  for (const MissedSide& missed : MissedSides(muscle, *lines, surroundings)) {
    goals.push_back(
        {missed.is_origin, missed.body, targets_of(missed.landmarks)});
  }
  std::vector<bool> are_forward;
  for (const ActionLine& line : *lines) {
    are_forward.push_back(
        BeginsAtOrigin(surroundings, goals, muscle.end_bodies, line));
  }
  const MuscleFacts* facts = FindMuscleFacts(muscle.name);
  std::vector<BareTendon> tendons;
  for (const Goal& goal : goals) {
    // Pulleys are those of the tendon to the insertion.
    const std::vector<Target> pulleys = facts && !goal.is_origin
                                            ? targets_of(facts->pulleys)
                                            : std::vector<Target>();
    tendons.push_back(
        GoOnAtSide(goal, are_forward, surroundings, pulleys, lines));
  }
  return tendons;
}

std::vector<std::string> BareTendonWarnings(
    const std::string& muscle,
    const std::vector<BareTendon>& tendons,
    double body_size) {
  std::vector<std::string> warnings;
  for (const BareTendon& tendon : tendons) {
    warnings.push_back(
        muscle + " has no mesh of its tendon to the " + tendon.bone +
        ", which moves with " + tendon.body + ": its lines go on over " +
        LengthText(tendon.length, body_size) + " without one, to " +
        PlaceOf(tendon) + " (" + ToString(tendon.evidence) +
        "). If that is not right, add the tendon to the mesh, or as a mesh of "
        "its own, or name the bodies in \"end_bodies\"");
  }
  return warnings;
}

}  // namespace musclewarp
