// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/figures/frame_figures.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A muscle in one pose: its figures and its shape.
struct MuscleFrame : MuscleFigures {
  Points points;  // of the fine mesh, n x 3, mm

  // The distance of each vertex to the nearest other mesh, n, mm, negative
  // inside one and at most kGapLimit, if it was asked for (MeasureOptions).
  Eigen::VectorXd gaps;

  // The action lines, sampled, and the fibres, as the muscle carries them; #P x
  // 3 each, mm.
  std::vector<Points> lines;
  std::vector<Points> fibres;

  // Where its lines go on along tendons that have no mesh, #P x 3 each, mm
  // (frames/bare_tendon_lines.h).
  std::vector<Points> bare_tendons;
};

// Gaps to other meshes are measured up to this distance, mm.
constexpr double kGapLimit = 5;

// A whole scene in one pose, with everything that is known about it. Muscles
// and bones are in the order of the scene.
//
//   const Frame frame = deformer.MoveTo(pose);
//   if (!frame.IsUsable()) LOG(WARNING) << frame.FullReport();
//   for (const MuscleFrame& muscle : frame.muscles) {
//     Show(muscle.name, muscle.points);
//   }
struct Frame : FiguresOfFrame<MuscleFrame> {
  std::vector<Points> bones;  // #V x 3 each, mm

  // The rigid motions of the bones from rest, 4 x 4, translation in mm: `bones`
  // are the points at rest, Transformed() by them.
  std::vector<Eigen::Matrix4d> bones_from_rest;

  // One line: the name of the pose, whether the frame is usable, and how many
  // triangles cross.
  std::string BriefReport() const;

  // The brief report, a line for each muscle, and all shortcomings.
  std::string FullReport() const;
};

}  // namespace musclewarp
