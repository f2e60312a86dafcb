// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/piece_selection.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>

#include "musclewarp/base/option_check.h"
#include "musclewarp/mesh/box.h"
#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/pieces.h"
#include "musclewarp/proximity/triangle_bvh.h"
#include "musclewarp/proximity/winding_number.h"

namespace musclewarp {
namespace {

// A piece and its measures.
struct Piece {
  TriangleSoup soup;
  double area = 0;           // mm^2
  double border_length = 0;  // mm
};

struct MeasuredPieces {
  std::vector<Piece> pieces;
  std::vector<int> piece_of;  // by triangle of the mesh
  double area = 0;            // of all, mm^2
  size_t largest = 0;
};

double BorderLength(const TriangleSoup& soup) {
  double length = 0;
  for (const EdgeUses::Uses& uses : EdgeUses(soup.triangles)) {
    if (uses.size() != 1) continue;
    length += (soup.points.row(OriginOf(soup.triangles, uses[0])) -
               soup.points.row(TargetOf(soup.triangles, uses[0])))
                  .norm();
  }
  return length;
}

MeasuredPieces Measured(const TriangleSoup& soup) {
  MeasuredPieces measured;
  measured.piece_of =
      ConnectedComponents(
          soup.triangles, EdgeUses(soup.triangles), soup.triangles.rows())
          .label;
  for (TriangleSoup& piece : PiecesOf(soup)) {
    measured.pieces.push_back({std::move(piece)});
    Piece& last = measured.pieces.back();
    last.area = SurfaceArea(last.soup.points, last.soup.triangles);
    last.border_length = BorderLength(last.soup);
    measured.area += last.area;
    if (last.area > measured.pieces[measured.largest].area) {
      measured.largest = measured.pieces.size() - 1;
    }
  }
  return measured;
}

Eigen::RowVector3d MeanPlace(const TriangleSoup& soup, double area) {
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    const Corners corners = CornersOf(soup.points, soup.triangles.row(f));
    sum += AreaVector(corners).norm() / 2 * corners.colwise().mean();
  }
  return area > 0 ? Eigen::RowVector3d(sum / area) : soup.points.row(0);
}

// Why a piece goes, or nothing if it stays.
using Verdict = std::function<std::optional<DropReason>(size_t piece)>;

void Drop(const MeasuredPieces& measured,
          const Verdict& verdict,
          TriangleSoup* soup,
          std::vector<DroppedPiece>* dropped) {
  std::vector<bool> keep_piece(measured.pieces.size(), true);
  for (size_t i = 0; i < measured.pieces.size(); ++i) {
    const std::optional<DropReason> reason = verdict(i);
    if (!reason) continue;
    keep_piece[i] = false;
    const Piece& piece = measured.pieces[i];
    DroppedPiece& gone = dropped->emplace_back();
    gone.reason = *reason;
    gone.triangles = static_cast<int>(piece.soup.triangles.rows());
    gone.area = piece.area;
    gone.share = measured.area > 0 ? piece.area / measured.area : 0;
    (*reason == DropReason::kShell ? gone.cavity : gone.volume) =
        std::abs(EnclosedVolume(piece.soup));
    gone.place = MeanPlace(piece.soup, piece.area);
  }
  std::vector<bool> keep_triangle(soup->triangles.rows());
  for (size_t f = 0; f < keep_triangle.size(); ++f) {
    keep_triangle[f] = keep_piece[measured.piece_of[f]];
  }
  KeepTriangles(keep_triangle, &soup->triangles);
}

// A flap has a long border for its area, a body with a hole a short one.
bool IsNearlyClosed(const Piece& piece) {
  return piece.border_length * piece.border_length < piece.area;
}

// True if a closed piece has no thickness: the isoperimetric quotient, 1 for a
// ball, is about 14 (t / l)^2 for a plate of side l and thickness t.
bool IsFlat(const Piece& piece) {
  constexpr double kThinnest = 1e-6;
  const double volume = SignedVolume(piece.soup.points, piece.soup.triangles);
  return 36 * M_PI * volume * volume < kThinnest * std::pow(piece.area, 3);
}

// Tells which pieces lie within others.
class Shells {
 public:
  explicit Shells(const std::vector<Piece>& pieces) : pieces_(pieces) {
    for (const Piece& piece : pieces)
      boxes_.push_back(BoxOf(piece.soup.points));
    solids_.resize(pieces.size());
  }

  // True if a piece lies within another, larger one. Pieces that cross each
  // other are both surfaces of the mesh.
  bool IsWithinAnother(size_t inner) {
    for (size_t outer = 0; outer < pieces_.size(); ++outer) {
      if (outer == inner || pieces_[outer].area < pieces_[inner].area) continue;
      if (Contains(boxes_[outer], boxes_[inner]) && IsWithin(inner, outer)) {
        return true;
      }
    }
    return false;
  }

 private:
  struct Solid {
    TriangleBvh tree;
    WindingNumber winding;
    explicit Solid(const TriangleSoup& soup)
        : tree(soup.points, soup.triangles), winding(&tree, soup.triangles) {}
  };

  static bool Contains(const Box3& outer, const Box3& inner) {
    return outer.Contains({inner.lower[0], inner.lower[1], inner.lower[2]}) &&
           outer.Contains({inner.upper[0], inner.upper[1], inner.upper[2]});
  }

  bool IsWithin(size_t inner, size_t outer) {
    if (!solids_[outer]) {
      solids_[outer] = std::make_unique<Solid>(pieces_[outer].soup);
    }
    const Points& points = pieces_[inner].soup.points;
    for (Eigen::Index v = 0; v < points.rows(); ++v) {
      if (!solids_[outer]->winding.IsInside(points.row(v))) return false;
    }
    return true;
  }

  const std::vector<Piece>& pieces_;
  std::vector<Box3> boxes_;
  std::vector<std::unique_ptr<Solid>> solids_;
};

}  // namespace

std::string ToString(DropReason reason) {
  switch (reason) {
    case DropReason::kCrumb:
      return "crumb";
    case DropReason::kSmaller:
      return "smaller";
    case DropReason::kOpen:
      return "open";
    case DropReason::kFlat:
      return "flat";
    case DropReason::kShell:
      return "shell";
  }
  LOG(FATAL) << "no such reason";
}

bool PieceOptions::IsValid(std::string* error) const {
  return OptionCheck("PieceOptions", error)
      .IsWithin("stray_area", stray_area, 0, 1)
      .IsWithin("crumb_area", crumb_area, 0, 1)
      .is_valid();
}

void DropCrumbs(const PieceOptions& options,
                TriangleSoup* soup,
                std::vector<DroppedPiece>* dropped) {
  const MeasuredPieces measured = Measured(*soup);
  if (measured.pieces.size() < 2) return;
  const double stray = options.stray_area * measured.area;
  const double crumb =
      options.crumb_area * measured.pieces[measured.largest].area;
  const auto is_crumb = [&](const Piece& piece) {
    return options.rule == PieceRule::kLargest
               ? piece.area < stray
               : piece.area < crumb ||
                     (piece.area < stray && !IsNearlyClosed(piece));
  };
  Drop(
      measured,
      [&](size_t i) {
        return is_crumb(measured.pieces[i]) ? std::optional(DropReason::kCrumb)
                                            : std::nullopt;
      },
      soup,
      dropped);
}

void KeepSurfaces(const PieceOptions& options,
                  TriangleSoup* soup,
                  std::vector<DroppedPiece>* dropped) {
  const MeasuredPieces measured = Measured(*soup);
  if (measured.pieces.size() < 2) return;
  Shells shells(measured.pieces);
  const auto verdict = [&](size_t i) -> std::optional<DropReason> {
    if (i == measured.largest) return std::nullopt;
    const Piece& piece = measured.pieces[i];
    if (piece.border_length > 0) {
      return options.rule == PieceRule::kAll ? DropReason::kOpen
                                             : DropReason::kSmaller;
    }
    if (IsFlat(piece)) return DropReason::kFlat;
    if (shells.IsWithinAnother(i)) return DropReason::kShell;
    if (options.rule == PieceRule::kLargest) return DropReason::kSmaller;
    return std::nullopt;
  };
  Drop(measured, verdict, soup, dropped);
}

DroppedTotals TotalsOf(const std::vector<DroppedPiece>& dropped) {
  DroppedTotals totals;
  for (const DroppedPiece& piece : dropped) {
    totals.triangles += piece.triangles;
    totals.area += piece.area;
    totals.largest_area = std::max(totals.largest_area, piece.area);
    totals.volume += piece.volume;
    totals.cavity += piece.cavity;
  }
  return totals;
}

}  // namespace musclewarp
