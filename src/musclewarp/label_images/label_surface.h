// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/label_images/image_grid.h"
#include "musclewarp/label_images/label_regions.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The surface of a label.
struct LabelSurface {
  TriangleSoup mesh;  // mm, closed, outward oriented, one piece

  // The volume of the mesh, and the volume of the region that it lacks, mm^3:
  // parts that are too thin, or too thinly connected, for the smoothed surface
  // to include them.
  double volume = 0;
  double lost_volume = 0;
};

// Returns the surface of a region in the frame of the image, with triangles
// whose edges are about `edge_length` mm long.
//
// The region is smoothed by a Gaussian with a standard deviation of 0.7 voxels
// along each axis, which removes the staircase, and the surface is a level set
// of the smoothed region (vtkImageGaussianSmooth, vtkFlyingEdges3D). Smoothing
// moves the level 0.5 inward where the surface is convex; the level is
// therefore chosen so that the volume is that of the voxels. The usual pair of
// vtkDiscreteFlyingEdges3D and vtkWindowedSincPolyDataFilter cuts edges: it
// loses 1.2 % of the volume of a flat muscle (the subscapularis at 1 mm).
// Moreover, a level set of a smooth function does not cross itself.
//
// The triangles are then made uniform (RemeshedWithoutCrossings), and all
// vertices move along their normals by the same small distance, which restores
// the volume. A part that is no thicker than an edge, such as a tendon of two
// voxels, keeps the small triangles of the level set, so that none cross.
//
// Throws InputError, naming `where`, for a region with fewer than kFewestVoxels
// voxels, and for one that is so thin that half of it is lost. Precondition
// (CHECKed): the edge length is above zero.
LabelSurface SurfaceOfRegion(const std::string& where,
                             const LabelRegion& region,
                             const ImageGrid& grid,
                             double edge_length);

}  // namespace musclewarp
