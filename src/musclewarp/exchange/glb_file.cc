// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/glb_file.h"

#include <Eigen/Geometry>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "musclewarp/base/output_file.h"
#include "musclewarp/base/palette.h"
#include "musclewarp/exchange/glb_container.h"
#include "musclewarp/run/frame_files.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;
using Eigen::RowVector3d;

// Origins are moved by multiples of this (m), which a float holds exactly.
constexpr double kOriginStep = 1.0 / 1024;

RowVector3d Middle(const Points& points) {
  const RowVector3d middle =
      (points.colwise().minCoeff() + points.colwise().maxCoeff()) / 2;
  return (middle / kOriginStep).array().round() * kOriginStep;
}

std::vector<double> ToJson(const RowVector3d& v) { return {v[0], v[1], v[2]}; }

// IEC 61966-2-1; colours of materials are linear.
double LinearFromSrgb(std::uint8_t value) {
  const double v = value / 255.0;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

// A list of one. Compilers disagree about braces around a single value.
OrderedJson ListOf(OrderedJson item) {
  OrderedJson list = OrderedJson::array();
  list.push_back(std::move(item));
  return list;
}

OrderedJson MaterialJson(const std::string& name, const Color& color) {
  return {{"name", name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor",
             {LinearFromSrgb(color.r),
              LinearFromSrgb(color.g),
              LinearFromSrgb(color.b),
              1.0}},
            {"metallicFactor", 0.0},
            {"roughnessFactor", 0.7}}}};
}

// A scene while it is written. Nodes, meshes and materials have the same
// numbers, muscles first, but for the root, which is the last node.
class GlbScene {
 public:
  GlbScene(const Animation& animation, GlbArrays* arrays)
      : animation_(animation),
        conversion_(GltfFromAxes(animation.axes)),
        arrays_(arrays) {
    const auto each = [&](const auto& visit) {
      for (size_t i = 0; i < animation.names.muscles.size(); ++i) {
        visit(animation.names.muscles[i],
              animation.rest.muscles[i],
              MuscleColor(static_cast<int>(i)));
      }
      for (size_t i = 0; i < animation.names.bones.size(); ++i) {
        visit(animation.names.bones[i], animation.rest.bones[i], BoneColor());
      }
    };
    RowVector3d low = RowVector3d::Constant(INFINITY), high = -low;
    each([&](const std::string&, const TriangleSoup& soup, const Color&) {
      const Points points = conversion_.Convert(soup.points);
      low = low.cwiseMin(points.colwise().minCoeff());
      high = high.cwiseMax(points.colwise().maxCoeff());
    });
    Points box(2, 3);
    box << low, high;
    origin_ = Middle(box);
    each([&](const std::string& name,
             const TriangleSoup& soup,
             const Color& color) { AddMesh(name, soup, color); });
  }

  void AddFrame(const RecordedPose& pose) {
    const size_t muscles = animation_.names.muscles.size();
    for (size_t i = 0; i < muscles; ++i) {
      const Points moved = conversion_.Convert(pose.muscles[i].points);
      const Eigen::MatrixXf steps =
          (moved.rowwise() - (origin_ + middles_[i]) - rest_[i].cast<double>())
              .cast<float>();
      const int accessor = arrays_->AddFloats(steps, true, true);
      meshes_[i]["primitives"][0]["targets"].push_back(
          {{"POSITION", accessor}});
    }
    for (size_t i = 0; i < animation_.names.bones.size(); ++i) {
      AddBonePose(pose, i);
    }
  }

  // The JSON of the scene, once all frames are there.
  OrderedJson Json() {
    OrderedJson children = OrderedJson::array();
    for (size_t i = 0; i < nodes_.size(); ++i) children.push_back(i);
    const size_t root = nodes_.size();
    OrderedJson json = {
        {"asset", {{"version", "2.0"}, {"generator", "musclewarp-export"}}},
        {"scene", 0},
        {"scenes",
         ListOf({{"name", animation_.name}, {"nodes", ListOf(root)}})}};
    AddTargets();
    json["animations"] = ListOf(AnimationJson());
    nodes_.push_back({{"name", animation_.name},
                      {"translation", ToJson(origin_)},
                      {"children", children}});
    json["nodes"] = nodes_;
    json["meshes"] = meshes_;
    json["materials"] = materials_;
    return json;
  }

 private:
  void AddMesh(const std::string& name,
               const TriangleSoup& soup,
               const Color& color) {
    const size_t number = nodes_.size();
    const Points points = conversion_.Convert(soup.points).rowwise() - origin_;
    middles_.push_back(Middle(points));
    rest_.push_back((points.rowwise() - middles_.back()).cast<float>());
    const int positions = arrays_->AddFloats(rest_.back(), true, true);
    const int indices =
        arrays_->AddTriangles(conversion_.Convert(soup.triangles));
    meshes_.push_back({{"name", name},
                       {"primitives",
                        ListOf({{"attributes", {{"POSITION", positions}}},
                                {"indices", indices},
                                {"material", number}})}});
    materials_.push_back(MaterialJson(name, color));
    nodes_.push_back({{"name", name},
                      {"mesh", number},
                      {"translation", ToJson(middles_.back())}});
  }

  void AddBonePose(const RecordedPose& pose, size_t bone) {
    const size_t node = animation_.names.muscles.size() + bone;
    const Eigen::Matrix4d motion =
        conversion_.Convert(RigidMotion(pose.bone_files[bone],
                                        animation_.rest.bones[bone].points,
                                        pose.bones[bone].points));
    const Eigen::Matrix3d rotation = motion.topLeftCorner<3, 3>();
    const RowVector3d middle = origin_ + middles_[node];
    Eigen::Quaterniond turn(rotation);
    turn.normalize();
    if (turns_.size() <= bone) {
      turns_.resize(bone + 1);
      places_.resize(bone + 1);
    }
    // Of the two quaternions of a rotation, that near the frame before.
    if (!turns_[bone].empty() && turns_[bone].back().dot(turn) < 0) {
      turn.coeffs() = -turn.coeffs();
    }
    turns_[bone].push_back(turn);
    places_[bone].push_back(
        (rotation * middle.transpose() + motion.topRightCorner<3, 1>())
            .transpose() -
        origin_);
  }

  void AddTargets() {
    OrderedJson names = OrderedJson::array();
    for (const int number : animation_.numbers) {
      names.push_back(FrameFolder(number));
    }
    for (size_t i = 0; i < animation_.names.muscles.size(); ++i) {
      meshes_[i]["weights"] = std::vector<double>(names.size(), 0.0);
      meshes_[i]["extras"] = {{"targetNames", names}};
    }
  }

  OrderedJson AnimationJson() {
    const auto frames = static_cast<Eigen::Index>(animation_.times.size());
    const Eigen::VectorXd times =
        Eigen::Map<const Eigen::VectorXd>(animation_.times.data(), frames);
    const int input = arrays_->AddFloats(times.cast<float>(), false, true);
    OrderedJson samplers = OrderedJson::array();
    OrderedJson channels = OrderedJson::array();
    const auto add = [&](size_t node, const char* path, int output) {
      channels.push_back({{"sampler", samplers.size()},
                          {"target", {{"node", node}, {"path", path}}}});
      samplers.push_back(
          {{"input", input}, {"interpolation", "LINEAR"}, {"output", output}});
    };
    const size_t muscles = animation_.names.muscles.size();
    if (muscles > 0) {
      // Each frame has its own target, and no other.
      const Eigen::MatrixXf identity =
          Eigen::MatrixXf::Identity(frames, frames);
      const int weights = arrays_->AddFloats(identity.reshaped(), false, false);
      for (size_t i = 0; i < muscles; ++i) add(i, "weights", weights);
    }
    for (size_t bone = 0; bone < turns_.size(); ++bone) {
      Eigen::MatrixXf turns(frames, 4), places(frames, 3);
      for (Eigen::Index k = 0; k < frames; ++k) {
        turns.row(k) = turns_[bone][k].coeffs().transpose().cast<float>();
        places.row(k) = places_[bone][k].cast<float>();
      }
      add(muscles + bone, "rotation", arrays_->AddFloats(turns, false, false));
      add(muscles + bone,
          "translation",
          arrays_->AddFloats(places, false, false));
    }
    return {{"name", "motion"},
            {"samplers", samplers},
            {"channels", channels},
            {"extras", {{"frames", animation_.numbers}}}};
  }

  const Animation& animation_;
  GltfConversion conversion_;
  GlbArrays* arrays_;
  RowVector3d origin_;                // of the root, m
  std::vector<RowVector3d> middles_;  // origins of the meshes, in the root
  std::vector<Eigen::MatrixXf> rest_;
  // Of the bones, frame by frame.
  std::vector<std::vector<Eigen::Quaterniond>> turns_;
  std::vector<std::vector<RowVector3d>> places_;
  OrderedJson nodes_ = OrderedJson::array();
  OrderedJson meshes_ = OrderedJson::array();
  OrderedJson materials_ = OrderedJson::array();
};

}  // namespace

void WriteGlb(const std::string& path, const Animation& animation) {
  WriteFileAtomically(path, [&](const std::string& partial) {
    GlbArrays arrays(partial + ".arrays");
    GlbScene scene(animation, &arrays);
    for (size_t i = 0; i < animation.times.size(); ++i) {
      scene.AddFrame(animation.read(static_cast<int>(i)));
    }
    arrays.WriteGlb(partial, path, scene.Json());
  });
}

}  // namespace musclewarp
