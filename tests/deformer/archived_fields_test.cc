// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/deformer/archived_fields.h"

#include <gmock/gmock.h>

#include <cereal/archives/binary.hpp>
#include <sstream>
#include <string>

#include "musclewarp/deformer/preparation_archive.h"

namespace musclewarp {

// One struct before and after two of its fields swapped places.
namespace before {
struct Ends {
  double first = 1, last = 2;
};
MUSCLEWARP_ARCHIVE(Ends, first, last)
}  // namespace before
namespace after {
struct Ends {
  double last = 0, first = 0;
};
MUSCLEWARP_ARCHIVE(Ends, first, last)
}  // namespace after

namespace {

using ::testing::HasSubstr;

TEST(ArchivedFields, FieldsThatSwapPlacesKeepTheirValues) {
  std::stringstream stream;
  before::Ends written;
  cereal::BinaryOutputArchive output(stream);
  output(written);
  after::Ends read;
  cereal::BinaryInputArchive input(stream);
  input(read);
  EXPECT_EQ(read.first, written.first);
  EXPECT_EQ(read.last, written.last);
}

// A file states the names and types of what it holds, in their order.
TEST(ArchivedFields, AreNamedWithTheirTypes) {
  const std::string point =
      std::string("SegmentPoint\n  line ") + typeid(int).name() +
      "\n  segment " + typeid(int).name() + "\n  t " + typeid(double).name();
  EXPECT_THAT(ArchivedFields(), HasSubstr(point));
}

}  // namespace
}  // namespace musclewarp
