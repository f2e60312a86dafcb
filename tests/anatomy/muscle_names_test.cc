// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/anatomy/muscle_names.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

TEST(MuscleKey, IsTheSameForEverySpelling) {
  for (const char* name : {"tibialis_anterior",
                           "Tibialis anterior",
                           "TIBIALIS-ANTERIOR",
                           "TibialisAnterior",
                           "musculus tibialis anterior",
                           "M. tibialis anterior",
                           "tibialis anterior muscle",
                           "tibialis_anterior_2",
                           "tibialis_anterior2"}) {
    EXPECT_EQ(MuscleKey(name), "tibialisanterior") << name;
  }
}

TEST(MuscleKey, HasNoSide) {
  for (const char* name : {"soleus_r",
                           "soleus_l",
                           "L_Soleus",
                           "soleus.R",
                           "left soleus",
                           "soleus_right",
                           "r_m_soleus",
                           "soleus_r_2",
                           "soleus2_l"}) {
    EXPECT_EQ(MuscleKey(name), "soleus") << name;
  }
  EXPECT_EQ(MuscleKey("long head of right biceps femoris"),
            MuscleKey("long head of biceps femoris"));
}

TEST(MuscleKey, KeepsAllOtherWords) {
  EXPECT_NE(MuscleKey("soleus_fascia"), MuscleKey("soleus"));
  EXPECT_NE(MuscleKey("tibialis"), MuscleKey("tibialis_anterior"));
  EXPECT_NE(MuscleKey("gluteus_m"), MuscleKey("gluteus"));
}

TEST(MuscleKey, TakesOldNamesForNewOnes) {
  EXPECT_EQ(MuscleKey("peroneus_longus"), MuscleKey("fibularis longus"));
  EXPECT_EQ(MuscleKey("Peronaeus brevis"), MuscleKey("fibularis_brevis_l"));
  EXPECT_EQ(MuscleKey("glutaeus maximus"), MuscleKey("gluteus_maximus"));
}

TEST(MuscleKey, IsEmptyIfNothingIsLeft) {
  for (const char* name : {"", "_", "12", "muscle", "left", "head of"}) {
    EXPECT_EQ(MuscleKey(name), "") << name;
  }
}

}  // namespace
}  // namespace musclewarp
