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
  Points points;  // of the surface, #P x 3, mm
  std::string body;
  bool is_on_bones = true;
  Eigen::RowVector3d tip = Eigen::RowVector3d::Zero();  // mm, if not on bones

  // The index of the soft part on which the end lies instead of on bones, or
  // -1 if there is none.
  int soft_part = -1;

  Eigen::RowVector3d Middle() const { return points.colwise().mean(); }
};

// A muscle of a scene, or a tendon with its own mesh. All positions are in the
// rest pose, mm.
struct SoftPart {
  const TriangleBvh* surface = nullptr;  // must outlive this object
  double volume = 0;                     // mm^3
  std::vector<ActionLine> lines;         // from end to end
  std::vector<SoftPartEnd> ends;

  // The indices of the parts on which it ends, if the scene names them.
  std::optional<std::vector<int>> ends_on;
};

// Returns the ends of a muscle: the attachments that the scene names and, if
// they are fewer than two, also those that were detected (FindAttachments).
std::vector<SoftPartEnd> EndsOf(const SceneMuscle& muscle,
                                const std::vector<FoundAttachment>& found);

// Returns true if at least half of the points of a muscle's tip (#P x 3, mm)
// are inside one of the soft parts or at most 1 mm away.
bool LiesOnSoftPart(const Points& tip,
                    const std::vector<const TriangleBvh*>& soft_parts);

// Finds the soft parts on which ends without bones lie, unless the scene names
// them: the thinner part that is nearest to the tip of the end, at most 3 mm
// away. Where one part ends on another, an end of the latter without bones also
// lies on the former, as the upper end of a tendon does on its muscle.
void FindSoftEnds(std::vector<SoftPart>* parts);

// The lines of a muscle, continued beyond its ends, and the indices of the
// parts through which they continue, ascending.
struct ContinuedLines {
  std::vector<ActionLine> lines;
  std::vector<int> through;

  // The parts on which the muscle itself ends, and to which it is to be
  // attached, ascending. Of two parts that end on each other, the thinner one
  // carries the other.
  std::vector<int> tied_to;
};

// Returns the sliding lines of parts[part], continued over those of its ends
// that lie on other parts: along the nearest line of such a part, away from the
// muscle, and perhaps through further parts, to an end on bones. A tendon
// between the muscle and the bone then keeps its length (LineRule::kTendon),
// and the muscle takes up the stretch of both. A line is not continued if it
// would turn by more than 60 degrees, if it reaches no bone, or if it returns
// to the body at its other end although the scene does not name the parts on
// which the muscle ends.
ContinuedLines ContinueLines(int part,
                             const std::vector<SoftPart>& parts,
                             const std::vector<BodySurface>& bodies);

}  // namespace musclewarp
