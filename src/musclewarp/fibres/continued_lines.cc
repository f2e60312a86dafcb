// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/continued_lines.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "musclewarp/base/infinity.h"
#include "musclewarp/fibres/bodies_along.h"
#include "musclewarp/fibres/distance_outside.h"
#include "musclewarp/skeleton/nearest_segment.h"
#include "musclewarp/skeleton/polyline.h"
#include "musclewarp/skeleton/sampling.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Points at most this far from another soft part touch it, mm.
constexpr double kTouching = 1;
// A tip at most this far from another soft part lies on it, mm: there may be a
// gap, such as a voxel of the image, between parts that belong together.
constexpr double kNearTip = 3;
// The length of the chord that gives the direction of a line, mm.
constexpr double kChord = 30;
// The cosine of the largest turn of a line where it enters another part.
constexpr double kSharpestTurn = 0.5;

Eigen::Index NumTouching(const Points& points,
                         const std::vector<const TriangleBvh*>& parts) {
  Eigen::Index count = 0;
  for (const auto& point : points.rowwise()) {
    count += DistanceOutside(parts, point) <= kTouching;
  }
  return count;
}

// Returns the mean cross-sectional area of a part, mm^2.
double MeanSection(const SoftPart& part) {
  double length = 0;
  for (const ActionLine& line : part.lines) {
    length +=
        PolylineLength(line.rest) / static_cast<double>(part.lines.size());
  }
  return part.volume / length;
}

// Returns the thinner part that is nearest to the tip of an end of part `own`,
// at most kNearTip away, or -1 if there is none. If the tip is inside several,
// returns the part that the most points of the end touch. Muscles whose bone is
// missing may lie on each other too, but a tendon is thinner than the muscles
// that end on it.
int PartAtTip(const SoftPartEnd& end,
              int own,
              const std::vector<SoftPart>& parts) {
  int nearest = -1;
  std::pair<double, Eigen::Index> best;  // distance, points that do not touch
  for (size_t p = 0; p < parts.size(); ++p) {
    if (MeanSection(parts[p]) >= MeanSection(parts[own])) continue;
    const std::vector<const TriangleBvh*> part = {parts[p].surface};
    const double distance = DistanceOutside(part, end.tip);
    if (distance > kNearTip) continue;
    const std::pair<double, Eigen::Index> here = {
        distance, end.points.rows() - NumTouching(end.points, part)};
    if (nearest >= 0 && here >= best) continue;
    best = here;
    nearest = static_cast<int>(p);
  }
  return nearest;
}

// Returns the mean distance of points from the surface of a part, mm.
double DistanceFrom(const SoftPart& part, const Points& points) {
  double sum = 0;
  for (const auto& point : points.rowwise()) {
    sum += part.surface->ClosestPoint(point).distance;
  }
  return sum / static_cast<double>(points.rows());
}

// For each part that the scene names, lets the nearest end lie on it.
void SetNamedEnds(const std::vector<SoftPart>& parts, SoftPart* part) {
  for (const int other : *part->ends_on) {
    const auto nearest =
        std::min_element(part->ends.begin(),
                         part->ends.end(),
                         [&](const SoftPartEnd& a, const SoftPartEnd& b) {
                           return DistanceFrom(parts[other], a.points) <
                                  DistanceFrom(parts[other], b.points);
                         });
    if (nearest == part->ends.end()) continue;
    nearest->is_on_bones = false;
    nearest->soft_part = other;
  }
}

bool EndsOn(const SoftPart& part, int other) {
  return std::any_of(
      part.ends.begin(), part.ends.end(), [&](const SoftPartEnd& end) {
        return end.soft_part == other;
      });
}

// Returns the end of a part at the last point of one of its lines (#P x 3): the
// end nearest to that point, if it is nearer to it than to the first point.
// Null if there is none.
const SoftPartEnd* EndOfLine(const SoftPart& part, const Points& line) {
  const SoftPartEnd* nearest = nullptr;
  double least = kInfinity;
  for (const SoftPartEnd& end : part.ends) {
    const RowVector3d middle = end.Middle();
    const double distance = (line.row(line.rows() - 1) - middle).norm();
    if (distance >= least || distance >= (line.row(0) - middle).norm()) {
      continue;
    }
    least = distance;
    nearest = &end;
  }
  return nearest;
}

// Returns the point at a distance (mm) along a line, clamped to its ends.
RowVector3d PointAt(const Points& line, double along) {
  const double share = std::clamp(along / PolylineLength(line), 0.0, 1.0);
  return PointsAtShares(line, Eigen::VectorXd::Constant(1, share)).row(0);
}

// Returns the direction of the chord of length kChord around a position on a
// line (mm along it).
RowVector3d DirectionAt(const Points& line, double along) {
  return (PointAt(line, along + kChord / 2) - PointAt(line, along - kChord / 2))
      .normalized();
}

// A point on one of the lines of a part.
struct PlaceOnLine {
  Points line;       // #P x 3, in the direction in which it is followed
  double along = 0;  // mm from its beginning
  double distance = kInfinity;  // from the query point, mm
};

// Returns the nearest point to `point` on the lines of a part. The line is
// reversed if it runs against `direction` there.
PlaceOnLine NearestPlace(const SoftPart& part,
                         const RowVector3d& point,
                         const RowVector3d& direction) {
  PlaceOnLine nearest;
  for (const ActionLine& line : part.lines) {
    const SegmentPoint place = NearestSegment(point, {line});
    const RowVector3d here = PointOnSegment(line.rest, place);
    const double distance = (here - point).norm();
    if (distance >= nearest.distance) continue;
    Points to_here(place.segment + 2, 3);
    to_here << line.rest.topRows(place.segment + 1), here;
    nearest = {line.rest, PolylineLength(to_here), distance};
  }
  if (nearest.line.rows() > 0 &&
      DirectionAt(nearest.line, nearest.along).dot(direction) < 0) {
    nearest.along = PolylineLength(nearest.line) - nearest.along;
    nearest.line = Points(nearest.line.colwise().reverse());
  }
  return nearest;
}

// The continuation of a line beyond its muscle.
struct Continuation {
  Points points;  // mm, at distances of about `spacing`
  std::string body;
  std::set<int> through;
};

// Returns the continuation of a line of parts[from] through the part `to`, from
// the end `point` and the direction of the line there. Nothing if it reaches no
// bone.
std::optional<Continuation> FindContinuation(
    int from,
    int to,
    const RowVector3d& point,
    const RowVector3d& direction,
    double spacing,
    const std::vector<SoftPart>& parts) {
  std::vector<RowVector3d> points;
  Continuation found;
  std::set<int> visited = {from};
  RowVector3d here = point, heading = direction;
  while (visited.insert(to).second) {
    found.through.insert(to);
    const PlaceOnLine place = NearestPlace(parts[to], here, heading);
    if (place.line.rows() == 0 ||
        DirectionAt(place.line, place.along).dot(heading) < kSharpestTurn) {
      return std::nullopt;
    }
    // Begin farther along, so that the crossing to the line makes no corner.
    const double length = PolylineLength(place.line);
    const double begin = place.along + std::max(place.distance, spacing / 2);
    const double left = length - begin;
    const int pieces =
        std::max(1, static_cast<int>(std::lround(left / spacing)));
    for (int i = left > spacing / 2 ? 0 : 1; i <= pieces; ++i) {
      points.push_back(PointAt(place.line, begin + left * i / pieces));
    }
    here = points.back();
    heading = DirectionAt(place.line, length);
    const SoftPartEnd* end = EndOfLine(parts[to], place.line);
    if (!end) return std::nullopt;
    if (end->is_on_bones) {
      found.points.resize(points.size(), 3);
      for (size_t i = 0; i < points.size(); ++i) {
        found.points.row(i) = points[i];
      }
      found.body = end->body;
      return found;
    }
    if (end->soft_part < 0) return std::nullopt;
    to = end->soft_part;
  }
  return std::nullopt;
}

// Continues a line beyond its last point, if that is at an end on another part.
// A line that returns to the body of its other end is anatomically wrong,
// unless the scene names the parts on which the muscle ends.
void ContinueOverLast(int part,
                      const std::vector<SoftPart>& parts,
                      double spacing,
                      ActionLine* line,
                      std::set<int>* through) {
  const SoftPartEnd* end = EndOfLine(parts[part], line->rest);
  if (!end || end->soft_part < 0) return;
  const auto found =
      FindContinuation(part,
                       end->soft_part,
                       line->rest.row(line->rest.rows() - 1),
                       DirectionAt(line->rest, PolylineLength(line->rest)),
                       spacing,
                       parts);
  if (!found) return;
  if (found->body == line->bodies.front() && !parts[part].ends_on) return;
  Points rest(line->rest.rows() + found->points.rows(), 3);
  rest << line->rest, found->points;
  line->rest = std::move(rest);
  line->bodies.resize(line->rest.rows(), found->body);
  through->insert(found->through.begin(), found->through.end());
}

void Reverse(ActionLine* line) {
  line->rest = Points(line->rest.colwise().reverse());
  std::reverse(line->bodies.begin(), line->bodies.end());
}

}  // namespace

std::vector<SoftPartEnd> EndsOf(const SceneMuscle& muscle,
                                const std::vector<FoundAttachment>& found) {
  std::vector<SoftPartEnd> ends;
  for (const Attachment& attachment : muscle.attachments) {
    ends.push_back({attachment.points, attachment.body});
  }
  if (ends.size() >= 2) return ends;
  for (const FoundAttachment& end : found) {
    ends.push_back(
        {end.attachment.points, end.attachment.body, end.is_on_bones, end.tip});
  }
  return ends;
}

bool LiesOnSoftPart(const Points& tip,
                    const std::vector<const TriangleBvh*>& soft_parts) {
  const Eigen::Index touching = NumTouching(tip, soft_parts);
  return touching > 0 && 2 * touching >= tip.rows();
}

void FindSoftEnds(std::vector<SoftPart>* parts) {
  const int count = static_cast<int>(parts->size());
  for (int p = 0; p < count; ++p) {
    SoftPart& part = (*parts)[p];
    if (part.ends_on) {
      SetNamedEnds(*parts, &part);
      continue;
    }
    for (SoftPartEnd& end : part.ends) {
      if (!end.is_on_bones) end.soft_part = PartAtTip(end, p, *parts);
    }
  }
  const std::vector<SoftPart> found = *parts;
  for (int p = 0; p < count; ++p) {
    for (SoftPartEnd& end : (*parts)[p].ends) {
      if (found[p].ends_on || end.is_on_bones || end.soft_part >= 0) continue;
      double least = kInfinity;
      for (int other = 0; other < count; ++other) {
        if (!EndsOn(found[other], p)) continue;
        const double distance = DistanceFrom(found[other], end.points);
        if (distance >= least) continue;
        least = distance;
        end.soft_part = other;
      }
    }
  }
}

ContinuedLines ContinueLines(int part,
                             const std::vector<SoftPart>& parts,
                             const std::vector<BodySurface>& bodies) {
  ContinuedLines continued;
  std::set<int> through;
  for (ActionLine line : parts[part].lines) {
    const Eigen::Index count = line.rest.rows();
    const double spacing =
        PolylineLength(line.rest) / static_cast<double>(count - 1);
    ContinueOverLast(part, parts, spacing, &line, &through);
    Reverse(&line);
    ContinueOverLast(part, parts, spacing, &line, &through);
    Reverse(&line);
    if (line.rest.rows() > count) {
      line.bodies = BodiesAlong(
          line.rest, line.bodies.front(), line.bodies.back(), bodies);
    }
    continued.lines.push_back(std::move(line));
  }
  continued.through.assign(through.begin(), through.end());
  for (const int other : continued.through) {
    const bool is_carrier =
        !EndsOn(parts[other], part) ||
        MeanSection(parts[other]) < MeanSection(parts[part]);
    if (EndsOn(parts[part], other) && is_carrier) {
      continued.tied_to.push_back(other);
    }
  }
  return continued;
}

}  // namespace musclewarp
