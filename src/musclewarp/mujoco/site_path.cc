// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mujoco/site_path.h"

#include <ceres/dynamic_autodiff_cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "musclewarp/base/infinity.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/scene/perturbed_poses.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;

// How bodies are, and move with each coordinate, in a posture.
struct MovingBodies {
  std::vector<Matrix4d> frames;              // by body, mm
  std::vector<std::vector<Matrix4d>> rates;  // by coordinate and body
};

MovingBodies BodiesAt(const Model& model,
                      const std::vector<int>& coordinates,
                      const CoordinateValues& values) {
  MovingBodies bodies;
  bodies.frames = BodyFrames(model, values);
  for (const int coordinate : coordinates) {
    const auto aside = [&](double step) {
      CoordinateValues moved = values;
      moved[coordinate] += step;
      ApplyCouplers(model, &moved);
      return BodyFrames(model, moved);
    };
    const auto before = aside(-PerturbedPoses::kStep);
    const auto after = aside(PerturbedPoses::kStep);
    std::vector<Matrix4d>& rates = bodies.rates.emplace_back();
    for (size_t b = 0; b < before.size(); ++b) {
      rates.push_back(RateBetween(before[b], after[b]));
    }
  }
  return bodies;
}

// The length of a path and its arms in a posture, less those of the muscle.
struct PathMisfit {
  const MovingBodies* bodies;
  const SitePosture* posture;
  std::vector<int> body_of_site;

  template <typename T>
  bool operator()(T const* const* places, T* residuals) const {
    using Vector = Eigen::Matrix<T, 3, 1>;
    const auto count = static_cast<int>(body_of_site.size());
    const size_t num_arms = bodies->rates.size();
    T length(0);
    std::vector<T> arms(num_arms, T(0));
    Vector before;
    for (int i = 0; i < count; ++i) {
      const Eigen::Map<const Vector> local(places[0] + 3 * i);
      const Matrix4d& frame = bodies->frames[body_of_site[i]];
      const Vector here = frame.topLeftCorner<3, 3>().cast<T>() * local +
                          frame.topRightCorner<3, 1>().cast<T>();
      if (i > 0) {
        const Vector way = here - before;
        // A segment without length has no direction; 1e-3 mm keeps one.
        const T segment = sqrt(way.squaredNorm() + T(1e-6));
        length += segment;
        for (size_t k = 0; k < num_arms; ++k) {
          const auto velocity = [&](int site, const Vector& place) -> Vector {
            const Matrix4d& rate = bodies->rates[k][body_of_site[site]];
            return rate.topLeftCorner<3, 3>().cast<T>() * place +
                   rate.topRightCorner<3, 1>().cast<T>();
          };
          arms[k] -=
              way.dot(velocity(i, here) - velocity(i - 1, before)) / segment;
        }
      }
      before = here;
    }
    residuals[0] = length - T(posture->length);
    for (size_t k = 0; k < num_arms; ++k) {
      residuals[k + 1] = arms[k] - T(posture->arms[static_cast<int>(k)]);
    }
    return true;
  }
};

// Keeps sites near where the line is.
struct PlaceMisfit {
  Eigen::VectorXd start;

  template <typename T>
  bool operator()(T const* const* places, T* residuals) const {
    constexpr double kFar = 30;  // mm, that counts as an error of 1 mm
    for (Eigen::Index i = 0; i < start.size(); ++i) {
      residuals[i] = (places[0][i] - T(start[i])) / T(kFar);
    }
    return true;
  }
};

// Returns the site for a place of the line, the one with a number of `count`
// that are evenly spread: on the body against which it moves least.
Site StartOf(const std::vector<int>& bodies,
             const std::vector<SitePosture>& postures,
             const std::vector<MovingBodies>& moving,
             int number,
             int count) {
  std::vector<Vector3d> places;
  for (const SitePosture& posture : postures) {
    places.push_back(Resampled(posture.line, count).row(number).transpose());
  }
  Site best;
  double least = kInfinity;
  for (const int body : bodies) {
    Vector3d sum = Vector3d::Zero();
    double squares = 0;
    for (size_t i = 0; i < postures.size(); ++i) {
      const Vector3d place =
          (RigidInverse(moving[i].frames[body]) * places[i].homogeneous())
              .head<3>();
      sum += place;
      squares += place.squaredNorm();
    }
    const auto total = static_cast<double>(postures.size());
    const double variance = squares - sum.squaredNorm() / total;
    if (!(variance < least)) continue;
    least = variance;
    best = {body, sum / total};
  }
  return best;
}

std::unique_ptr<ceres::DynamicCostFunction> WithSizes(
    std::unique_ptr<ceres::DynamicCostFunction> cost,
    int parameters,
    int residuals) {
  cost->AddParameterBlock(parameters);
  cost->SetNumResiduals(residuals);
  return cost;
}

double MedianOf(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void SetErrors(const std::vector<SitePosture>& postures,
               const std::vector<MovingBodies>& moving,
               SitePath* path) {
  std::vector<int> bodies;
  Eigen::VectorXd places(3 * static_cast<Eigen::Index>(path->sites.size()));
  for (const Site& site : path->sites) {
    places.segment<3>(3 * static_cast<Eigen::Index>(bodies.size())) =
        site.place;
    bodies.push_back(site.body);
  }
  const double* const parameters = places.data();
  std::vector<double> arms;
  for (size_t i = 0; i < postures.size(); ++i) {
    std::vector<double> residuals(moving[i].rates.size() + 1);
    PathMisfit{&moving[i], &postures[i], bodies}(&parameters, residuals.data());
    const double length = std::abs(residuals[0]);
    path->length_mean += length / static_cast<double>(postures.size());
    path->length_largest = std::max(path->length_largest, length);
    for (size_t k = 1; k < residuals.size(); ++k) {
      arms.push_back(std::abs(residuals[k]));
      path->arm_largest = std::max(path->arm_largest, arms.back());
    }
  }
  path->arm_median = MedianOf(std::move(arms));
}

// The bodies of so many sites, from origin to insertion, of which one is to be
// chosen: those against which the line moves least, and of a path between two
// bodies each place at which it may go over from one to the other.
std::vector<std::vector<Site>> StartsWith(
    int count,
    const std::vector<int>& bodies,
    const std::vector<SitePosture>& postures,
    const std::vector<MovingBodies>& moving) {
  const auto start_on = [&](const std::vector<int>& some, int i) {
    return StartOf(some, postures, moving, i, count);
  };
  std::vector<std::vector<Site>> starts(1);
  for (int i = 0; i < count; ++i) starts[0].push_back(start_on(bodies, i));
  if (bodies.size() != 2) return starts;
  for (int first = 0; first < 2; ++first) {
    for (int change = 1; change < count; ++change) {
      std::vector<Site>& start = starts.emplace_back();
      for (int i = 0; i < count; ++i) {
        start.push_back(start_on({bodies[i < change ? first : 1 - first]}, i));
      }
    }
  }
  return starts;
}

// Fits a path whose sites start there.
SitePath FitFrom(const std::vector<Site>& start,
                 const std::vector<SitePosture>& postures,
                 const std::vector<MovingBodies>& moving) {
  const auto count = static_cast<int>(start.size());
  SitePath path;
  std::vector<int> body_of_site;
  Eigen::VectorXd places(3 * count);
  for (int i = 0; i < count; ++i) {
    places.segment<3>(3 * i) = start[i].place;
    body_of_site.push_back(start[i].body);
  }
  constexpr int kStride = 4;
  ceres::Problem problem;
  for (size_t i = 0; i < postures.size(); ++i) {
    auto cost = std::make_unique<
        ceres::DynamicAutoDiffCostFunction<PathMisfit, kStride>>(
        new PathMisfit{&moving[i], &postures[i], body_of_site});
    problem.AddResidualBlock(
        WithSizes(std::move(cost),
                  3 * count,
                  1 + static_cast<int>(moving[i].rates.size()))
            .release(),
        nullptr,
        places.data());
  }
  auto near = std::make_unique<
      ceres::DynamicAutoDiffCostFunction<PlaceMisfit, kStride>>(
      new PlaceMisfit{places});
  problem.AddResidualBlock(
      WithSizes(std::move(near), 3 * count, 3 * count).release(),
      nullptr,
      places.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = 100;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  for (int i = 0; i < count; ++i) {
    path.sites.push_back({body_of_site[i], places.segment<3>(3 * i)});
  }
  SetErrors(postures, moving, &path);
  return path;
}

}  // namespace

SitePath FitSites(const Model& model,
                  const std::vector<int>& bodies,
                  const std::vector<int>& coordinates,
                  const std::vector<SitePosture>& postures) {
  CHECK(!bodies.empty() && !postures.empty());
  std::vector<MovingBodies> moving;
  for (const SitePosture& posture : postures) {
    moving.push_back(BodiesAt(model, coordinates, posture.values));
  }
  constexpr int kCounts[] = {3, 4, 5, 6, 8};
  SitePath best;
  double least = kInfinity;
  for (const int count : kCounts) {
    for (const auto& start : StartsWith(count, bodies, postures, moving)) {
      const SitePath path = FitFrom(start, postures, moving);
      if (!(path.arm_median < least)) continue;
      least = path.arm_median;
      best = path;
      if (least <= kGoodArm) return best;
    }
  }
  return best;
}

}  // namespace musclewarp
