// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "support/data_root.h"
#include "support/prepared_small_scene.h"

namespace musclewarp {
namespace {

// The calf of the public shank: its muscles end above the heel, on the
// calcaneal tendon, which is a mesh of its own.
Scene Calf(const std::string& root) {
  Scene scene = ReadScene(root + "/bodyparts3d_shank/scene_uniform.json", root);
  const auto keep = [](auto* parts, const std::vector<std::string>& names) {
    parts->erase(std::remove_if(parts->begin(),
                                parts->end(),
                                [&](const auto& part) {
                                  return std::find(names.begin(),
                                                   names.end(),
                                                   part.name) == names.end();
                                }),
                 parts->end());
  };
  keep(&scene.muscles,
       {"gastrocnemius_medial",
        "gastrocnemius_lateral",
        "soleus",
        "calcaneal_tendon"});
  keep(&scene.bones, {"femur", "tibia", "fibula", "talus", "calcaneus"});
  return scene;
}

TEST(SoftAttachmentsData, TheCalfPullsOnTheHeelAndItsTendonKeepsItsLength) {
  const std::string root = DataRoot();
  if (root.empty()) GTEST_SKIP() << kNoDataRoot;
  const PreparedScene calf = PrepareScene(Calf(root), {});
  std::map<std::string, double> stretch;
  const ScenePose& dorsiflexed = calf.scene.poses[1];
  ASSERT_EQ(dorsiflexed.name, "dorsiflexion_20");
  for (const PreparedMuscle& muscle : calf.muscles) {
    const std::string& name = muscle.model.name;
    stretch[name] = CarriedLength(muscle, dorsiflexed) /
                        CarriedLength(muscle, calf.scene.poses[0]) -
                    1;
    const auto& attachments = muscle.model.attachments;
    ASSERT_EQ(attachments.size(), name == "calcaneal_tendon" ? 1u : 2u) << name;
    if (name == "calcaneal_tendon") continue;
    EXPECT_EQ(attachments[1].soft_part, "calcaneal_tendon") << name;
    EXPECT_THAT(muscle.lines_through, ::testing::ElementsAre(3)) << name;
    // Measured: 3.2 to 4.2 %. A muscle that ended on the tibia had none.
    EXPECT_GT(stretch[name], 0.025) << name;
  }
  // A tendon between heel and tibia was stretched by 5.7 %.
  EXPECT_LT(stretch["calcaneal_tendon"], 0.02);
}

}  // namespace
}  // namespace musclewarp
