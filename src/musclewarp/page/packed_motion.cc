// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/packed_motion.h"

#include <glog/logging.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace musclewarp {
namespace {

// Rows are poses, columns coordinates.
using Rows =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Weights, which are at most 1, are multiples of this.
constexpr double kWeightStep = 1e-7;

// Bytes that a correction takes, about: how far it is from the one before, and
// its size.
constexpr double kBytesOfCorrection = 3;

// More modes do not pay once so many have not.
constexpr int kPatience = 4;

// A shape that all poses have in some measure.
struct Mode {
  Eigen::VectorXi shape;    // by coordinate, in steps
  Eigen::VectorXi weights;  // by pose, in kWeightStep
};

Eigen::RowVectorXd FlatOf(const Points& points) {
  return Eigen::Map<const Eigen::RowVectorXd>(points.data(), points.size());
}

Eigen::VectorXi Rounded(const Eigen::VectorXd& values, double step) {
  return (values / step).array().round().cast<int>();
}

// Bytes of a number as PackedNumbers writes it.
int BytesOf(int number) {
  int bytes = 1;
  for (long rest = std::labs(number) >> 6; rest > 0; rest >>= 7) ++bytes;
  return bytes;
}

double BytesOf(const Eigen::VectorXi& numbers) {
  double bytes = 0;
  for (const int number : numbers) bytes += BytesOf(number);
  return bytes;
}

void Subtract(const Mode& mode, double step, Rows* rows) {
  const Eigen::VectorXd weights = kWeightStep * mode.weights.cast<double>();
  *rows -= weights * (step * mode.shape.cast<double>()).transpose();
}

// Returns the modes that pay, and takes what they explain from `rows`.
std::vector<Mode> TakeModes(double tolerance, Rows* rows) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      *rows * rows->transpose());
  const Rows all = *rows;
  const auto cost_of_corrections = [&](const Rows& rest) {
    return kBytesOfCorrection *
           static_cast<double>((rest.array().abs() > tolerance).count());
  };
  Rows rest = all;
  std::vector<Mode> modes;
  double cost_of_modes = 0;
  double best = cost_of_corrections(rest);
  std::size_t best_count = 0;
  for (Eigen::Index i = 0; i < all.rows(); ++i) {
    if (best == 0 || modes.size() > best_count + kPatience) break;
    const Eigen::VectorXd weights =
        solver.eigenvectors().col(all.rows() - 1 - i);
    const double largest = weights.cwiseAbs().maxCoeff();
    Mode mode;
    mode.weights = Rounded(weights / largest, kWeightStep);
    mode.shape = Rounded(largest * (all.transpose() * weights), tolerance);
    Subtract(mode, tolerance, &rest);
    cost_of_modes += BytesOf(mode.shape);
    modes.push_back(std::move(mode));
    const double cost = cost_of_modes + cost_of_corrections(rest);
    if (cost >= best) continue;
    best = cost;
    best_count = modes.size();
    *rows = rest;
  }
  modes.resize(best_count);
  return modes;
}

std::vector<int> NumbersOf(const Eigen::VectorXi& values) {
  return {values.data(), values.data() + values.size()};
}

// What is added to coordinates that modes do not bring near enough.
struct Corrections {
  double step = 0;  // mm
  // How far a coordinate is from the one corrected before it in its pose (from
  // the first one), and by how many steps it is corrected.
  std::vector<int> pairs;
  std::vector<int> by_pose;  // the number of pairs
  double max_error = 0;      // of a coordinate afterwards, mm
};

Corrections CorrectionsOf(const Rows& rows, double tolerance) {
  Corrections result;
  // Rounded to twice the tolerance, each is within it.
  result.step = 2 * tolerance;
  for (Eigen::Index pose = 0; pose < rows.rows(); ++pose) {
    int count = 0;
    Eigen::Index last = 0;
    for (Eigen::Index i = 0; i < rows.cols(); ++i) {
      double error = rows(pose, i);
      if (std::abs(error) > tolerance) {
        const int steps = static_cast<int>(std::round(error / result.step));
        result.pairs.push_back(static_cast<int>(i - last));
        result.pairs.push_back(steps);
        error -= result.step * steps;
        last = i;
        ++count;
      }
      result.max_error = std::max(result.max_error, std::abs(error));
    }
    result.by_pose.push_back(count);
  }
  return result;
}

}  // namespace

PackedMotion PackMotion(const std::vector<const Points*>& poses,
                        double tolerance,
                        PackedNumbers* packed) {
  CHECK(!poses.empty());
  CHECK_GT(tolerance, 0);
  const Eigen::Index size = poses[0]->size();
  std::vector<int> first;
  AppendRounded(*poses[0], tolerance, &first);
  const Eigen::RowVectorXd start =
      tolerance *
      Eigen::Map<const Eigen::RowVectorXi>(first.data(), size).cast<double>();
  PackedMotion motion;
  if (size > 0) {
    motion.max_error = (FlatOf(*poses[0]) - start).cwiseAbs().maxCoeff();
  }
  Rows rows(poses.size() - 1, size);
  for (std::size_t pose = 1; pose < poses.size(); ++pose) {
    CHECK_EQ(poses[pose]->size(), size);
    rows.row(pose - 1) = FlatOf(*poses[pose]) - start;
  }
  std::vector<int> shapes, weights;
  int count = 0;
  if (rows.size() > 0) {
    for (const Mode& mode : TakeModes(tolerance, &rows)) {
      const std::vector<int> shape = NumbersOf(mode.shape);
      shapes.insert(shapes.end(), shape.begin(), shape.end());
      const std::vector<int> of_poses = NumbersOf(mode.weights);
      weights.insert(weights.end(), of_poses.begin(), of_poses.end());
      ++count;
    }
  }
  const Corrections corrections = CorrectionsOf(rows, tolerance);
  motion.max_error = std::max(motion.max_error, corrections.max_error);
  motion.json = {{"coordinates", size},
                 {"step_mm", tolerance},
                 {"weight_step", kWeightStep},
                 {"correction_step_mm", corrections.step},
                 {"first", packed->Add(first, 3)},
                 {"modes", count},
                 {"shapes", packed->Add(shapes, 3)},
                 {"weights", packed->Add(weights, 1)},
                 {"corrections",
                  packed->Add(corrections.pairs,
                              static_cast<int>(corrections.pairs.size()) + 1)},
                 {"corrections_by_pose", packed->Add(corrections.by_pose, 1)}};
  return motion;
}

}  // namespace musclewarp
