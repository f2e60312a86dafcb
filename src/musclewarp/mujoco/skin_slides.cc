// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mujoco/skin_slides.h"

#include <glog/logging.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

namespace musclewarp {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kHighestDegree = 4;    // of an equality of MuJoCo
constexpr int kFramesPerDegree = 5;  // with fewer, curves swing between them
constexpr int kRounds = 2;           // of improving all slides by turns

// Polynomials of one coordinate over the frames.
struct Polynomials {
  double middle = 0, half = 0;  // of the values
  MatrixXd powers;              // #frames x (degree + 1), of the scaled values
  MatrixXd basis;               // the same span, orthonormal columns
};

Polynomials PolynomialsOf(const VectorXd& values) {
  Polynomials made;
  made.middle = (values.maxCoeff() + values.minCoeff()) / 2;
  made.half = (values.maxCoeff() - values.minCoeff()) / 2;
  const int degree = std::min(
      kHighestDegree, static_cast<int>(values.size()) / kFramesPerDegree);
  if (!(made.half > 0) || degree < 1) return made;
  const VectorXd scaled = (values.array() - made.middle) / made.half;
  made.powers.resize(values.size(), degree + 1);
  made.powers.col(0).setOnes();
  for (int k = 1; k <= degree; ++k) {
    made.powers.col(k) = made.powers.col(k - 1).cwiseProduct(scaled);
  }
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(made.powers);
  made.basis = MatrixXd(qr.householderQ()).leftCols(qr.rank());
  return made;
}

// Returns the coefficients over the values themselves of a polynomial that has
// `amplitudes` in the frames.
std::array<double, 5> CoefficientsOf(const Polynomials& polynomials,
                                     const VectorXd& amplitudes) {
  const VectorXd scaled =
      polynomials.powers.colPivHouseholderQr().solve(amplitudes);
  std::array<double, 5> all = {0, 0, 0, 0, 0};
  // By Horner: all = all * (q - middle) / half + scaled[k].
  for (Index k = scaled.size(); k-- > 0;) {
    for (size_t i = all.size(); i-- > 0;) {
      const double before = i > 0 ? all[i - 1] : 0;
      all[i] = (before - polynomials.middle * all[i]) / polynomials.half;
    }
    all[0] += scaled[k];
  }
  return all;
}

// The eigenvector of the largest eigenvalue.
template <typename Matrix>
std::pair<double, Eigen::Matrix<double, Matrix::RowsAtCompileTime, 1>> Leading(
    const Matrix& gram) {
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(gram);
  const Index last = gram.rows() - 1;
  return {solver.eigenvalues()[last], solver.eigenvectors().col(last)};
}

// The movement of all vertices along one direction, as one polynomial.
struct Candidate {
  double explained = 0;  // of the sum of squares, mm2
  int coordinate = -1;
  VectorXd amplitudes;  // #frames, of length 1
  Vector3d direction = Vector3d::UnitX();
};

// Fits slides on one bone. Movements are #frames x 3 #V: x, y and z of each
// vertex in turn, in the axes of the bone.
class SlideFitter {
 public:
  SlideFitter(MatrixXd movements, const std::vector<Polynomials>& polynomials)
      : movements_(std::move(movements)),
        left_(movements_),
        polynomials_(polynomials) {}

  double MeanDistance() const {
    double sum = 0;
    for (Index v = 0; v < num_vertices(); ++v) {
      sum += left_.middleCols<3>(3 * v).rowwise().norm().sum();
    }
    return sum / static_cast<double>(num_vertices() * left_.rows());
  }

  double LargestDistance() const {
    double largest = 0;
    for (Index v = 0; v < num_vertices(); ++v) {
      largest = std::max(
          largest, left_.middleCols<3>(3 * v).rowwise().norm().maxCoeff());
    }
    return largest;
  }

  // Returns false if no polynomial explains anything.
  bool Add() {
    Candidate best;
    for (size_t c = 0; c < polynomials_.size(); ++c) {
      if (polynomials_[c].basis.cols() == 0) continue;
      Candidate candidate = BestOf(static_cast<int>(c), left_);
      if (candidate.explained > best.explained) best = std::move(candidate);
    }
    constexpr double kLeast = 1e-9;  // of the sum of squares: roundings
    if (!(best.explained > kLeast * movements_.squaredNorm())) return false;
    chosen_.push_back(std::move(best));
    FitWeights();
    for (int round = 0; chosen_.size() > 1 && round < kRounds; ++round) {
      Improve();
    }
    return true;
  }

  std::vector<SkinSlide> Slides() const {
    std::vector<SkinSlide> slides;
    for (size_t k = 0; k < chosen_.size(); ++k) {
      SkinSlide slide;
      slide.coordinate = chosen_[k].coordinate;
      slide.direction = chosen_[k].direction;
      slide.weights = weights_.row(static_cast<Index>(k)).transpose();
      const double scale = slide.weights.cwiseAbs().maxCoeff();
      slide.weights /= scale;
      slide.coefficients = CoefficientsOf(polynomials_[slide.coordinate],
                                          scale * chosen_[k].amplitudes);
      slides.push_back(std::move(slide));
    }
    return slides;
  }

  size_t num_slides() const { return chosen_.size(); }

 private:
  Index num_vertices() const { return movements_.cols() / 3; }

  // Returns the parts of rows of movements along a direction, #rows x #V.
  MatrixXd Along(const MatrixXd& rows, const Vector3d& direction) const {
    MatrixXd along(rows.rows(), num_vertices());
    for (Index v = 0; v < num_vertices(); ++v) {
      along.col(v) = rows.middleCols<3>(3 * v) * direction;
    }
    return along;
  }

  // The best slide by a coordinate for movements.
  Candidate BestOf(int coordinate, const MatrixXd& movements) const {
    const MatrixXd& basis = polynomials_[coordinate].basis;
    const MatrixXd projected = basis.transpose() * movements;
    const VectorXd mode =
        projected.transpose() *
        Leading<MatrixXd>(projected * projected.transpose()).second;
    const auto by_vertex =
        Eigen::Map<const Eigen::Matrix3Xd>(mode.data(), 3, num_vertices());
    Candidate candidate;
    candidate.coordinate = coordinate;
    candidate.direction =
        Leading<Matrix3d>(by_vertex * by_vertex.transpose()).second;
    const MatrixXd along = Along(projected, candidate.direction);
    const auto leading = Leading<MatrixXd>(along * along.transpose());
    candidate.explained = leading.first;
    candidate.amplitudes = basis * leading.second;
    return candidate;
  }

  // Takes each slide anew, for what the others leave.
  void Improve() {
    for (size_t k = 0; k < chosen_.size(); ++k) {
      chosen_[k] = BestOf(chosen_[k].coordinate, left_ + MovedBy(k));
      FitWeights();
    }
  }

  // How a slide moves the vertices.
  MatrixXd MovedBy(size_t k) const {
    const Eigen::Matrix3Xd moved =
        chosen_[k].direction * weights_.row(static_cast<Index>(k));
    return chosen_[k].amplitudes *
           Eigen::Map<const Eigen::RowVectorXd>(moved.data(), moved.size());
  }

  // The best weights of all slides, by least squares, and what they leave.
  void FitWeights() {
    const auto count = static_cast<Index>(chosen_.size());
    MatrixXd gram(count, count), right(count, num_vertices());
    for (Index k = 0; k < count; ++k) {
      const Candidate& one = chosen_[k];
      for (Index l = 0; l < count; ++l) {
        gram(k, l) = one.amplitudes.dot(chosen_[l].amplitudes) *
                     one.direction.dot(chosen_[l].direction);
      }
      right.row(k) =
          Along(one.amplitudes.transpose() * movements_, one.direction);
    }
    weights_ = gram.ldlt().solve(right);
    left_ = movements_;
    for (size_t k = 0; k < chosen_.size(); ++k) left_ -= MovedBy(k);
  }

  const MatrixXd movements_;
  MatrixXd left_;
  const std::vector<Polynomials>& polynomials_;
  std::vector<Candidate> chosen_;
  MatrixXd weights_;  // #slides x #V
};

// What a skin misses of the frames, in the axes of a bone: #frames x 3 #V.
MatrixXd MissedBy(const SkinWeights& skin,
                  const std::vector<Points>& frames,
                  const std::vector<std::vector<Eigen::Matrix4d>>& motions,
                  Index bone) {
  const Index count = skin.places.rows();
  MatrixXd missed(static_cast<Index>(frames.size()), 3 * count);
  for (size_t f = 0; f < frames.size(); ++f) {
    CHECK_EQ(frames[f].rows(), count);
    Points carried = Points::Zero(count, 3);
    for (Index b = 0; b < skin.weights.cols(); ++b) {
      const Eigen::Matrix4d& motion = motions[f][b];
      const Points places =
          (skin.places * motion.topLeftCorner<3, 3>().transpose()).rowwise() +
          motion.topRightCorner<3, 1>().transpose();
      carried += skin.weights.col(b).asDiagonal() * places;
    }
    const Matrix3d turn = motions[f][bone].topLeftCorner<3, 3>();
    const Eigen::Matrix3Xd in_bone =
        turn.transpose() * (frames[f] - carried).transpose();
    missed.row(static_cast<Index>(f)) =
        Eigen::Map<const Eigen::RowVectorXd>(in_bone.data(), in_bone.size());
  }
  return missed;
}

}  // namespace

SkinSlides FitSlides(const SkinWeights& skin,
                     const std::vector<Points>& frames,
                     const std::vector<std::vector<Eigen::Matrix4d>>& motions,
                     const Eigen::MatrixXd& values,
                     double max_mean_distance) {
  CHECK(frames.size() == motions.size());
  CHECK_EQ(values.rows(), static_cast<Index>(frames.size()));
  SkinSlides best;
  best.mean_distance = skin.mean_distance;
  best.largest_distance = skin.largest_distance;
  if (best.mean_distance <= max_mean_distance) return best;
  std::vector<Polynomials> polynomials;
  for (const auto& of_coordinate : values.colwise()) {
    polynomials.push_back(PolynomialsOf(of_coordinate));
  }
  for (Index bone = 0; bone < skin.weights.cols(); ++bone) {
    SlideFitter fitter(MissedBy(skin, frames, motions, bone), polynomials);
    while (fitter.MeanDistance() > max_mean_distance &&
           fitter.num_slides() < kMostSkinSlides && fitter.Add()) {
    }
    if (fitter.num_slides() == 0) continue;
    const std::pair found(fitter.num_slides(), fitter.MeanDistance());
    if (best.bone >= 0 &&
        found >= std::pair(best.slides.size(), best.mean_distance)) {
      continue;
    }
    best.bone = static_cast<int>(bone);
    best.slides = fitter.Slides();
    best.mean_distance = found.second;
    best.largest_distance = fitter.LargestDistance();
  }
  return best;
}

}  // namespace musclewarp
