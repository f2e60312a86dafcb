// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/repaired_meshes.h"

#include <cmath>
#include <optional>
#include <string>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/triangle_difference.h"
#include "musclewarp/preparation/delivered_mesh.h"
#include "musclewarp/preparation/lost_parts.h"
#include "musclewarp/scene/coordinate_limits.h"
#include "musclewarp/scene/length_unit.h"

namespace musclewarp {
namespace {

// Repairs a mesh. Messages name a mesh without a file by `name`.
TriangleSoup Repaired(const TriangleSoup& delivered,
                      const std::string& name,
                      const std::string& path,
                      const PrepareOptions& options,
                      MeshPreparation* preparation) {
  CheckCoordinates(
      path.empty() ? name : path, delivered.points, options.repair.body_size);
  preparation->name = name;
  preparation->path = path;
  preparation->defects = CountDefects(delivered);
  TriangleSoup repaired = RepairMesh(delivered,
                                     path.empty() ? name : path,
                                     options.repair,
                                     &preparation->repairs);
  preparation->delivered_volume =
      SignedVolume(repaired.points, repaired.triangles) +
      TotalsOf(preparation->repairs.dropped_pieces).volume;
  if (options.remove_self_crossings) {
    preparation->self_crossings = RemoveSelfCrossings(&repaired);
  }
  return repaired;
}

}  // namespace

PreparedBone RepairBone(PrepareOptions options, const SceneBone& bone) {
  options.repair.pieces.rule = PieceRule::kAll;
  PreparedBone prepared;
  const TriangleSoup delivered = DeliveredMesh(bone, &prepared.mesh.notes);
  try {
    prepared.rest =
        Repaired(delivered, bone.name, bone.mesh_path, options, &prepared.mesh);
  } catch (const InputError& error) {
    if (!bone.is_of_model) throw;
    prepared.left_out = error.problem();
    return prepared;
  }
  prepared.delivered_only = TrianglesNotIn(delivered, prepared.rest);
  prepared.body = bone.body;
  return prepared;
}

TriangleSoup RepairMuscle(const PrepareOptions& options,
                          const SceneMuscle& muscle,
                          PreparedMuscle* prepared) {
  const std::string& where =
      muscle.mesh_path.empty() ? muscle.name : muscle.mesh_path;
  MeshParts parts;
  const TriangleSoup delivered =
      DeliveredMesh(muscle, &prepared->mesh.notes, &parts);
  const double body_size = options.repair.body_size;
  CheckCoordinates(where, delivered.points, body_size);
  // This precedes the repair, whose tolerances assume the size of a muscle.
  CheckMuscleSize(where,
                  body_size * BoundingBoxDiagonal(delivered.points),
                  std::nullopt,
                  body_size * muscle.mm_per_unit);
  TriangleSoup fine = Repaired(
      delivered, muscle.name, muscle.mesh_path, options, &prepared->mesh);
  CheckNoPartIsLost(where, parts, delivered, fine, prepared->mesh.repairs);
  CheckMuscleSize(where,
                  body_size * BoundingBoxDiagonal(fine.points),
                  std::pow(body_size, 3) * prepared->mesh.delivered_volume,
                  body_size * muscle.mm_per_unit);
  if (muscle.delivered_volume > 0) {
    prepared->mesh.delivered_volume = muscle.delivered_volume;
  }
  if (options.remove_slivers) {
    prepared->mesh.slivers = RemoveSlivers(options.slivers, &fine);
  }
  return fine;
}

}  // namespace musclewarp
