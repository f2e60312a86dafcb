// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/fibres/found_attachments.h"
#include "musclewarp/fibres/muscle_ends.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/triangle_bvh.h"
#include "musclewarp/scene/scene.h"
#include "musclewarp/skeleton/action_line.h"

namespace musclewarp {

// An end of a soft part.
struct SoftPartEnd {
  Points points;  // #P x 3, mm: of the surface
  std::string body;
  bool is_on_bones = true;
  Eigen::RowVector3d tip = Eigen::RowVector3d::Zero();  // if it is not, mm

  // The index of the soft part on which the end lies instead of on bones, or
  // -1 if there is none.
  int soft_part = -1;

  Eigen::RowVector3d Middle() const { return points.colwise().mean(); }
};

// A muscle, or a tendon that has a mesh of its own, among those of a scene. All
// positions are those of the rest pose.
struct SoftPart {
  const TriangleBvh* surface = nullptr;  // must outlive this object
  double volume = 0;                     // mm^3
  std::vector<ActionLine> lines;         // from end to end
  std::vector<SoftPartEnd> ends;

  // The indices of the parts on which it ends, if the scene says so.
  std::optional<std::vector<int>> ends_on;
};

// Returns the ends of a muscle: the attachments that the scene names, and those
// that were found (FindAttachments) if it does not name two.
std::vector<SoftPartEnd> EndsOf(const SceneMuscle& muscle,
                                const std::vector<FoundAttachment>& found);

// Returns true if at least half of the points of a muscle's tip (#P x 3) lie in
// one of the soft parts, or at most 1 mm away.
bool LiesOnSoftPart(const Points& tip,
                    const std::vector<const TriangleBvh*>& soft_parts);

// Finds on which soft parts ends without bones lie, unless the scene says it:
// on the part nearest to their tip, of those that are thinner and at most 3 mm
// away. Where a part ends on another, the end without bones of that lies on it
// in turn, as the upper end of a tendon does on a muscle.
void FindSoftEnds(std::vector<SoftPart>* parts);

// Lines that go on beyond the ends of their muscle. The numbers are indices of
// other parts, ascending.
struct ContinuedLines {
  std::vector<ActionLine> lines;
  std::vector<int> through;

  // Those on which the muscle itself ends, and to which it is to be attached.
  // Of two that end on each other the thinner one carries the other.
  std::vector<int> tied_to;
};

// Returns the lines of parts[part], which slide, each continued over the ends
// that lie on other parts: along the nearest line of such a part, away from the
// muscle, to an end on bones, perhaps through further parts. A tendon between
// muscle and bone then keeps its length (LineRule::kTendon), and the muscle
// bears what both have to be stretched. A line that would have to turn back, or
// to turn by more than 60 degrees, or that finds no bone, or one of the body at
// its other end although the scene does not ask for it, stays as it is.
ContinuedLines ContinueLines(int part,
                             const std::vector<SoftPart>& parts,
                             const std::vector<BodySurface>& bodies);

}  // namespace musclewarp
