// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/random_bones.h"

#include <glog/logging.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "musclewarp/phantom/scene_parts.h"

namespace musclewarp::phantom {
namespace {

using Eigen::Vector3d;

// Bones at rest are at least so far apart, mm; bumps take some of it.
constexpr double kLeastDistance = 1;

// The room between a solid and its box, mm: bumps and rounded joins.
constexpr double kMargin = 8;

// A bone in its own frame: its joint is the origin, and its length runs along
// z. Lengths are in mm.
struct BoneShape {
  bool is_plate = false;
  double length = 0;
  double near_radius = 0;  // of the knob at the origin
  double far_radius = 0;   // of the knob at the other end
  // Rods: the radius of the shaft, and how far its middle is out of line.
  double shaft_radius = 0;
  double bow = 0;
  // Plates: y = bend * x^2 is the middle surface.
  double width = 0;
  double thickness = 0;
  double bend = 0;
};

BoneShape DrawRod(RandomDraws* draws) {
  BoneShape shape;
  shape.length = draws->Uniform(100, 240);
  if (draws->Chance(0.2)) shape.length += draws->Uniform(0, 70);
  shape.shaft_radius = draws->Uniform(6, 9) + 0.02 * shape.length;
  shape.near_radius = shape.shaft_radius * draws->Uniform(1.2, 1.7);
  shape.far_radius = shape.shaft_radius * draws->Uniform(1.2, 1.7);
  shape.bow = draws->Uniform(0, 0.05) * shape.length;
  shape.thickness = 2 * shape.shaft_radius;
  return shape;
}

BoneShape DrawPlate(RandomDraws* draws) {
  BoneShape shape;
  shape.is_plate = true;
  shape.length = draws->Uniform(90, 170);
  shape.width = shape.length * draws->Uniform(0.5, 0.9);
  shape.thickness = draws->Uniform(7, 12);
  shape.bend = draws->Uniform(0, 0.5) / shape.width;
  shape.near_radius = draws->Uniform(9, 14);
  shape.far_radius = draws->Uniform(9, 14);
  return shape;
}

Field RodField(const BoneShape& shape) {
  const Field shaft =
      Sweep({{Vector3d::Zero(), 0.9 * shape.shaft_radius},
             {{shape.bow, 0, 0.5 * shape.length}, shape.shaft_radius},
             {{0, 0, shape.length}, shape.shaft_radius}});
  return Union(Union(shaft, Sphere(Vector3d::Zero(), shape.near_radius), 6),
               Sphere({0, 0, shape.length}, shape.far_radius),
               6);
}

Field PlateField(const BoneShape& shape) {
  // The outline is an ellipse, cut out of a slab by an ellipsoid that is long
  // across the slab.
  const Field outline =
      Ellipsoid({0, 0, 0.5 * shape.length},
                {0.5 * shape.width, 20 * shape.width, 0.5 * shape.length});
  const Field plate = [shape, outline](const Vector3d& p) {
    const double y = p.y() - shape.bend * p.x() * p.x();
    return SmoothMax(std::abs(y) - 0.5 * shape.thickness,
                     outline({p.x(), y, p.z()}),
                     0.5 * shape.thickness);
  };
  return Union(Union(plate, Sphere(Vector3d::Zero(), shape.near_radius), 6),
               Sphere({0, 0, shape.length}, shape.far_radius),
               6);
}

Eigen::AlignedBox3d LocalBox(const BoneShape& shape) {
  const double ends = std::max(shape.near_radius, shape.far_radius) + kMargin;
  const double half_width = std::max(ends, 0.5 * shape.width + kMargin);
  const double sag =
      std::max(shape.bow, 0.25 * shape.bend * shape.width * shape.width);
  return {Vector3d(-half_width, -ends, -ends),
          Vector3d(half_width + shape.bow, ends + sag, shape.length + ends)};
}

// A bone of the tree before it is a mesh.
struct PlacedBone {
  BoneShape shape;
  RandomBone bone;
  Eigen::AlignedBox3d box;
  Eigen::Isometry3d world_from_local;
  bool is_far_end_free = true;
  bool is_near_end_free = false;
  bool has_neighbour_beside = false;

  Vector3d Direction() const { return world_from_local.linear().col(2); }
  Vector3d FarEnd() const {
    return world_from_local * Vector3d(0, 0, shape.length);
  }
};

// Puts a bone with its joint at `origin` and its length along `axis`.
PlacedBone PlacedAt(const BoneShape& shape,
                    const Vector3d& origin,
                    const Vector3d& axis,
                    RandomDraws* draws) {
  PlacedBone placed;
  placed.shape = shape;
  placed.bone.axis = axis;
  placed.bone.thickness = shape.thickness;
  placed.bone.breadth = shape.is_plate ? shape.width : 3 * shape.shaft_radius;
  placed.world_from_local = Eigen::Isometry3d::Identity();
  const Vector3d x = draws->DirectionAcross(axis);
  placed.world_from_local.linear() << x, axis.cross(x), axis;
  placed.world_from_local.translation() = origin;
  const Eigen::Isometry3d local_from_world = placed.world_from_local.inverse();
  placed.bone.field = [field =
                           shape.is_plate ? PlateField(shape) : RodField(shape),
                       local_from_world](const Vector3d& p) {
    return field(local_from_world * p);
  };
  const Eigen::AlignedBox3d local = LocalBox(shape);
  for (int corner = 0; corner < 8; ++corner) {
    placed.box.extend(
        placed.world_from_local *
        local.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
  }
  return placed;
}

// An end of a bone, on which the joint to another bone may be.
struct FreeEnd {
  int bone;
  Vector3d centre;
  double radius;
  Vector3d outward;
};

std::vector<FreeEnd> FreeEnds(const std::vector<PlacedBone>& bones) {
  std::vector<FreeEnd> ends;
  for (size_t i = 0; i < bones.size(); ++i) {
    const PlacedBone& placed = bones[i];
    const int index = static_cast<int>(i);
    if (placed.is_far_end_free) {
      ends.push_back({index,
                      placed.FarEnd(),
                      placed.shape.far_radius,
                      placed.Direction()});
    }
    if (placed.is_near_end_free) {
      ends.push_back({index,
                      placed.world_from_local.translation(),
                      placed.shape.near_radius,
                      -placed.Direction()});
    }
  }
  return ends;
}

// Adds a rod whose head turns in a socket, which is added to the parent.
void AddBallJoint(const FreeEnd& end,
                  const Vector3d& axis,
                  RandomDraws* draws,
                  std::vector<PlacedBone>* bones) {
  BoneShape shape = DrawRod(draws);
  shape.near_radius = 1.7 * shape.shaft_radius;
  const double gap = draws->Uniform(2, 3.5);
  const double wall = draws->Uniform(5, 7);
  const double rim = draws->Uniform(-0.25, 0.1) * shape.near_radius;
  const double cavity = shape.near_radius + gap;
  const Vector3d centre = end.centre + (cavity + 0.5 * end.radius) * axis;
  PlacedBone& parent = (*bones)[end.bone];
  const Field cup = Intersection(Sphere(centre, cavity + wall),
                                 HalfSpace(axis, axis.dot(centre) + rim),
                                 2);
  parent.bone.field =
      Difference(Union(parent.bone.field, cup, 6), Sphere(centre, cavity), 1);
  const Vector3d room = Vector3d::Constant(cavity + wall + kMargin);
  parent.box.extend(centre + room);
  parent.box.extend(centre - room);
  parent.bone.thickness = std::min(parent.bone.thickness, wall);
  PlacedBone child = PlacedAt(shape, centre, axis, draws);
  child.bone.parent = end.bone;
  child.bone.joint = centre;
  bones->push_back(child);
}

// Adds a bone whose round end rolls on that of the parent.
void AddHinge(const FreeEnd& end,
              const Vector3d& axis,
              RandomDraws* draws,
              std::vector<PlacedBone>* bones) {
  const BoneShape shape =
      draws->Chance(0.2) ? DrawPlate(draws) : DrawRod(draws);
  const double gap = draws->Uniform(2, 4);
  const Vector3d origin =
      end.centre + (end.radius + gap + shape.near_radius) * axis;
  PlacedBone child = PlacedAt(shape, origin, axis, draws);
  child.bone.parent = end.bone;
  child.bone.joint = end.centre;
  bones->push_back(child);
}

// Adds a rod that runs beside bone `index`.
void AddBeside(int index, RandomDraws* draws, std::vector<PlacedBone>* bones) {
  BoneShape shape = DrawRod(draws);
  PlacedBone& parent = (*bones)[index];
  shape.length = parent.shape.length * draws->Uniform(0.8, 1);
  shape.bow = 0;
  const double space = draws->Uniform(6, 22);
  const Vector3d aside = draws->DirectionAcross(parent.Direction());
  const Vector3d tilt = draws->DirectionAcross(parent.Direction());
  const Vector3d axis =
      (parent.Direction() + draws->Uniform(0, 0.08) * tilt).normalized();
  const double apart =
      std::max(parent.shape.near_radius, parent.shape.far_radius) +
      std::max(shape.near_radius, shape.far_radius) + space + parent.shape.bow;
  const Vector3d origin = parent.world_from_local.translation() + apart * aside;
  parent.has_neighbour_beside = true;
  PlacedBone child = PlacedAt(shape, origin, axis, draws);
  child.bone.parent = index;
  child.bone.joint = origin;
  child.bone.is_beside_parent = true;
  child.is_far_end_free = false;
  bones->push_back(child);
}

// Adds a bone to the tree.
void AddBone(RandomDraws* draws, std::vector<PlacedBone>* bones) {
  const int last = static_cast<int>(bones->size()) - 1;
  if (draws->Chance(0.25) && !(*bones)[last].shape.is_plate &&
      !(*bones)[last].has_neighbour_beside &&
      !(*bones)[last].bone.is_beside_parent) {
    AddBeside(last, draws, bones);
    return;
  }
  const std::vector<FreeEnd> ends = FreeEnds(*bones);
  const FreeEnd& end =
      ends[draws->Integer(0, static_cast<int>(ends.size()) - 1)];
  PlacedBone& parent = (*bones)[end.bone];
  if (end.outward.dot(parent.Direction()) > 0) {
    parent.is_far_end_free = false;
  } else {
    parent.is_near_end_free = false;
  }
  const Vector3d aside = draws->DirectionAcross(end.outward);
  const double bend = draws->Uniform(0, 1.2);  // tangent of the angle
  const Vector3d axis = (end.outward + bend * aside).normalized();
  if (draws->Chance(0.4)) {
    AddBallJoint(end, axis, draws, bones);
  } else {
    AddHinge(end, axis, draws, bones);
  }
}

std::vector<RandomBone> DrawTree(RandomDraws* draws) {
  const int count = draws->Integer(2, 6);
  const BoneShape root = draws->Chance(0.5) ? DrawPlate(draws) : DrawRod(draws);
  const Vector3d tilt = draws->Direction();
  std::vector<PlacedBone> placed = {
      PlacedAt(root,
               Vector3d::Zero(),
               (-Vector3d::UnitZ() + 0.4 * tilt).normalized(),
               draws)};
  placed[0].is_near_end_free = true;
  while (static_cast<int>(placed.size()) < count) AddBone(draws, &placed);
  std::vector<RandomBone> bones;
  for (PlacedBone& one : placed) {
    RandomBone bone = std::move(one.bone);
    bone.name = std::string(one.shape.is_plate ? "plate" : "rod") + "_" +
                std::to_string(bones.size() + 1);
    // Two cells to the wall of a socket or the thickness of a plate.
    Solid solid = {bone.name, bone.field, one.box, 0, {}};
    const double coarsest = std::min(5.0, 0.5 * bone.thickness);
    solid.cell = draws->Uniform(std::min(2.8, coarsest), coarsest);
    solid.roughness = draws->Uniform(0.1, 0.3);
    bone.mesh =
        MeshOf(solid, static_cast<uint32_t>(draws->Integer(0, 1000000)));
    bones.push_back(std::move(bone));
  }
  return bones;
}

}  // namespace

std::vector<RandomBone> DrawBones(RandomDraws* draws) {
  constexpr int kAttempts = 1000;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    std::vector<RandomBone> bones = DrawTree(draws);
    const std::vector<Eigen::Matrix4d> rest(bones.size(),
                                            Eigen::Matrix4d::Identity());
    const bool is_clean =
        std::all_of(bones.begin(), bones.end(), [](const RandomBone& bone) {
          return IsSoundSurface(bone.mesh.surface);
        });
    if (is_clean && LeastBoneDistance(bones, rest) > kLeastDistance) {
      return bones;
    }
  }
  LOG(FATAL) << "no arrangement of bones found in " << kAttempts << " attempts";
  return {};
}

double LeastBoneDistance(const std::vector<RandomBone>& bones,
                         const std::vector<Eigen::Matrix4d>& target_from_rest) {
  CHECK_EQ(bones.size(), target_from_rest.size());
  double least = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < bones.size(); ++i) {
    const Points& points = bones[i].mesh.surface.points;
    for (size_t j = 0; j < bones.size(); ++j) {
      if (i == j) continue;
      const Eigen::Matrix4d j_from_i =
          target_from_rest[j].inverse() * target_from_rest[i];
      for (Eigen::Index v = 0; v < points.rows(); ++v) {
        const Vector3d p = points.row(v).transpose();
        least = std::min(
            least, bones[j].field((j_from_i * p.homogeneous()).head<3>()));
      }
    }
  }
  return least;
}

}  // namespace musclewarp::phantom
