// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/muscle_pieces.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "musclewarp/mesh/box.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/pieces.h"
#include "musclewarp/mesh/triangle_difference.h"
#include "musclewarp/mesh_files/mesh_parts.h"
#include "musclewarp/preparation/delivered_mesh.h"
#include "musclewarp/scene/coordinate_limits.h"
#include "musclewarp/scene/length_unit.h"

namespace musclewarp {
namespace {

bool ShareTriangles(const TriangleSoup& piece, const TriangleSoup& part) {
  return BoxOf(piece.points).Overlaps(BoxOf(part.points)) &&
         TrianglesNotIn(piece, part).triangles.rows() < piece.triangles.rows();
}

// Returns the part name of each piece, or nothing if a piece has no name or
// several.
std::optional<std::vector<std::string>> NamesByParts(
    const std::vector<MusclePiece>& pieces,
    const TriangleSoup& delivered,
    const MeshParts& parts) {
  std::vector<std::string> names(pieces.size());
  for (size_t part = 0; part < parts.names.size(); ++part) {
    const TriangleSoup mesh =
        MeshOfPart(delivered, parts, static_cast<int>(part));
    for (size_t i = 0; i < pieces.size(); ++i) {
      if (names[i] == parts.names[part]) continue;
      if (!ShareTriangles(pieces[i].mesh, mesh)) continue;
      if (!names[i].empty()) return std::nullopt;
      names[i] = parts.names[part];
    }
  }
  if (std::count(names.begin(), names.end(), "") > 0) return std::nullopt;
  return names;
}

// Names the pieces, and numbers those of the same name in order.
void NamePieces(const std::vector<std::string>& names,
                std::vector<MusclePiece>* pieces) {
  std::map<std::string, int> used;
  for (size_t i = 0; i < pieces->size(); ++i) {
    const bool is_alone = std::count(names.begin(), names.end(), names[i]) == 1;
    (*pieces)[i].name =
        is_alone ? names[i] : names[i] + "_" + std::to_string(++used[names[i]]);
  }
}

}  // namespace

MusclePieces PiecesOfMuscle(const SceneMuscle& muscle, RepairOptions options) {
  const std::string& where =
      muscle.mesh_path.empty() ? muscle.name : muscle.mesh_path;
  MusclePieces result;
  MeshParts parts;
  const TriangleSoup delivered = DeliveredMesh(muscle, &result.notes, &parts);
  CheckCoordinates(where, delivered.points);
  CheckMuscleSize(where,
                  BoundingBoxDiagonal(delivered.points),
                  std::nullopt,
                  muscle.mm_per_unit);
  options.pieces.rule = PieceRule::kAll;
  for (TriangleSoup& mesh :
       PiecesOf(RepairMesh(delivered, where, options, &result.repairs))) {
    const double volume = SignedVolume(mesh.points, mesh.triangles);
    result.pieces.push_back({"", std::move(mesh), volume});
  }
  std::stable_sort(result.pieces.begin(),
                   result.pieces.end(),
                   [](const MusclePiece& a, const MusclePiece& b) {
                     return a.volume > b.volume;
                   });
  const auto by_parts = NamesByParts(result.pieces, delivered, parts);
  NamePieces(by_parts.value_or(
                 std::vector<std::string>(result.pieces.size(), muscle.name)),
             &result.pieces);
  return result;
}

}  // namespace musclewarp
