// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/lost_parts.h"

#include <gtest/gtest.h>

#include "support/input_errors.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// Repairs a mesh as that of a muscle, and checks its parts.
void Check(const TriangleSoup& delivered, const MeshParts& parts) {
  RepairReport repairs;
  const TriangleSoup repaired =
      RepairMesh(delivered, "m.obj", RepairOptions(), &repairs);
  CheckNoPartIsLost("m.obj", parts, delivered, repaired, repairs);
}

// Parts that follow one another, with so many triangles each.
MeshParts PartsOf(const std::vector<std::string>& names,
                  const std::vector<Eigen::Index>& triangles) {
  MeshParts parts = {"object", names, {}, {}};
  for (size_t i = 0; i < triangles.size(); ++i) {
    parts.part_of.insert(
        parts.part_of.end(), triangles[i], static_cast<int>(i));
  }
  return parts;
}

MeshParts PartsOf(const std::vector<std::string>& names,
                  const TriangleSoup& a,
                  const TriangleSoup& b) {
  return PartsOf(names, {a.triangles.rows(), b.triangles.rows()});
}

TEST(LostParts, TheNamesAndHowToNameOneAreSaid) {
  const TriangleSoup a = SphereAt({0, 0, 0}, 20, 2);
  const TriangleSoup b = SphereAt({60, 0, 0}, 15, 2);
  ExpectInputError(
      [&] {
        Check(Together(a, b), PartsOf({"medius", "minimus"}, a, b));
      },
      {"m.obj: has 2 objects: medius, minimus; a muscle is one closed surface",
       "\"m.obj#medius\"",
       "pieces=all"});
}

TEST(LostParts, PartsOfOneNameHaveToBeRenamed) {
  const TriangleSoup a = SphereAt({0, 0, 0}, 20, 2);
  const TriangleSoup b = SphereAt({60, 0, 0}, 15, 2);
  ExpectInputError(
      [&] {
        Check(Together(a, b), PartsOf({"m", "m"}, a, b));
      },
      {"has 2 objects of the name m;", "give each a name of its own"});
}

TEST(LostParts, AnObjectThatIsNamedTwiceIsOneName) {
  const TriangleSoup a = SphereAt({0, 0, 0}, 20, 2);
  const TriangleSoup b = SphereAt({60, 0, 0}, 15, 2);
  const Eigen::Index half = a.triangles.rows() / 2;
  ExpectInputError(
      [&] {
        Check(Together(a, b),
              PartsOf({"m", "m", "n"}, {half, half, b.triangles.rows()}));
      },
      {"has 2 objects: m, n;", "\"m.obj#m\""});
}

TEST(LostParts, ABodyIsNoCrumbHoweverSmall) {
  const TriangleSoup a = SphereAt({0, 0, 0}, 30, 2);
  const TriangleSoup b = SphereAt({60, 0, 0}, 2, 1);
  ExpectInputError(
      [&] {
        Check(Together(a, b), PartsOf({"large", "small"}, a, b));
      },
      {"has 2 objects: large, small"});
}

TEST(LostParts, AScrapIsACrumb) {
  const TriangleSoup a = SphereAt({0, 0, 0}, 30, 2);
  const TriangleSoup b = {
      (Points(3, 3) << 60, 0, 0, 61, 0, 0, 60, 1, 0).finished(),
      (Triangles(1, 3) << 0, 1, 2).finished()};
  Check(Together(a, b), PartsOf({"muscle", "mark"}, a, b));
}

TEST(LostParts, MaterialsOfOneSurfaceAreNotLost) {
  const TriangleSoup sphere = SphereAt({0, 0, 0}, 20, 2);
  const Eigen::Index half = sphere.triangles.rows() / 2;
  Check(sphere, PartsOf({"belly", "tendon"}, {half, half}));

  // Even with a piece beside it, which is a loss of the surface.
  const TriangleSoup beside = SphereAt({60, 0, 0}, 8, 2);
  Check(Together(sphere, beside),
        PartsOf({"belly", "tendon"}, {half, half + beside.triangles.rows()}));
}

TEST(LostParts, OnePartMayLoseAPiece) {
  const TriangleSoup a = SphereAt({0, 0, 0}, 20, 2);
  const TriangleSoup b = SphereAt({60, 0, 0}, 15, 2);
  const TriangleSoup both = Together(a, b);
  Check(both, PartsOf({"m"}, {both.triangles.rows()}));
  Check(both, MeshParts());
}

}  // namespace
}  // namespace musclewarp
