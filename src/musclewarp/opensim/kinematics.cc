// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/kinematics.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh/transformed.h"

namespace musclewarp {
namespace {

// OpenSim extends the range of a conditional point by this at both ends.
constexpr double kRangeSlack = 1e-5;

double ValueOf(const TransformAxis& axis, const CoordinateValues& values) {
  std::vector<double> arguments;
  for (const int coordinate : axis.coordinates) {
    arguments.push_back(values[coordinate]);
  }
  return axis.function->Value(arguments);
}

// Returns the transform of the joint itself (X_FM of Simbody), mm.
Eigen::Matrix4d JointTransform(const Joint& joint,
                               const CoordinateValues& values) {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  for (const TransformAxis& axis : joint.rotations) {
    if (!axis.function) continue;
    rotation *=
        Eigen::AngleAxisd(ValueOf(axis, values), axis.axis).toRotationMatrix();
  }
  for (const TransformAxis& axis : joint.translations) {
    if (!axis.function) continue;
    translation += ValueOf(axis, values) * axis.axis;
  }
  Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
  transform.topLeftCorner<3, 3>() = rotation;
  transform.topRightCorner<3, 1>() = translation;
  return transform;
}

Eigen::Matrix4d ParentFromChild(const Joint& joint,
                                const CoordinateValues& values) {
  const Eigen::Matrix4d moved = JointTransform(joint, values);
  return joint.parent_from_joint *
         (joint.is_reversed ? RigidInverse(moved) : moved) *
         RigidInverse(joint.child_from_joint);
}

}  // namespace

CoordinateValues DefaultValues(const Model& model) {
  CoordinateValues values;
  for (const Coordinate& coordinate : model.coordinates) {
    values.push_back(coordinate.default_value);
  }
  ApplyCouplers(model, &values);
  return values;
}

void ApplyCouplers(const Model& model, CoordinateValues* values) {
  // A coupler may depend on one that comes later. As many rounds as there are
  // couplers settle every chain.
  for (size_t round = 0; round < model.couplers.size(); ++round) {
    for (const CoordinateCoupler& coupler : model.couplers) {
      std::vector<double> arguments;
      for (const int coordinate : coupler.independents) {
        arguments.push_back((*values)[coordinate]);
      }
      (*values)[coupler.dependent] =
          coupler.scale * coupler.function->Value(arguments);
    }
  }
}

std::vector<int> FreeCoordinates(const Model& model) {
  std::vector<char> is_free;
  for (const Coordinate& coordinate : model.coordinates) {
    is_free.push_back(!coordinate.is_locked);
  }
  for (const CoordinateCoupler& coupler : model.couplers) {
    is_free[coupler.dependent] = false;
  }
  std::vector<int> free;
  for (size_t i = 0; i < is_free.size(); ++i) {
    if (is_free[i]) free.push_back(static_cast<int>(i));
  }
  return free;
}

void CheckBodyIsSupported(const Model& model,
                          int body,
                          const std::string& used_by) {
  const std::string where = model.path + ": body \"" + model.bodies[body].name +
                            "\", which " + used_by + " needs";
  while (body > 0) {
    const int joint = model.bodies[body].joint;
    if (joint < 0) {
      throw InputError(where,
                       "\"" + model.bodies[body].name + "\" has no joint",
                       "join it to another body");
    }
    if (!model.joints[joint].unsupported.empty()) {
      throw InputError(where,
                       "depends on " + model.joints[joint].type + " \"" +
                           model.joints[joint].name +
                           "\", which is not supported because of " +
                           model.joints[joint].unsupported,
                       "replace it, or give \"poses\"");
    }
    body = model.joints[joint].parent;
  }
}

void CheckMuscleIsSupported(const Model& model, int muscle) {
  const ModelMuscle& path = model.muscles[muscle];
  if (!path.unsupported.empty()) {
    throw InputError(model.path + ": muscle \"" + path.name + "\"",
                     "is not supported because of " + path.unsupported,
                     "replace it, or give the line as an object");
  }
  for (const PathPoint& point : path.path) {
    CheckBodyIsSupported(model, point.body, "the muscle \"" + path.name + "\"");
  }
}

std::vector<Eigen::Matrix4d> BodyFrames(const Model& model,
                                        const CoordinateValues& values) {
  std::vector<Eigen::Matrix4d> frames(model.bodies.size(),
                                      Eigen::Matrix4d::Identity());
  std::vector<char> is_known(model.bodies.size(), 0);
  for (size_t start = 0; start < model.bodies.size(); ++start) {
    // Go up to a body whose frame is known, then back down.
    std::vector<int> chain;
    int body = static_cast<int>(start);
    while (!is_known[body] && model.bodies[body].joint >= 0) {
      chain.push_back(body);
      body = model.joints[model.bodies[body].joint].parent;
    }
    is_known[body] = 1;
    for (auto child = chain.rbegin(); child != chain.rend(); ++child) {
      const Joint& joint = model.joints[model.bodies[*child].joint];
      frames[*child] = frames[joint.parent];
      if (joint.unsupported.empty()) {
        frames[*child] *= ParentFromChild(joint, values);
      }
      is_known[*child] = 1;
    }
  }
  return frames;
}

Eigen::Vector3d LocationOnBody(const PathPoint& point,
                               const CoordinateValues& values) {
  if (!point.is_moving) return point.location;
  Eigen::Vector3d location;
  for (int i = 0; i < 3; ++i) {
    const int coordinate = point.moving_coordinates[i];
    location[i] = point.moving_functions[i]->Value(
        coordinate < 0 ? std::vector<double>{}
                       : std::vector<double>{values[coordinate]});
  }
  return (point.body_from_frame * location.homogeneous()).head<3>();
}

bool IsActive(const PathPoint& point, const CoordinateValues& values) {
  if (point.condition < 0) return true;
  const double value = values[point.condition];
  return value >= point.range[0] - kRangeSlack &&
         value <= point.range[1] + kRangeSlack;
}

Points PathPoints(const ModelMuscle& muscle,
                  const std::vector<Eigen::Matrix4d>& body_frames,
                  const CoordinateValues& values) {
  Points path(muscle.path.size(), 3);
  Eigen::Index count = 0;
  for (const PathPoint& point : muscle.path) {
    if (!IsActive(point, values)) continue;
    path.row(count++) =
        (body_frames[point.body] * LocationOnBody(point, values).homogeneous())
            .head<3>()
            .transpose();
  }
  path.conservativeResize(count, 3);
  return path;
}

double PathLength(const ModelMuscle& muscle,
                  const std::vector<Eigen::Matrix4d>& body_frames,
                  const CoordinateValues& values) {
  if (muscle.length_function) {
    std::vector<double> arguments;
    for (const int coordinate : muscle.length_coordinates) {
      arguments.push_back(values[coordinate]);
    }
    return kMillimetresPerMetre * muscle.length_function->Value(arguments);
  }
  const Points path = PathPoints(muscle, body_frames, values);
  double length = 0;
  for (Eigen::Index i = 0; i + 1 < path.rows(); ++i) {
    length += (path.row(i + 1) - path.row(i)).norm();
  }
  return length;
}

double PathMomentArm(const Model& model,
                     const ModelMuscle& muscle,
                     int coordinate,
                     const CoordinateValues& values) {
  // A length of 500 mm is rounded by 1e-13 mm, which makes 1e-9 mm/rad. The
  // third derivative of l adds about 1e-6 mm/rad.
  constexpr double kStep = 1e-4;
  struct Side {
    double length, at;
    std::vector<bool> active;
  };
  const auto side = [&](double step) {
    CoordinateValues moved = values;
    moved[coordinate] += step;
    ApplyCouplers(model, &moved);
    Side result;
    result.length = PathLength(muscle, BodyFrames(model, moved), moved);
    result.at = step;
    for (const PathPoint& point : muscle.path) {
      result.active.push_back(IsActive(point, moved));
    }
    return result;
  };
  Side before = side(-kStep);
  Side after = side(kStep);
  if (before.active != after.active) {
    const Side here = side(0);
    (before.active == here.active ? after : before) = here;
  }
  return -(after.length - before.length) / (after.at - before.at);
}

bool MovesBody(const Model& model, int coordinate, int body) {
  // The coordinate itself and those coupled to it.
  std::vector<int> moving = {coordinate};
  for (size_t i = 0; i < moving.size(); ++i) {
    for (const CoordinateCoupler& coupler : model.couplers) {
      if (std::count(coupler.independents.begin(),
                     coupler.independents.end(),
                     moving[i]) &&
          !std::count(moving.begin(), moving.end(), coupler.dependent)) {
        moving.push_back(coupler.dependent);
      }
    }
  }
  for (; model.bodies[body].joint >= 0;
       body = model.joints[model.bodies[body].joint].parent) {
    const Joint& joint = model.joints[model.bodies[body].joint];
    for (const auto* axes : {&joint.rotations, &joint.translations}) {
      for (const TransformAxis& axis : *axes) {
        for (const int mine : axis.coordinates) {
          if (std::count(moving.begin(), moving.end(), mine)) return true;
        }
      }
    }
  }
  return false;
}

}  // namespace musclewarp
