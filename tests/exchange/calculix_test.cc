// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "exchange/small_model.h"
#include "musclewarp/base/child_process.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/exchange/element_files.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::HasSubstr;

// CalculiX prints seven digits.
constexpr double kPrintedDigits = 1e-6;

// Writes the model and a deck with one step around it, and solves it.
ChildResult RunCalculix(const std::string& ccx,
                        const ElementModel& model,
                        const std::string& dir) {
  WriteTextAtomically(dir + "/model.inp", AbaqusText(model));
  WriteTextAtomically(dir + "/deck.inp",
                      "*INCLUDE, INPUT=model.inp\n"
                      "*BOUNDARY\nMUSCLE_NODES, 1, 3\nbody_thigh_RIGID, 1, 3\n"
                      "*STEP\n*STATIC\n"
                      "*EL PRINT, ELSET=psoas\nEVOL\n"
                      "*END STEP\n");
  constexpr double kLongestSeconds = 60;
  return RunChild({ccx, "-i", "deck"}, dir, kLongestSeconds);
}

// The volumes of the elements as CalculiX prints them, by their number.
std::map<int, double> PrintedVolumes(const std::string& dir) {
  std::ifstream in(dir + "/deck.dat");
  std::map<int, double> volumes;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    int element = 0;
    double volume = 0;
    if (words >> element >> volume) volumes[element] = volume;
  }
  return volumes;
}

// The corner of an element is the last node, next to the origin, where numbers
// with all their digits take more room than CalculiX has for them.
TEST(Calculix, ReadsPointsNextToTheOrigin) {
  const std::string ccx = FindProgram("ccx");
  if (ccx.empty()) {
    GTEST_SKIP() << "no ccx; apt-get install calculix-ccx";
  }
  ElementModel model = MakeSmallModel().Model();
  const Eigen::Index centre = model.mesh.points.rows() - 1;
  ASSERT_TRUE(model.mesh.points.row(centre).isZero());
  model.mesh.points.row(centre) << -7.61363549309262e-05,
      4.6374671874097848e-05, -1.2345678901234567e-05;
  const std::string dir = TestTempDir();
  const ChildResult result = RunCalculix(ccx, model, dir);
  EXPECT_TRUE(result.IsFine()) << result.Text();
  EXPECT_THAT(result.output, HasSubstr("Job finished"));
  const std::map<int, double> printed = PrintedVolumes(dir);
  const MuscleElements& psoas = model.muscles[0];
  ASSERT_EQ(printed.size(), static_cast<size_t>(psoas.num_elements));
  for (const auto& [element, volume] : printed) {
    EXPECT_NEAR(volume / Volumes(model.mesh)[element - 1], 1, kPrintedDigits);
  }
}

// CalculiX takes a gap below 1 / stiffness for closed at the start.
TEST(Calculix, ContactIsStiffEnoughForTheSmallestGap) {
  ElementModel model = MakeSmallModel().Model();
  const std::string keyword =
      "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n";
  const auto stiffness = [&] {
    const std::string text = AbaqusText(model);
    return std::stod(text.substr(text.find(keyword) + keyword.size(), 20));
  };
  EXPECT_EQ(stiffness(), 100);
  model.contacts[0].gap_mm = 0.002;
  EXPECT_GT(stiffness() * model.contacts[0].gap_mm, 1);
}

}  // namespace
}  // namespace musclewarp
