// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/json_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;

JsonField Parsed(const std::string& text) {
  const std::string path = TestTempDir() + "/file.json";
  WriteTextAtomically(path, text);
  return JsonField::ParseFile(path);
}

void ExpectNotParsed(const std::string& text,
                     const std::vector<std::string>& words) {
  ExpectInputError([&] { Parsed(text); }, words);
}

TEST(JsonField, RefusesWhatIsNestedTooDeep) {
  const auto nested = [](int depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };
  EXPECT_NO_THROW(Parsed(nested(1000)));
  ExpectNotParsed(nested(1002), {"file.json", "more than 1000 deep"});
  ExpectNotParsed(nested(100000), {"more than 1000 deep"});
  ExpectNotParsed(std::string(100000, '['), {"more than 1000 deep"});
}

TEST(Shortened, EscapesControlCharactersAndCutsLongTexts) {
  EXPECT_EQ(Shortened("a\nb"), R"("a\nb")");
  EXPECT_EQ(Shortened(std::string("a\0b\x7f", 4)), R"("a\u0000b\u007f")");
  EXPECT_EQ(Shortened(std::string(300, 'x')),
            "\"" + std::string(36, 'x') + "...");
  EXPECT_EQ(Shortened(1.5), "1.5");
}

TEST(Shortened, CutsBetweenCharactersOfUtf8) {
  std::string umlauts;
  for (int i = 0; i < 40; ++i) umlauts += "\xc3\xa4";
  // With the quote, 37 bytes hold 18 of two bytes each.
  EXPECT_EQ(Shortened("x" + umlauts), "\"x" + umlauts.substr(0, 34) + "...");
}

TEST(Shortened, SaysOfArraysAndObjectsOnlyWhatTheyAre) {
  EXPECT_EQ(Shortened(Json::array({1, 2, 3})), "an array of 3 elements");
  EXPECT_EQ(Shortened(Json::object({{"a", 1}})), "an object");
}

TEST(JsonField, KnowsThePathToItself) {
  const JsonField root = Parsed(R"({"a": [{"b": 1}, {"b": 2}]})");
  EXPECT_EQ(root.where(), root.file());
  const JsonField field = root.At("a").At(1).At("b");
  EXPECT_EQ(field.where(), root.file() + ": a[1].b");
  EXPECT_EQ(field.AsNumber(), 2);
  ExpectInputError([&] { field.Fail("is odd", "mend it"); },
                   {"file.json: a[1].b: is odd; mend it"});
}

TEST(JsonField, RefusesTextsThatAreNotSoundJson) {
  ExpectNotParsed("{\n\"a\": 1,,\n}", {"file.json: is not JSON", "line 2"});
  ExpectNotParsed(R"({"a": {"b": 1, "b": 2}})", {"\"b\"", "twice"});
  ExpectNotParsed(R"({"a": 1e999})", {"file.json", "too large"});
  ExpectNotParsed("", {"file.json", "empty"});
}

TEST(JsonField, ReadsKeysOfTheSameNameInDifferentObjects) {
  EXPECT_EQ(Parsed(R"({"b": {"b": 1}, "c": {"b": 2}})").At("c").At("b").value(),
            2);
}

TEST(JsonField, RefusesUnknownAndMissingKeys) {
  const JsonField root = Parsed(R"({"a": 1, "b\n": 2})");
  ExpectInputError(
      [&] {
        root.CheckKeys({"a", "c"});
      },
      {R"(unknown key "b\n"; allowed: a, c)"});
  ExpectInputError(
      [] {
        Parsed(R"({"boens": 1})").CheckKeys({"a", "bones"});
      },
      {R"(unknown key "boens"; did you mean bones? allowed: )"});
  EXPECT_TRUE(root.Has("a"));
  EXPECT_FALSE(root.Has("c"));
  ExpectInputError([&] { root.At("c"); }, {"file.json: c: is missing"});
  ExpectInputError([&] { root.At("a").At("b"); }, {"a: is 1", "object"});
}

TEST(JsonField, RefusesValuesOfAnotherType) {
  const JsonField root = Parsed(R"({"text": "x", "empty": "", "number": 1})");
  EXPECT_EQ(root.At("text").AsString(), "x");
  ExpectInputError([&] { root.At("empty").AsString(); }, {"empty", "\"\""});
  ExpectInputError([&] { root.At("number").AsString(); }, {"number: is 1"});
  ExpectInputError([&] { root.At("text").AsNumber(); }, {"text: is \"x\""});
  ExpectInputError([&] { root.At("text").AsBool(); }, {"true or false"});
  ExpectInputError([&] { root.At("text").ArraySize(); }, {"array"});
  EXPECT_THAT(Parsed(R"(["a", "b"])").AsStrings(), ElementsAre("a", "b"));
  ExpectInputError([] { Parsed(R"(["a", 2])").AsStrings(); }, {"[1]: is 2"});
}

TEST(JsonField, ReadsCoordinatesWithinTheLimit) {
  EXPECT_EQ(Parsed("[1e7]").At(0).AsCoordinate(), 1e7);
  EXPECT_EQ(Parsed("[-1e7]").At(0).AsCoordinate(), -1e7);
  for (const char* text : {"[1.1e7]", "[-1e308]", "[100000000]"}) {
    ExpectInputError([&] { Parsed(text).At(0).AsCoordinate(); },
                     {"file.json: [0]", "allowed: -1e7 to 1e7 mm"});
  }
}

TEST(JsonField, ReadsPointsRowByRow) {
  const Points points = Parsed("[[1, 2, 3], [4, 5, 6]]").AsPoints();
  Points expected(2, 3);
  expected << 1, 2, 3, 4, 5, 6;
  EXPECT_EQ(points, expected);
  EXPECT_EQ(Parsed("[]").AsPoints().rows(), 0);
  ExpectInputError([] { Parsed("[[1, 2]]").AsPoints(); },
                   {"[0]: has 2 entries", "[x, y, z]"});
  ExpectInputError([] { Parsed("[[1, 2, 1e308]]").AsPoints(); },
                   {"[0][2]: is 1e+308", "1e7"});
}

TEST(JsonField, ReadsRigidMotionsOnly) {
  const JsonField good = Parsed("[[0,-1,0,5],[1,0,0,6],[0,0,1,7],[0,0,0,1]]");
  const Eigen::Matrix4d transform = good.AsRigidTransform();
  EXPECT_EQ(transform(0, 1), -1);
  EXPECT_EQ(transform(2, 3), 7);
  const auto refuse = [](const char* text, const char* word) {
    ExpectInputError([&] { Parsed(text).AsRigidTransform(); }, {word});
  };
  refuse("[[1,0,0,0],[0,1,0,0],[0,0,1,0]]", "3 rows");
  refuse("[[1,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", "3 numbers");
  refuse("[[2,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", "rigid");
  refuse("[[-1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", "rigid");
  refuse("[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,1,1]]", "0 0 0 1");
  refuse("[[1,0,0,1e9],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", "[0][3]: is 1000");
}

}  // namespace
}  // namespace musclewarp
