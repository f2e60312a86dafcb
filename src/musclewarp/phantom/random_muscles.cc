// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/random_muscles.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "musclewarp/phantom/muscle_path.h"
#include "musclewarp/phantom/muscle_shape.h"
#include "musclewarp/phantom/polygonize.h"
#include "musclewarp/phantom/scene_parts.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp::phantom {
namespace {

using Eigen::Vector3d;

constexpr double kShortest = 40;  // mm
constexpr double kLongest = 300;  // mm

// How deep a muscle may be in a bone or a muscle, as a share of the (mean)
// thickness of the thinner one. What remains of both has room beside each
// other.
constexpr double kDeepestShare = 0.33;

MuscleEnd EndAt(const std::vector<RandomBone>& bones, int bone, int vertex) {
  MuscleEnd end;
  end.bone = bone;
  end.site = bones[bone].mesh.surface.points.row(vertex).transpose();
  end.normal = NormalOf(bones[bone].field, end.site);
  return end;
}

MuscleEnd DrawEnd(const std::vector<RandomBone>& bones,
                  int bone,
                  RandomDraws* draws) {
  const int count = static_cast<int>(bones[bone].mesh.surface.points.rows());
  return EndAt(bones, bone, draws->Integer(0, count - 1));
}

// Draws, out of some ends on a bone, the one that is nearest to a solid: for a
// muscle between two bones.
MuscleEnd DrawEndFacing(const std::vector<RandomBone>& bones,
                        int bone,
                        const Field& solid,
                        RandomDraws* draws) {
  constexpr int kDraws = 12;
  MuscleEnd best = DrawEnd(bones, bone, draws);
  for (int i = 1; i < kDraws; ++i) {
    const MuscleEnd end = DrawEnd(bones, bone, draws);
    if (solid(end.site) < solid(best.site)) best = end;
  }
  return best;
}

// Draws, out of some ends on the bone of another end, the one whose distance to
// it is nearest to `distance`.
MuscleEnd DrawEndBeside(const std::vector<RandomBone>& bones,
                        const MuscleEnd& other,
                        double distance,
                        RandomDraws* draws) {
  constexpr int kDraws = 60;
  const auto miss = [&](const MuscleEnd& end) {
    return std::abs((end.site - other.site).norm() - distance);
  };
  MuscleEnd best = DrawEnd(bones, other.bone, draws);
  for (int i = 1; i < kDraws; ++i) {
    const MuscleEnd end = DrawEnd(bones, other.bone, draws);
    if (miss(end) < miss(best)) best = end;
  }
  return best;
}

std::array<int, 2> DrawBonePair(const std::vector<RandomBone>& bones,
                                RandomDraws* draws) {
  const int last = static_cast<int>(bones.size()) - 1;
  const int second = draws->Integer(1, last);
  int first = bones[second].parent;
  if (draws->Chance(0.15) && bones[first].parent >= 0) {
    first = bones[first].parent;
  } else if (draws->Chance(0.1)) {
    first = (second + draws->Integer(1, last)) % (last + 1);
  }
  return {first, second};
}

std::array<MuscleEnd, 2> DrawEnds(const std::vector<RandomBone>& bones,
                                  const std::vector<RandomMuscle>& earlier,
                                  RandomDraws* draws) {
  if (!earlier.empty() && draws->Chance(0.35)) {
    const int count = static_cast<int>(earlier.size());
    const RandomMuscle& beside = earlier[draws->Integer(0, count - 1)];
    const double at_origin = draws->Uniform(3, 25);
    const double at_insertion = draws->Uniform(3, 25);
    const MuscleEnd origin =
        DrawEndBeside(bones, beside.ends[0], at_origin, draws);
    return {origin, DrawEndBeside(bones, beside.ends[1], at_insertion, draws)};
  }
  auto [first, second] = DrawBonePair(bones, draws);
  if (!earlier.empty() && draws->Chance(0.5)) {
    // The same bones as an earlier muscle, so that muscles cross each other.
    const int count = static_cast<int>(earlier.size());
    const RandomMuscle& other = earlier[draws->Integer(0, count - 1)];
    first = other.ends[0].bone;
    second = other.ends[1].bone;
  }
  if (draws->Chance(0.15)) {
    const MuscleEnd origin =
        DrawEndFacing(bones, first, bones[second].field, draws);
    return {origin, DrawEndFacing(bones, second, bones[first].field, draws)};
  }
  const MuscleEnd origin = DrawEnd(bones, first, draws);
  return {origin, DrawEnd(bones, second, draws)};
}

// Returns what the muscle keeps out of: all bones, then all earlier muscles.
std::vector<PathObstacle> Obstacles(const MuscleShape& shape,
                                    const std::vector<RandomBone>& bones,
                                    const std::vector<RandomMuscle>& earlier) {
  const double thickness = shape.MeanThickness();
  std::vector<PathObstacle> obstacles;
  for (const RandomBone& bone : bones) {
    Eigen::AlignedBox3d box;
    const Points& points = bone.mesh.surface.points;
    box.extend(Vector3d(points.colwise().minCoeff().transpose()));
    box.extend(Vector3d(points.colwise().maxCoeff().transpose()));
    obstacles.push_back(
        {bone.field,
         box,
         std::min(shape.depth_in_bones,
                  kDeepestShare * std::min(bone.thickness, thickness))});
  }
  for (const RandomMuscle& muscle : earlier) {
    obstacles.push_back(
        {muscle.strap,
         muscle.box,
         std::min(shape.depth_in_muscles,
                  kDeepestShare * std::min(muscle.thickness, thickness))});
  }
  return obstacles;
}

// The union of all bones with sharp edges.
Field GroundOf(const std::vector<RandomBone>& bones) {
  std::vector<Field> fields;
  for (const RandomBone& bone : bones) fields.push_back(bone.field);
  return [fields](const Vector3d& p) {
    double least = fields[0](p);
    for (const Field& field : fields) least = std::min(least, field(p));
    return least;
  };
}

// Returns the nodes on a bow from one end to the other, which lies on the side
// of the bones that the ends are on.
std::vector<StrapNode> BowBetween(const MuscleShape& shape,
                                  const std::vector<RandomBone>& bones,
                                  const std::array<MuscleEnd, 2>& ends,
                                  const std::vector<PathObstacle>& obstacles,
                                  RandomDraws* draws) {
  constexpr double kSpacing = 10;  // mm
  std::array<Vector3d, 2> tips;
  for (int k = 0; k < 2; ++k) {
    const MuscleEnd& end = ends[k];
    // The end of the strap enters the bone by the depth that is drawn.
    tips[k] =
        end.site + (shape.tendon - obstacles[end.bone].depth) * end.normal;
  }
  const Vector3d chord = tips[1] - tips[0];
  Vector3d aside = ends[0].normal + ends[1].normal;
  // Ends on opposite sides: the muscle winds around to either side.
  if (aside.norm() < 0.5) aside += draws->DirectionAcross(ends[0].normal);
  const Vector3d bow =
      draws->Uniform(0.05, 0.25) * chord.norm() * aside.normalized();
  const int count =
      std::clamp(static_cast<int>(chord.norm() / kSpacing), 6, 30);
  std::vector<StrapNode> nodes(count);
  for (int i = 0; i < count; ++i) {
    const double t = i / (count - 1.0);
    nodes[i].centre = tips[0] + t * chord + 4 * t * (1 - t) * bow;
    nodes[i].across = bones[ends[0].bone].axis.cross(ends[0].normal);
    nodes[i].half_width = shape.HalfWidth(t);
    nodes[i].half_thickness = shape.HalfThickness(t);
  }
  return nodes;
}

bool IsPathSound(const MuscleShape& shape,
                 const std::vector<StrapNode>& nodes,
                 const std::vector<PathObstacle>& obstacles) {
  constexpr double kLargestExcess = 1.5;  // mm; the rest is cut off
  constexpr double kSharpestTurn = 0.7;   // rad
  const double length = PolylineLength(CentresOf(nodes));
  if (length < kShortest || length > kLongest - 2 * shape.tendon ||
      length < 6 * shape.belly || length < 2 * shape.width[1] ||
      SharpestTurn(CentresOf(nodes)) > kSharpestTurn) {
    return false;
  }
  for (const StrapNode& node : nodes) {
    for (const PathObstacle& obstacle : obstacles) {
      if (Excess(node, obstacle) > kLargestExcess) return false;
    }
  }
  return true;
}

// Returns the strap cut along those obstacles that it touches.
Field CutStrap(const Field& strap,
               const Eigen::AlignedBox3d& box,
               const std::vector<PathObstacle>& obstacles) {
  constexpr double kRounding = 4;  // mm
  // Where the strap or an obstacle is farther away than this, mm, the cut makes
  // no difference to the surface.
  constexpr double kFar = 5;
  std::vector<PathObstacle> near;
  for (const PathObstacle& obstacle : obstacles) {
    if (box.intersects(obstacle.box)) near.push_back(obstacle);
  }
  return [=](const Vector3d& p) {
    double value = strap(p);
    if (value > kFar) return value;
    for (const PathObstacle& obstacle : near) {
      if (obstacle.box.exteriorDistance(p) > kFar) continue;
      value = SmoothMax(value, -obstacle.field(p) - obstacle.depth, kRounding);
    }
    return value;
  };
}

// Tests on a grid that most of the strap is left by the cut, and that most of
// what is left is outside bones.
bool HasEnoughVolume(const Field& strap,
                     const Field& muscle,
                     const Field& ground,
                     const Eigen::AlignedBox3d& box) {
  constexpr double kLeastKept = 0.7;
  constexpr double kLeastOutside = 0.6;
  const double step = std::cbrt(box.volume() / 40000);
  int whole = 0, kept = 0, outside = 0;
  for (double x = box.min().x(); x < box.max().x(); x += step) {
    for (double y = box.min().y(); y < box.max().y(); y += step) {
      for (double z = box.min().z(); z < box.max().z(); z += step) {
        const Vector3d p(x, y, z);
        if (strap(p) >= 0) continue;
        ++whole;
        if (muscle(p) >= 0) continue;
        ++kept;
        if (ground(p) > 0) ++outside;
      }
    }
  }
  return kept > kLeastKept * whole && outside > kLeastOutside * kept;
}

// Returns the index of the bone among `chain` that is nearest to p.
int NearestBone(const std::vector<RandomBone>& bones,
                const std::vector<int>& chain,
                const Vector3d& p) {
  return *std::min_element(chain.begin(), chain.end(), [&](int a, int b) {
    return bones[a].field(p) < bones[b].field(p);
  });
}

// Returns the bones of both ends and those between them in the tree.
std::vector<int> ChainBetween(const std::vector<RandomBone>& bones,
                              int first,
                              int second) {
  std::vector<int> chain = {first, second};
  // Parents come before their children, so the later one is climbed from.
  while (first != second) {
    int& later = first > second ? first : second;
    later = bones[later].parent;
    chain.push_back(later);
  }
  return chain;
}

// Returns the line through the nodes at `place` times their half widths.
ActionLine LineAlong(const std::string& name,
                     const std::vector<StrapNode>& nodes,
                     double place,
                     const std::vector<RandomBone>& bones,
                     const std::array<MuscleEnd, 2>& ends) {
  constexpr double kSpacing = 30;  // mm
  const int count = std::clamp(
      2 + static_cast<int>(PolylineLength(CentresOf(nodes)) / kSpacing), 3, 10);
  const std::vector<int> chain =
      ChainBetween(bones, ends[0].bone, ends[1].bone);
  ActionLine line;
  line.name = name;
  line.slides = true;  // the muscle is attached at its ends only
  line.rest.resize(count, 3);
  for (int i = 0; i < count; ++i) {
    // The mesh is shorter than the strap: its ends are not sharp.
    constexpr double kFromEnd = 0.35;  // of an edge of the path
    const double last = nodes.size() - 1.0;
    const double at =
        std::clamp(i * last / (count - 1), kFromEnd, last - kFromEnd);
    const int k = std::min(static_cast<int>(at), static_cast<int>(last) - 1);
    const auto on_node = [&](const StrapNode& node) -> Vector3d {
      return node.centre + place * node.half_width * node.across;
    };
    const Vector3d p = RoundedPoint((k + 1 - at) * on_node(nodes[k]) +
                                    (at - k) * on_node(nodes[k + 1]));
    line.rest.row(i) = p.transpose();
    const int bone = i == 0           ? ends[0].bone
                     : i == count - 1 ? ends[1].bone
                                      : NearestBone(bones, chain, p);
    line.bodies.push_back(bones[bone].name);
  }
  return line;
}

std::vector<ActionLine> LinesAlong(const std::string& name,
                                   const MuscleShape& shape,
                                   const std::vector<StrapNode>& nodes,
                                   const std::vector<RandomBone>& bones,
                                   const std::array<MuscleEnd, 2>& ends) {
  if (!shape.IsFlat())
    return {LineAlong(name + "_line", nodes, 0, bones, ends)};
  return {LineAlong(name + "_middle", nodes, 0, bones, ends),
          LineAlong(name + "_left", nodes, -0.5, bones, ends),
          LineAlong(name + "_right", nodes, 0.5, bones, ends)};
}

bool AreLinesInside(const std::vector<ActionLine>& lines,
                    const TriangleSoup& muscle) {
  const SearchableMesh mesh(muscle);
  for (const ActionLine& line : lines) {
    for (Eigen::Index i = 0; i < line.rest.rows(); ++i) {
      if (!mesh.winding().IsInside(line.rest.row(i))) return false;
    }
  }
  return true;
}

}  // namespace

std::optional<RandomMuscle> DrawMuscle(const std::string& name,
                                       const std::vector<RandomBone>& bones,
                                       const std::vector<RandomMuscle>& earlier,
                                       double size,
                                       RandomDraws* draws) {
  MuscleShape shape = DrawMuscleShape(size, draws);
  RandomMuscle muscle;
  muscle.name = name;
  muscle.ends = DrawEnds(bones, earlier, draws);
  // An end is not much wider than its bone.
  for (const int k : {0, 1}) {
    double& width = shape.width[2 * k];
    width = std::min(width, 0.5 * bones[muscle.ends[k].bone].breadth);
  }
  muscle.thickness = shape.MeanThickness();
  const double distance = (muscle.ends[0].site - muscle.ends[1].site).norm();
  if (distance < 0.7 * kShortest || distance > kLongest) return {};
  const std::vector<PathObstacle> obstacles = Obstacles(shape, bones, earlier);
  const Field ground = GroundOf(bones);
  const std::vector<StrapNode> nodes =
      TautPath(BowBetween(shape, bones, muscle.ends, obstacles, draws),
               obstacles,
               ground);
  if (!IsPathSound(shape, nodes, obstacles)) return {};

  muscle.strap = Strap(nodes);
  muscle.box = StrapBox(nodes, 0);
  const Field cut = CutStrap(muscle.strap, muscle.box, obstacles);
  muscle.lines = LinesAlong(name, shape, nodes, bones, muscle.ends);
  if (!HasEnoughVolume(muscle.strap, cut, ground, muscle.box)) return {};

  Solid solid = {name, cut, StrapBox(nodes, 6), 0, {}};
  solid.cell = DrawCellSize(shape, PolylineLength(CentresOf(nodes)), draws);
  solid.roughness = draws->Uniform(0.05, 0.3);
  muscle.mesh =
      MeshOf(solid, static_cast<uint32_t>(draws->Integer(0, 1000000)));
  if (!IsSoundSurface(muscle.mesh.surface) ||
      !AreLinesInside(muscle.lines, muscle.mesh.surface)) {
    return {};
  }
  return muscle;
}

}  // namespace musclewarp::phantom
