// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
//
// Uses the installed library as the README of a dependent project would.

#include <cmath>
#include <cstdio>

#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/mesh.h"

int main() {
  musclewarp::TriangleSoup soup;
  soup.points.resize(4, 3);
  soup.points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  soup.triangles.resize(4, 3);
  soup.triangles << 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2;

  const musclewarp::Mesh mesh = musclewarp::MeshFromSoup(soup);
  const musclewarp::TriangleSoup back = musclewarp::SoupFromMesh(mesh);
  const double volume = musclewarp::SignedVolume(back.points, back.triangles);
  std::printf("consumer: unit tetrahedron, volume %.6f\n", volume);
  return std::abs(volume - 1.0 / 6.0) < 1e-12 ? 0 : 1;
}
