// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/function_reader.h"

#include <cmath>
#include <utility>

#include "musclewarp/opensim/multivariate_polynomial.h"

namespace musclewarp {
namespace {

std::vector<double> Coefficients(const OsimXml& xml, pugi::xml_node element) {
  auto coefficients = xml.Numbers(xml.Child(element, "coefficients"));
  if (coefficients.empty()) {
    xml.Fail(element, "has no coefficients", "give at least one");
  }
  return coefficients;
}

struct Knots {
  std::vector<double> x, y;
};

Knots ReadKnots(const OsimXml& xml, pugi::xml_node element) {
  Knots knots;
  knots.x = xml.Numbers(xml.Child(element, "x"));
  knots.y = xml.Numbers(xml.Child(element, "y"));
  if (knots.x.size() != knots.y.size()) {
    xml.Fail(element,
             "has " + std::to_string(knots.x.size()) + " values of x and " +
                 std::to_string(knots.y.size()) + " of y",
             "give as many of both");
  }
  if (knots.x.size() < 2) {
    xml.Fail(element,
             "has " + std::to_string(knots.x.size()) + " points",
             "give at least 2");
  }
  for (size_t i = 0; i + 1 < knots.x.size(); ++i) {
    if (knots.x[i] >= knots.x[i + 1]) {
      xml.Fail(element,
               "has values of x that do not ascend after point " +
                   std::to_string(i + 1),
               "sort the points by x and remove repeated ones");
    }
  }
  return knots;
}

// Reads an integer that is in a range.
int Integer(const OsimXml& xml,
            pugi::xml_node element,
            const char* name,
            int smallest,
            int largest) {
  const pugi::xml_node child = xml.Child(element, name);
  const double number = xml.Number(element, name, 0);
  if (number != std::floor(number) || number < smallest || number > largest) {
    xml.Fail(child,
             "is " + xml.Text(child),
             "give an integer from " + std::to_string(smallest) + " to " +
                 std::to_string(largest));
  }
  return static_cast<int>(number);
}

MultivariatePolynomial ReadMultivariate(const OsimXml& xml,
                                        pugi::xml_node element) {
  constexpr int kMaxOrder = 20;  // Monomials grow with its sixth power.
  MultivariatePolynomial polynomial;
  polynomial.dimension =
      Integer(xml, element, "dimension", 1, kMaxPolynomialDimension);
  polynomial.order = Integer(xml, element, "order", 0, kMaxOrder);
  const std::vector<double> coefficients = Coefficients(xml, element);
  const size_t count = Monomials(polynomial.dimension, polynomial.order).rows();
  if (coefficients.size() != count) {
    xml.Fail(element,
             "has " + std::to_string(coefficients.size()) + " coefficients",
             "give " + std::to_string(count) +
                 ", one for each monomial of its dimension and order");
  }
  polynomial.coefficients =
      Eigen::Map<const Eigen::VectorXd>(coefficients.data(), count);
  return polynomial;
}

}  // namespace

pugi::xml_node FunctionElement(pugi::xml_node node, const char* property) {
  if (const auto wrapper = node.child(property)) {
    const auto elements = ElementsOf(wrapper);
    return elements.empty() ? pugi::xml_node() : elements[0];
  }
  return node.find_child_by_attribute("name", property);
}

FunctionPtr ReadFunction(const OsimXml& xml,
                         pugi::xml_node element,
                         std::string* unsupported) {
  const std::string type = element.name();
  if (type == "Constant") {
    return MakeConstant(xml.Number(element, "value", 0));
  }
  if (type == "LinearFunction") {
    return MakeLinear(Coefficients(xml, element));
  }
  if (type == "PolynomialFunction") {
    return MakePolynomial(Coefficients(xml, element));
  }
  if (type == "MultivariatePolynomialFunction") {
    return MakeMultivariatePolynomial(ReadMultivariate(xml, element));
  }
  if (type == "SimmSpline" || type == "NaturalCubicSpline" ||
      type == "natCubicSpline") {
    Knots knots = ReadKnots(xml, element);
    return MakeSimmSpline(std::move(knots.x), std::move(knots.y));
  }
  if (type == "PiecewiseLinearFunction") {
    Knots knots = ReadKnots(xml, element);
    return MakePiecewiseLinear(std::move(knots.x), std::move(knots.y));
  }
  if (type == "MultiplierFunction") {
    const auto inner = FunctionElement(element, "function");
    if (!inner) xml.Fail(element, "has no <function>", "give one");
    FunctionPtr function = ReadFunction(xml, inner, unsupported);
    if (!function) return nullptr;
    return MakeMultiplier(xml.Number(element, "scale", 1), std::move(function));
  }
  *unsupported =
      "<" + type + "> in line " + std::to_string(xml.LineOf(element));
  return nullptr;
}

}  // namespace musclewarp
