// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/bare_tendons.h"

#include <algorithm>
#include <set>
#include <utility>

#include "musclewarp/anatomy/bone_names.h"
#include "musclewarp/anatomy/muscle_facts.h"
#include "musclewarp/base/infinity.h"
#include "musclewarp/base/text.h"
#include "musclewarp/fibres/bodies_along.h"
#include "musclewarp/fibres/tendon_course.h"
#include "musclewarp/preparation/line_ends.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

using Eigen::Index;
using Eigen::RowVector3d;

// How far from the bone a pulley holds the middle of a tendon, mm: half of its
// thickness, and its sheath.
constexpr double kPulleyHeight = 5;

// A place on a bone at which a tendon may end.
struct Target {
  std::string landmark;
  LandmarkPoint place;
};

// Where one side of a muscle ends: on one of the bodies, at the targets on
// them, if there are any.
struct Destination {
  std::set<std::string> bodies;
  std::vector<Target> targets;
};

// What is known of the muscle and the bones around it.
struct Anatomy {
  const Surroundings& surroundings;
  const std::optional<Side> side;
  const Eigen::Matrix3d& image;

  std::vector<Target> TargetsOf(const std::vector<AnatomicalEnd>& ends) const {
    std::vector<Target> targets;
    for (const AnatomicalEnd& end : ends) {
      const auto place =
          FindLandmark(end.places, surroundings.bones(), side, image);
      if (place) targets.push_back({end.landmark, *place});
    }
    return targets;
  }

  const std::string& BodyOf(const Target& target) const {
    return surroundings.bones()[target.place.bone].body;
  }
};

Destination DestinationOf(const Anatomy& anatomy,
                          const std::vector<AnatomicalEnd>& ends) {
  Destination destination;
  destination.targets = anatomy.TargetsOf(ends);
  for (const Target& target : destination.targets) {
    destination.bodies.insert(anatomy.BodyOf(target));
  }
  return destination;
}

// A body that the scene names; of the targets only those on it count.
Destination NamedDestination(const Anatomy& anatomy,
                             const std::string& body,
                             Destination by_name) {
  std::vector<Target>& targets = by_name.targets;
  targets.erase(std::remove_if(targets.begin(),
                               targets.end(),
                               [&](const Target& target) {
                                 return anatomy.BodyOf(target) != body;
                               }),
                targets.end());
  by_name.bodies = {body};
  return by_name;
}

// Returns the point of the bones of a body that is nearest to a point, as a
// guess of where the muscle ends.
Target NearestTarget(const Surroundings& surroundings,
                     const std::string& body,
                     const RowVector3d& point) {
  Target nearest;
  double least = kInfinity;
  for (size_t b = 0; b < surroundings.bones().size(); ++b) {
    if (surroundings.bones()[b].body != body) continue;
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

Target TargetFor(const Surroundings& surroundings,
                 const Destination& destination,
                 const RowVector3d& point) {
  if (destination.targets.empty()) {
    return NearestTarget(surroundings, *destination.bodies.begin(), point);
  }
  return *std::min_element(destination.targets.begin(),
                           destination.targets.end(),
                           [&](const Target& a, const Target& b) {
                             return (a.place.point - point).norm() <
                                    (b.place.point - point).norm();
                           });
}

double DistanceTo(const Surroundings& surroundings,
                  const Destination& destination,
                  const RowVector3d& point) {
  return (TargetFor(surroundings, destination, point).place.point - point)
      .norm();
}

void Reverse(ActionLine* line) {
  line->rest = Points(line->rest.colwise().reverse());
  std::reverse(line->bodies.begin(), line->bodies.end());
  std::swap(line->bare_begin, line->bare_end);
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
  Points course(static_cast<Index>(corners.size() - passed) + 1, 3);
  course.row(0) = from;
  for (size_t c = passed; c < corners.size(); ++c) {
    course.row(static_cast<Index>(c - passed) + 1) = corners[c];
  }
  return course;
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
  const Points course =
      TendonCourse(CornersTo(inside.row(inside.rows() - 1), pulleys, target),
                   surroundings.SurfacesOfBones());
  Points rest(inside.rows() + course.rows() - 1, 3);
  rest << inside, course.bottomRows(course.rows() - 1);
  line->rest = std::move(rest);
  line->bare_end = std::max(PolylineLength(course) - tip, 0.0);
  line->bodies = BodiesAlong(line->rest,
                             line->bodies.front(),
                             surroundings.bones()[target.place.bone].body,
                             surroundings.bodies());
}

bool Meet(const std::set<std::string>& a, const std::set<std::string>& b) {
  return std::any_of(a.begin(), a.end(), [&](const std::string& body) {
    return b.count(body) > 0;
  });
}

std::set<std::string> EndBodies(const std::vector<ActionLine>& lines) {
  std::set<std::string> bodies;
  for (const ActionLine& line : lines) {
    bodies.insert({line.bodies.front(), line.bodies.back()});
  }
  return bodies;
}

// Both sides of a muscle, and which of them its lines do not reach.
struct Sides {
  Destination origin, insertion;
  bool misses_origin = false, misses_insertion = false;
};

bool IsFarFrom(const std::string& body,
               const std::vector<ActionLine>& lines,
               const Surroundings& surroundings) {
  const auto ends = LineEndsOf(lines, surroundings.bodies());
  const bool is_there =
      std::any_of(ends.begin(), ends.end(), [&](const LineEnd& end) {
        return end.body == body && end.distance <= kFarEnd;
      });
  return !is_there;
}

Sides SidesOf(const SceneMuscle& muscle,
              const Anatomy& anatomy,
              const MuscleFacts* facts,
              const std::vector<ActionLine>& lines) {
  Sides sides;
  if (facts) {
    sides.origin = DestinationOf(anatomy, facts->origin_ends);
    sides.insertion = DestinationOf(anatomy, facts->insertion_ends);
  }
  if (muscle.end_bodies.size() == 2) {
    const std::string &origin = muscle.end_bodies[0],
                      &insertion = muscle.end_bodies[1];
    sides.origin = NamedDestination(anatomy, origin, std::move(sides.origin));
    sides.insertion =
        NamedDestination(anatomy, insertion, std::move(sides.insertion));
    if (origin == insertion) return sides;
    sides.misses_origin = IsFarFrom(origin, lines, anatomy.surroundings);
    sides.misses_insertion = IsFarFrom(insertion, lines, anatomy.surroundings);
    return sides;
  }
  if (Meet(sides.origin.bodies, sides.insertion.bodies)) return sides;
  const std::set<std::string> reached = EndBodies(lines);
  sides.misses_origin =
      !sides.origin.bodies.empty() && !Meet(sides.origin.bodies, reached);
  sides.misses_insertion =
      !sides.insertion.bodies.empty() && !Meet(sides.insertion.bodies, reached);
  return sides;
}

// Returns true if the first point of a line is on the side of the origin, as
// told by the sides that are missed, of which there is one: an origin may run
// along most of a bone.
bool BeginsAtOrigin(const Surroundings& surroundings,
                    const Sides& sides,
                    const ActionLine& line) {
  const RowVector3d first = line.rest.row(0),
                    last = line.rest.row(line.rest.rows() - 1);
  double forward = 0, backward = 0;
  if (sides.misses_origin) {
    forward += DistanceTo(surroundings, sides.origin, first);
    backward += DistanceTo(surroundings, sides.origin, last);
  }
  if (sides.misses_insertion) {
    forward += DistanceTo(surroundings, sides.insertion, last);
    backward += DistanceTo(surroundings, sides.insertion, first);
  }
  return forward <= backward;
}

// Lets the lines go on at one side, and returns the tendon there.
BareTendon GoOnAtSide(bool is_at_origin,
                      const Surroundings& surroundings,
                      const Sides& sides,
                      const std::vector<Target>& pulleys,
                      std::vector<ActionLine>* lines) {
  const Destination& destination =
      is_at_origin ? sides.origin : sides.insertion;
  BareTendon tendon;
  tendon.is_at_origin = is_at_origin;
  for (ActionLine& line : *lines) {
    const bool reverses =
        BeginsAtOrigin(surroundings, sides, line) == is_at_origin;
    if (reverses) Reverse(&line);
    const Target target = TargetFor(
        surroundings, destination, line.rest.row(line.rest.rows() - 1));
    GoOn(surroundings, pulleys, target, &line);
    tendon.length += line.bare_end / static_cast<double>(lines->size());
    if (reverses) Reverse(&line);
    const Bone& bone = surroundings.bones()[target.place.bone];
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
  const MuscleFacts* facts = FindMuscleFacts(muscle.name);
  const bool have_bodies =
      std::all_of(lines->begin(), lines->end(), [](const ActionLine& line) {
        return !line.bodies.empty();
      });
  if ((!facts && muscle.end_bodies.empty()) || lines->empty() || !have_bodies) {
    return {};
  }
  const Anatomy anatomy = {surroundings, SideOfName(muscle.name), image};
  const Sides sides = SidesOf(muscle, anatomy, facts, *lines);
  std::vector<BareTendon> tendons;
  if (sides.misses_origin) {
    tendons.push_back(GoOnAtSide(true, surroundings, sides, {}, lines));
  }
  if (sides.misses_insertion) {
    const std::vector<Target> pulleys =
        facts ? anatomy.TargetsOf(facts->pulleys) : std::vector<Target>();
    tendons.push_back(GoOnAtSide(false, surroundings, sides, pulleys, lines));
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
