// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/memory_need.h"

#include <algorithm>
#include <string>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/memory.h"
#include "musclewarp/solver/bone_push.h"

namespace musclewarp {

double MemoryNeeded(const std::vector<SizedMesh>& meshes,
                    int coarse_vertices,
                    bool is_certified) {
  // The program itself, and what does not grow with the meshes.
  constexpr double kProgram = 4e7;
  // Of a vertex of a muscle: a weight for each vertex of the hull, in double
  // precision while it is found and in single afterwards, and with certified
  // contact once more in single; and what is kept of its triangles: trees,
  // planes, offsets. Of a vertex of a bone: its trees at rest and in motion.
  const double of_weight = is_certified ? 12 : 8;
  const double of_vertex = is_certified ? 6000 : 3700;
  const double of_bone_vertex = is_certified ? 1700 : 1500;
  // Of a muscle that bones push: how its samples move each other and the hull,
  // in double precision.
  const double samples = NumPushSamples({}, coarse_vertices);
  const double of_muscle = 8 * samples * (samples + 2 * coarse_vertices);
  double bytes = kProgram;
  for (const SizedMesh& mesh : meshes) {
    if (mesh.is_muscle) bytes += of_muscle;
    bytes += mesh.vertices * (mesh.is_muscle
                                  ? of_weight * coarse_vertices + of_vertex
                                  : of_bone_vertex);
  }
  return bytes;
}

void CheckMemory(const std::vector<SizedMesh>& meshes,
                 double needed,
                 double allowed) {
  if (needed <= allowed) return;
  // A vertex of a bone takes little.
  const auto takes_less = [](const SizedMesh& a, const SizedMesh& b) {
    return std::pair(a.is_muscle, a.vertices) <
           std::pair(b.is_muscle, b.vertices);
  };
  const auto largest =
      std::max_element(meshes.begin(), meshes.end(), takes_less);
  std::string advice = "allow more if the machine has it";
  if (largest != meshes.end()) {
    advice = "simplify the meshes, of which " + largest->name +
             " takes most (" +
             std::to_string(static_cast<long>(largest->vertices)) +
             " vertices), or " + advice;
  }
  throw InputError("{max_memory_gib}",
                   "the run needs about " + MemoryText(needed) +
                       "; allowed: " + MemoryText(allowed),
                   advice);
}

double CheckedMemory(const PrepareOptions& options,
                     const std::vector<TriangleSoup>& muscles,
                     const PreparedScene& scene) {
  std::vector<SizedMesh> meshes;
  for (size_t i = 0; i < muscles.size(); ++i) {
    meshes.push_back({scene.scene.muscles[i].name,
                      static_cast<double>(muscles[i].points.rows()),
                      true});
  }
  for (const PreparedBone& bone : scene.bones) {
    meshes.push_back(
        {bone.mesh.name, static_cast<double>(bone.rest.points.rows())});
  }
  const double needed = MemoryNeeded(meshes,
                                     options.muscle.hull.coarse_vertices,
                                     options.remove_self_crossings);
  CheckMemory(meshes, needed, options.max_memory);
  return needed;
}

}  // namespace musclewarp
