// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/delivered_mesh.h"

#include "musclewarp/mesh/transformed.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/mesh_files/stated_space.h"

namespace musclewarp {

TriangleSoup DeliveredMesh(const SceneMuscle& muscle,
                           std::vector<std::string>* notes,
                           MeshParts* parts) {
  if (muscle.mesh_path.empty()) return {muscle.points, muscle.triangles};
  TriangleSoup soup = ReadTriangleSoup(muscle.mesh_path, notes, parts);
  if (muscle.is_turned) TurnToOtherSpace(&soup.points);
  if (muscle.mm_per_unit != 1) soup.points *= muscle.mm_per_unit;
  return soup;
}

TriangleSoup DeliveredMesh(const SceneBone& bone,
                           std::vector<std::string>* notes) {
  TriangleSoup soup = bone.mesh_path.empty()
                          ? TriangleSoup{bone.points, bone.triangles}
                          : ReadTriangleSoup(bone.mesh_path, notes);
  if (bone.is_turned) TurnToOtherSpace(&soup.points);
  if (!bone.rest_from_file.isIdentity(0)) {
    soup.points = Transformed(soup.points, bone.rest_from_file);
  }
  return soup;
}

}  // namespace musclewarp
