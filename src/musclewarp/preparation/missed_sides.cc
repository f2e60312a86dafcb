// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/missed_sides.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "musclewarp/anatomy/bone_names.h"
#include "musclewarp/anatomy/landmark_point.h"
#include "musclewarp/preparation/line_ends.h"

namespace musclewarp {
namespace {

// Where one side of a muscle ends: on one of the bodies, at the landmarks on
// them, if there are any.
struct Destination {
  std::set<std::string> bodies;
  std::vector<AnatomicalEnd> landmarks;
};

// Returns the body of the bone that a landmark is on; empty if it is on none.
std::string BodyOfLandmark(const AnatomicalEnd& end,
                           const std::optional<Side>& side,
                           const Surroundings& surroundings) {
  const auto place = FindPlace(end.places, surroundings.bones(), side);
  return place ? surroundings.bones()[place->bone].bone.body : "";
}

Destination DestinationOf(const std::vector<AnatomicalEnd>& ends,
                          const std::optional<Side>& side,
                          const Surroundings& surroundings) {
  Destination destination;
  for (const AnatomicalEnd& end : ends) {
    const std::string body = BodyOfLandmark(end, side, surroundings);
    if (body.empty()) continue;
    destination.bodies.insert(body);
    destination.landmarks.push_back(end);
  }
  return destination;
}

// Returns the body that the scene names; of the landmarks only those on it
// count.
Destination NamedDestination(const std::string& body,
                             const Destination& by_name,
                             const std::optional<Side>& side,
                             const Surroundings& surroundings) {
  Destination named;
  named.bodies = {body};
  std::copy_if(by_name.landmarks.begin(),
               by_name.landmarks.end(),
               std::back_inserter(named.landmarks),
               [&](const AnatomicalEnd& end) {
                 return BodyOfLandmark(end, side, surroundings) == body;
               });
  return named;
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

bool IsReached(const std::string& body,
               const std::vector<ActionLine>& lines,
               const Surroundings& surroundings) {
  const auto ends = LineEndsOf(lines, surroundings.bodies());
  return std::any_of(ends.begin(), ends.end(), [&](const LineEnd& end) {
    return end.body == body && end.distance <= kFarEnd;
  });
}

std::string Joined(const std::set<std::string>& names, const char* between) {
  std::string joined;
  for (const std::string& name : names) {
    joined += (joined.empty() ? "" : between) + name;
  }
  return joined;
}

}  // namespace

std::vector<MissedSide> MissedSides(const SceneMuscle& muscle,
                                    const std::vector<ActionLine>& lines,
                                    const Surroundings& surroundings) {
  const MuscleFacts* facts = FindMuscleFacts(muscle.name);
  const bool are_named = muscle.end_bodies.size() == 2;
  const bool have_bodies =
      std::none_of(lines.begin(), lines.end(), [](const ActionLine& line) {
        return line.bodies.empty();
      });
  if ((!facts && !are_named) || lines.empty() || !have_bodies) return {};
  const std::optional<Side> side = SideOfName(muscle.name);
  Destination origin, insertion;
  if (facts) {
    origin = DestinationOf(facts->origin_ends, side, surroundings);
    insertion = DestinationOf(facts->insertion_ends, side, surroundings);
  }
  if (are_named) {
    origin = NamedDestination(muscle.end_bodies[0], origin, side, surroundings);
    insertion =
        NamedDestination(muscle.end_bodies[1], insertion, side, surroundings);
  }
  if (Meet(origin.bodies, insertion.bodies)) return {};
  const std::set<std::string> ends = EndBodies(lines);
  std::vector<MissedSide> missed;
  for (const bool is_origin : {true, false}) {
    const Destination& destination = is_origin ? origin : insertion;
    if (destination.bodies.empty()) continue;
    const std::string body = Joined(destination.bodies, " or ");
    if (are_named ? IsReached(body, lines, surroundings)
                  : Meet(destination.bodies, ends)) {
      continue;
    }
    const std::string bone =
        are_named ? body
                  : (is_origin ? facts->origins : facts->insertions).front();
    missed.push_back(
        {is_origin, bone, body, !are_named, destination.landmarks});
  }
  return missed;
}

std::vector<std::string> MissedBones(const SceneMuscle& muscle,
                                     const std::vector<ActionLine>& lines,
                                     const Surroundings& surroundings) {
  std::vector<std::string> shortcomings;
  for (const MissedSide& side : MissedSides(muscle, lines, surroundings)) {
    if (!side.is_by_name) continue;
    shortcomings.push_back(
        muscle.name + " by its name ends on the " + side.bone +
        ", which moves with " + side.body + ", but its lines end on " +
        Joined(EndBodies(lines), " and ") +
        ": is its tendon missing from the mesh? Add it to the mesh, or as a "
        "mesh of its own, or name the bodies in \"end_bodies\"");
  }
  return shortcomings;
}

}  // namespace musclewarp
