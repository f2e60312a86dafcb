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

  // The volume of the mesh, and what of the region it lacks, mm^3: parts that
  // are so thin, or hang on the rest by so little, that the smoothed surface
  // does not hold them.
  double volume = 0;
  double lost_volume = 0;
};

// Returns the surface of a region in the frame of the image, with triangles
// whose edges are about `edge_length` mm long.
//
// The region is smoothed by a Gaussian of 0.7 voxels along each axis, which
// takes the stairs off, and the surface is where the smoothed region has a
// certain level (vtkImageGaussianSmooth, vtkFlyingEdges3D). Smoothing moves the
// level 0.5 inward where the surface is round; the level is therefore chosen
// such that the volume is that of the voxels. The usual pair of
// vtkDiscreteFlyingEdges3D and vtkWindowedSincPolyDataFilter cuts edges: on a
// flat muscle (the subscapularis at 1 mm) it loses 1.2 % of the volume. And a
// level of a smooth function does not cross itself.
//
// The triangles are then made even (RemeshedWithoutCrossings), and the vertices
// moved along their normals, all by the same small distance, to where the
// volume is that from before. Where a part is not thicker than an edge, as a
// tendon of two voxels, it keeps the small triangles of the level, so that none
// cross.
//
// Throws InputError with `where` as its place for a region with fewer than
// kFewestVoxels, and one that is so thin that half of it is lost. Precondition
// (CHECKed): the edge length is above zero.
LabelSurface SurfaceOfRegion(const std::string& where,
                             const LabelRegion& region,
                             const ImageGrid& grid,
                             double edge_length);

}  // namespace musclewarp
