// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/attachments.h"

#include <algorithm>
#include <map>

#include "musclewarp/mesh/transformed.h"
#include "musclewarp/mesh/triangle.h"
#include "musclewarp/scene/attachment_area.h"

namespace musclewarp {

AttachedVertices FindAttachedVertices(
    const std::vector<Attachment>& attachments, const Points& rest) {
  std::map<int, int> attachment_of;
  for (size_t a = 0; a < attachments.size(); ++a) {
    for (const int v : VerticesInArea(attachments[a], rest)) {
      attachment_of.emplace(v, static_cast<int>(a));
    }
  }
  AttachedVertices attached;
  for (const auto& [vertex, attachment] : attachment_of) {
    attached.vertices.push_back(vertex);
    attached.attachment.push_back(attachment);
  }
  return attached;
}

std::vector<double> AttachedAreas(const std::vector<Attachment>& attachments,
                                  const AttachedVertices& attached,
                                  const Points& points,
                                  const Triangles& triangles) {
  constexpr int kNone = -1;
  std::vector<int> attachment_of(points.rows(), kNone);
  for (size_t i = 0; i < attached.vertices.size(); ++i) {
    attachment_of[attached.vertices[i]] = attached.attachment[i];
  }
  std::vector<double> areas(attachments.size(), 0);
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    const double area =
        AreaVector(CornersOf(points, triangles.row(f))).norm() / 2;
    for (const int v : triangles.row(f)) {
      if (attachment_of[v] != kNone) areas[attachment_of[v]] += area / 3;
    }
  }
  return areas;
}

Points AttachedPositions(const MuscleModel& model,
                         const AttachedVertices& attached,
                         const Points& rest,
                         const ScenePose& pose) {
  std::vector<Eigen::Matrix4d> transforms;
  for (size_t a = 0; a < model.attachments.size(); ++a) {
    transforms.push_back(AttachmentTransform(model, static_cast<int>(a), pose));
  }
  Points positions(rest.rows(), 3);
  for (Eigen::Index i = 0; i < rest.rows(); ++i) {
    positions.row(i) =
        Transformed(rest.row(i), transforms[attached.attachment[i]]);
  }
  return positions;
}

std::vector<AttachmentDrift> DriftOf(const std::vector<Attachment>& attachments,
                                     const AttachedVertices& attached,
                                     const Points& positions,
                                     const Points& points) {
  std::vector<AttachmentDrift> drifts;
  for (const Attachment& attachment : attachments) {
    drifts.emplace_back().body = NameOfCarrier(attachment);
  }
  for (size_t i = 0; i < attached.vertices.size(); ++i) {
    AttachmentDrift& drift = drifts[attached.attachment[i]];
    const double distance =
        (points.row(attached.vertices[i]) - positions.row(i)).norm();
    ++drift.vertices;
    drift.mean += distance;
    if (distance < drift.max) continue;
    drift.max = distance;
    drift.place = points.row(attached.vertices[i]);
  }
  for (AttachmentDrift& drift : drifts) {
    if (drift.vertices > 0) drift.mean /= drift.vertices;
  }
  return drifts;
}

}  // namespace musclewarp
