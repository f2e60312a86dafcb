// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/label_surface.h"

#include <glog/logging.h>
#include <vtkCellArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/geometry/remeshing.h"
#include "musclewarp/label_images/thin_parts.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/mesh/triangle.h"
#include "musclewarp/mesh_repair/repair.h"

namespace musclewarp {
namespace {

constexpr double kSmoothing = 0.7;  // standard deviation, voxels

// The Gaussian is cut off there: 3e-5 of it lies beyond.
constexpr double kSmoothingReach = 4;  // standard deviations

// The range of levels. Beyond it the surface is more than a voxel off.
constexpr double kLowestLevel = 0.15, kHighestLevel = 0.85;
constexpr int kLevelSteps = 12;
constexpr double kVolumeAccuracy = 2e-4;

// The amount by which the voxels of thin parts are raised above the level: a
// tendon of one voxel, next to which the smoothed region has the value 0.1,
// then becomes 0.8 voxels thick.
constexpr double kRaised = 0.25;

// The largest share of a region that may be lost.
constexpr double kMostLost = 0.5;

// The steps that restore the volume after remeshing. Each leaves a few per cent
// of the error.
constexpr int kVolumeSteps = 3;

// Returns the smoothed region: 1 deep inside, 0 far outside.
vtkSmartPointer<vtkImageData> Smoothed(const LabelRegion& region) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(region.size[0], region.size[1], region.size[2]);
  image->AllocateScalars(VTK_FLOAT, 1);
  float* values = static_cast<float*>(image->GetScalarPointer());
  for (std::size_t at = 0; at < region.is_inside.size(); ++at) {
    values[at] = region.is_inside[at] ? 1.F : 0.F;
  }
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputData(image);
  smooth->SetDimensionality(3);
  smooth->SetStandardDeviations(kSmoothing, kSmoothing, kSmoothing);
  smooth->SetRadiusFactors(kSmoothingReach, kSmoothingReach, kSmoothingReach);
  smooth->Update();
  return smooth->GetOutput();
}

// Returns the level set of an image, outward oriented, in voxels from the first
// voxel of the region.
TriangleSoup LevelSet(vtkImageData* image, double level) {
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, level);
  edges->ComputeNormalsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  vtkPolyData* output = edges->GetOutput();
  TriangleSoup soup;
  soup.points.resize(output->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i) {
    output->GetPoint(i, soup.points.row(i).data());
  }
  soup.triangles.resize(output->GetNumberOfPolys(), 3);
  vtkCellArray* cells = output->GetPolys();
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  cells->InitTraversal();
  for (int f = 0; cells->GetNextCell(count, corners); ++f) {
    for (int c = 0; c < 3; ++c) {
      soup.triangles(f, c) = static_cast<int>(corners[c]);
    }
  }
  if (SignedVolume(soup.points, soup.triangles) < 0) {
    soup.triangles.col(1).swap(soup.triangles.col(2));
  }
  return soup;
}

// A level of a smoothed region, and its surface.
struct Level {
  double value = 0.5;
  TriangleSoup soup;
};

// Returns the level set with the volume of the voxels, as nearly as levels
// permit. A higher level has a smaller volume.
Level LevelWithVolume(vtkImageData* image, double volume) {
  double low = kLowestLevel, high = kHighestLevel;
  Level level;
  for (int step = 0; step < kLevelSteps; ++step) {
    level.soup = LevelSet(image, level.value);
    const double error =
        SignedVolume(level.soup.points, level.soup.triangles) / volume - 1;
    if (std::abs(error) < kVolumeAccuracy) break;
    (error > 0 ? low : high) = level.value;
    level.value = (low + high) / 2;
  }
  return level;
}

// Returns the level set with this volume that includes thin parts, whose voxels
// are raised above the level.
TriangleSoup LevelSetWithThinParts(const LabelRegion& region) {
  const double volume = static_cast<double>(region.voxels);
  const vtkSmartPointer<vtkImageData> image = Smoothed(region);
  float* values = static_cast<float*>(image->GetScalarPointer());
  Level level = LevelWithVolume(image, volume);
  const std::vector<std::int64_t> cut_off =
      VoxelsCutOff(region, values, level.value);
  if (cut_off.empty()) return std::move(level.soup);
  for (const std::int64_t at : cut_off) {
    values[at] =
        std::max(values[at], static_cast<float>(level.value + kRaised));
  }
  image->Modified();
  return LevelWithVolume(image, volume).soup;
}

// Moves all vertices along their normals by a common distance, so that the mesh
// has the given volume.
void RestoreVolume(double volume, TriangleSoup* soup) {
  for (int step = 0; step < kVolumeSteps; ++step) {
    Points normals = Points::Zero(soup->points.rows(), 3);
    for (Eigen::Index f = 0; f < soup->triangles.rows(); ++f) {
      const Eigen::RowVector3i triangle = soup->triangles.row(f);
      const Eigen::RowVector3d area =
          AreaVector(CornersOf(soup->points, triangle));
      for (int c = 0; c < 3; ++c) normals.row(triangle[c]) += area;
    }
    normals.rowwise().normalize();
    const double distance =
        (volume - SignedVolume(soup->points, soup->triangles)) /
        SurfaceArea(soup->points, soup->triangles);
    soup->points += distance * normals;
  }
}

}  // namespace

LabelSurface SurfaceOfRegion(const std::string& where,
                             const LabelRegion& region,
                             const ImageGrid& grid,
                             double edge_length) {
  CHECK_GT(edge_length, 0);
  if (region.voxels < kFewestVoxels) {
    throw InputError(where,
                     "has " + std::to_string(region.voxels) +
                         " voxels in one piece; allowed: at least 64",
                     "remove it from the image, or from the table of labels");
  }
  TriangleSoup soup = LevelSetWithThinParts(region);
  soup.points.rowwise() += region.first.cast<double>().matrix().transpose();
  soup.points = Transformed(soup.points, grid.world_from_index);
  if (grid.world_from_index.topLeftCorner<3, 3>().determinant() < 0) {
    soup.triangles.col(1).swap(soup.triangles.col(2));
  }
  soup = RepairMesh(soup, where, RepairOptions(), nullptr);
  const double all = static_cast<double>(region.voxels) * grid.VoxelVolume();
  LabelSurface surface;
  surface.volume = SignedVolume(soup.points, soup.triangles);
  surface.lost_volume = std::max(0.0, all - surface.volume);
  if (surface.lost_volume > kMostLost * all) {
    throw InputError(where,
                     "is so thin that no closed surface holds half of it",
                     "remove it from the image, or make it thicker");
  }
  surface.mesh =
      RemeshedWithoutCrossings(soup, edge_length, [&](TriangleSoup* even) {
        RestoreVolume(surface.volume, even);
      });
  surface.volume = SignedVolume(surface.mesh.points, surface.mesh.triangles);
  return surface;
}

}  // namespace musclewarp
