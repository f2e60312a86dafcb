// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/muscle_elements.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "joints/made_leg.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/joints/articulated_model.h"
#include "musclewarp/opensim/kinematics.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// A line from the pelvis over the femur to the tibia, whose name XML has to
// escape, and another one.
std::vector<LineMuscle> TwoMuscles() {
  std::vector<LineMuscle> muscles(2);
  ActionLine& line = muscles[0].line;
  line.name = "rectus & \"co\"<1>";
  line.rest.resize(3, 3);
  line.rest << -100.123456789, -40, 20, 1.0 / 3, -60, -200, -90, -50, -400;
  line.bodies = {"pelvis", "femur_r", "tibia_r"};
  muscles[0].volume = 3e5;
  muscles[1] = muscles[0];
  muscles[1].line.name = "vastus_1";
  muscles[1].line.bodies[0] = "femur_r";
  return muscles;
}

class MusclesOfModel : public ::testing::Test {
 protected:
  MusclesOfModel()
      : articulation_(Articulate(LegOf(Side::kRight).bones, {})),
        text_(ArticulatedModelText(articulation_, "leg", TwoMuscles())) {}

  Model Read() const {
    const std::string path = TestTempDir() + "/model.osim";
    WriteTextAtomically(path, text_);
    return ReadModel(path);
  }

  const Articulation articulation_;
  const std::string text_;
};

TEST_F(MusclesOfModel, HaveTheirLinesAtRestAsPaths) {
  const Model model = Read();
  EXPECT_TRUE(model.warnings.empty());
  ASSERT_EQ(model.muscles.size(), 2u);
  const auto ground_from_body = BodyFrames(model, DefaultValues(model));
  for (size_t m = 0; m < 2; ++m) {
    const ActionLine line = TwoMuscles()[m].line;
    const ModelMuscle& muscle = model.muscles[m];
    EXPECT_EQ(muscle.name, line.name);
    EXPECT_TRUE(muscle.unsupported.empty());
    ASSERT_EQ(muscle.path.size(), 3u);
    for (int i = 0; i < 3; ++i) {
      const PathPoint& point = muscle.path[i];
      EXPECT_EQ(model.bodies[point.body].name, line.bodies[i]);
      const Eigen::Vector4d place =
          ground_from_body[point.body] * point.location.homogeneous();
      // As exact as the frames of the bodies, which are unit matrices to 1e-6.
      EXPECT_LT((place.head<3>() - line.rest.row(i).transpose()).norm(), 1e-6);
    }
  }
}

TEST_F(MusclesOfModel, HaveTheEstimatesInMetres) {
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(text_.c_str()));
  const pugi::xml_node objects = document.document_element()
                                     .child("Model")
                                     .child("ForceSet")
                                     .child("objects");
  int count = 0;
  for (const pugi::xml_node node :
       objects.children("Millard2012EquilibriumMuscle")) {
    const MuscleEstimate estimate = EstimateMuscle(TwoMuscles()[count++]);
    const auto number = [&](const char* name) {
      return std::stod(node.child_value(name));
    };
    EXPECT_EQ(number("max_isometric_force"), estimate.max_isometric_force);
    EXPECT_EQ(number("optimal_fiber_length"),
              estimate.optimal_fibre_length / 1000);
    EXPECT_EQ(number("tendon_slack_length"),
              estimate.tendon_slack_length / 1000);
    EXPECT_EQ(number("pennation_angle_at_optimal"), estimate.pennation);
  }
  EXPECT_EQ(count, 2);
}

TEST_F(MusclesOfModel, AreCalledEstimates) {
  EXPECT_THAT(text_, HasSubstr("are estimates from the shapes"));
  EXPECT_THAT(text_, HasSubstr("60 N/cm2"));
}

TEST_F(MusclesOfModel, AreAllThatTheyAddToTheModel) {
  const std::string without = ArticulatedModelText(articulation_, "leg");
  EXPECT_THAT(without, Not(HasSubstr("ForceSet")));
  const size_t begin = text_.find("    <ForceSet");
  const std::string end = "</ForceSet>\n";
  EXPECT_EQ(text_.substr(0, begin) + text_.substr(text_.find(end) + end.size()),
            without);
}

TEST_F(MusclesOfModel, MustBeOnBodiesOfTheModel) {
  std::vector<LineMuscle> muscles = TwoMuscles();
  muscles[0].line.bodies[1] = "patella_r";
  EXPECT_DEATH(ArticulatedModelText(articulation_, "leg", muscles),
               "patella_r");
}

}  // namespace
}  // namespace musclewarp
