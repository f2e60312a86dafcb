// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mujoco/skin_weights.h"

#include <glog/logging.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "musclewarp/base/infinity.h"
#include "musclewarp/base/parallel_for.h"

namespace musclewarp {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// One vertex: where it is in the frames.
struct Vertex {
  Vector3d place;
  std::vector<Vector3d> targets;
};

// Columns: where each bone carries the vertex in all frames, 3 #frames x
// #bones.
MatrixXd CarriedBy(const Vertex& vertex,
                   const std::vector<std::vector<Eigen::Matrix4d>>& motions) {
  const auto frames = static_cast<Eigen::Index>(motions.size());
  MatrixXd carried(3 * frames, static_cast<Eigen::Index>(motions[0].size()));
  for (Eigen::Index f = 0; f < frames; ++f) {
    for (Eigen::Index b = 0; b < carried.cols(); ++b) {
      carried.block<3, 1>(3 * f, b) =
          (motions[f][b] * vertex.place.homogeneous()).head<3>();
    }
  }
  return carried;
}

// Returns the best weights of some bones, with the sum 1, by least squares;
// `gram` and `right` are of all bones.
VectorXd WeightsOf(const MatrixXd& gram,
                   const VectorXd& right,
                   const std::vector<int>& bones) {
  const auto count = static_cast<Eigen::Index>(bones.size());
  MatrixXd system = MatrixXd::Zero(count + 1, count + 1);
  VectorXd sides(count + 1);
  system.topLeftCorner(count, count) = gram(bones, bones);
  system.row(count).head(count).setOnes();
  system.col(count).head(count).setOnes();
  sides.head(count) = right(bones);
  sides[count] = 1;
  return system.completeOrthogonalDecomposition().solve(sides).head(count);
}

// Returns the weights, none negative, with the least squares of distances.
VectorXd BestWeights(const MatrixXd& carried, const VectorXd& targets) {
  const auto num_bones = static_cast<int>(carried.cols());
  // Seen from the first bone, so that large coordinates do not cancel.
  const MatrixXd seen = carried.colwise() - carried.col(0);
  const VectorXd wanted = targets - carried.col(0);
  const MatrixXd gram = seen.transpose() * seen;
  const VectorXd right = seen.transpose() * wanted;
  VectorXd best = VectorXd::Zero(num_bones);
  double least = kInfinity;
  for (int subset = 1; subset < (1 << num_bones); ++subset) {
    std::vector<int> bones;
    for (int b = 0; b < num_bones; ++b) {
      if ((subset >> b & 1) != 0) bones.push_back(b);
    }
    const VectorXd weights = WeightsOf(gram, right, bones);
    if (weights.minCoeff() < 0) continue;
    const double misfit = weights.dot(gram(bones, bones) * weights) -
                          2 * weights.dot(right(bones));
    if (!(misfit < least)) continue;
    least = misfit;
    best.setZero();
    for (size_t k = 0; k < bones.size(); ++k) {
      best[bones[k]] = weights[static_cast<int>(k)];
    }
  }
  return best / best.sum();
}

// Returns the place of the vertex at rest that its weights carry best.
Vector3d BestPlace(const Vertex& vertex,
                   const std::vector<std::vector<Eigen::Matrix4d>>& motions,
                   const VectorXd& weights) {
  Matrix3d system = Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  for (size_t f = 0; f < motions.size(); ++f) {
    Eigen::Matrix4d motion = Eigen::Matrix4d::Zero();
    for (Eigen::Index b = 0; b < weights.size(); ++b) {
      motion += weights[b] * motions[f][b];
    }
    const Matrix3d turn = motion.topLeftCorner<3, 3>();
    const Vector3d wanted =
        vertex.targets[f] - motion.topRightCorner<3, 1>() - turn * vertex.place;
    system += turn.transpose() * turn;
    right += turn.transpose() * wanted;
  }
  return vertex.place + system.ldlt().solve(right);
}

}  // namespace

SkinWeights FitSkin(const Points& rest,
                    const std::vector<Points>& frames,
                    const std::vector<std::vector<Eigen::Matrix4d>>& motions) {
  CHECK(!frames.empty() && frames.size() == motions.size());
  CHECK(!motions[0].empty() && motions[0].size() <= kMostSkinBones);
  constexpr int kRounds = 4;  // of weights and places by turns
  const Eigen::Index count = rest.rows();
  SkinWeights skin;
  skin.places = rest;
  skin.weights.resize(count, static_cast<Eigen::Index>(motions[0].size()));
  VectorXd sums(count), largest(count);
  ParallelFor(static_cast<size_t>(count), [&](size_t v) {
    const auto row = static_cast<Eigen::Index>(v);
    Vertex vertex;
    vertex.place = rest.row(row).transpose();
    VectorXd targets(3 * static_cast<Eigen::Index>(frames.size()));
    for (size_t f = 0; f < frames.size(); ++f) {
      vertex.targets.push_back(frames[f].row(row).transpose());
      targets.segment<3>(3 * static_cast<Eigen::Index>(f)) =
          vertex.targets.back();
    }
    VectorXd weights = BestWeights(CarriedBy(vertex, motions), targets);
    for (int round = 1; round < kRounds; ++round) {
      vertex.place = BestPlace(vertex, motions, weights);
      weights = BestWeights(CarriedBy(vertex, motions), targets);
    }
    vertex.place = BestPlace(vertex, motions, weights);
    const VectorXd off = CarriedBy(vertex, motions) * weights - targets;
    sums[row] = 0;
    largest[row] = 0;
    for (size_t f = 0; f < frames.size(); ++f) {
      const double distance =
          off.segment<3>(3 * static_cast<Eigen::Index>(f)).norm();
      sums[row] += distance / static_cast<double>(frames.size());
      largest[row] = std::max(largest[row], distance);
    }
    skin.places.row(row) = vertex.place.transpose();
    skin.weights.row(row) = weights.transpose();
  });
  skin.mean_distance = sums.mean();
  skin.largest_distance = largest.maxCoeff();
  return skin;
}

}  // namespace musclewarp
