// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/rotation_field.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <cmath>

#include "musclewarp/skeleton/sampling.h"
#include "musclewarp/skeleton/segment_rotation.h"

namespace musclewarp {
namespace {

// A short piece of a line, in one of its segments.
struct LinePiece {
  SegmentPoint middle;
  double length;  // mm
};

std::vector<LinePiece> PiecesOf(const std::vector<ActionLine>& lines,
                                double longest) {
  std::vector<LinePiece> pieces;
  for (size_t line = 0; line < lines.size(); ++line) {
    const Points& rest = lines[line].rest;
    for (Eigen::Index s = 0; s + 1 < rest.rows(); ++s) {
      const double length = (rest.row(s + 1) - rest.row(s)).norm();
      const int count = NumPieces(length, longest);
      for (int i = 0; i < count; ++i) {
        pieces.push_back(
            {{static_cast<int>(line), static_cast<int>(s), (i + 0.5) / count},
             length / count});
      }
    }
  }
  return pieces;
}

// Returns the mean of rotations. `weights` has one for each of them.
Eigen::Matrix3d MeanOf(const std::vector<Eigen::Quaterniond>& rotations,
                       const Eigen::RowVectorXd& weights) {
  Eigen::Index largest;
  weights.maxCoeff(&largest);
  const Eigen::Vector4d nearest = rotations[largest].coeffs();
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (size_t p = 0; p < rotations.size(); ++p) {
    const Eigen::Vector4d& q = rotations[p].coeffs();
    sum += (q.dot(nearest) < 0 ? -weights[p] : weights[p]) * q;
  }
  return Eigen::Quaterniond(sum).normalized().toRotationMatrix();
}

// Finds the means of rotations for each row of weights (#V x #P) if all of them
// are within a cone. They have the same signs then, whatever they are aligned
// to, so that all sums run side by side. Returns false otherwise.
bool MeansInCone(const std::vector<Eigen::Quaterniond>& rotations,
                 const Eigen::MatrixXd& weights,
                 std::vector<Eigen::Matrix3d>* means) {
  // Twice the angle between two quaternions below it is a right one.
  constexpr double kCosine = 0.7072;
  for (const Eigen::Quaterniond& rotation : rotations) {
    if (std::abs(rotation.dot(rotations[0])) < kCosine) return false;
  }
  // Place by place, in the order of MeanOf(), and so with the same rounding.
  Eigen::MatrixX4d sums = Eigen::MatrixX4d::Zero(weights.rows(), 4);
  for (size_t p = 0; p < rotations.size(); ++p) {
    const double sign = rotations[p].dot(rotations[0]) < 0 ? -1 : 1;
    for (int k = 0; k < 4; ++k) {
      sums.col(k) += sign * rotations[p].coeffs()[k] * weights.col(p);
    }
  }
  means->reserve(sums.rows());
  for (Eigen::Index i = 0; i < sums.rows(); ++i) {
    const Eigen::Vector4d sum = sums.row(i).transpose();
    means->push_back(Eigen::Quaterniond(sum).normalized().toRotationMatrix());
  }
  return true;
}

}  // namespace

RotationField NearestRotations(const Points& points,
                               const std::vector<ActionLine>& lines) {
  RotationField field;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    field.places.push_back(NearestSegment(points.row(i), lines));
  }
  return field;
}

RotationField SmoothRotations(const Points& points,
                              const std::vector<ActionLine>& lines,
                              double radius) {
  CHECK(!lines.empty());
  CHECK_GT(radius, 0);
  const std::vector<LinePiece> pieces = PiecesOf(lines, radius / 2);
  RotationField field;
  field.weights.resize(points.rows(), pieces.size());
  for (size_t p = 0; p < pieces.size(); ++p) {
    const SegmentPoint& place = pieces[p].middle;
    field.places.push_back(place);
    const Eigen::RowVector3d middle =
        PointOnSegment(lines[place.line].rest, place);
    const Eigen::ArrayXd squared =
        (points.rowwise() - middle).rowwise().squaredNorm().array() +
        radius * radius;
    field.weights.col(p) = pieces[p].length * squared.square().inverse();
  }
  field.weights.array().colwise() /= field.weights.rowwise().sum().array();
  return field;
}

Eigen::VectorXd StretchesOf(const RotationField& field,
                            const std::vector<ActionLine>& lines,
                            const std::vector<LineTarget>& targets) {
  const auto length = [](const Points& points, int segment) {
    return (points.row(segment + 1) - points.row(segment)).norm();
  };
  Eigen::VectorXd stretches(field.places.size());
  for (size_t p = 0; p < field.places.size(); ++p) {
    const SegmentPoint& place = field.places[p];
    const double at_rest = length(lines[place.line].rest, place.segment);
    const double here = length(targets[place.line].points, place.segment);
    stretches[p] = at_rest > 0 ? here / at_rest : 1;
  }
  if (field.weights.size() == 0) return stretches;
  return field.weights * stretches;
}

std::vector<Eigen::Matrix3d> RotationsOf(const RotationField& field,
                                         const std::vector<ActionLine>& lines,
                                         const std::vector<LineTarget>& targets,
                                         bool use_body_twist) {
  std::vector<Eigen::Matrix3d> rotations;
  for (const SegmentPoint& place : field.places) {
    rotations.push_back(SegmentRotation(
        lines[place.line], targets[place.line], place, use_body_twist));
  }
  if (field.weights.size() == 0) return rotations;
  std::vector<Eigen::Quaterniond> quaternions(rotations.begin(),
                                              rotations.end());
  rotations.clear();
  if (MeansInCone(quaternions, field.weights, &rotations)) return rotations;
  for (Eigen::Index i = 0; i < field.weights.rows(); ++i) {
    rotations.push_back(MeanOf(quaternions, field.weights.row(i)));
  }
  return rotations;
}

}  // namespace musclewarp
