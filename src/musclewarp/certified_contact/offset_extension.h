// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

#include "musclewarp/certified_contact/muscle_surface.h"

namespace musclewarp {

// Extends the offsets of some vertices of a muscle to all others by minimizing
// the energy of relaxation.h without contact. This gives the shape under
// attachments alone, relative to which displacement by contact is measured.
//
//   const OffsetExtension extension(surface, attached_vertices, 8);
//   points += extension.Extended(offsets_of_attached_vertices);
class OffsetExtension {
 public:
  // `given`: the vertices with given offsets, in rising order. `length`: the
  // smoothing length, mm, above 0. Factorises a sparse matrix of the size of
  // the mesh.
  OffsetExtension(const MuscleSurface& surface,
                  const std::vector<int>& given,
                  double length);

  // Returns the offset of every vertex, #V x 3, mm. `given`: those of the given
  // vertices, #given x 3, mm.
  Points Extended(const Points& given) const;

 private:
  std::vector<int> given_, free_;
  Eigen::SparseMatrix<double> coupling_;  // #free x #given
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
};

}  // namespace musclewarp
