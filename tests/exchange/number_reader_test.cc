// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/number_reader.h"

#include <gtest/gtest.h>

#include "support/input_errors.h"

namespace musclewarp {
namespace {

TEST(NumberReader, PassesOverBlanksAndComments) {
  NumberReader in("f", "# of TetGen\n 2 -1.5e3# more\n\t7 8");
  EXPECT_EQ(in.Count(0, 9), 2);
  EXPECT_EQ(in.Real(), -1500);
  in.Skip(1);
  in.Expect(8);
  ExpectInputError([&] { in.Real(); }, {"f", "ends early"});
}

TEST(NumberReader, FindsSections) {
  NumberReader in("f", "$A\n1\n$B\n2\n");
  in.Find("$B");
  EXPECT_EQ(in.Count(0, 9), 2);
  ExpectInputError([&] { in.Find("$A"); }, {"f", "has no $A"});
}

TEST(NumberReader, RefusesWhatIsOutOfRange) {
  for (const char* text : {"10", "-1", "2.5", "1e300", "x"}) {
    NumberReader in("f", text);
    ExpectInputError([&] { in.Count(0, 9); }, {"f"});
  }
  NumberReader in("f", "3");
  ExpectInputError([&] { in.Expect(4); }, {"f"});
}

}  // namespace
}  // namespace musclewarp
