// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/model_poses.h"

#include <Eigen/Geometry>
#include <sstream>
#include <utility>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/near_name.h"
#include "musclewarp/base/short_list.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/opensim/guiding_path.h"
#include "musclewarp/opensim/rest_pose.h"
#include "musclewarp/scene/scaled_scene.h"

namespace musclewarp {
namespace {

// The largest distance and angle between the frames of bodies that count as
// coincident. Rounding in the model causes less, another pose more.
constexpr double kLargestGap = 1;                // mm
constexpr double kLargestTurn = RadiansOf(0.5);  // rad

template <class Part>
std::vector<std::string> NamesOf(const std::vector<Part>& parts) {
  std::vector<std::string> names;
  for (const Part& part : parts) names.push_back(part.name);
  return names;
}

int BodyNamed(const Model& model,
              const std::string& name,
              const std::string& where) {
  const int body = model.FindBody(name);
  if (body < 0) {
    const std::vector<std::string> names = NamesOf(model.bodies);
    throw InputError(where,
                     "the body \"" + name + "\" is not in " + model.path,
                     DidYouMean(name, names) +
                         "its bodies: " + ShortList(names, names.size()));
  }
  return body;
}

CoordinateValues GivenRest(const Model& model,
                           const std::map<std::string, double>& coordinates,
                           const std::string& where) {
  CoordinateValues values = DefaultValues(model);
  for (const auto& [name, value] : coordinates) {
    const int coordinate = model.FindCoordinate(name);
    if (coordinate < 0) {
      throw InputError(
          where + ": model_rest.coordinates",
          "\"" + name + "\" " + WhyNoCoordinate(model, name) + ", " +
              model.path,
          DidYouMean(name, NamesOf(model.coordinates)) + "check the name");
    }
    values[coordinate] = value;
  }
  ApplyCouplers(model, &values);
  return values;
}

CoordinateValues FoundRest(const Model& model,
                           const std::vector<int>& bodies,
                           const std::string& where,
                           std::vector<std::string>* notes) {
  const CoincidentPose pose = FindCoincidentPose(model, bodies);
  std::ostringstream gap;
  gap << pose.distance << " mm and " << DegreesOf(pose.angle)
      << " degrees remain";
  if (pose.distance > kLargestGap || pose.angle > kLargestTurn) {
    throw InputError(
        where,
        "in no pose found of " + model.path +
            " the frames of the bones' bodies coincide: " + gap.str(),
        "give \"model_rest\": the coordinates in which the meshes were made");
  }
  std::ostringstream note;
  note << "rest pose of the meshes, where the body frames coincide ("
       << gap.str() << "):";
  const CoordinateValues defaults = DefaultValues(model);
  if (pose.values == defaults) note << " all coordinates at their defaults";
  for (size_t i = 0; i < pose.values.size(); ++i) {
    if (pose.values[i] == defaults[i]) continue;
    const bool is_angle =
        model.coordinates[i].kind == CoordinateKind::kRotational;
    note << " " << model.coordinates[i].name << " "
         << pose.values[i] * (is_angle ? kDegreesPerRadian : 1)
         << (is_angle ? " degrees" : "");
  }
  notes->push_back(note.str());
  return pose.values;
}

}  // namespace

ModelPoses BindModel(Model model,
                     const ModelRest& rest,
                     const std::vector<std::string>& bodies,
                     const std::string& where,
                     std::vector<std::string>* notes) {
  ModelPoses poses;
  for (const std::string& name : bodies) {
    poses.bodies.push_back(BodyNamed(model, name, where));
    CheckBodyIsSupported(model, poses.bodies.back(), "the scene");
  }
  int frame = rest.frame.empty() ? 0 : BodyNamed(model, rest.frame, where);
  if (rest.coordinates) {
    poses.rest = GivenRest(model, *rest.coordinates, where);
  } else {
    poses.rest = FoundRest(model, poses.bodies, where, notes);
    frame = poses.bodies[0];
  }
  const auto ground_from_body = BodyFrames(model, poses.rest);
  poses.scene_from_ground = RigidInverse(ground_from_body[frame]);
  for (size_t i = 0; i < model.bodies.size(); ++i) {
    poses.body_from_rest.push_back(
        rest.coordinates
            ? RigidInverse(poses.scene_from_ground * ground_from_body[i])
            : Eigen::Matrix4d::Identity());
  }
  poses.model = std::move(model);
  return poses;
}

ActionLine LineOfMuscle(const ModelPoses& poses, int muscle) {
  const ModelMuscle& path = poses.model.muscles[muscle];
  std::vector<Eigen::Matrix4d> rest_from_body;
  for (const Eigen::Matrix4d& transform : poses.body_from_rest) {
    rest_from_body.push_back(RigidInverse(transform));
  }
  ActionLine line;
  line.name = path.name;
  line.rest = GuidingPath(poses.model, path, rest_from_body, poses.rest);
  for (const PathPoint& point : path.path) {
    line.bodies.push_back(poses.model.bodies[point.body].name);
  }
  return line;
}

ScenePose PoseAt(const ModelPoses& poses, const CoordinateValues& values) {
  const Model& model = poses.model;
  const auto ground_from_body = BodyFrames(model, values);
  std::vector<Eigen::Matrix4d> scene_from_body;
  for (const Eigen::Matrix4d& frame : ground_from_body) {
    scene_from_body.push_back(poses.scene_from_ground * frame);
  }
  ScenePose pose;
  pose.model_values = values;
  for (const int body : poses.bodies) {
    pose.bodies[model.bodies[body].name] =
        scene_from_body[body] * poses.body_from_rest[body];
  }
  for (const int coordinate : poses.given_coordinates) {
    const bool is_angle =
        model.coordinates[coordinate].kind == CoordinateKind::kRotational;
    pose.coordinates[model.coordinates[coordinate].name] =
        values[coordinate] * (is_angle ? kDegreesPerRadian : 1);
  }
  for (const int index : poses.muscles) {
    const ModelMuscle& muscle = model.muscles[index];
    pose.lines[muscle.name] =
        GuidingPath(model, muscle, scene_from_body, values);
    pose.path_lengths[muscle.name] =
        PathLength(muscle, ground_from_body, values);
  }
  if (poses.body_size != 1) ScaleLengths(1 / poses.body_size, &pose);
  return pose;
}

}  // namespace musclewarp
