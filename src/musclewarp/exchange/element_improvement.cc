// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/element_improvement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "musclewarp/base/angles.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;
using Corners = std::array<int, 4>;
using Face = std::array<int, 3>;

// Below all qualities of tetrahedra that are not inverted.
constexpr double kInverted = -2;

// Returns minus the cosine of the smallest dihedral angle of a tetrahedron,
// which grows with the angle, or kInverted.
double QualityOf(const std::array<RowVector3d, 4>& c) {
  if (!((c[1] - c[0]).cross(c[2] - c[0]).dot(c[3] - c[0]) > 0)) {
    return kInverted;
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

class Improver {
 public:
  Improver(double goal_deg,
           Eigen::Index surface_points,
           const TetrahedralMesh& mesh)
      : goal_(-std::cos(RadiansOf(goal_deg))),
        surface_points_(static_cast<int>(surface_points)),
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

  void Execute() {
    constexpr int kMaxPasses = 8;
    for (int pass = 0; pass < kMaxPasses; ++pass) {
      std::vector<int> bad;
      for (size_t t = 0; t < elements_.size(); ++t) {
        if (quality_[t] < goal_ && IsThere(static_cast<int>(t))) {
          bad.push_back(static_cast<int>(t));
        }
      }
      std::stable_sort(bad.begin(), bad.end(), [&](int a, int b) {
        return quality_[a] < quality_[b];
      });
      int changes = 0;
      for (const int t : bad) changes += Improve(t);
      if (changes == 0) return;
    }
  }

  // Leaves out points that no element has any more.
  TetrahedralMesh Result() const {
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
    for (const Corners& corners : elements_) rows += corners[0] >= 0;
    mesh.tetrahedra.resize(rows, 4);
    Eigen::Index t = 0;
    for (const Corners& corners : elements_) {
      if (corners[0] < 0) continue;
      for (int k = 0; k < 4; ++k) mesh.tetrahedra(t, k) = number[corners[k]];
      ++t;
    }
    return mesh;
  }

 private:
  bool IsThere(int t) const { return elements_[t][0] >= 0; }

  double Quality(const Corners& c) const {
    return QualityOf(
        {points_[c[0]], points_[c[1]], points_[c[2]], points_[c[3]]});
  }

  void Add(const Corners& corners) {
    for (const int v : corners) {
      elements_of_[v].push_back(static_cast<int>(elements_.size()));
    }
    quality_.push_back(Quality(corners));
    elements_.push_back(corners);
  }

  void Remove(int t) {
    for (const int v : elements_[t]) {
      std::vector<int>& of = elements_of_[v];
      of.erase(std::find(of.begin(), of.end(), t));
    }
    elements_[t][0] = -1;
  }

  // Returns the smallest quality of elements.
  double Worst(const std::vector<int>& elements) const {
    double worst = std::numeric_limits<double>::infinity();
    for (const int t : elements) worst = std::min(worst, quality_[t]);
    return worst;
  }

  void Replace(const std::vector<int>& old, const std::vector<Corners>& fresh) {
    for (const int t : old) Remove(t);
    for (const Corners& corners : fresh) Add(corners);
  }

  // Tries everything on an element, the cheapest first, until it is gone or
  // good. Returns true if anything changed.
  bool Improve(int t) {
    if (!IsThere(t)) return false;
    const Corners corners = elements_[t];
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
      is_changed |= v >= surface_points_ && Move(v);
      if (quality_[t] >= goal_) return true;
    }
    for (int a = 0; a < 4; ++a) {
      for (int b = a + 1; b < 4; ++b) {
        if (Insert(ElementsAround(corners[a], corners[b]))) return true;
      }
    }
    return InsertInGrowing(t) || is_changed;
  }

  std::vector<int> ElementsAround(int a, int b) const {
    std::vector<int> around;
    for (const int t : elements_of_[a]) {
      const Corners& c = elements_[t];
      if (std::find(c.begin(), c.end(), b) != c.end()) around.push_back(t);
    }
    return around;
  }

  // Returns the element on the other side of a face, or -1 at the border.
  int Neighbour(int t, const Face& face) const {
    for (const int other : ElementsAround(face[0], face[1])) {
      const Corners& c = elements_[other];
      if (other != t && std::find(c.begin(), c.end(), face[2]) != c.end()) {
        return other;
      }
    }
    return -1;
  }

  Face FaceOf(int t, int f) const {
    const Corners& c = elements_[t];
    const int* const k = kFaceCorners[f];
    return {c[k[0]], c[k[1]], c[k[2]]};
  }

  // Returns the points around an edge inside, counterclockwise seen from b;
  // none for an edge of the border.
  std::vector<int> RingOf(int a, int b, const std::vector<int>& around) const {
    std::map<int, int> next;
    for (const int t : around) {
      Corners c = elements_[t];
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

  // The two elements that stand on a triangle of points around an edge.
  static std::array<Corners, 2> OnTriangle(int a, int b, const Face& f) {
    return {Corners{f[0], f[1], f[2], b}, Corners{f[0], f[2], f[1], a}};
  }

  // Replaces the elements around an edge by the best that stand on triangles
  // between the points around it, if these are better (Klincsek's dynamic
  // program).
  bool RemoveEdge(int a, int b) {
    constexpr size_t kMaxRing = 9;
    const std::vector<int> around = ElementsAround(a, b);
    if (around.size() < 3 || around.size() > kMaxRing) return false;
    const std::vector<int> ring = RingOf(a, b, around);
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
          for (const Corners& c :
               OnTriangle(a, b, {ring[i], ring[j], ring[k]})) {
            if (worst > best[i][k]) worst = std::min(worst, Quality(c));
          }
          if (worst <= best[i][k]) continue;
          best[i][k] = worst;
          middle[i][k] = j;
        }
      }
    }
    if (!IsBetter(best[0][n - 1], Worst(around))) return false;
    std::vector<Corners> fresh;
    std::vector<std::pair<int, int>> spans = {{0, n - 1}};
    while (!spans.empty()) {
      const auto [i, k] = spans.back();
      spans.pop_back();
      if (k - i < 2) continue;
      const int j = middle[i][k];
      for (const Corners& c : OnTriangle(a, b, {ring[i], ring[j], ring[k]})) {
        fresh.push_back(c);
      }
      spans.push_back({i, j});
      spans.push_back({j, k});
    }
    Replace(around, fresh);
    return true;
  }

  // Replaces two elements by three around the edge between the corners that
  // they do not share.
  bool RemoveFace(int t, int f) {
    const Face face = FaceOf(t, f);
    const int other = Neighbour(t, face);
    if (other < 0) return false;
    const int a = CornerBeside(t, face), b = CornerBeside(other, face);
    std::vector<Corners> fresh;
    double worst = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      // `face` runs counterclockwise seen from b.
      fresh.push_back({a, b, face[k], face[(k + 1) % 3]});
      worst = std::min(worst, Quality(fresh.back()));
    }
    if (!IsBetter(worst, Worst({t, other}))) return false;
    Replace({t, other}, fresh);
    return true;
  }

  int CornerBeside(int t, const Face& face) const {
    for (const int v : elements_[t]) {
      if (std::find(face.begin(), face.end(), v) == face.end()) return v;
    }
    return -1;
  }

  // Moves a point inside to where the worst of its elements is best.
  bool Move(int v) {
    std::vector<Face> faces;
    for (const int t : elements_of_[v]) faces.push_back(FaceOpposite(t, v));
    const double before = Worst(elements_of_[v]);
    const auto [place, quality] = BestPlace(faces, points_[v], before);
    if (!IsBetter(quality, before)) return false;
    points_[v] = place;
    for (const int t : elements_of_[v]) quality_[t] = Quality(elements_[t]);
    return true;
  }

  Face FaceOpposite(int t, int v) const {
    for (int f = 0; f < 4; ++f) {
      const Face face = FaceOf(t, f);
      if (std::find(face.begin(), face.end(), v) == face.end()) return face;
    }
    return {};
  }

  // A face of the border of some elements, outward, and the element inside.
  struct BorderFace {
    Face face;
    int element = -1;
  };

  std::vector<BorderFace> BorderOf(const std::vector<int>& elements) const {
    std::map<Face, BorderFace> border;  // by sorted corners
    for (const int t : elements) {
      for (int f = 0; f < 4; ++f) {
        const Face face = FaceOf(t, f);
        Face sorted = face;
        std::sort(sorted.begin(), sorted.end());
        const auto [entry, is_new] =
            border.emplace(sorted, BorderFace{face, t});
        if (!is_new) border.erase(entry);
      }
    }
    std::vector<BorderFace> faces;
    for (const auto& entry : border) faces.push_back(entry.second);
    return faces;
  }

  static std::vector<Face> FacesOf(const std::vector<BorderFace>& border) {
    std::vector<Face> faces;
    for (const BorderFace& face : border) faces.push_back(face.face);
    return faces;
  }

  // Replaces elements by those that join the faces around them to a new point,
  // if these are better.
  bool Insert(const std::vector<int>& cavity) {
    const std::vector<Face> faces = FacesOf(BorderOf(cavity));
    const auto [place, quality] =
        BestPlace(faces, MiddleOf(cavity[0]), kInverted);
    if (!IsGain(place, quality, faces, cavity)) return false;
    JoinTo(place, faces, cavity);
    return true;
  }

  // Returns true if joining faces to a place makes the worst element better and
  // no more of them bad.
  bool IsGain(const RowVector3d& place,
              double quality,
              const std::vector<Face>& faces,
              const std::vector<int>& cavity) const {
    if (!IsBetter(quality, Worst(cavity))) return false;
    int before = 0, after = 0;
    for (const int t : cavity) before += quality_[t] < goal_;
    for (const Face& face : faces) after += Joined(face, place) < goal_;
    return after <= before;
  }

  // The same for elements around `t`, to which that behind the worst face is
  // added until nothing is gained.
  bool InsertInGrowing(int t) {
    constexpr int kMaxElements = 24;
    std::vector<int> cavity = {t};
    while (cavity.size() < kMaxElements) {
      const std::vector<BorderFace> border = BorderOf(cavity);
      const std::vector<Face> faces = FacesOf(border);
      const auto [place, quality] = BestPlace(faces, MiddleOf(t), kInverted);
      if (IsGain(place, quality, faces, cavity)) {
        JoinTo(place, faces, cavity);
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
      const double quality = Joined(face.face, place);
      if (quality >= worst) continue;
      const int other = Neighbour(face.element, face.face);
      if (other < 0 ||
          std::find(cavity.begin(), cavity.end(), other) != cavity.end()) {
        continue;
      }
      worst = quality;
      behind = other;
    }
    return behind;
  }

  RowVector3d MiddleOf(int t) const {
    RowVector3d middle = RowVector3d::Zero();
    for (const int v : elements_[t]) middle += points_[v] / 4;
    return middle;
  }

  // The quality of the element that joins an outward face to a place inside,
  // from which its corners run clockwise.
  double Joined(const Face& f, const RowVector3d& place) const {
    return QualityOf({points_[f[0]], points_[f[2]], points_[f[1]], place});
  }

  void JoinTo(const RowVector3d& place,
              const std::vector<Face>& faces,
              const std::vector<int>& cavity) {
    const int v = static_cast<int>(points_.size());
    points_.push_back(place);
    elements_of_.emplace_back();
    std::vector<Corners> fresh;
    for (const Face& f : faces) fresh.push_back({f[0], f[2], f[1], v});
    Replace(cavity, fresh);
  }

  // The place of a point where the worst of the elements that join outward
  // faces to it is best, and that quality: a pattern search from `start`.
  std::pair<RowVector3d, double> BestPlace(const std::vector<Face>& faces,
                                           const RowVector3d& start,
                                           double start_quality) const {
    const auto quality_at = [&](const RowVector3d& place, double enough) {
      double worst = std::numeric_limits<double>::infinity();
      for (const Face& f : faces) {
        worst = std::min(worst, Joined(f, place));
        if (worst <= enough) break;
      }
      return worst;
    };
    RowVector3d middle = RowVector3d::Zero();
    double size = 0;
    for (const Face& f : faces) {
      middle += (points_[f[0]] + points_[f[1]] + points_[f[2]]) /
                (3.0 * faces.size());
      size = std::max(size, (points_[f[0]] - points_[f[1]]).norm());
    }
    RowVector3d best = start;
    double quality =
        start_quality > kInverted
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
  int surface_points_;
  std::vector<RowVector3d> points_;
  std::vector<Corners> elements_;  // those that are gone begin with -1
  std::vector<double> quality_;
  std::vector<std::vector<int>> elements_of_;  // of each point
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
