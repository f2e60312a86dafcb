// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How cereal writes and reads everything that a preparation consists of, for
// preparation_cache.cc. Each struct is taken apart into all of its fields, so
// that this file does not compile once a field is added and forgotten here.

#include <cereal/types/map.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <cstdint>

#include "musclewarp/motion/frame_solver.h"
#include "musclewarp/motion/prepared_scene.h"

namespace cereal {

template <class Archive, class T, int R, int C, int O, int MR, int MC>
void save(Archive& archive, const Eigen::Matrix<T, R, C, O, MR, MC>& matrix) {
  archive(static_cast<std::int64_t>(matrix.rows()),
          static_cast<std::int64_t>(matrix.cols()),
          binary_data(matrix.data(), matrix.size() * sizeof(T)));
}

template <class Archive, class T, int R, int C, int O, int MR, int MC>
void load(Archive& archive, Eigen::Matrix<T, R, C, O, MR, MC>& matrix) {
  std::int64_t rows, columns;
  archive(rows, columns);
  matrix.resize(rows, columns);
  archive(binary_data(matrix.data(), matrix.size() * sizeof(T)));
}

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

template <class Archive>
void serialize(Archive& archive, TriangleSoup& soup) {
  auto& [points, triangles] = soup;
  archive(points, triangles);
}

template <class Archive>
void serialize(Archive& archive, ActionLine& line) {
  auto& [name, rest, bodies, slides] = line;
  archive(name, rest, bodies, slides);
}

template <class Archive>
void serialize(Archive& archive, Attachment& attachment) {
  auto& [body, points, radius, may_penetrate] = attachment;
  archive(body, points, radius, may_penetrate);
}

template <class Archive>
void serialize(Archive& archive, SceneMuscle& muscle) {
  auto& [name, points, triangles, lines, attachments, path] = muscle;
  archive(name, points, triangles, lines, attachments, path);
}

template <class Archive>
void serialize(Archive& archive, SceneBone& bone) {
  auto& [name, points, triangles, body, path, rest_from_file] = bone;
  archive(name, points, triangles, body, path, rest_from_file);
}

template <class Archive>
void serialize(Archive& archive, ScenePose& pose) {
  auto& [name, time, coordinates, bodies, lines, values, lengths] = pose;
  archive(name, time, coordinates, bodies, lines, values, lengths);
}

template <class Archive>
void serialize(Archive& archive, ExemptArea& area) {
  auto& [muscle, bone, vertices, triangles] = area;
  archive(muscle, bone, vertices, triangles);
}

// What was done to a mesh.

template <class Archive>
void serialize(Archive& archive, MeshDefects& defects) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l] = defects;
  archive(a, b, c, d, e, f, g, h, i, j, k, l);
}

template <class Archive>
void serialize(Archive& archive, PointMerges& merges) {
  auto& [merged, longest] = merges;
  archive(merged, longest);
}

template <class Archive>
void serialize(Archive& archive, Separation& separation) {
  auto& [edges, copies] = separation;
  archive(edges, copies);
}

template <class Archive>
void serialize(Archive& archive, Stitches& stitches) {
  auto& [merged, inserted, longest] = stitches;
  archive(merged, inserted, longest);
}

template <class Archive>
void serialize(Archive& archive, Fillings& fillings) {
  auto& [holes, triangles, points, area, longest] = fillings;
  archive(holes, triangles, points, area, longest);
}

template <class Archive>
void serialize(Archive& archive, Pulls& pulls) {
  auto& [points, longest] = pulls;
  archive(points, longest);
}

template <class Archive>
void serialize(Archive& archive, RepairReport& report) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = report;
  archive(a, b, c, d, e, f, g, h, i, j, k, l, m, n);
}

template <class Archive>
void serialize(Archive& archive, SelfCrossingRemoval& removal) {
  auto& [before, after, vertices, place, farthest] = removal;
  archive(before, after, vertices, place, farthest);
}

template <class Archive>
void serialize(Archive& archive, SliverRemovals& removals) {
  auto& [collapsed, flipped, left, deviation] = removals;
  archive(collapsed, flipped, left, deviation);
}

template <class Archive>
void serialize(Archive& archive, Remaking& remaking) {
  auto& [is_done, before, after, lost, place, farthest] = remaking;
  archive(is_done, before, after, lost, place, farthest);
}

template <class Archive>
void serialize(Archive& archive, MeshPreparation& mesh) {
  auto& [a, b, c, d, e, f, g] = mesh;
  archive(a, b, c, d, e, f, g);
}

// Prepared scenes.

template <class Archive>
void serialize(Archive& archive, SegmentPoint& point) {
  auto& [line, segment, t] = point;
  archive(line, segment, t);
}

template <class Archive>
void serialize(Archive& archive, CarriedLines& lines) {
  auto& [from_coarse, starts] = lines;
  archive(from_coarse, starts);
}

template <class Archive>
void serialize(Archive& archive, AttachedVertices& attached) {
  auto& [vertices, attachment] = attached;
  archive(vertices, attachment);
}

// But for the normal matrix, which follows from the others.
template <class Archive>
void serialize(Archive& archive, MuscleModel& model) {
  auto& [a,
         b,
         c,
         d,
         e,
         f,
         g,
         h,
         i,
         j,
         k,
         l,
         m,
         n,
         o,
         p,
         q,
         r,
         s,
         t,
         u,
         normal] = model;
  archive(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u);
}

template <class Archive>
void serialize(Archive& archive, PreparedMuscle& muscle) {
  auto& [a, b, c, d, e, f, g, h] = muscle;
  archive(a, b, c, d, e, f, g, h);
}

template <class Archive>
void serialize(Archive& archive, PreparedBone& bone) {
  auto& [mesh, body, rest] = bone;
  archive(mesh, body, rest);
}

template <class Archive>
void serialize(Archive& archive, PairIntersection& pair) {
  auto& [a, b, c, d, e, f, g, h, i] = pair;
  archive(a, b, c, d, e, f, g, h, i);
}

template <class Archive>
void serialize(Archive& archive, MeshGap& gap) {
  auto& [a, b, at_least, at_most, place] = gap;
  archive(a, b, at_least, at_most, place);
}

template <class Archive>
void serialize(Archive& archive, SceneIntersections& intersections) {
  auto& [a, b, c, d, e, f, g, h, i] = intersections;
  archive(a, b, c, d, e, f, g, h, i);
}

// But for the scene itself, which the caller has, and the times.
template <class Archive>
void serialize(Archive& archive, PreparedScene& prepared) {
  auto& [scene, muscles, bones, exempt, warnings, delivered, cached, ms, t] =
      prepared;
  archive(muscles, bones, exempt, warnings, delivered);
}

// The separated rest pose.

template <class Archive>
void serialize(Archive& archive, HeldVertices& held) {
  auto& [vertices, positions] = held;
  archive(vertices, positions);
}

template <class Archive>
void serialize(Archive& archive, VertexCorrections& corrections) {
  auto& [offset, coarse, fine] = corrections;
  archive(offset, coarse, fine);
}

template <class Archive>
void serialize(Archive& archive, MuscleState& state) {
  auto& [coarse, corrections] = state;
  archive(coarse, corrections);
}

template <class Archive>
void serialize(Archive& archive, SceneState& state) {
  auto& [pose, muscles, free_coarse] = state;
  archive(pose, muscles, free_coarse);
}

template <class Archive>
void serialize(Archive& archive, SeparatedRest& rest) {
  auto& [state, attached, intersections, displaced] = rest;
  archive(state, attached, intersections, displaced);
}

}  // namespace musclewarp
