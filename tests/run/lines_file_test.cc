// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/lines_file.h"

#include <gtest/gtest.h>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

TEST(LinesFile, ComesBackToTheLastBit) {
  const Points line = RandomPoints(5, 1);
  const std::string path = TestTempDir() + "/lines.json";
  WriteLinesFile(path,
                 {{"a \"muscle\"", {{"l1", line}, {"l2", 2 * line}}, {}},
                  {"b", {}, {line, line.topRows(2)}, {line.topRows(3)}}});
  const std::vector<MuscleLines> muscles = ReadLinesFile(path);
  ASSERT_EQ(muscles.size(), 2u);
  EXPECT_EQ(muscles[0].name, "a \"muscle\"");
  ASSERT_EQ(muscles[0].lines.size(), 2u);
  EXPECT_EQ(muscles[0].lines[1].name, "l2");
  EXPECT_EQ(muscles[0].lines[1].points, 2 * line);
  ASSERT_EQ(muscles[1].fibres.size(), 2u);
  EXPECT_EQ(muscles[1].fibres[1], line.topRows(2));
  EXPECT_TRUE(muscles[0].tendons.empty());
  ASSERT_EQ(muscles[1].tendons.size(), 1u);
  EXPECT_EQ(muscles[1].tendons[0], line.topRows(3));
}

TEST(LinesFile, DamageIsNamed) {
  const std::string path = TestTempDir() + "/lines.json";
  const auto refused = [&](const std::string& text, const std::string& field) {
    WriteTextAtomically(path, text);
    ExpectInputError([&] { ReadLinesFile(path); }, {"lines.json", field});
  };
  refused("{", "not JSON");
  refused("{}", "muscles");
  refused(R"({"muscles": [{"name": "m", "lines": []}]})", "muscles[0].fibres");
  refused(R"({"muscles": [{"name": "m", "lines": [{"name": "l",
             "points": [[1, 2]]}], "fibres": []}]})",
          "muscles[0].lines[0].points[0]");
}

}  // namespace
}  // namespace musclewarp
