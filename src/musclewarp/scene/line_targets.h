// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/transformed.h"
#include "musclewarp/scene/perturbed_poses.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Returns the transform target_from_rest of a body in a pose (mm), or the
// identity if the pose does not name the body.
Eigen::Matrix4d BodyTransform(const ScenePose& pose, const std::string& body);

// Returns the targets of the lines of a muscle in a pose, one for each line:
// the target points that the pose gives, or else those of a taut line
// (taut_lines.h), or else the rest points moved with their bodies, or else the
// rest points. The inner points of a sliding line that is not taut also move
// with the bodies of neighbouring points, and are then distributed along the
// line as at rest. If a line names bodies, its target also has their rotations,
// for the twist of the muscle about the line. Points are #P x 3, mm. `lines`
// are all lines of the muscle, as they may be tied to each other.
std::vector<LineTarget> LineTargets(const std::vector<ActionLine>& lines,
                                    const ScenePose& pose);

// Returns a pose with the taut lines of all muscles of a scene solved
// (ScenePose::taut_lines), so that LineTargets() need not solve them again.
ScenePose WithTautLines(const Scene& scene, ScenePose pose);

// Gives the taut lines of a muscle to the poses beside `pose`, by coordinate:
// their points
// there, moved on by their exact derivative (TautRates), so that differences
// between the two poses do not depend on where in between a support begins to
// bear. Lines to which `pose` gives points stay as they are.
void SetTautLines(const std::vector<ActionLine>& lines,
                  const ScenePose& pose,
                  std::vector<PerturbedPoses>* beside);

}  // namespace musclewarp
