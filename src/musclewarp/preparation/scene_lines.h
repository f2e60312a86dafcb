// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "musclewarp/fibres/continued_lines.h"
#include "musclewarp/preparation/bare_tendons.h"
#include "musclewarp/preparation/surroundings.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// How sliding lines go between their ends in a pose.
enum class LineCourse {
  kTaut,    // as short as what supports them allows (taut_lines.h)
  kGuided,  // each point with the nearest body
};

std::string ToString(LineCourse course);

// Returns true if MakeSceneLines has anything to do.
bool NeedsLines(const Scene& scene, LineCourse course);

struct SceneLineOptions {
  int lines_each = 3;  // for each muscle without lines
  LineCourse course = LineCourse::kTaut;
};

// The lines of a muscle of a scene.
struct MadeLines : ContinuedLines {
  // Along which they go on to bones where no mesh does; taut lines only.
  std::vector<BareTendon> bare_tendons;
};

// Makes lines for each muscle of a scene that has none (MakeLines), continues
// them through the soft parts on which these muscles end (ContinueLines) and
// along tendons without a mesh (AddBareTendons), and finds what holds them
// where they are to be taut (FindSupports); this also for sliding lines of the
// scene. `surroundings` has the repaired meshes of the scene. Returns the lines
// of each muscle for which it made or changed any, and none for the others.
// `on_item`, which may be empty, is called on the calling thread with the
// number of a muscle before its lines are made, and of the finished muscles
// (ParallelFor). Throws InputError as MakeLines does.
std::vector<MadeLines> MakeSceneLines(
    const Surroundings& surroundings,
    const SceneLineOptions& options,
    const std::function<void(size_t m, size_t done)>& on_item,
    const Scene& scene);

// Returns of the soft parts `through` which lines go on those that are no
// tendons to which the muscle is tied. Guided lines count them all.
std::vector<int> BesideTendons(LineCourse course,
                               const std::vector<int>& through,
                               const std::vector<int>& tied_to);

}  // namespace musclewarp
