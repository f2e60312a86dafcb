// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/osim_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <pugixml.hpp>

#include "musclewarp/base/output_file.h"
#include "musclewarp/opensim/kinematics.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

// Between them is the path of the first muscle.
const char kBefore[] =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\r\n"
    "<OpenSimDocument Version=\"30000\"><Model name=\"caf\xc3\xa9\">\r\n"
    "<BodySet><objects><Body name=\"ground\"/><Body name=\"femur\"><Joint>"
    "<PinJoint name=\"hip\"><parent_body>ground</parent_body>"
    "<CoordinateSet><objects><Coordinate name=\"flexion\"/></objects>"
    "</CoordinateSet></PinJoint></Joint></Body></objects></BodySet>\r\n"
    "<ForceSet><objects><Thelen2003Muscle name=\"psoas\">\r\n\t";
const char kPath[] =
    "<GeometryPath><!-- not the end: </GeometryPath> --><PathPointSet><objects>"
    "<PathPoint name=\"a\"><location>0 0 0</location><body>ground</body>"
    "</PathPoint><PathPoint name=\"b\"><location>0 1 0</location>"
    "<body>femur</body></PathPoint></objects></PathPointSet></GeometryPath>";
const char kAfter[] =
    "\r\n\t<max>1</max> </Thelen2003Muscle></objects></ForceSet>\r\n"
    "</Model></OpenSimDocument>\r\n";

std::map<std::string, PathFunction> Fits(const std::string& muscle) {
  PathFunction path;
  path.coordinates = {0};
  path.exponents.resize(3, 1);
  path.exponents << 0, 1, 2;
  path.coefficients = Eigen::Vector3d(100.1, 1 / 3., -7e-5);
  return {{muscle, path}};
}

std::string Edited(const std::string& path = kPath) {
  return WithFunctionPaths(
      kBefore + path + kAfter, "leg.osim", {"flexion"}, Fits("psoas"));
}

TEST(OsimFile, KeepsAllOtherBytes) {
  const std::string edited = Edited();
  EXPECT_THAT(edited, ::testing::StartsWith(kBefore));
  EXPECT_THAT(edited, ::testing::EndsWith(kAfter));
  EXPECT_THAT(edited,
              ::testing::HasSubstr("\r\n\t\t\t<coordinate_paths>/jointset/hip/"
                                   "flexion</coordinate_paths>\r\n"));
}

TEST(OsimFile, KeepsThePropertyOfOpenSim45) {
  const std::string open = "<path>", close = "</path>";
  const std::string edited = Edited(open + kPath + close);
  EXPECT_THAT(edited, ::testing::StartsWith(kBefore + open + "<FunctionBased"));
  EXPECT_THAT(edited, ::testing::EndsWith("BasedPath>" + close + kAfter));
}

// The whole model with another encoding, or none, in its declaration.
std::string Declared(const std::string& encoding) {
  const std::string utf8 = " encoding=\"UTF-8\"";
  std::string text = std::string(kBefore) + kPath + kAfter;
  return text.replace(text.find(utf8),
                      utf8.size(),
                      encoding.empty() ? "" : " encoding='" + encoding + "'");
}

// Its one character that is not ASCII as a byte of Latin-1.
std::string InLatin1(std::string text) {
  return text.replace(text.find("\xc3\xa9"), 2, "\xe9");
}

// The name that readers find which take the file at its word.
std::string NameIn(const std::string& bytes) {
  const std::string edited =
      WithFunctionPaths(bytes, "leg.osim", {"flexion"}, Fits("psoas"));
  pugi::xml_document document;
  EXPECT_TRUE(document.load_buffer(edited.data(), edited.size()));
  EXPECT_TRUE(document.find_node([](pugi::xml_node node) {
    return std::string(node.name()) == "FunctionBasedPath";
  }));
  const std::string encoding = document.document_element()
                                   .previous_sibling()
                                   .attribute("encoding")
                                   .value();
  EXPECT_TRUE(encoding.empty() || encoding == "UTF-8") << encoding;
  return document.document_element().child("Model").attribute("name").value();
}

TEST(OsimFile, IsInTheEncodingThatItNames) {
  const std::string mark = "\xef\xbb\xbf";
  for (const char* encoding : {"ISO-8859-1", "windows-1252", "UTF-8", ""}) {
    const std::string text = Declared(encoding);
    EXPECT_EQ(NameIn(text), "caf\xc3\xa9") << encoding;
    EXPECT_EQ(NameIn(mark + text), "caf\xc3\xa9") << encoding;
    EXPECT_EQ(NameIn(InLatin1(text)), "caf\xc3\xa9") << encoding;
  }
  std::string utf16 = "\xff\xfe";
  for (const char c : InLatin1(Declared("UTF-16"))) utf16 += {c, '\0'};
  EXPECT_EQ(NameIn(utf16), "caf\xc3\xa9");
}

TEST(OsimFile, KeepsTheMarkOfUtf8) {
  const std::string mark = "\xef\xbb\xbf";
  EXPECT_EQ(WithFunctionPaths(mark + kBefore + kPath + kAfter,
                              "leg.osim",
                              {"flexion"},
                              Fits("psoas")),
            mark + Edited());
}

TEST(OsimFile, FindsNamesThatAreNotAscii) {
  const auto renamed = [](std::string text) {
    text.replace(text.find("\"hip\""),
                 5,
                 "\"H\xfc"
                 "fte &amp; Co\"");
    return text.replace(text.find("\"psoas\""),
                        7,
                        "\"L\xfc"
                        "ck\"");
  };
  const std::string edited =
      WithFunctionPaths(renamed(InLatin1(Declared("ISO-8859-1"))),
                        "leg.osim",
                        {"flexion"},
                        Fits("L\xc3\xbc"
                             "ck"));
  EXPECT_THAT(edited,
              ::testing::HasSubstr("<coordinate_paths>/jointset/H\xc3\xbc"
                                   "fte &amp; Co/flexion<"));
}

TEST(OsimFile, ReaderGivesTheFitBack) {
  const std::string file = TestTempDir() + "/leg.osim";
  WriteTextAtomically(file, Edited());
  const Model model = ReadModel(file);
  ASSERT_EQ(model.muscles.size(), 1u);
  EXPECT_THAT(model.muscles[0].unsupported,
              ::testing::HasSubstr("FunctionBasedPath"));
  PathFunction path = Fits("psoas")["psoas"];
  path.low = Eigen::VectorXd::Constant(1, -2);
  path.high = Eigen::VectorXd::Constant(1, 2);
  for (const double q : {-0.3, 0., 1.2}) {
    const double length =
        Evaluate(path, Eigen::VectorXd::Constant(1, q)).length;
    const double read =
        PathLength(model.muscles[0], BodyFrames(model, {q}), {q});
    EXPECT_NEAR(read, length, 1e-9);
  }
}

TEST(OsimFile, RefusesAModelWithoutTheMuscle) {
  ExpectInputError(
      [] {
        WithFunctionPaths(std::string(kBefore) + kPath + kAfter,
                          "leg.osim",
                          {"flexion"},
                          Fits("soleus"));
      },
      {"leg.osim", "soleus"});
  ExpectInputError(
      [] { WithFunctionPaths("<a", "leg.osim", {"flexion"}, Fits("psoas")); },
      {"leg.osim", "not XML"});
}

}  // namespace
}  // namespace musclewarp
