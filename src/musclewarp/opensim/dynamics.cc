// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/dynamics.h"

#include <vector>

#include "musclewarp/opensim/component_tree.h"
#include "musclewarp/opensim/osim_xml.h"

namespace musclewarp {
namespace {

// OpenSim 4 has the moments of inertia in one element, OpenSim 3 in six.
BodyMass MassOf(const OsimXml& xml, pugi::xml_node element) {
  constexpr std::array<const char*, 6> kOfOpenSim3 = {"inertia_xx",
                                                      "inertia_yy",
                                                      "inertia_zz",
                                                      "inertia_xy",
                                                      "inertia_xz",
                                                      "inertia_yz"};
  BodyMass body;
  body.mass = xml.Number(element, "mass", 0);
  body.centre = kMillimetresPerMetre *
                xml.Vector(element, "mass_center", Eigen::Vector3d::Zero());
  const std::vector<double> moments =
      xml.Numbers(element, "inertia", body.inertia.size(), {0, 0, 0, 0, 0, 0});
  for (size_t i = 0; i < body.inertia.size(); ++i) {
    body.inertia[i] = xml.Number(element, kOfOpenSim3[i], moments[i]);
  }
  return body;
}

void AddMuscles(const OsimXml& xml,
                pugi::xml_node element,
                ModelDynamics* dynamics) {
  if (element.child("max_isometric_force")) {
    MuscleDynamics& muscle = dynamics->muscles[ComponentName(element)];
    muscle.force = xml.Number(element, "max_isometric_force", 0);
    muscle.tendon =
        kMillimetresPerMetre * xml.Number(element, "tendon_slack_length", 0);
    return;
  }
  for (const pugi::xml_node child : ElementsOf(element)) {
    AddMuscles(xml, child, dynamics);
  }
}

}  // namespace

ModelDynamics DynamicsOf(const Model& model) {
  const OsimXml xml(model.text, model.path);
  const pugi::xml_node root = std::string(xml.root().name()) == "Model"
                                  ? xml.root()
                                  : xml.root().child("Model");
  ModelDynamics dynamics;
  for (const pugi::xml_node body : ElementsNamed(root, "Body")) {
    dynamics.bodies[ComponentName(body)] = MassOf(xml, body);
  }
  for (const pugi::xml_node child : ElementsOf(root)) {
    if (std::string(child.name()) != "defaults") {
      AddMuscles(xml, child, &dynamics);
    }
  }
  return dynamics;
}

}  // namespace musclewarp
