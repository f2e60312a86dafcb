// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/fibres.h"

#include <glog/logging.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/invalid_option.h"
#include "musclewarp/fibres/laplacian_flow.h"
#include "musclewarp/fibres/voxel_grid.h"
#include "musclewarp/geometry/inside_test.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

// Smooths out the steps that voxels leave in a course, and keeps its ends.
void Smooth(int rounds, Points* line) {
  for (int round = 0; round < rounds; ++round) {
    const Points before = *line;
    for (Eigen::Index i = 1; i + 1 < line->rows(); ++i) {
      line->row(i) =
          (before.row(i - 1) + 2 * before.row(i) + before.row(i + 1)) / 4;
    }
  }
}

// Corners of voxels stick out of the surface, and smoothing may cut a bend. So
// points outside are moved towards the centre of their voxel, which is inside.
void PullInside(const VoxelGrid& grid, const InsideTest& inside, Points* line) {
  constexpr double kPart = 0.2;
  for (Eigen::Index i = 0; i < line->rows(); ++i) {
    if (inside.Contains(line->row(i))) continue;
    const int voxel = grid.Nearest(line->row(i));
    if (voxel < 0) continue;
    const Eigen::RowVector3d center = grid.Center(voxel);
    const Eigen::RowVector3d outside = line->row(i);
    for (double part = kPart; part < 1 + kPart / 2; part += kPart) {
      line->row(i) = outside + std::min(1.0, part) * (center - outside);
      if (inside.Contains(line->row(i))) break;
    }
  }
}

struct Courses {
  MuscleEnds ends;
  std::vector<Points> lines;
};

// Returns `count` courses from origin to insertion with `points` points each.
Courses FindCourses(const TriangleSoup& muscle,
                    const std::vector<BodySurface>& bodies,
                    const std::vector<Attachment>& attachments,
                    int count,
                    int points,
                    int voxels) {
  constexpr int kFine = 4;  // points smoothed for one that is kept
  constexpr int kRounds = 4;
  constexpr int kFewest = 20;  // voxels that a course can run through
  const VoxelGrid grid = Voxelize(muscle, voxels);
  Courses courses;
  if (grid.num_voxels() < kFewest) return courses;
  courses.ends = FindMuscleEnds(muscle, grid, bodies, attachments);
  const LaplacianFlow flow = SolveFlow(
      grid, courses.ends.origin.voxels, courses.ends.insertion.voxels);
  const InsideTest inside(muscle.points, muscle.triangles, /*seed=*/1);
  const Points seeds = SpreadOverSection(flow, count);
  for (Eigen::Index i = 0; i < seeds.rows(); ++i) {
    Points line = StreamLine(flow, seeds.row(i));
    if (line.rows() < 2) continue;
    line = Resampled(line, kFine * (points - 1) + 1);
    Smooth(kRounds, &line);
    line = Resampled(line, points);
    PullInside(grid, inside, &line);
    courses.lines.push_back(std::move(line));
  }
  return courses;
}

// Returns the bodies of the points of a line: first that of the origin, then
// perhaps one between, then that of the insertion. The sum of the distances of
// the points from their bodies is as small as it can be.
std::vector<std::string> BodiesAlong(const Points& line,
                                     const MuscleEnds& ends,
                                     const std::vector<BodySurface>& bodies) {
  const int count = static_cast<int>(line.rows());
  const auto distances_to = [&](const std::string& name) {
    Eigen::VectorXd distances = Eigen::VectorXd::Zero(count);
    for (const BodySurface& body : bodies) {
      if (body.body != name) continue;
      for (int i = 0; i < count; ++i) distances[i] = body.Distance(line.row(i));
    }
    return distances;
  };
  const Eigen::VectorXd to_origin = distances_to(ends.origin.body);
  const Eigen::VectorXd to_insertion = distances_to(ends.insertion.body);
  std::vector<std::string> best;
  double least = std::numeric_limits<double>::infinity();
  for (const BodySurface& between : bodies) {
    const Eigen::VectorXd to_between = distances_to(between.body);
    // Points below i follow the origin, those from k on the insertion.
    for (int i = 1; i < count; ++i) {
      for (int k = i; k < count; ++k) {
        const double sum = to_origin.head(i).sum() +
                           to_between.segment(i, k - i).sum() +
                           to_insertion.tail(count - k).sum();
        if (sum >= least) continue;
        least = sum;
        best.assign(count, between.body);
        std::fill(best.begin(), best.begin() + i, ends.origin.body);
        std::fill(best.begin() + k, best.end(), ends.insertion.body);
      }
    }
  }
  return best;
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
                               const std::vector<Attachment>& attachments,
                               const FibreOptions& options) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  return FindCourses(muscle,
                     bodies,
                     attachments,
                     options.fibres,
                     options.segments + 1,
                     options.voxels)
      .lines;
}

std::vector<ActionLine> MakeLines(const std::string& name,
                                  const TriangleSoup& muscle,
                                  const std::vector<BodySurface>& bodies,
                                  const std::vector<Attachment>& attachments,
                                  int count) {
  CHECK_GT(count, 0);
  if (bodies.empty()) {
    throw InputError(
        "muscle " + name,
        "has no lines, and the scene has no bones to make them from",
        "add \"bones\" or \"lines\"");
  }
  constexpr int kPoints = 5;
  const Courses courses = FindCourses(
      muscle, bodies, attachments, count, kPoints, FibreOptions().voxels);
  std::vector<ActionLine> lines;
  for (const Points& course : courses.lines) {
    ActionLine line;
    line.name = name + "_" + std::to_string(lines.size() + 1);
    line.rest = course;
    line.bodies = BodiesAlong(course, courses.ends, bodies);
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
