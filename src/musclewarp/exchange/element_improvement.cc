// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/element_improvement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "musclewarp/base/angles.h"
#include "musclewarp/exchange/changing_elements.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

class Improver {
 public:
  Improver(double goal_deg,
           Eigen::Index surface_points,
           const TetrahedralMesh& mesh)
      : goal_(-std::cos(RadiansOf(goal_deg))), mesh_(surface_points, mesh) {}

  void Execute() {
    constexpr int kMaxPasses = 8;
    for (int pass = 0; pass < kMaxPasses; ++pass) {
      std::vector<int> bad;
      for (int t = 0; t < mesh_.num_elements(); ++t) {
        if (mesh_.IsThere(t) && mesh_.quality(t) < goal_) bad.push_back(t);
      }
      std::stable_sort(bad.begin(), bad.end(), [&](int a, int b) {
        return mesh_.quality(a) < mesh_.quality(b);
      });
      int changes = 0;
      for (const int t : bad) changes += Improve(t);
      if (changes == 0) return;
    }
  }

  TetrahedralMesh Result() const { return mesh_.Result(); }

 private:
  // Tries everything on an element, the cheapest first, until it is gone or
  // good. Returns true if anything changed.
  bool Improve(int t) {
    if (!mesh_.IsThere(t)) return false;
    const ElementCorners corners = mesh_.corners(t);
    for (int a = 0; a < 4; ++a) {
      for (int b = a + 1; b < 4; ++b) {
        if (RemoveEdge(corners[a], corners[b])) return true;
      }
    }
    for (int f = 0; f < 4; ++f) {
      if (RemoveFace(t, f)) return true;
    }
    bool is_changed = false;
    for (const int v : corners) {
      is_changed |= mesh_.IsInside(v) && Move(v);
      if (mesh_.quality(t) >= goal_) return true;
    }
    for (int a = 0; a < 4; ++a) {
      for (int b = a + 1; b < 4; ++b) {
        if (Insert(mesh_.ElementsAround(corners[a], corners[b]))) return true;
      }
    }
    return InsertInGrowing(t) || is_changed;
  }

  // The two elements that stand on a triangle of points around an edge.
  static std::array<ElementCorners, 2> OnTriangle(int a,
                                                  int b,
                                                  const FaceCorners& f) {
    return {ElementCorners{f[0], f[1], f[2], b},
            ElementCorners{f[0], f[2], f[1], a}};
  }

  // Replaces the elements around an edge by the best that stand on triangles
  // between the points around it, if these are better (Klincsek's dynamic
  // program).
  bool RemoveEdge(int a, int b) {
    constexpr size_t kMaxRing = 9;
    const std::vector<int> around = mesh_.ElementsAround(a, b);
    if (around.size() < 3 || around.size() > kMaxRing) return false;
    const std::vector<int> ring = mesh_.RingOf(a, b, around);
    if (ring.empty()) return false;
    const int n = static_cast<int>(ring.size());
    double best[kMaxRing][kMaxRing];
    int middle[kMaxRing][kMaxRing];
    for (int span = 1; span < n; ++span) {
      for (int i = 0; i + span < n; ++i) {
        const int k = i + span;
        best[i][k] = span == 1 ? std::numeric_limits<double>::infinity()
                               : -std::numeric_limits<double>::infinity();
        for (int j = i + 1; j < k; ++j) {
          double worst = std::min(best[i][j], best[j][k]);
          for (const ElementCorners& c :
               OnTriangle(a, b, {ring[i], ring[j], ring[k]})) {
            if (worst > best[i][k]) worst = std::min(worst, mesh_.QualityOf(c));
          }
          if (worst <= best[i][k]) continue;
          best[i][k] = worst;
          middle[i][k] = j;
        }
      }
    }
    if (!IsBetter(best[0][n - 1], mesh_.Worst(around))) return false;
    std::vector<ElementCorners> fresh;
    std::vector<std::pair<int, int>> spans = {{0, n - 1}};
    while (!spans.empty()) {
      const auto [i, k] = spans.back();
      spans.pop_back();
      if (k - i < 2) continue;
      const int j = middle[i][k];
      for (const ElementCorners& c :
           OnTriangle(a, b, {ring[i], ring[j], ring[k]})) {
        fresh.push_back(c);
      }
      spans.push_back({i, j});
      spans.push_back({j, k});
    }
    mesh_.Replace(around, fresh);
    return true;
  }

  // Replaces two elements by three around the edge between the corners that
  // they do not share.
  bool RemoveFace(int t, int f) {
    const FaceCorners face = mesh_.FaceOf(t, f);
    const int other = mesh_.Neighbour(t, face);
    if (other < 0) return false;
    const int a = mesh_.CornerBeside(t, face);
    const int b = mesh_.CornerBeside(other, face);
    std::vector<ElementCorners> fresh;
    double worst = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      // `face` runs counterclockwise seen from b.
      fresh.push_back({a, b, face[k], face[(k + 1) % 3]});
      worst = std::min(worst, mesh_.QualityOf(fresh.back()));
    }
    if (!IsBetter(worst, mesh_.Worst({t, other}))) return false;
    mesh_.Replace({t, other}, fresh);
    return true;
  }

  // Moves a point inside to where the worst of its elements is best.
  bool Move(int v) {
    std::vector<FaceCorners> faces;
    for (const int t : mesh_.elements_of(v)) {
      faces.push_back(mesh_.FaceOpposite(t, v));
    }
    const double before = mesh_.Worst(mesh_.elements_of(v));
    const auto [place, quality] = BestPlace(faces, mesh_.point(v), before);
    if (!IsBetter(quality, before)) return false;
    mesh_.MovePoint(v, place);
    return true;
  }

  static std::vector<FaceCorners> FacesOf(
      const std::vector<BorderFace>& border) {
    std::vector<FaceCorners> faces;
    for (const BorderFace& face : border) faces.push_back(face.face);
    return faces;
  }

  // Replaces elements by those that join the faces around them to a new point,
  // if these are better.
  bool Insert(const std::vector<int>& cavity) {
    const std::vector<FaceCorners> faces = FacesOf(mesh_.BorderOf(cavity));
    const auto [place, quality] = BestPlace(
        faces, mesh_.MiddleOf(cavity[0]), ChangingElements::kInverted);
    if (!IsGain(place, quality, faces, cavity)) return false;
    mesh_.JoinTo(place, faces, cavity);
    return true;
  }

  // Returns true if joining faces to a place makes the worst element better and
  // no more of them bad.
  bool IsGain(const RowVector3d& place,
              double quality,
              const std::vector<FaceCorners>& faces,
              const std::vector<int>& cavity) const {
    if (!IsBetter(quality, mesh_.Worst(cavity))) return false;
    int before = 0, after = 0;
    for (const int t : cavity) before += mesh_.quality(t) < goal_;
    for (const FaceCorners& face : faces)
      after += mesh_.QualityOf(face, place) < goal_;
    return after <= before;
  }

  // The same for elements around `t`, to which that behind the worst face is
  // added until nothing is gained.
  bool InsertInGrowing(int t) {
    constexpr int kMaxElements = 24;
    std::vector<int> cavity = {t};
    while (cavity.size() < kMaxElements) {
      const std::vector<BorderFace> border = mesh_.BorderOf(cavity);
      const std::vector<FaceCorners> faces = FacesOf(border);
      const auto [place, quality] =
          BestPlace(faces, mesh_.MiddleOf(t), ChangingElements::kInverted);
      if (IsGain(place, quality, faces, cavity)) {
        mesh_.JoinTo(place, faces, cavity);
        return true;
      }
      const int next = BehindWorst(border, place, cavity);
      if (next < 0) return false;
      cavity.push_back(next);
    }
    return false;
  }

  // Returns the element outside behind the face whose element with a corner at
  // `place` is worst, among the faces that have one behind them, or -1.
  int BehindWorst(const std::vector<BorderFace>& border,
                  const RowVector3d& place,
                  const std::vector<int>& cavity) const {
    double worst = std::numeric_limits<double>::infinity();
    int behind = -1;
    for (const BorderFace& face : border) {
      const double quality = mesh_.QualityOf(face.face, place);
      if (quality >= worst) continue;
      const int other = mesh_.Neighbour(face.element, face.face);
      if (other < 0 ||
          std::find(cavity.begin(), cavity.end(), other) != cavity.end()) {
        continue;
      }
      worst = quality;
      behind = other;
    }
    return behind;
  }

  // The place of a point where the worst of the elements that join outward
  // faces to it is best, and that quality: a pattern search from `start`.
  std::pair<RowVector3d, double> BestPlace(
      const std::vector<FaceCorners>& faces,
      const RowVector3d& start,
      double start_quality) const {
    const auto quality_at = [&](const RowVector3d& place, double enough) {
      double worst = std::numeric_limits<double>::infinity();
      for (const FaceCorners& f : faces) {
        worst = std::min(worst, mesh_.QualityOf(f, place));
        if (worst <= enough) break;
      }
      return worst;
    };
    RowVector3d middle = RowVector3d::Zero();
    double size = 0;
    for (const FaceCorners& f : faces) {
      middle += (mesh_.point(f[0]) + mesh_.point(f[1]) + mesh_.point(f[2])) /
                (3.0 * faces.size());
      size = std::max(size, (mesh_.point(f[0]) - mesh_.point(f[1])).norm());
    }
    RowVector3d best = start;
    double quality =
        start_quality > ChangingElements::kInverted
            ? start_quality
            : quality_at(start, -std::numeric_limits<double>::infinity());
    const double in_middle = quality_at(middle, quality);
    if (in_middle > quality) {
      best = middle;
      quality = in_middle;
    }
    constexpr double kFirstStep = 0.3, kLastStep = 0.01;
    for (double step = kFirstStep; step > kLastStep;) {
      bool is_moved = false;
      for (int k = 0; k < 6; ++k) {
        RowVector3d place = best;
        place[k / 2] += (k % 2 == 0 ? step : -step) * size;
        const double there = quality_at(place, quality);
        if (there <= quality) continue;
        best = place;
        quality = there;
        is_moved = true;
      }
      if (!is_moved) step /= 2;
    }
    return {best, quality};
  }

  // Tiny gains would be made for ever.
  static bool IsBetter(double quality, double before) {
    constexpr double kLeastGain = 1e-4;
    return quality > before + kLeastGain;
  }

  double goal_;
  ChangingElements mesh_;
};

}  // namespace

void ImproveElements(double goal_deg,
                     Eigen::Index surface_points,
                     TetrahedralMesh* mesh) {
  Improver improver(goal_deg, surface_points, *mesh);
  improver.Execute();
  *mesh = improver.Result();
}

}  // namespace musclewarp
