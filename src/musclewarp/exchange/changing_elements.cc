// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/changing_elements.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// The quality of a tetrahedron with these corners.
double QualityAt(const std::array<RowVector3d, 4>& c) {
  if (!((c[1] - c[0]).cross(c[2] - c[0]).dot(c[3] - c[0]) > 0)) {
    return ChangingElements::kInverted;
  }
  std::array<RowVector3d, 4> normals;
  for (int f = 0; f < 4; ++f) {
    const int* const k = kFaceCorners[f];
    normals[f] = (c[k[1]] - c[k[0]]).cross(c[k[2]] - c[k[0]]).normalized();
  }
  double largest_cosine = -1;
  for (int i = 0; i < 4; ++i) {
    for (int k = i + 1; k < 4; ++k) {
      largest_cosine = std::max(largest_cosine, -normals[i].dot(normals[k]));
    }
  }
  return -largest_cosine;
}

}  // namespace

ChangingElements::ChangingElements(Eigen::Index surface_points,
                                   const TetrahedralMesh& mesh)
    : surface_points_(static_cast<int>(surface_points)),
      elements_of_(mesh.points.rows()) {
  for (Eigen::Index i = 0; i < mesh.points.rows(); ++i) {
    points_.push_back(mesh.points.row(i));
  }
  for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t) {
    Add({mesh.tetrahedra(t, 0),
         mesh.tetrahedra(t, 1),
         mesh.tetrahedra(t, 2),
         mesh.tetrahedra(t, 3)});
  }
}

TetrahedralMesh ChangingElements::Result() const {
  std::vector<int> number(points_.size(), -1);
  int count = 0;
  for (size_t v = 0; v < points_.size(); ++v) {
    const bool is_kept =
        static_cast<int>(v) < surface_points_ || !elements_of_[v].empty();
    if (is_kept) number[v] = count++;
  }
  TetrahedralMesh mesh;
  mesh.points.resize(count, 3);
  for (size_t v = 0; v < points_.size(); ++v) {
    if (number[v] >= 0) mesh.points.row(number[v]) = points_[v];
  }
  Eigen::Index rows = 0;
  for (const ElementCorners& corners : elements_) rows += corners[0] >= 0;
  mesh.tetrahedra.resize(rows, 4);
  Eigen::Index t = 0;
  for (const ElementCorners& corners : elements_) {
    if (corners[0] < 0) continue;
    for (int k = 0; k < 4; ++k) mesh.tetrahedra(t, k) = number[corners[k]];
    ++t;
  }
  return mesh;
}

double ChangingElements::QualityOf(const ElementCorners& c) const {
  return QualityAt(
      {points_[c[0]], points_[c[1]], points_[c[2]], points_[c[3]]});
}

void ChangingElements::Add(const ElementCorners& corners) {
  for (const int v : corners) {
    elements_of_[v].push_back(static_cast<int>(elements_.size()));
  }
  quality_.push_back(QualityOf(corners));
  elements_.push_back(corners);
}

void ChangingElements::Remove(int t) {
  for (const int v : elements_[t]) {
    std::vector<int>& of = elements_of_[v];
    of.erase(std::find(of.begin(), of.end(), t));
  }
  elements_[t][0] = -1;
}

double ChangingElements::Worst(const std::vector<int>& elements) const {
  double worst = std::numeric_limits<double>::infinity();
  for (const int t : elements) worst = std::min(worst, quality_[t]);
  return worst;
}

void ChangingElements::Replace(const std::vector<int>& old,
                               const std::vector<ElementCorners>& fresh) {
  for (const int t : old) Remove(t);
  for (const ElementCorners& corners : fresh) Add(corners);
}

double ChangingElements::QualityOf(const FaceCorners& f,
                                   const RowVector3d& place) const {
  // Seen from inside, the corners of an outward face run clockwise.
  return QualityAt({points_[f[0]], points_[f[2]], points_[f[1]], place});
}

void ChangingElements::JoinTo(const RowVector3d& place,
                              const std::vector<FaceCorners>& border,
                              const std::vector<int>& elements) {
  const int v = static_cast<int>(points_.size());
  points_.push_back(place);
  elements_of_.emplace_back();
  std::vector<ElementCorners> fresh;
  for (const FaceCorners& f : border) fresh.push_back({f[0], f[2], f[1], v});
  Replace(elements, fresh);
}

void ChangingElements::MovePoint(int v, const RowVector3d& place) {
  points_[v] = place;
  for (const int t : elements_of_[v]) quality_[t] = QualityOf(elements_[t]);
}

std::vector<int> ChangingElements::ElementsAround(int a, int b) const {
  std::vector<int> around;
  for (const int t : elements_of_[a]) {
    const ElementCorners& c = elements_[t];
    if (std::find(c.begin(), c.end(), b) != c.end()) around.push_back(t);
  }
  return around;
}

int ChangingElements::Neighbour(int t, const FaceCorners& face) const {
  for (const int other : ElementsAround(face[0], face[1])) {
    const ElementCorners& c = elements_[other];
    if (other != t && std::find(c.begin(), c.end(), face[2]) != c.end()) {
      return other;
    }
  }
  return -1;
}

FaceCorners ChangingElements::FaceOf(int t, int f) const {
  const ElementCorners& c = elements_[t];
  const int* const k = kFaceCorners[f];
  return {c[k[0]], c[k[1]], c[k[2]]};
}

std::vector<int> ChangingElements::RingOf(
    int a, int b, const std::vector<int>& around) const {
  std::map<int, int> next;
  for (const int t : around) {
    ElementCorners c = elements_[t];
    // Even permutations bring a, then b, to the front.
    const int at_a =
        static_cast<int>(std::find(c.begin(), c.end(), a) - c.begin());
    if (at_a != 0) {
      std::swap(c[0], c[at_a]);
      const int i = at_a == 1 ? 2 : 1, k = at_a == 3 ? 2 : 3;
      std::swap(c[i], c[k]);
    }
    while (c[1] != b) std::rotate(c.begin() + 1, c.begin() + 2, c.end());
    next[c[2]] = c[3];
  }
  std::vector<int> ring;
  int at = next.begin()->first;
  for (size_t i = 0; i < around.size(); ++i) {
    ring.push_back(at);
    const auto after = next.find(at);
    if (after == next.end()) return {};
    at = after->second;
  }
  return at == ring.front() && next.size() == around.size()
             ? ring
             : std::vector<int>();
}

int ChangingElements::CornerBeside(int t, const FaceCorners& face) const {
  for (const int v : elements_[t]) {
    if (std::find(face.begin(), face.end(), v) == face.end()) return v;
  }
  return -1;
}

FaceCorners ChangingElements::FaceOpposite(int t, int v) const {
  for (int f = 0; f < 4; ++f) {
    const FaceCorners face = FaceOf(t, f);
    if (std::find(face.begin(), face.end(), v) == face.end()) return face;
  }
  return {};
}

std::vector<BorderFace> ChangingElements::BorderOf(
    const std::vector<int>& elements) const {
  std::map<FaceCorners, BorderFace> border;  // by sorted corners
  for (const int t : elements) {
    for (int f = 0; f < 4; ++f) {
      const FaceCorners face = FaceOf(t, f);
      FaceCorners sorted = face;
      std::sort(sorted.begin(), sorted.end());
      const auto [entry, is_new] = border.emplace(sorted, BorderFace{face, t});
      if (!is_new) border.erase(entry);
    }
  }
  std::vector<BorderFace> faces;
  for (const auto& entry : border) faces.push_back(entry.second);
  return faces;
}

RowVector3d ChangingElements::MiddleOf(int t) const {
  RowVector3d middle = RowVector3d::Zero();
  for (const int v : elements_[t]) middle += points_[v] / 4;
  return middle;
}

}  // namespace musclewarp
