// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/function_reader.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "opensim/read_models.h"

namespace musclewarp {
namespace {

FunctionPtr FunctionIn(const std::string& element) {
  const OsimXml xml = Xml(element);
  std::string unsupported;
  const FunctionPtr function = ReadFunction(xml, xml.root(), &unsupported);
  EXPECT_EQ(unsupported, "");
  return function;
}

void ExpectFunctionRefused(const std::string& element,
                           const std::vector<std::string>& words) {
  ExpectInputError([&] { FunctionIn(element); }, words);
}

TEST(FunctionReader, ReadsEveryKind) {
  EXPECT_EQ(FunctionIn("<Constant><value>7</value></Constant>")->Value({}), 7);
  EXPECT_EQ(FunctionIn("<Constant/>")->Value({}), 0);
  EXPECT_EQ(FunctionIn("<LinearFunction><coefficients>2 3 4</coefficients>"
                       "</LinearFunction>")
                ->Value({10, 100}),
            324);
  EXPECT_EQ(FunctionIn("<PolynomialFunction><coefficients>2 3 4</coefficients>"
                       "</PolynomialFunction>")
                ->Value({10}),
            234);
  EXPECT_EQ(FunctionIn("<PiecewiseLinearFunction><x>0 1 2</x><y>0 5 0</y>"
                       "</PiecewiseLinearFunction>")
                ->Value({0.5}),
            2.5);
  EXPECT_EQ(
      FunctionIn("<MultiplierFunction><function><Constant><value>3</value>"
                 "</Constant></function><scale>-2</scale>"
                 "</MultiplierFunction>")
          ->Value({}),
      -6);
}

TEST(FunctionReader, AllNamesOfTheSplineMeanTheSame) {
  const std::string points = "<x>0 1 2 4</x><y>1 0 3 2</y>";
  const auto expected = MakeSimmSpline({0, 1, 2, 4}, {1, 0, 3, 2});
  for (const std::string name :
       {"SimmSpline", "NaturalCubicSpline", "natCubicSpline"}) {
    const auto spline =
        FunctionIn("<" + name + ">" + points + "</" + name + ">");
    for (double x = -1; x < 6; x += 0.3) {
      EXPECT_EQ(spline->Value({x}), expected->Value({x})) << name << " " << x;
    }
  }
}

TEST(FunctionReader, PropertiesAreWrappedOrNamed) {
  const OsimXml three = Xml("<a><f><Constant/></f><g/></a>");
  EXPECT_STREQ(FunctionElement(three.root(), "f").name(), "Constant");
  EXPECT_FALSE(FunctionElement(three.root(), "g"));
  const OsimXml four = Xml("<a><SimmSpline name=\"f\"/></a>");
  EXPECT_STREQ(FunctionElement(four.root(), "f").name(), "SimmSpline");
  EXPECT_FALSE(FunctionElement(four.root(), "g"));
}

TEST(FunctionReader, KindsThatAreNotKnownAreNamed) {
  for (const std::string element :
       {"<GCVSpline/>",
        "<MultiplierFunction><function><GCVSpline/></function>"
        "</MultiplierFunction>"}) {
    const OsimXml xml = Xml("\n" + element);
    std::string unsupported;
    EXPECT_EQ(ReadFunction(xml, xml.root(), &unsupported), nullptr);
    EXPECT_EQ(unsupported, "<GCVSpline> in line 2");
  }
}

TEST(FunctionReader, RefusesFunctionsThatAreNotSound) {
  ExpectFunctionRefused("<SimmSpline><x>0 1 1</x><y>0 1 2</y></SimmSpline>",
                        {"part.osim", "line 1", "SimmSpline", "after point 2"});
  ExpectFunctionRefused("<SimmSpline><x>0 1</x><y>0 1 2</y></SimmSpline>",
                        {"2 values of x and 3 of y"});
  ExpectFunctionRefused(
      "<PiecewiseLinearFunction><x>0</x><y>0</y></PiecewiseLinearFunction>",
      {"1 points", "at least 2"});
  ExpectFunctionRefused("<LinearFunction/>", {"no <coefficients>"});
  ExpectFunctionRefused("<LinearFunction><coefficients/></LinearFunction>",
                        {"no coefficients"});
  ExpectFunctionRefused("<MultiplierFunction/>", {"no <function>"});
}

}  // namespace
}  // namespace musclewarp
