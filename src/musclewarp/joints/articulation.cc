// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/articulation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "musclewarp/anatomy/image_directions.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/parallel_for.h"
#include "musclewarp/base/text.h"
#include "musclewarp/joints/ankle_joints.h"
#include "musclewarp/joints/arm_joints.h"
#include "musclewarp/joints/articulation_checks.h"
#include "musclewarp/joints/bone_sides.h"
#include "musclewarp/joints/hip_joint.h"
#include "musclewarp/joints/joint_building.h"
#include "musclewarp/joints/joint_limits.h"
#include "musclewarp/joints/knee_joint.h"
#include "musclewarp/joints/patella_joint.h"
#include "musclewarp/joints/pelvis_frame.h"
#include "musclewarp/joints/skeleton_size.h"

namespace musclewarp {
namespace {

SurfacePoints Together(const std::vector<const SurfacePoints*>& parts) {
  SurfacePoints all;
  int count = 0;
  for (const SurfacePoints* part : parts) count += part->size();
  all.points.resize(count, 3);
  all.normals.resize(count, 3);
  int next = 0;
  for (const SurfacePoints* part : parts) {
    all.points.middleRows(next, part->size()) = part->points;
    all.normals.middleRows(next, part->size()) = part->normals;
    next += part->size();
    all.area = part->area;  // nearly the same for all
  }
  return all;
}

class Articulator {
 public:
  Articulator(std::vector<Bone> bones, const ArticulationOptions& options)
      : options_(options) {
    for (Bone& bone : bones) bones_.push_back({std::move(bone), {}, {}});
  }

  Articulation Articulate() {
    MeasureBones();
    FindHipBoneCalledPelvis();
    lacks_sides_ =
        !DecideSides(options_.side, image_axes_, &bones_, &result_.notes);
    AssignBodies();
    MeasurePelvis();
    for (const Side side : {Side::kRight, Side::kLeft}) {
      if (options_.side && *options_.side != side) continue;
      FindJoints(side);
    }
    std::vector<std::string> names;
    for (const SampledBone& bone : bones_) names.push_back(bone.bone.name);
    CheckJointsAreThere(options_, names, lacks_sides_, result_.joints);
    CompareSides();
    ConnectBodies();
    for (SampledBone& bone : bones_) {
      result_.bones.push_back(std::move(bone.bone));
    }
    return std::move(result_);
  }

 private:
  void MeasureBones() {
    std::optional<Eigen::Vector3d> up;
    if (!options_.axes.empty()) {
      image_axes_ = DirectionsOfAxes(options_.axes);
      up = image_axes_->col(1);
    }
    ParallelFor(bones_.size(), [&](size_t i) {
      SampledBone& bone = bones_[i];
      if (bone.bone.kind == BoneKind::kOther) return;
      CheckBoneSize(bone.bone);
      bone.surface = SampleSurface(bone.bone.mesh);
      if (bone.bone.kind == BoneKind::kFemur) {
        bone.femur = ShapeOfFemur(bone.surface, up);
      }
    });
    if (!image_axes_ || AgreeWithImage(bones_, *image_axes_)) return;
    image_axes_.reset();
    result_.notes.push_back(
        "the femora do not stand in the frame as its axes " + options_.axes +
        " say, so that the axes are not used");
  }

  // A hip bone that is called a pelvis would be taken for both.
  void FindHipBoneCalledPelvis() {
    SampledBone* pelvis = nullptr;
    for (SampledBone& bone : bones_) {
      const BoneKind kind = bone.bone.kind;
      if (kind != BoneKind::kPelvis && kind != BoneKind::kHipBone) continue;
      if (pelvis != nullptr) return;  // there are both halves
      pelvis = &bone;
    }
    if (!pelvis || pelvis->bone.kind != BoneKind::kPelvis) return;
    for (const SampledBone& bone : bones_) {
      if (!bone.femur.head ||
          !IsOneHipBone(pelvis->surface.points, bone.femur.head->sphere)) {
        continue;
      }
      pelvis->bone.kind = BoneKind::kHipBone;
      result_.notes.push_back(pelvis->bone.name +
                              " is taken for one hip bone, as the head of " +
                              bone.bone.name + " lies in the middle of it");
      return;
    }
  }

  // The name that a body has by the table of joints, of a bone with one.
  static std::string TableBody(const Bone& bone) {
    return BodyOf(bone.kind, bone.side.value_or(Side::kRight));
  }

  void AssignBodies() {
    for (SampledBone& bone : bones_) {
      const std::string of_table = TableBody(bone.bone);
      if (bone.bone.body.empty()) {
        bone.bone.body = of_table.empty() ? bone.bone.name : of_table;
      }
      if (!of_table.empty()) body_of_.emplace(of_table, bone.bone.body);
    }
  }

  SurfacePoints SurfaceOf(BoneKind kind,
                          const std::optional<Side>& side) const {
    std::vector<const SurfacePoints*> parts;
    for (const SampledBone& bone : bones_) {
      if (bone.bone.kind != kind) continue;
      if (side && bone.bone.side && *bone.bone.side != *side) continue;
      parts.push_back(&bone.surface);
    }
    return Together(parts);
  }

  const FemurShape* FemurOf(Side side) const {
    for (const SampledBone& bone : bones_) {
      if (bone.bone.kind == BoneKind::kFemur && bone.bone.side == side) {
        return &bone.femur;
      }
    }
    return nullptr;
  }

  // The points of both hip bones, the mirror image of one if need be.
  Points PointsOfPelvis() const {
    const SurfacePoints pelvis = SurfaceOf(BoneKind::kPelvis, {});
    if (pelvis.size() > 0) return pelvis.points;
    const SurfacePoints both = SurfaceOf(BoneKind::kHipBone, {});
    for (const Side side : {Side::kRight, Side::kLeft}) {
      const SurfacePoints one = SurfaceOf(BoneKind::kHipBone, side);
      if (one.size() == 0 || one.size() < both.size()) continue;
      if (!image_axes_) return Points(0, 3);
      return WithMirrorImage(one.points, side, image_axes_->col(2));
    }
    return both.points;
  }

  void MeasurePelvis() {
    const Points pelvis = PointsOfPelvis();
    if (pelvis.rows() == 0) return;
    Eigen::Vector3d across = Eigen::Vector3d::Zero();
    const FemurShape* right = FemurOf(Side::kRight);
    const FemurShape* left = FemurOf(Side::kLeft);
    if (right && left && right->head && left->head) {
      across =
          (right->head->sphere.center - left->head->sphere.center).normalized();
    }
    pelvis_axes_ = PelvisAxes(pelvis, across);
  }

  Limb LimbOf(Side side) const {
    Limb limb;
    limb.side = side;
    limb.image_axes = image_axes_;
    limb.pelvis_axes = pelvis_axes_;
    std::set<BoneKind> kinds;
    for (const SampledBone& bone : bones_) kinds.insert(bone.bone.kind);
    for (const BoneKind kind : kinds) {
      SurfacePoints surface = SurfaceOf(kind, side);
      if (surface.size() > 0) limb.surfaces[kind] = std::move(surface);
    }
    return limb;
  }

  bool IsAskedFor(JointKind kind) const {
    return options_.joints.empty() ||
           std::count(options_.joints.begin(), options_.joints.end(), kind) > 0;
  }

  void FindJoints(Side side) {
    const Limb limb = LimbOf(side);
    const FemurShape* femur = FemurOf(side);
    const FemurShape none;
    if (femur == nullptr) femur = &none;
    const auto has = [&](std::initializer_list<BoneKind> kinds) {
      return std::any_of(kinds.begin(), kinds.end(), [&](BoneKind kind) {
        return limb.Find(kind) != nullptr;
      });
    };
    const bool has_femur = has({BoneKind::kFemur});
    const bool has_tibia = has({BoneKind::kTibia});
    if (has({BoneKind::kPelvis, BoneKind::kHipBone}) && has_femur) {
      Add(JointKind::kHip, side, [&] { return FindHip(limb, *femur); });
    }
    if (has_femur && has_tibia) {
      Add(JointKind::kKnee, side, [&] { return FindKnee(limb, *femur); });
    }
    if (has_femur && has_tibia && has({BoneKind::kPatella})) {
      AddPatella(limb);
    }
    if (has_tibia && has({BoneKind::kTalus, BoneKind::kFoot})) {
      Add(JointKind::kAnkle, side, [&] { return FindAnkle(limb, *femur); });
    }
    if (has_tibia && has({BoneKind::kTalus}) && has({BoneKind::kFoot})) {
      Add(JointKind::kSubtalar, side, [&] {
        return FindSubtalar(limb, *femur);
      });
    }
    FindArmJoints(limb);
  }

  // The patella follows the knee, and stands still without one.
  void AddPatella(const Limb& limb) {
    const auto knee = std::find_if(
        result_.joints.begin(), result_.joints.end(), [&](auto& joint) {
          return joint.kind == JointKind::kKnee && joint.side == limb.side;
        });
    if (knee == result_.joints.end()) return;
    const FoundJoint of_knee = *knee;
    Add(JointKind::kPatella, limb.side, [&] {
      return FindPatella(limb, of_knee);
    });
  }

  void FindArmJoints(const Limb& limb) {
    const bool has_humerus = limb.Find(BoneKind::kHumerus) != nullptr;
    const bool has_ulna = limb.Find(BoneKind::kUlna) != nullptr;
    const bool has_radius = limb.Find(BoneKind::kRadius) != nullptr;
    if (has_humerus && limb.Find(BoneKind::kScapula) != nullptr) {
      Add(JointKind::kShoulder, limb.side, [&] { return FindShoulder(limb); });
    }
    if (has_humerus && has_ulna) {
      Add(JointKind::kElbow, limb.side, [&] { return FindElbow(limb); });
    }
    if (has_humerus && has_ulna && has_radius) {
      Add(JointKind::kForearm, limb.side, [&] { return FindForearm(limb); });
    }
  }

  // The body of a bone that has this one by the table of joints; the foot
  // stands in for a talus that has no mesh of its own.
  std::string BodyByTable(const std::string& body, Side side) const {
    const auto own = body_of_.find(body);
    if (own != body_of_.end()) return own->second;
    if (body != BodyOf(BoneKind::kTalus, side)) return "";
    const auto foot = body_of_.find(BodyOf(BoneKind::kFoot, side));
    return foot == body_of_.end() ? "" : foot->second;
  }

  template <typename Find>
  void Add(JointKind kind, Side side, const Find& find) {
    if (!IsAskedFor(kind)) return;
    const auto given = std::find_if(
        options_.given.begin(), options_.given.end(), [&](auto& joint) {
          return joint.kind == kind && joint.side == side;
        });
    FoundJoint joint;
    if (given != options_.given.end()) {
      joint = *given;
      joint.is_given = true;
    } else {
      joint = find();
      if (options_.zero == ZeroPose::kScan) {
        joint.child_axes = joint.parent_axes;
      }
    }
    joint.parent = BodyByTable(ParentBody(kind, side), side);
    joint.child = BodyByTable(ChildBody(kind, side), side);
    if (joint.parent == joint.child) return;  // one body by the user's table
    result_.joints.push_back(std::move(joint));
  }

  FoundJoint* JointOf(JointKind kind, Side side) {
    for (FoundJoint& joint : result_.joints) {
      if (joint.kind == kind && joint.side == side && !joint.is_given) {
        return &joint;
      }
    }
    return nullptr;
  }

  // Left and right of one person are alike.
  void CompareSides() {
    for (const JointKind kind : AllJointKinds()) {
      FoundJoint* right = JointOf(kind, Side::kRight);
      FoundJoint* left = JointOf(kind, Side::kLeft);
      if (right == nullptr || left == nullptr) continue;
      if (right->shapes.empty() || left->shapes.empty()) continue;
      const double r = right->shapes[0].radius, l = left->shapes[0].radius;
      const double percent =
          r == l ? 0 : 100 * std::abs(r - l) / std::max(r, l);
      const std::map<std::string, std::string> words = {
          {"shape", right->shapes[0].what},
          {"right", RoundedText(r, 1)},
          {"left", RoundedText(l, 1)}};
      for (FoundJoint* joint : {right, left}) {
        Judge({{kJointLimits.sides.radius, percent}}, &joint->verdict, words);
      }
    }
  }

  // Puts the bodies in order, and fixes those that no joint carries.
  void ConnectBodies() {
    std::map<std::string, std::string> carrier;
    for (const FoundJoint& joint : result_.joints) {
      if (joint.IsFound()) carrier[joint.child] = joint.parent;
    }
    for (const SampledBone& bone : bones_) {
      if (carrier.count(bone.bone.body) > 0) continue;
      const std::string parent = CarrierByTable(bone.bone);
      carrier[bone.bone.body] = parent;
      result_.welds.push_back({parent, bone.bone.body});
    }
    std::set<std::string> placed = {"ground"};
    while (placed.size() <= carrier.size()) {
      const size_t before = placed.size();
      for (const auto& [body, parent] : carrier) {
        if (placed.count(parent) == 0 || !placed.insert(body).second) continue;
        result_.bodies.push_back(body);
      }
      if (placed.size() > before) continue;
      throw InputError("bodies",
                       "carry each other in a circle",
                       "correct the column \"body\" of the table");
    }
  }

  // The body that carries a bone by the table of joints, past those that are
  // not there: a tibia without a knee is fixed to the femur.
  std::string CarrierByTable(const Bone& bone) const {
    const Side side = bone.side.value_or(Side::kRight);
    if (bone.kind == BoneKind::kPatella) {
      const std::string tibia = BodyByTable("tibia" + SuffixOf(side), side);
      if (!tibia.empty() && tibia != bone.body) return tibia;
    }
    std::string of_table = TableBody(bone);
    for (bool is_found = true; is_found;) {
      is_found = false;
      for (const JointKind kind : AllJointKinds()) {
        if (ChildBody(kind, side) != of_table) continue;
        of_table = ParentBody(kind, side);
        const std::string parent = BodyByTable(of_table, side);
        if (!parent.empty() && parent != bone.body) return parent;
        is_found = true;
        break;
      }
    }
    return "ground";
  }

  const ArticulationOptions& options_;
  std::vector<SampledBone> bones_;
  std::optional<Eigen::Matrix3d> image_axes_, pelvis_axes_;
  std::map<std::string, std::string> body_of_;  // by the body of the table
  bool lacks_sides_ = false;  // a bone has none, although its kind does
  Articulation result_;
};

}  // namespace

Articulation Articulate(std::vector<Bone> bones,
                        const ArticulationOptions& options) {
  const double size = SkeletonSizeOf(bones);
  if (size == 1) return Articulator(std::move(bones), options).Articulate();
  ArticulationOptions of_human = options;
  for (Bone& bone : bones) bone.mesh.points /= size;
  for (FoundJoint& joint : of_human.given) ScaleLengths(1 / size, &joint);
  Articulation found = Articulator(std::move(bones), of_human).Articulate();
  found.size = size;
  for (Bone& bone : found.bones) bone.mesh.points *= size;
  for (FoundJoint& joint : found.joints) ScaleLengths(size, &joint);
  found.notes.push_back("the bones are " + BodySizeText(size) +
                        " human size; remarks on joints give lengths at human "
                        "size, tables and files true ones");
  return found;
}

}  // namespace musclewarp
