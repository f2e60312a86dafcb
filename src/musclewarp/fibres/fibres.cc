// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/fibres.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/invalid_option.h"
#include "musclewarp/fibres/bodies_along.h"
#include "musclewarp/fibres/laplacian_flow.h"
#include "musclewarp/fibres/voxel_grid.h"
#include "musclewarp/proximity/inside_test.h"
#include "musclewarp/proximity/triangle_bvh.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

// The points of the shortest lines that are made.
constexpr int kFewestPoints = 9;

// Smooths out the steps of the voxels in a line. Its ends stay fixed.
void Smooth(int rounds, Points* line) {
  for (int round = 0; round < rounds; ++round) {
    const Points before = *line;
    for (Eigen::Index i = 1; i + 1 < line->rows(); ++i) {
      line->row(i) =
          (before.row(i - 1) + 2 * before.row(i) + before.row(i + 1)) / 4;
    }
  }
}

// Returns a point inside the muscle between the point `out` outside and the
// point `in` inside, as near to `out` as bisection reaches.
Eigen::RowVector3d InsideBetween(const InsideTest& inside,
                                 Eigen::RowVector3d out,
                                 Eigen::RowVector3d in) {
  constexpr int kBisections = 10;
  for (int i = 0; i < kBisections; ++i) {
    const Eigen::RowVector3d middle = (out + in) / 2;
    (inside.Contains(middle) ? in : out) = middle;
  }
  return in;
}

// Moves points outside the muscle towards the centre of their voxel until they
// are inside: voxels extend beyond the surface, and smoothing may cut a bend.
// Where the muscle is thinner than a voxel, points of fibres move along the
// fibre, and points of lines, which extend to the tips, move to the surface.
void PullInside(const VoxelGrid& grid,
                const InsideTest& inside,
                const TriangleBvh& surface,
                bool reaches_tips,
                Points* line) {
  const auto pull = [&](Eigen::Index i, Eigen::Index neighbour) {
    const Eigen::RowVector3d outside = line->row(i);
    if (inside.Contains(outside)) return;
    const int voxel = grid.Nearest(outside);
    if (voxel < 0) return;
    const Eigen::RowVector3d center = grid.Center(voxel);
    const Eigen::RowVector3d beside = line->row(neighbour);
    if (inside.Contains(center)) {
      line->row(i) = InsideBetween(inside, outside, center);
    } else if (!reaches_tips && inside.Contains(beside)) {
      line->row(i) = InsideBetween(inside, outside, beside);
    } else {
      line->row(i) = surface.ClosestPoint(outside).point;
    }
  };
  const Eigen::Index last = line->rows() - 1;
  for (Eigen::Index i = 1; i < last; ++i) pull(i, i - 1);
  pull(0, 1);
  pull(last, last - 1);
}

// Returns a path from `start` to the tip at which the distance (one per voxel,
// mm) from the other end of the muscle is largest. The distance increases along
// it. The path consists of voxel centres in steps of at most two cells, so that
// it does not stop at a bump of the surface.
Points WayToTip(const VoxelGrid& grid,
                const Eigen::RowVector3d& start,
                const Eigen::VectorXd& distance) {
  constexpr int kStep = 2;
  constexpr double kLongest =
      1.2;  // ratio of path length in voxels to straight distance
  std::vector<Eigen::RowVector3d> way;
  for (int here = grid.Nearest(start), next = -1; here >= 0; here = next) {
    next = -1;
    double most = distance[here];
    for (const int voxel : grid.Around(here, kStep)) {
      const double apart = (grid.Center(voxel) - grid.Center(here)).norm();
      // A voxel that is near but a long way off through the muscle is in
      // another part of it.
      if (distance[voxel] <= most ||
          distance[voxel] - distance[here] > kLongest * apart) {
        continue;
      }
      most = distance[voxel];
      next = voxel;
    }
    if (next >= 0) way.push_back(grid.Center(next));
  }
  Points points(way.size(), 3);
  for (size_t i = 0; i < way.size(); ++i) points.row(i) = way[i];
  return points;
}

// Returns the concatenation of polylines.
Points Concatenated(const std::vector<Points>& lines) {
  Eigen::Index count = 0;
  for (const Points& line : lines) count += line.rows();
  Points together(count, 3);
  Eigen::Index row = 0;
  for (const Points& line : lines) {
    together.middleRows(row, line.rows()) = line;
    row += line.rows();
  }
  return together;
}

// Drops fibres that are shorter than a tenth of the median: where the two ends
// are close to each other, short lines would count as fibres without moment
// arms.
void DropShort(std::vector<Points>* lines) {
  constexpr double kShortest = 0.1;  // of the median
  std::vector<double> lengths;
  for (const Points& line : *lines) lengths.push_back(PolylineLength(line));
  if (lengths.empty()) return;
  const auto middle = lengths.begin() + lengths.size() / 2;
  std::nth_element(lengths.begin(), middle, lengths.end());
  const double shortest = kShortest * *middle;
  lines->erase(std::remove_if(lines->begin(),
                              lines->end(),
                              [&](const Points& line) {
                                return PolylineLength(line) < shortest;
                              }),
               lines->end());
}

struct Courses {
  MuscleEnds ends;
  std::vector<Points> lines;
};

struct CourseOptions {
  int count;
  int smoothed;  // points of a course, on which its smoothing depends
  int voxels;

  // The points of each course; without a value as many as NumLinePoints().
  std::optional<int> points;

  // If true, a course continues through the ends of the muscle to the tips.
  bool reaches_tips;
};

// Returns fibres or lines from the origin to the insertion.
Courses FindCourses(const TriangleSoup& muscle,
                    const std::vector<BodySurface>& bodies,
                    const KnownEnds& known,
                    const CourseOptions& options) {
  constexpr int kFine = 4;  // points during smoothing per final point
  constexpr int kRounds = 4;
  constexpr int kFewest = 20;  // voxels of a muscle that is not too thin
  const VoxelGrid grid = Voxelize(muscle, options.voxels);
  Courses courses;
  if (grid.num_voxels() < kFewest) return courses;
  courses.ends = FindMuscleEnds(
      muscle,
      grid,
      bodies,
      known,
      options.reaches_tips ? EndExtent::kFarPart : EndExtent::kClearOfOther);
  const LaplacianFlow flow = SolveFlow(
      grid, courses.ends.origin.voxels, courses.ends.insertion.voxels);
  const InsideTest inside(muscle.points, muscle.triangles, /*seed=*/1);
  const TriangleBvh surface(muscle.points, muscle.triangles);
  const Points seeds = SpreadOverSection(flow, options.count);
  Eigen::VectorXd to_origin, to_insertion;
  if (options.reaches_tips) {
    to_origin = DistancesWithin(grid, courses.ends.origin.voxels);
    to_insertion = DistancesWithin(grid, courses.ends.insertion.voxels);
  }
  for (Eigen::Index i = 0; i < seeds.rows(); ++i) {
    Points line = StreamLine(flow, seeds.row(i));
    if (line.rows() < 2) continue;
    if (options.reaches_tips) {
      line = Concatenated(
          {WayToTip(grid, line.row(0), to_insertion).colwise().reverse(),
           line,
           WayToTip(grid, line.row(line.rows() - 1), to_origin)});
    }
    line = Resampled(line, kFine * (options.smoothed - 1) + 1);
    Smooth(kRounds, &line);
    courses.lines.push_back(std::move(line));
  }
  if (courses.lines.empty()) return courses;
  const int points =
      options.points ? *options.points : NumLinePoints(courses.lines);
  for (Points& line : courses.lines) {
    line = Resampled(line, points);
    PullInside(grid, inside, surface, options.reaches_tips, &line);
  }
  DropShort(&courses.lines);
  return courses;
}

}  // namespace

bool FibreOptions::IsValid(std::string* error) const {
  if (fibres < 0) {
    return InvalidOption("FibreOptions::fibres", fibres, "0 or above", error);
  }
  if (segments < 1) {
    return InvalidOption(
        "FibreOptions::segments", segments, "1 or above", error);
  }
  if (voxels < 100) {
    return InvalidOption("FibreOptions::voxels", voxels, "100 or above", error);
  }
  return true;
}

std::vector<Points> MakeFibres(const TriangleSoup& muscle,
                               const std::vector<BodySurface>& bodies,
                               const KnownEnds& known,
                               const FibreOptions& options) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  return FindCourses(muscle,
                     bodies,
                     known,
                     {options.fibres,
                      options.segments + 1,
                      options.voxels,
                      options.segments + 1,
                      /*reaches_tips=*/false})
      .lines;
}

int NumLinePoints(const std::vector<Points>& lines) {
  constexpr double kSpacing = 10;  // mm
  CHECK(!lines.empty());
  double length = 0;
  for (const Points& line : lines) {
    length += PolylineLength(line) / static_cast<double>(lines.size());
  }
  return std::max(kFewestPoints,
                  static_cast<int>(std::lround(length / kSpacing)) + 1);
}

std::vector<ActionLine> MakeLines(const std::string& name,
                                  const TriangleSoup& muscle,
                                  const std::vector<BodySurface>& bodies,
                                  const std::vector<Attachment>& attachments,
                                  int count,
                                  LinePoints points) {
  CHECK_GT(count, 0);
  if (bodies.empty()) {
    throw InputError(
        "muscle " + name,
        "has no lines, and the scene has no bones to make them from",
        "add \"bones\" or \"lines\"");
  }
  CourseOptions options = {
      count, kFewestPoints, FibreOptions().voxels, {}, attachments.empty()};
  if (points == LinePoints::kNine) options.points = kFewestPoints;
  const Courses courses =
      FindCourses(muscle, bodies, {attachments, {}}, options);
  std::vector<ActionLine> lines;
  for (const Points& course : courses.lines) {
    ActionLine line;
    line.name = name + "_" + std::to_string(lines.size() + 1);
    line.rest = course;
    line.bodies = BodiesAlong(
        course, courses.ends.origin.body, courses.ends.insertion.body, bodies);
    line.slides = true;
    lines.push_back(std::move(line));
  }
  if (lines.empty()) {
    throw InputError("muscle " + name,
                     "is too thin to make lines inside it",
                     "give it \"lines\"");
  }
  return lines;
}

}  // namespace musclewarp
