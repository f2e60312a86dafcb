// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace musclewarp {

// A scalar function of coordinates. OpenSim models describe by such functions
// how joints move with their coordinates, where moving path points are, and how
// coupled coordinates follow others. Functions are immutable and have the units
// of the place where they are used.
class Function {
 public:
  virtual ~Function() = default;

  // Returns the value of the function. There must be at least Arity()
  // arguments; further ones are ignored.
  virtual double Value(const std::vector<double>& arguments) const = 0;

  // Returns the number of arguments on which the function depends.
  virtual size_t Arity() const { return 1; }
};

using FunctionPtr = std::shared_ptr<const Function>;

// Returns a function without arguments.
FunctionPtr MakeConstant(double value);

// Returns the function c_0 q_0 + c_1 q_1 + ... + c_n of n arguments; the last
// coefficient is the constant. Precondition (CHECKed): there is a coefficient.
FunctionPtr MakeLinear(std::vector<double> coefficients);

// Returns a polynomial in one argument, whose coefficients begin with that of
// the highest power. Precondition (CHECKed): there is a coefficient.
FunctionPtr MakePolynomial(std::vector<double> coefficients);

// Returns the cubic spline of SIMM and OpenSim through the points (x, y), of
// one argument. Files call it "SimmSpline" and also "NaturalCubicSpline" or
// "natCubicSpline", although it is not a natural spline: the third derivative
// at each end is that of the cubic through the four nearest points (Forsythe,
// Malcolm and Moler, "Computer Methods for Mathematical Computations", 1977,
// section 4.4). Three points give the parabola through them, two the line.
// Beyond its ends the spline is continued by its tangents. Preconditions
// (CHECKed): there are as many x as y, at least two, and x ascends strictly.
FunctionPtr MakeSimmSpline(std::vector<double> x, std::vector<double> y);

// Returns the function that is linear between the points (x, y), of one
// argument. Beyond its ends the first and the last segment are continued.
// Preconditions are those of MakeSimmSpline.
FunctionPtr MakePiecewiseLinear(std::vector<double> x, std::vector<double> y);

// Returns the function scale * function.
FunctionPtr MakeMultiplier(double scale, FunctionPtr function);

}  // namespace musclewarp
