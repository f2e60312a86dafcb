// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns the length of a polyline (#P x 3), mm. It is 0 for fewer than two
// points.
double PolylineLength(const Points& points);

// Returns for each point of a polyline (#P x 3) at which share of its length it
// lies: from 0 to 1, #P. All are 0 if the polyline has no length.
Eigen::VectorXd SharesAlong(const Points& points);

// Returns the largest angle by which the direction of a polyline (#P x 3) turns
// from a segment to the next, rad: pi where it goes back the way it came. It is
// 0 for fewer than three points; segments without a length do not count.
double SharpestTurn(const Points& points);

// Returns the points at these shares of the length of a polyline (#P x 3), #S x
// 3. Preconditions (CHECKed): the polyline has at least two points. The shares
// are from 0 to 1.
Points PointsAtShares(const Points& points, const Eigen::VectorXd& shares);

// Resamples a polyline (#P x 3): returns `count` points on it, count x 3, at
// equal distances along it. The first and the last one are its ends. The points
// between are not kept, so that corners are cut. Preconditions (CHECKed): the
// polyline has at least two points, and count is at least 2.
Points Resampled(const Points& points, int count);

}  // namespace musclewarp
