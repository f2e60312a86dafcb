// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/muscle_elements.h"

#include <glog/logging.h>

#include <algorithm>

#include "musclewarp/base/text.h"
#include "musclewarp/joints/model_elements.h"
#include "musclewarp/opensim/model.h"

namespace musclewarp {
namespace {

void AddPath(const std::vector<std::string>& bodies,
             const ActionLine& line,
             pugi::xml_node muscle) {
  CHECK_EQ(line.bodies.size(), static_cast<size_t>(line.rest.rows()));
  pugi::xml_node objects = AddNamed(muscle, "GeometryPath", "geometrypath")
                               .append_child("PathPointSet")
                               .append_child("objects");
  for (int i = 0; i < line.rest.rows(); ++i) {
    const std::string& body = line.bodies[i];
    CHECK(std::count(bodies.begin(), bodies.end(), body) > 0) << body;
    pugi::xml_node point = AddNamed(
        objects, "PathPoint", line.name + "-P" + std::to_string(i + 1));
    AddText(point, "socket_parent_frame", FramePathOf(body));
    AddText(point,
            "location",
            VectorText(line.rest.row(i).transpose() / kMillimetresPerMetre));
  }
}

void AddMuscle(const std::vector<std::string>& bodies,
               const LineMuscle& muscle,
               pugi::xml_node objects) {
  pugi::xml_node node =
      AddNamed(objects, "Millard2012EquilibriumMuscle", muscle.line.name);
  AddPath(bodies, muscle.line, node);
  const MuscleEstimate estimate = EstimateMuscle(muscle);
  AddComment(node, "Estimates, no measurements:");
  AddText(node, "max_isometric_force", ExactText(estimate.max_isometric_force));
  AddText(node,
          "optimal_fiber_length",
          ExactText(estimate.optimal_fibre_length / kMillimetresPerMetre));
  AddText(node,
          "tendon_slack_length",
          ExactText(estimate.tendon_slack_length / kMillimetresPerMetre));
  AddText(node, "pennation_angle_at_optimal", ExactText(estimate.pennation));
}

std::string HowTheyAreEstimated() {
  constexpr double kSquareMillimetres = 100;  // in a cm2
  return "Forces and lengths of fibres and tendons are estimates from the "
         "shapes of the muscles: the optimal fibre length is " +
         MeasureText(kFibreShare) + " of the path at rest, the force is " +
         MeasureText(kSpecificTension * kSquareMillimetres) +
         " N/cm2 times volume over fibre length, the tendon is slack at rest, "
         "and pennation is 0. Replace them by measurements where you have "
         "them.";
}

}  // namespace

void AddMuscles(const std::vector<std::string>& bodies,
                const std::vector<LineMuscle>& muscles,
                pugi::xml_node model) {
  pugi::xml_node set = AddNamed(model, "ForceSet", "forceset");
  AddComment(set, HowTheyAreEstimated());
  pugi::xml_node objects = set.append_child("objects");
  for (const LineMuscle& muscle : muscles) AddMuscle(bodies, muscle, objects);
}

}  // namespace musclewarp
