// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/function_reader.h"

#include <utility>

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
