// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/certified_contact/plane_owner.h"
#include "musclewarp/solver/one_sided_rows.h"
#include "musclewarp/solver/shape_derivative.h"

namespace musclewarp {

// The one-sided rows with which contact had a muscle solved, and what the plane
// of each row goes along with. Muscles and bones are numbered as in the scene.
struct ContactRows {
  OneSidedRows rows;
  std::vector<PlaneOwner> owners;
};

// How a muscle that carries planes moves with a coordinate: its fine vertices,
// #V x 3, mm, and their derivatives beside the motion of a body.
struct MuscleCarrier {
  const Points* points = nullptr;
  const Points* rate = nullptr;
  Eigen::Matrix4d body = Eigen::Matrix4d::Zero();  // RateBetween
};

// How all bones and muscles do, those to which no row refers excepted, as seen
// from some body.
struct CarrierRates {
  std::vector<Eigen::Matrix4d> bones;
  std::vector<MuscleCarrier> muscles;
};

// Adds to `rate` how the planes of contact rows change with a coordinate.
// `places` are those of the vertices of the rows in the shape that they hold, K
// x 3, mm.
//
// The plane of a bone moves with it. A plane between two muscles turns and
// moves with both of its triangles, as contact would have it in a step
// (separating_planes.h, plane_set.h).
void AddPlaneRates(const ContactRows& contact,
                   const Points& places,
                   const CarrierRates& owners,
                   TargetRate* rate);

}  // namespace musclewarp
