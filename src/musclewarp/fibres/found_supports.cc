// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/found_supports.h"

#include <algorithm>
#include <cmath>

#include "musclewarp/fibres/distance_outside.h"
#include "musclewarp/fibres/tendon_course.h"
#include "musclewarp/skeleton/nearest_segment.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

using Eigen::Index;
using Eigen::RowVector3d;
using Eigen::VectorXd;

// A support doubles its push over this distance, mm.
constexpr double kYield = 5;
// The stiffness of bone, against the tension of the line, 1/mm.
constexpr double kHard = 10;
// A muscle touches a bone that is at most this far from its surface, mm; from
// twice that on it does not.
constexpr double kTouchedBone = 5;
// A muscle lies beside a bone that is at most this far from its surface, mm.
constexpr double kBoneBeside = 10;
// The stiffness of an attachment by length of the line, 1/mm^2, and the length
// over which it fades beyond the middle of the attachment, mm.
constexpr double kHold = 0.04;
constexpr double kHoldFades = 15;
// Lines nearer to each other than this are tied as if they were so far apart,
// mm.
constexpr double kClosestLines = 5;
// A bend below this is rounding, rad.
constexpr double kStraight = 1e-6;

double SmoothStep(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// Returns 1 for gaps up to `near`, 0 from twice that on.
double Fade(double gap, double near) {
  return SmoothStep((2 * near - gap) / near);
}

// Returns the distances of the points of a line from its beginning, mm.
VectorXd Along(const Points& line) {
  return SharesAlong(line) * PolylineLength(line);
}

// Returns half of the length of the segments at each point, mm.
VectorXd PartsOf(const Points& line) {
  const VectorXd along = Along(line);
  const Index last = line.rows() - 1;
  VectorXd parts(last + 1);
  for (Index i = 0; i <= last; ++i) {
    parts[i] =
        (along[std::min(i + 1, last)] - along[std::max<Index>(i - 1, 0)]) / 2;
  }
  return parts;
}

// Returns how far along the line from its first point the middle of the
// attachments at that end lies, mm: the median over their points.
double HeldLength(const Points& line,
                  const std::string& body,
                  const std::string& other,
                  const std::vector<SoftPartEnd>& ends) {
  const std::vector<ActionLine> alone = {{"", line, {}}};
  const double length = PolylineLength(line);
  const VectorXd along = Along(line);
  double held = 0;
  for (const SoftPartEnd& end : ends) {
    if (!end.is_on_bones || end.body != body || end.points.rows() == 0) {
      continue;
    }
    std::vector<double> places;
    for (const auto& point : end.points.rowwise()) {
      const SegmentPoint place = NearestSegment(point, alone);
      places.push_back(along[place.segment] +
                       place.t *
                           (along[place.segment + 1] - along[place.segment]));
    }
    const auto middle = places.begin() + places.size() / 2;
    std::nth_element(places.begin(), middle, places.end());
    // Where both ends are on one body, an area belongs to the nearer end.
    if (body == other && *middle > length / 2) continue;
    held = std::max(held, *middle);
  }
  return held;
}

VectorXd HoldOf(const ActionLine& line, const std::vector<SoftPartEnd>& ends) {
  const Points reversed = line.rest.colwise().reverse();
  const std::string& origin = line.bodies.front();
  const std::string& insertion = line.bodies.back();
  const double first = HeldLength(line.rest, origin, insertion, ends);
  const double last = HeldLength(reversed, insertion, origin, ends);
  const VectorXd along = Along(line.rest), parts = PartsOf(line.rest);
  const double length = along[along.size() - 1];
  VectorXd hold(along.size());
  for (Index i = 0; i < hold.size(); ++i) {
    const double share =
        std::max(SmoothStep(1 - (along[i] - first) / kHoldFades),
                 SmoothStep(1 - (length - along[i] - last) / kHoldFades));
    hold[i] = kHold * parts[i] * share;
  }
  return hold;
}

// The bone of a point's own body beside it.
struct BoneBeside {
  double gap = kInfinity;  // between the muscle's surface and the bone, mm
  RowVector3d outward = RowVector3d::Zero();  // across the line

  // 1 where the bone lies beside the line, 0 where it lies ahead of it: there
  // is no direction across the line in which it would be left.
  double beside = 0;
};

// Returns true if a point of a line, `along` mm from its beginning, lies where
// the line stands for a tendon without a mesh.
bool IsBare(const ActionLine& line, double along, double length) {
  return along < line.bare_begin || length - along < line.bare_end;
}

BoneBeside BoneAt(Index i,
                  bool is_bare,
                  const ActionLine& line,
                  const LineSurroundings& around) {
  BoneBeside bone;
  for (const BodySurface& body : around.bodies) {
    if (body.body != line.bodies[i]) continue;
    const RowVector3d point = line.rest.row(i);
    const PlaceBeside place = PlaceBesideMeshes(body.bones, point);
    double inside = is_bare ? kTendonClearance : kInfinity;
    if (!is_bare) {
      for (const TriangleBvh* surface : around.soft) {
        inside = std::min(inside, surface->ClosestPoint(point).distance);
      }
    }
    bone.gap = place.distance - (std::isfinite(inside) ? inside : 0);
    const Index last = line.rest.rows() - 1;
    const RowVector3d direction = (line.rest.row(std::min(i + 1, last)) -
                                   line.rest.row(std::max<Index>(i - 1, 0)))
                                      .normalized();
    const RowVector3d across =
        place.outward - place.outward.dot(direction) * direction;
    bone.beside = std::clamp((across.norm() - 0.3) / 0.4, 0.0, 1.0);
    if (bone.beside > 0) bone.outward = across.normalized();
  }
  return bone;
}

LineSupports SupportsOf(const ActionLine& line,
                        const LineSurroundings& around) {
  const Points& rest = line.rest;
  const Index count = rest.rows();
  LineSupports supports;
  supports.bends = supports.outward = Points::Zero(count, 3);
  supports.loads = supports.stiffness = supports.plane_stiffness =
      VectorXd::Zero(count);
  supports.hold = HoldOf(line, around.ends);
  const VectorXd along = Along(rest);
  for (Index i = 1; i + 1 < count; ++i) {
    const BoneBeside bone =
        BoneAt(i, IsBare(line, along[i], along[count - 1]), line, around);
    supports.outward.row(i) = bone.outward;
    supports.plane_stiffness[i] =
        kHard * bone.beside * Fade(bone.gap, kBoneBeside);
    const RowVector3d turn = (rest.row(i + 1) - rest.row(i)).normalized() -
                             (rest.row(i) - rest.row(i - 1)).normalized();
    const double load = turn.norm();
    if (load < kStraight) continue;
    supports.bends.row(i) = turn / load;
    supports.loads[i] = load;
    const double towards = -supports.bends.row(i).dot(bone.outward);
    const double hard = bone.beside * Fade(bone.gap, kTouchedBone) *
                        std::clamp((towards - 0.5) / 0.4, 0.0, 1.0);
    const double soft = load / kYield;
    supports.stiffness[i] = soft + hard * std::max(kHard - soft, 0.0);
  }
  return supports;
}

// Returns true if two lines run between the same bodies in the same direction,
// point by point.
bool RunAlike(const ActionLine& a, const ActionLine& b) {
  if (a.rest.rows() != b.rest.rows() || a.bodies.front() != b.bodies.front() ||
      a.bodies.back() != b.bodies.back()) {
    return false;
  }
  const Points reversed = b.rest.colwise().reverse();
  return (a.rest - b.rest).norm() <= (a.rest - reversed).norm();
}

// Ties lines as a membrane would that is as tense across them as along them:
// by 1 / distance^2 and length for two lines. Each pair of m lines counts
// 2 / m, so that as many lines as one likes shear alike.
void Tie(const std::vector<int>& members, std::vector<ActionLine>* lines) {
  const double share = 2.0 / static_cast<double>(members.size());
  for (size_t a = 0; a < members.size(); ++a) {
    ActionLine& line = (*lines)[members[a]];
    for (size_t b = a + 1; b < members.size(); ++b) {
      const ActionLine& other = (*lines)[members[b]];
      const VectorXd parts = (PartsOf(line.rest) + PartsOf(other.rest)) / 2;
      const Eigen::ArrayXd apart =
          (line.rest - other.rest).rowwise().norm().array().max(kClosestLines);
      LineTie& tie = line.supports->ties.emplace_back();
      tie.other = members[b];
      tie.stiffness = share * parts.array() / apart.square();
    }
  }
}

}  // namespace

void FindSupports(const LineSurroundings& around,
                  std::vector<ActionLine>* lines) {
  std::vector<std::vector<int>> alike;
  for (size_t i = 0; i < lines->size(); ++i) {
    ActionLine& line = (*lines)[i];
    if (!line.slides || line.bodies.empty()) continue;
    line.supports = SupportsOf(line, around);
    const auto group =
        std::find_if(alike.begin(), alike.end(), [&](const auto& members) {
          return RunAlike((*lines)[members[0]], line);
        });
    if (group != alike.end()) {
      group->push_back(static_cast<int>(i));
    } else {
      alike.push_back({static_cast<int>(i)});
    }
  }
  for (const std::vector<int>& members : alike) Tie(members, lines);
}

}  // namespace musclewarp
