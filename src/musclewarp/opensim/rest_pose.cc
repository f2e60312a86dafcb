// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/rest_pose.h"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "musclewarp/mesh/transformed.h"

namespace musclewarp {
namespace {

// In the sum of squares a radian counts as this many mm, which is about the
// size of a bone.
constexpr double kRadianInMm = 100;

// The transform between two frames, as a rotation vector and a translation.
struct FrameGap {
  Eigen::Vector3d rotation;     // rad
  Eigen::Vector3d translation;  // mm
};

FrameGap GapBetween(const Eigen::Matrix4d& a, const Eigen::Matrix4d& b) {
  const Eigen::Matrix4d a_from_b = RigidInverse(a) * b;
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(a_from_b.topLeftCorner<3, 3>()));
  return {turn.angle() * turn.axis(), a_from_b.topRightCorner<3, 1>()};
}

// Returns the coordinates that move some of the bodies, but not all of them.
std::vector<int> FreeCoordinates(const Model& model,
                                 const std::vector<int>& bodies) {
  std::vector<int> free;
  for (size_t c = 0; c < model.coordinates.size(); ++c) {
    const int coordinate = static_cast<int>(c);
    const auto moved =
        std::count_if(bodies.begin(), bodies.end(), [&](int body) {
          return MovesBody(model, coordinate, body);
        });
    const bool is_coupled =
        std::any_of(model.couplers.begin(),
                    model.couplers.end(),
                    [&](const CoordinateCoupler& coupler) {
                      return coupler.dependent == coordinate;
                    });
    if (moved > 0 && moved < static_cast<int>(bodies.size()) && !is_coupled) {
      free.push_back(coordinate);
    }
  }
  return free;
}

struct GapResiduals {
  const Model& model;
  const std::vector<int>& bodies;
  const std::vector<int>& free;

  CoordinateValues ValuesAt(const double* parameters) const {
    CoordinateValues values = DefaultValues(model);
    for (size_t i = 0; i < free.size(); ++i) values[free[i]] = parameters[i];
    ApplyCouplers(model, &values);
    return values;
  }

  bool operator()(double const* const* parameters, double* residuals) const {
    const auto frames = BodyFrames(model, ValuesAt(parameters[0]));
    for (size_t i = 1; i < bodies.size(); ++i) {
      const FrameGap gap = GapBetween(frames[bodies[0]], frames[bodies[i]]);
      Eigen::Map<Eigen::Vector3d>(residuals + 6 * (i - 1)) =
          kRadianInMm * gap.rotation;
      Eigen::Map<Eigen::Vector3d>(residuals + 6 * (i - 1) + 3) =
          gap.translation;
    }
    return true;
  }
};

}  // namespace

CoincidentPose FindCoincidentPose(const Model& model,
                                  const std::vector<int>& bodies) {
  CHECK(!bodies.empty());
  const std::vector<int> free = FreeCoordinates(model, bodies);
  CoincidentPose pose;
  pose.values = DefaultValues(model);
  if (!free.empty()) {
    GapResiduals residuals{model, bodies, free};
    std::vector<double> parameters;
    for (const int coordinate : free) {
      parameters.push_back(pose.values[coordinate]);
    }
    auto* const cost =
        new ceres::DynamicNumericDiffCostFunction<GapResiduals, ceres::CENTRAL>(
            &residuals, ceres::DO_NOT_TAKE_OWNERSHIP);
    cost->AddParameterBlock(static_cast<int>(free.size()));
    cost->SetNumResiduals(6 * static_cast<int>(bodies.size() - 1));
    ceres::Problem problem;
    problem.AddResidualBlock(cost, nullptr, parameters.data());
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = 200;
    options.function_tolerance = 1e-16;
    options.parameter_tolerance = 1e-14;
    options.gradient_tolerance = 1e-14;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    pose.values = residuals.ValuesAt(parameters.data());
  }
  const auto frames = BodyFrames(model, pose.values);
  for (const int body : bodies) {
    const FrameGap gap = GapBetween(frames[bodies[0]], frames[body]);
    pose.distance = std::max(pose.distance, gap.translation.norm());
    pose.angle = std::max(pose.angle, gap.rotation.norm());
  }
  return pose;
}

}  // namespace musclewarp
