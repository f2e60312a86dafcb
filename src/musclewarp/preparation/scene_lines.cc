// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/scene_lines.h"

#include <algorithm>
#include <utility>

#include "musclewarp/anatomy/image_directions.h"
#include "musclewarp/base/parallel_for.h"
#include "musclewarp/fibres/bodies_along.h"
#include "musclewarp/fibres/fibres.h"
#include "musclewarp/fibres/found_supports.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

// Returns the indices of the muscles on which a muscle ends according to the
// scene.
std::optional<std::vector<int>> NamedEnds(const SceneMuscle& muscle,
                                          const Scene& scene) {
  if (!muscle.ends_on) return std::nullopt;
  std::vector<int> ends_on;
  for (const std::string& name : *muscle.ends_on) {
    const auto named = std::find_if(
        scene.muscles.begin(), scene.muscles.end(), [&](const auto& other) {
          return other.name == name;
        });
    if (named == scene.muscles.end()) continue;  // CheckScene refuses it
    ends_on.push_back(static_cast<int>(named - scene.muscles.begin()));
  }
  return ends_on;
}

// Lets lines that were made end on the two bodies that the scene names, if both
// ends are nearest to the same body.
void PutEndsOnBodies(const std::vector<BodySurface>& bodies,
                     std::vector<ActionLine>* lines) {
  if (bodies.size() != 2) return;
  for (ActionLine& line : *lines) {
    const int last = static_cast<int>(line.rest.rows()) - 1;
    if (line.bodies.empty() || line.bodies.front() != line.bodies.back()) {
      continue;
    }
    const auto distance = [&](int body, int point) {
      return bodies[body].Distance(line.rest.row(point));
    };
    const bool is_forward = distance(0, 0) + distance(1, last) <=
                            distance(1, 0) + distance(0, last);
    for (int point = 0; point <= last; ++point) {
      const bool is_first_half = 2 * point <= last;
      line.bodies[point] = bodies[is_first_half == is_forward ? 0 : 1].body;
    }
  }
}

bool LacksLines(const Scene& scene) {
  return std::any_of(
      scene.muscles.begin(),
      scene.muscles.end(),
      [](const SceneMuscle& muscle) { return muscle.lines.empty(); });
}

bool HasSlidingLines(const SceneMuscle& muscle) {
  return std::any_of(muscle.lines.begin(),
                     muscle.lines.end(),
                     [](const ActionLine& line) { return line.slides; });
}

// Gives all lines of a muscle equally many points again, after some of them
// were continued.
void PlaceEvenly(const std::vector<BodySurface>& bodies,
                 std::vector<ActionLine>* lines) {
  std::vector<Points> courses;
  for (const ActionLine& line : *lines) courses.push_back(line.rest);
  const int count = NumLinePoints(courses);
  for (ActionLine& line : *lines) {
    if (line.rest.rows() == count) continue;
    line.rest = Resampled(line.rest, count);
    line.bodies =
        BodiesAlong(line.rest, line.bodies.front(), line.bodies.back(), bodies);
  }
}

bool Contains(const std::vector<int>& numbers, int number) {
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

// Returns true if the lines of a muscle that is no tendon itself go through the
// tendon `other`, on which it or a tendon between the two ends.
bool PullsOn(int other, int muscle, const std::vector<MadeLines>& made) {
  return Contains(made[muscle].through, other) &&
         std::none_of(made.begin(), made.end(), [&](const auto& third) {
           return Contains(third.tied_to, muscle);
         });
}

// Gives the tendons with meshes of their own the lines of the muscles that end
// on them, so that both go the same way in each pose.
void GiveTendonsTheirMuscles(const Scene& scene, std::vector<MadeLines>* made) {
  const std::vector<MadeLines> before = *made;
  const int count = static_cast<int>(before.size());
  for (int tendon = 0; tendon < count; ++tendon) {
    const bool is_tendon =
        std::any_of(before.begin(), before.end(), [&](const auto& other) {
          return Contains(other.tied_to, tendon);
        });
    if (!is_tendon || !scene.muscles[tendon].lines.empty()) continue;
    MadeLines lines;
    for (int m = 0; m < count; ++m) {
      if (m == tendon || !PullsOn(tendon, m, before)) continue;
      const int first = static_cast<int>(lines.lines.size());
      for (ActionLine line : before[m].lines) {
        for (LineTie& tie : line.supports->ties) tie.other += first;
        line.name = scene.muscles[tendon].name + "_" +
                    std::to_string(lines.lines.size() + 1);
        lines.lines.push_back(std::move(line));
      }
      lines.through.push_back(m);
    }
    if (lines.lines.empty()) continue;
    lines.tied_to = before[tendon].tied_to;
    (*made)[tendon] = std::move(lines);
  }
}

std::vector<int> WithOwn(int own, std::vector<int> others) {
  others.insert(others.begin(), own);
  return others;
}

}  // namespace

std::string ToString(LineCourse course) {
  return course == LineCourse::kTaut ? "taut" : "guided";
}

bool NeedsLines(const Scene& scene, LineCourse course) {
  return LacksLines(scene) ||
         (course == LineCourse::kTaut &&
          std::any_of(
              scene.muscles.begin(), scene.muscles.end(), HasSlidingLines));
}

std::vector<MadeLines> MakeSceneLines(
    const Surroundings& surroundings,
    const SceneLineOptions& options,
    const std::function<void(size_t, size_t)>& on_item,
    const Scene& scene) {
  const size_t count = scene.muscles.size();
  const bool is_taut = options.course == LineCourse::kTaut;
  const bool makes_lines = LacksLines(scene);
  std::vector<MadeLines> made(count);
  std::vector<SoftPart> parts(count);
  const Eigen::Matrix3d image = DirectionsOfAxes(scene.axes);
  const auto make = [&](size_t m) {
    const SceneMuscle& muscle = scene.muscles[m];
    if (!makes_lines && !(is_taut && HasSlidingLines(muscle))) return;
    const TriangleSoup& mesh = surroundings.muscle(m);
    const std::vector<BodySurface> bodies = surroundings.BodiesOf(muscle);
    SoftPart& part = parts[m];
    part.surface = &surroundings.surface_of(m);
    part.volume = SignedVolume(mesh.points, mesh.triangles);
    part.lines =
        !muscle.lines.empty()
            ? muscle.lines
            : MakeLines(muscle.name,
                        mesh,
                        bodies,
                        muscle.attachments,
                        options.lines_each,
                        is_taut ? LinePoints::kEvery10Mm : LinePoints::kNine);
    if (muscle.lines.empty() && !muscle.end_bodies.empty()) {
      PutEndsOnBodies(bodies, &part.lines);
    }
    part.ends = EndsOf(muscle, FindAttachments(mesh, bodies, {}));
    part.ends_on = NamedEnds(muscle, scene);
  };
  ParallelFor(count, make, on_item);
  if (makes_lines) FindSoftEnds(&parts);
  ParallelFor(count, [&](size_t m) {
    const SceneMuscle& muscle = scene.muscles[m];
    if (muscle.lines.empty()) {
      made[m] = {
          ContinueLines(static_cast<int>(m), parts, surroundings.bodies()), {}};
      if (is_taut) {
        made[m].bare_tendons =
            AddBareTendons(muscle, surroundings, image, &made[m].lines);
        PlaceEvenly(surroundings.bodies(), &made[m].lines);
      }
    } else if (is_taut && HasSlidingLines(muscle)) {
      made[m].lines = muscle.lines;
    }
    if (!is_taut || made[m].lines.empty()) return;
    LineSurroundings around;
    around.bodies = surroundings.bodies();
    for (const int part : WithOwn(static_cast<int>(m), made[m].through)) {
      around.soft.push_back(&surroundings.surface_of(part));
      const std::vector<SoftPartEnd>& ends = parts[part].ends;
      around.ends.insert(around.ends.end(), ends.begin(), ends.end());
    }
    FindSupports(around, &made[m].lines);
  });
  if (is_taut) GiveTendonsTheirMuscles(scene, &made);
  return made;
}

std::vector<int> BesideTendons(LineCourse course,
                               const std::vector<int>& through,
                               const std::vector<int>& tied_to) {
  std::vector<int> beside;
  for (const int part : through) {
    if (course == LineCourse::kTaut && Contains(tied_to, part)) continue;
    beside.push_back(part);
  }
  return beside;
}

}  // namespace musclewarp
