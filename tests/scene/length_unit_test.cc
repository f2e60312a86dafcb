// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/length_unit.h"

#include <gtest/gtest.h>

#include "support/input_errors.h"

namespace musclewarp {
namespace {

TEST(LengthUnit, IsOneOfThree) {
  EXPECT_EQ(MillimetresPer("mm"), 1);
  EXPECT_EQ(MillimetresPer("cm"), 10);
  EXPECT_EQ(MillimetresPer("m"), 1000);
  EXPECT_FALSE(MillimetresPer("inch"));
  EXPECT_FALSE(MillimetresPer(""));
}

// A psoas of 300 mm and 250 cm3, read in another unit than its own.
TEST(MuscleSize, AsksForTheUnitThatWasMeant) {
  EXPECT_NO_THROW(CheckMuscleSize("psoas.ply", 300, 250e3, 1));
  EXPECT_NO_THROW(CheckMuscleSize("psoas.ply", 300, 250e3, 1000));
  ExpectInputError([] { CheckMuscleSize("psoas.ply", 0.3, 250e-6, 1); },
                   {"psoas.ply", "0.3 mm", "is it in metres?"});
  ExpectInputError([] { CheckMuscleSize("psoas.ply", 300e3, 250e12, 1000); },
                   {"psoas.ply", "is it in millimetres?"});
  ExpectInputError([] { CheckMuscleSize("psoas.ply", 30e3, 250e9, 1000); },
                   {"psoas.ply", "is it in millimetres or centimetres?"});
}

// From a mouse's foot to an elephant's back.
TEST(MuscleSize, OfAnAnimalIsTaken) {
  EXPECT_NO_THROW(CheckMuscleSize("interosseus.ply", 4, 0.3, 1));
  EXPECT_NO_THROW(CheckMuscleSize("longissimus.ply", 2500, 6e7, 1));
}

}  // namespace
}  // namespace musclewarp
