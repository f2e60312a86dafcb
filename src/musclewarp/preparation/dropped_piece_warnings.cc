// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/dropped_piece_warnings.h"

#include <cmath>

#include "musclewarp/base/text.h"

namespace musclewarp {
namespace {

// Smaller shares are single flaps at non-manifold edges, which nearly all
// meshes have.
constexpr double kShareWorthAWord = 1e-4;

// Returns true if a piece, however small, encloses a volume, unlike a flap: if
// its isoperimetric quotient is above that of a plate about 100 times as wide
// as thick.
bool IsBody(const DroppedPiece& piece) {
  constexpr double kPlate = 1e-3;
  return 36 * M_PI * piece.volume * piece.volume >
         kPlate * std::pow(piece.area, 3);
}

std::string SizeText(const DroppedPiece& piece, double body_size) {
  const double area = piece.area * std::pow(body_size, 2);
  const double volume = (piece.volume + piece.cavity) * std::pow(body_size, 3);
  return MeasureText(area / 100) + " cm2, " + MeasureText(100 * piece.share) +
         " % of its surface, " + MeasureText(volume / 1000) + " cm3";
}

std::string WhyText(DropReason reason) {
  switch (reason) {
    case DropReason::kCrumb:
      return "";
    case DropReason::kSmaller:
      return ": a muscle is one closed surface (separation with "
             "{pieces}=all makes a mesh of each piece)";
    case DropReason::kOpen:
      return ": its border is too long to be closed ({max_hole})";
    case DropReason::kFlat:
      return ": it encloses no volume";
    case DropReason::kShell:
      return ": it lies within the rest, and its cavity is filled";
  }
  return "";
}

}  // namespace

std::vector<std::string> DroppedPieceWarnings(const std::string& name,
                                              const RepairReport& repairs,
                                              double body_size) {
  std::vector<std::string> warnings;
  int crumbs = 0;
  bool has_body = false;
  DroppedPiece all, largest;  // crumbs
  for (const DroppedPiece& piece : repairs.dropped_pieces) {
    if (piece.reason == DropReason::kCrumb) {
      ++crumbs;
      has_body |= IsBody(piece);
      all.area += piece.area;
      all.share += piece.share;
      all.volume += piece.volume;
      if (piece.area > largest.area) largest = piece;
      continue;
    }
    if (piece.reason == DropReason::kFlat && piece.share < kShareWorthAWord) {
      continue;
    }
    warnings.push_back(name + ": a piece of " + SizeText(piece, body_size) +
                       " around " + PlaceText(piece.place, body_size) +
                       " is left out" + WhyText(piece.reason));
  }
  if (has_body || all.share >= kShareWorthAWord) {
    warnings.push_back(name + ": " + std::to_string(crumbs) +
                       (crumbs == 1 ? " crumb of " : " crumbs of together ") +
                       SizeText(all, body_size) +
                       (crumbs == 1 ? " is" : " are") + " left out" +
                       (crumbs == 1 ? ", around " : ", the largest around ") +
                       PlaceText(largest.place, body_size));
  }
  return warnings;
}

}  // namespace musclewarp
