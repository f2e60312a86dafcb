// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/anatomy/muscle_facts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "musclewarp/anatomy/bone_names.h"
#include "musclewarp/anatomy/muscle_names.h"

namespace musclewarp {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;

// The canonical name and all aliases.
std::vector<std::string> NamesOf(const MuscleFacts& facts) {
  std::vector<std::string> names = facts.aliases;
  names.push_back(facts.name);
  return names;
}

std::string Shouted(std::string text) {
  for (char& letter : text) {
    letter =
        static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  }
  return text;
}

std::string With(char sign, std::string text) {
  for (char& letter : text) {
    if (letter == '_' || letter == ' ') letter = sign;
  }
  return text;
}

std::vector<AnatomicalEnd> EndsOfBothSides(const MuscleFacts& facts) {
  std::vector<AnatomicalEnd> ends = facts.origin_ends;
  ends.insert(
      ends.end(), facts.insertion_ends.begin(), facts.insertion_ends.end());
  return ends;
}

TEST(MuscleFacts, HaveNamesOfTheirOwn) {
  std::map<std::string, std::string> owner_of_key;
  for (const MuscleFacts& facts : AllMuscleFacts()) {
    std::set<std::string> keys;
    for (const std::string& name : NamesOf(facts)) {
      EXPECT_TRUE(keys.insert(MuscleKey(name)).second)
          << name << " is twice with " << facts.name;
      const auto [owner, is_new] =
          owner_of_key.emplace(MuscleKey(name), facts.name);
      EXPECT_TRUE(is_new) << name << " is " << facts.name << " and "
                          << owner->second;
    }
  }
  EXPECT_THAT(owner_of_key, Not(Contains(::testing::Key(""))));
}

TEST(MuscleFacts, AreFoundByEveryNameInEverySpellingOnBothSides) {
  for (const MuscleFacts& facts : AllMuscleFacts()) {
    for (const std::string& name : NamesOf(facts)) {
      for (const std::string& spelled : {name,
                                         name + "_left",
                                         name + "_right",
                                         name + "_l",
                                         name + "_r",
                                         name + ".R",
                                         "L_" + name,
                                         "right " + name,
                                         name + "_3",
                                         name + "1_r",
                                         "m. " + name,
                                         "musculus_" + name,
                                         Shouted(name),
                                         With('-', name),
                                         With(' ', name)}) {
        EXPECT_EQ(FindMuscleFacts(spelled), &facts) << spelled;
      }
    }
  }
}

TEST(MuscleFacts, HaveEndsWithBonesAndSources) {
  for (const MuscleFacts& facts : AllMuscleFacts()) {
    EXPECT_FALSE(facts.origin_ends.empty()) << facts.name;
    EXPECT_FALSE(facts.insertion_ends.empty()) << facts.name;
    for (const AnatomicalEnd& end : EndsOfBothSides(facts)) {
      EXPECT_FALSE(end.places.empty()) << facts.name << " " << end.landmark;
      EXPECT_NE(end.source, "") << facts.name << " " << end.landmark;
    }
  }
}

TEST(MuscleFacts, ListTheMainBoneOfEachEndOnce) {
  for (const MuscleFacts& facts : AllMuscleFacts()) {
    for (const auto& [bones, ends] :
         {std::pair(facts.origins, facts.origin_ends),
          std::pair(facts.insertions, facts.insertion_ends)}) {
      EXPECT_EQ(bones.front(), ends.front().places.front().bone) << facts.name;
      const std::set<std::string> different(bones.begin(), bones.end());
      EXPECT_EQ(different.size(), bones.size()) << facts.name;
      for (const AnatomicalEnd& end : ends) {
        EXPECT_THAT(bones, Contains(end.places.front().bone)) << facts.name;
      }
      for (const std::string& bone : bones) {
        EXPECT_TRUE(ParseBoneName(bone).is_known) << facts.name << " " << bone;
      }
    }
  }
}

// No muscle here begins and ends on one bone.
TEST(MuscleFacts, LeadFromOneBoneToAnother) {
  for (const MuscleFacts& facts : AllMuscleFacts()) {
    EXPECT_THAT(facts.insertions, Not(Contains(facts.origins.front())))
        << facts.name;
  }
}

TEST(MuscleFacts, ConceptsBelongToOneMuscle) {
  std::set<std::string> concepts;
  for (const MuscleFacts& facts : AllMuscleFacts()) {
    if (facts.fma_id.empty()) continue;
    EXPECT_EQ(facts.fma_id.rfind("FMA", 0), 0u) << facts.name;
    EXPECT_TRUE(concepts.insert(facts.fma_id).second) << facts.fma_id;
  }
}

TEST(MuscleFacts, UseEveryLandmark) {
  std::set<std::string> used;
  for (const MuscleFacts& facts : AllMuscleFacts()) {
    for (const AnatomicalEnd& end : EndsOfBothSides(facts)) {
      used.insert(end.landmark);
    }
    for (const AnatomicalEnd& pulley : facts.pulleys) {
      used.insert(pulley.landmark);
    }
  }
  for (const std::string& landmark : LandmarkNames()) {
    EXPECT_EQ(used.count(landmark), 1u) << landmark;
  }
}

// What a belly without its tendon is asked about.
TEST(MuscleFacts, SayWhereTendonsGo) {
  const auto insertions_of = [](const std::string& name) {
    return FindMuscleFacts(name)->insertions;
  };
  EXPECT_THAT(insertions_of("soleus"), ElementsAre("calcaneus"));
  EXPECT_THAT(insertions_of("gastrocnemius_medial_l"),
              ElementsAre("calcaneus"));
  EXPECT_THAT(insertions_of("tib_ant_r"), ElementsAre("metatarsal_1"));
  EXPECT_THAT(insertions_of("peroneus longus"), ElementsAre("metatarsal_1"));
  EXPECT_THAT(insertions_of("perbrev_r"), ElementsAre("metatarsal_5"));
  EXPECT_THAT(insertions_of("tibpost_r"), ElementsAre("navicular"));
  EXPECT_THAT(insertions_of("semiten_r"), ElementsAre("tibia"));
  EXPECT_THAT(insertions_of("bflh_r"), ElementsAre("fibula"));
  EXPECT_THAT(insertions_of("vasmed_r"), ElementsAre("patella"));
  EXPECT_THAT(insertions_of("BIClong"), ElementsAre("radius"));
  EXPECT_THAT(insertions_of("deltoid"), ElementsAre("humerus"));
  EXPECT_THAT(FindMuscleFacts("soleus")->origins,
              ElementsAre("fibula", "tibia"));
}

// A group ends where its members end.
TEST(MuscleFacts, OfGroupsHaveTheBonesOfTheirMembers) {
  const std::map<std::string, std::vector<std::string>> members = {
      {"iliopsoas", {"psoas_major", "iliacus"}},
      {"gemelli", {"gemellus_superior", "gemellus_inferior"}},
      {"vasti", {"vastus_lateralis", "vastus_intermedius", "vastus_medialis"}},
      {"quadriceps_femoris", {"rectus_femoris", "vasti"}},
      {"biceps_femoris",
       {"biceps_femoris_long_head", "biceps_femoris_short_head"}},
      {"thigh_posterior_compartment",
       {"biceps_femoris", "semitendinosus", "semimembranosus"}},
      {"thigh_medial_compartment",
       {"adductor_longus", "adductor_brevis", "adductor_magnus", "gracilis"}},
      {"gastrocnemius",
       {"gastrocnemius_medial_head", "gastrocnemius_lateral_head"}},
      {"triceps_surae", {"gastrocnemius", "soleus"}},
      {"leg_anterior_compartment",
       {"tibialis_anterior",
        "extensor_digitorum_longus",
        "extensor_hallucis_longus",
        "fibularis_tertius"}},
      {"leg_lateral_compartment", {"fibularis_longus", "fibularis_brevis"}},
      {"leg_deep_posterior_compartment",
       {"tibialis_posterior",
        "flexor_digitorum_longus",
        "flexor_hallucis_longus"}},
      {"deltoid",
       {"deltoid_clavicular_part",
        "deltoid_acromial_part",
        "deltoid_spinal_part"}},
      {"rhomboids", {"rhomboid_major", "rhomboid_minor"}},
      {"biceps_brachii",
       {"biceps_brachii_long_head", "biceps_brachii_short_head"}},
      {"triceps_brachii",
       {"triceps_brachii_long_head",
        "triceps_brachii_lateral_head",
        "triceps_brachii_medial_head"}}};
  for (const auto& [group, names] : members) {
    std::set<std::string> origins, insertions;
    for (const std::string& name : names) {
      const MuscleFacts& facts = *FindMuscleFacts(name);
      origins.insert(facts.origins.begin(), facts.origins.end());
      insertions.insert(facts.insertions.begin(), facts.insertions.end());
    }
    const MuscleFacts& facts = *FindMuscleFacts(group);
    EXPECT_THAT(facts.origins, ::testing::UnorderedElementsAreArray(origins))
        << group;
    EXPECT_THAT(facts.insertions,
                ::testing::UnorderedElementsAreArray(insertions))
        << group;
  }
}

TEST(FindMuscleFacts, DoesNotKnowStrangersNorPartsOfNames) {
  for (const char* name : {"",
                           "_",
                           "liver",
                           "soleus_fascia",
                           "tibialis",
                           "gluteus",
                           "vastus_r_artery",
                           "femur",
                           "anterior compartment",
                           "autochthon_left",
                           "calcaneal_tendon",
                           "muscle1",
                           "left",
                           "m",
                           "adductor hallucis",
                           "erector spinae",
                           "sol",
                           "soleuss"}) {
    EXPECT_EQ(FindMuscleFacts(name), nullptr) << name;
  }
}

}  // namespace
}  // namespace musclewarp
