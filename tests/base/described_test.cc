// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/described.h"

#include <gtest/gtest.h>

#include <cmath>

#include "musclewarp/base/described_checks.h"

namespace musclewarp {
namespace {

struct Patch {
  double area = 2;
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
};
constexpr auto FieldsOf(Described<Patch>) {
  return std::make_tuple(
      Field(&Patch::area, "area_mm2", "mm2").Text("its area").AtLeast(0),
      Field(&Patch::place, "place_mm", "mm").Text("its centre"));
}

struct Surface {
  std::string name;
  std::vector<Patch> patches;
  std::map<std::string, double> shares;
  int hidden = 0;

  double Area() const {
    double sum = 0;
    for (const Patch& patch : patches) sum += patch.area;
    return sum;
  }
};
constexpr auto FieldsOf(Described<Surface>) {
  using S = Surface;
  return std::make_tuple(
      Field(&S::name, "name").Text("of the surface"),
      Field(&S::patches, "patches").Text("its patches"),
      Field(&S::shares, "shares").Text("of each part").Within(0, 1),
      Field(&S::Area, "area_mm2", "mm2").Text("the sum of their areas"),
      NotWritten(&S::hidden));
}

Surface SomeSurface() {
  Surface surface;
  surface.name = "s";
  surface.patches.resize(2);
  surface.shares = {{"a", 0.25}};
  return surface;
}

// Fields are counted at compile time: a list that lacks one does not compile.
static_assert(described_internal::NumFields<Patch>() == 2);
static_assert(described_internal::NumFields<Surface>() == 4);

TEST(Described, VisitsFieldsInTheOrderOfTheList) {
  const Surface surface = SomeSurface();
  std::string keys, names;
  VisitFields(surface, [&](const auto& field, const auto&) {
    keys += std::string(field.key) + " ";
    names += NameOf(field) + " ";
  });
  EXPECT_EQ(keys, "name patches shares area_mm2 ");
  EXPECT_EQ(names, "name patches shares area ");
}

TEST(Described, ComparesWhatIsWritten) {
  const Surface surface = SomeSurface();
  Surface other = surface;
  other.hidden = 1;
  EXPECT_TRUE(AreEqual(surface, other));
  other.patches[1].place.z() = 1e-300;
  EXPECT_FALSE(AreEqual(surface, other));
  other = surface;
  other.shares["a"] = 0.5;
  EXPECT_FALSE(AreEqual(surface, other));
  other = surface;
  other.patches.pop_back();
  EXPECT_FALSE(AreEqual(surface, other));
}

TEST(Described, NamesTheFieldThatIsNotValid) {
  Surface surface = SomeSurface();
  std::string error;
  EXPECT_TRUE(IsValid(surface, &error));
  surface.patches[1].area = -1;
  EXPECT_FALSE(IsValid(surface, &error));
  EXPECT_EQ(error, "patches[1].area_mm2 is -1, allowed: 0 or above");
  surface = SomeSurface();
  surface.shares["b"] = 2;
  EXPECT_FALSE(IsValid(surface, &error));
  EXPECT_EQ(error, "shares.b is 2, allowed: 0 to 1");
  surface = SomeSurface();
  surface.patches[0].place.y() = std::nan("");
  EXPECT_FALSE(IsValid(surface, &error));
  EXPECT_EQ(error, "patches[0].place_mm[1] is nan, allowed: numbers");
  surface.patches[0].place.y() = kInfinity;
  EXPECT_TRUE(IsValid(surface, &error));
}

}  // namespace
}  // namespace musclewarp
