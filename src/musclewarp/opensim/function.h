// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace musclewarp {

// A scalar function of coordinates, as the joints and moving path points of an
// OpenSim model use them.
class Function {
 public:
  virtual ~Function() = default;
  // At least Arity() arguments; further ones do not matter.
  virtual double Value(const std::vector<double>& arguments) const = 0;
  virtual size_t Arity() const { return 1; }
};

using FunctionPtr = std::shared_ptr<const Function>;

FunctionPtr MakeConstant(double value);

// c_0 q_0 + c_1 q_1 + ... + c_n, the last coefficient being the constant.
// Precondition (CHECKed): there is one.
FunctionPtr MakeLinear(std::vector<double> coefficients);

// Coefficients from the highest power down. Precondition (CHECKed): there is
// one.
FunctionPtr MakePolynomial(std::vector<double> coefficients);

// The cubic spline of SIMM and OpenSim ("SimmSpline"; files call it
// "NaturalCubicSpline" and "natCubicSpline" too, though it is no natural
// spline): at both ends the third derivative is that of the cubic through the
// four nearest points (Forsythe, Malcolm and Moler, Computer Methods for
// Mathematical Computations, 1977, section 4.4); with three points it is the
// parabola, with two the line. Outside it goes on straight. Preconditions
// (CHECKed): as many x as y, at least two, x rise.
FunctionPtr MakeSimmSpline(std::vector<double> x, std::vector<double> y);

// Straight between the points and beyond them. Preconditions as above.
FunctionPtr MakePiecewiseLinear(std::vector<double> x, std::vector<double> y);

// scale * function.
FunctionPtr MakeMultiplier(double scale, FunctionPtr function);

}  // namespace musclewarp
