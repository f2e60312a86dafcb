// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/base/described.h"

namespace musclewarp {

// The reason for the reconstruction of a muscle's mesh: the defect that moving
// its vertices has not resolved. Worst first.
enum class ReconstructionReason {
  kCrossesBone,
  kCrossesMuscle,
  kCrossesItself,
  kDisplaced,  // beyond the requirements on frames
};

// "crosses_bone", "crosses_muscle", "crosses_itself" or "displaced": the text
// of reports.
std::string ToString(ReconstructionReason reason);

// The reconstruction of a muscle's mesh that could not be separated from others
// by moving its vertices (frame_solvers/rest_separation.h).
struct SurfaceReconstruction {
  bool is_done = false;

  // `reason` and `volume_before` are those of the first reconstruction.
  ReconstructionReason reason = ReconstructionReason::kCrossesBone;
  double volume_before = 0, volume_after = 0;
  double lost_area = 0;
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
  double farthest = 0;

  // What is gone (frame_solvers/reconstruction_loss.h).
  double gone_area = 0;
  double lost_extent = 0;
  std::vector<std::string> lost_attachments;
};

constexpr auto FieldsOf(Described<SurfaceReconstruction>) {
  using F = SurfaceReconstruction;
  return std::make_tuple(
      Field(&F::reason, "reason")
          .Text("what was still the case once its vertices had been moved "
                "(`crosses_bone`, `crosses_muscle`, `crosses_itself`, or "
                "`displaced` too far)"),
      Field(&F::volume_before, "volume_before_mm3", "mm3")
          .Text("of the old mesh"),
      Field(&F::volume_after, "volume_after_mm3", "mm3").Text("of the new one"),
      Field(&F::lost_area, "lost_area_mm2", "mm2")
          .Text("how much of the old surface the new one leaves by more than "
                "an edge"),
      Field(&F::place, "place_mm", "mm").Text("the middle of that"),
      Field(&F::farthest, "farthest_mm", "mm")
          .Text("the largest distance of the old surface from the new one"),
      Field(&F::gone_area, "gone_area_mm2", "mm2")
          .Text("[what is lost](method.md#what-a-reconstruction-has-lost): the "
                "area of the delivered surface that is farther than 3 mm, and "
                "twice the depth of the muscle in others, from the new one"),
      Field(&F::lost_extent, "lost_extent_mm", "mm")
          .Text("by how much the muscle is shorter at one end, beyond twice "
                "that depth"),
      Field(&F::lost_attachments, "lost_attachments")
          .Text("the bodies or muscles to which it was attached and is no "
                "longer"),
      NotWritten(&F::is_done));
}

}  // namespace musclewarp
