// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Serialization of a Preparation by cereal, for preparation_cache.cc.

#include <cereal/types/map.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <cstdint>

#include "musclewarp/frame_solvers/rest_result.h"
#include "musclewarp/motion/state_archive.h"
#include "musclewarp/preparation/prepared_scene.h"

namespace cereal {

template <class Archive>
void save(Archive& archive, const musclewarp::SparseMatrix& matrix) {
  std::vector<int> rows, columns;
  std::vector<double> values;
  for (int i = 0; i < matrix.outerSize(); ++i) {
    for (musclewarp::SparseMatrix::InnerIterator entry(matrix, i); entry;
         ++entry) {
      rows.push_back(static_cast<int>(entry.row()));
      columns.push_back(static_cast<int>(entry.col()));
      values.push_back(entry.value());
    }
  }
  archive(static_cast<std::int64_t>(matrix.rows()),
          static_cast<std::int64_t>(matrix.cols()),
          rows,
          columns,
          values);
}

template <class Archive>
void load(Archive& archive, musclewarp::SparseMatrix& matrix) {
  std::int64_t num_rows, num_columns;
  std::vector<int> rows, columns;
  std::vector<double> values;
  archive(num_rows, num_columns, rows, columns, values);
  std::vector<Eigen::Triplet<double>> entries;
  for (size_t i = 0; i < values.size(); ++i) {
    entries.emplace_back(rows[i], columns[i], values[i]);
  }
  matrix.resize(num_rows, num_columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
}

}  // namespace cereal

namespace musclewarp {

MUSCLEWARP_ARCHIVE(TriangleSoup, points, triangles)
MUSCLEWARP_ARCHIVE(LineTie, other, stiffness)
MUSCLEWARP_ARCHIVE(LineSupports,
                   bends,
                   loads,
                   stiffness,
                   outward,
                   plane_stiffness,
                   hold,
                   onset,
                   plane_onset,
                   ties)
MUSCLEWARP_ARCHIVE(
    ActionLine, name, rest, bodies, slides, bare_begin, bare_end, supports)
MUSCLEWARP_ARCHIVE(
    Attachment, body, soft_part, points, radius, is_outline, may_penetrate)
MUSCLEWARP_ARCHIVE(SceneMuscle,
                   name,
                   points,
                   triangles,
                   lines,
                   attachments,
                   ends_on,
                   end_bodies,
                   mesh_path,
                   mm_per_unit,
                   is_turned,
                   delivered_volume)
MUSCLEWARP_ARCHIVE(SceneBone,
                   name,
                   points,
                   triangles,
                   body,
                   mesh_path,
                   rest_from_file,
                   is_turned,
                   is_of_model)
MUSCLEWARP_ARCHIVE(ExemptArea, muscle, bone, vertices, triangles)

// Repairs of a mesh.

MUSCLEWARP_ARCHIVE(MeshDefects,
                   duplicate_points,
                   unreferenced_points,
                   degenerate_triangles,
                   duplicate_triangles,
                   border_edges,
                   border_length,
                   non_manifold_edges,
                   non_manifold_vertices,
                   misoriented_edges,
                   components,
                   is_inside_out,
                   is_closed_manifold)
MUSCLEWARP_ARCHIVE(PointMerges, merged, longest)
MUSCLEWARP_ARCHIVE(Separation, edges, copies)
MUSCLEWARP_ARCHIVE(Stitches, merged_points, inserted_points, longest)
MUSCLEWARP_ARCHIVE(
    Fillings, holes, missing_faces, triangles, points, area, longest)
MUSCLEWARP_ARCHIVE(Pulls, points, longest)
MUSCLEWARP_ARCHIVE(
    DroppedPiece, reason, triangles, area, share, volume, place, cavity)
MUSCLEWARP_ARCHIVE(RepairReport,
                   point_merges,
                   degenerate_triangles,
                   duplicate_triangles,
                   flipped_triangles,
                   separation,
                   stitches,
                   fillings,
                   separated_vertices,
                   pieces,
                   dropped_pieces,
                   dropped_points,
                   pulls)
MUSCLEWARP_ARCHIVE(SelfCrossingRemoval,
                   pairs_before,
                   pairs_after,
                   new_vertices,
                   place,
                   farthest)
MUSCLEWARP_ARCHIVE(SliverRemovals,
                   collapsed_edges,
                   flipped_edges,
                   slivers_left,
                   largest_deviation)
MUSCLEWARP_ARCHIVE(SurfaceReconstruction,
                   is_done,
                   reason,
                   volume_before,
                   volume_after,
                   lost_area,
                   place,
                   farthest,
                   gone_area,
                   lost_extent,
                   lost_attachments)
MUSCLEWARP_ARCHIVE(MeshPreparation,
                   name,
                   path,
                   defects,
                   repairs,
                   self_crossings,
                   slivers,
                   reconstruction,
                   drawn_out_triangles,
                   delivered_volume,
                   notes)

// Prepared scenes.

MUSCLEWARP_ARCHIVE(SegmentPoint, line, segment, t)
MUSCLEWARP_ARCHIVE(
    GuidePath, lines, shares, places, rest_length, compliance, half_borne)
MUSCLEWARP_ARCHIVE(Guides, rule, lines, paths)
MUSCLEWARP_ARCHIVE(RotationField, places, weights)
MUSCLEWARP_ARCHIVE(SoftCarrier, muscle, lines, guides, field, from_coarse)
MUSCLEWARP_ARCHIVE(BendingRows, from_coarse, weights, points, rest, field)
MUSCLEWARP_ARCHIVE(EmbeddedLines, from_coarse, starts)
MUSCLEWARP_ARCHIVE(AttachedVertices, vertices, attachment)
MUSCLEWARP_ARCHIVE(FineMap, weights, corrected, corrections)
// The normal matrix and the push of bones are computed from the other fields.
MUSCLEWARP_ARCHIVE_WITHOUT(MuscleModel,
                           (normal_matrix, bone_push),
                           name,
                           lines,
                           guides,
                           attachments,
                           carriers,
                           fine_rest,
                           fine_triangles,
                           coarse_rest,
                           coarse_triangles,
                           fine_from_coarse,
                           weights,
                           laplacian,
                           laplacian_rest,
                           rotations,
                           skeleton,
                           samples,
                           skeleton_weights,
                           attachment,
                           attachment_of,
                           attachment_rest,
                           attachment_weights,
                           bending,
                           rest_volume,
                           coarse_rest_volume,
                           rest_area)
MUSCLEWARP_ARCHIVE(LineEnd, body, distance)
MUSCLEWARP_ARCHIVE(
    BareTendon, is_at_origin, body, bone, landmark, length, evidence)
MUSCLEWARP_ARCHIVE(PreparedMuscle,
                   mesh,
                   model,
                   attached,
                   area_on_bones,
                   lines_through,
                   tied_to,
                   is_tendon,
                   line_ends,
                   bare_tendons,
                   missed_bones,
                   attachment_warnings,
                   hull_encloses,
                   lines,
                   fibres,
                   fibres_ms)
MUSCLEWARP_ARCHIVE_WITHOUT(
    PreparedBone, (trees), mesh, body, rest, left_out, delivered_only)
MUSCLEWARP_ARCHIVE(PairFigures,
                   a,
                   b,
                   triangle_pairs,
                   vertices_inside,
                   max_depth_mm,
                   exempt_pairs,
                   place,
                   triangles_of_a,
                   triangles_of_b,
                   muscle_a,
                   muscle_b)
MUSCLEWARP_ARCHIVE(
    MeshGap, a, b, at_least_mm, at_most_mm, place, muscle_a, muscle_b)
MUSCLEWARP_ARCHIVE(SceneIntersections,
                   triangle_pairs,
                   vertices_inside,
                   max_depth_mm,
                   self_pairs,
                   exempt_pairs,
                   self_pairs_of_muscles,
                   pairs,
                   gaps,
                   inside_of_muscles)
MUSCLEWARP_ARCHIVE(BoneCrossing, a, b, triangle_pairs, place)
// The caller provides the scene itself, and times are those of the reading run.
MUSCLEWARP_ARCHIVE_WITHOUT(PreparedScene,
                           (scene, is_cached, wall_ms, stages),
                           muscles,
                           bones,
                           exempt,
                           bone_crossings,
                           warnings,
                           as_delivered,
                           memory_needed)

// The separated rest pose.

MUSCLEWARP_ARCHIVE_WITHOUT(
    RestResult, (wall_ms), state, intersections, displaced, reconstructed)

}  // namespace musclewarp
