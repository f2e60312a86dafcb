// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>

namespace musclewarp {

// A sequence of random numbers that is the same on every machine for the same
// seed. The engine std::mt19937 is specified to the bit; the distributions of
// the standard library are not, so this class has its own.
//
//   RandomDraws draws(7);
//   const double length_mm = draws.Uniform(80, 400);
//   const bool is_flat = draws.Chance(0.3);
//
// The order of the calls decides on the numbers. Two draws must therefore not
// be arguments of one function call, whose order C++ leaves open.
class RandomDraws {
 public:
  explicit RandomDraws(uint32_t seed) : engine_(seed) {}

  // Returns a number in [low, high), one of 2^32 values at equal distances.
  double Uniform(double low, double high);

  // Returns an integer from `low` to `high`, both included. Precondition
  // (CHECKed): low <= high.
  int Integer(int low, int high);

  // Returns true with this probability.
  bool Chance(double probability) { return Uniform(0, 1) < probability; }

  // Returns a vector of unit length, uniformly distributed on the sphere.
  Eigen::Vector3d Direction();

  // Returns a unit vector orthogonal to `direction`, uniformly distributed on
  // the circle. Precondition: `direction` has unit length.
  Eigen::Vector3d DirectionAcross(const Eigen::Vector3d& direction);

 private:
  std::mt19937 engine_;
};

}  // namespace musclewarp
