// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/base/described.h"
#include "musclewarp/studies/convergence_study.h"
#include "tools/deform_command.h"

namespace musclewarp {

// The settings that a study of discretisations has in addition to those of the
// scene.
struct ConvergenceSettings {
  bool convergence = false;
  std::string convergence_vertices = "100,200,300,600,1200,2400";
  std::string convergence_spacing = "2.5,5,10,20,40";
  std::string convergence_density = "0.25,1,4";
};

constexpr const char* HeadingOf(Described<ConvergenceSettings>) {
  return "Study of convergence";
}

constexpr auto FieldsOf(Described<ConvergenceSettings>) {
  using S = ConvergenceSettings;
  return std::make_tuple(
      Field(&S::convergence, "convergence")
          .Text("compare discretisations instead of solvers: how far shapes "
                "are from those of the finest; with {contact}=none or "
                "certified"),
      Field(&S::convergence_vertices, "convergence_vertices")
          .Text("with {convergence}, approximate numbers of vertices of hulls "
                "to compare; empty: hulls are not studied"),
      Field(&S::convergence_spacing, "convergence_spacing", "mm")
          .Text("with {convergence}, distances of samples along a line to "
                "compare; empty: samples are not studied"),
      Field(&S::convergence_density, "convergence_density")
          .Text("with {convergence}, numbers of triangles of muscle meshes to "
                "compare, as multiples of what they have: 0.25, 1, 4 and 16; "
                "empty: they are not studied"));
}

struct ConvergenceOptions {
  // The scene, its frames, preparation, contact and solver. The formats are not
  // used.
  DeformOptions deform;
  StudyValues values;
};

// Returns the values of the studies. Their texts are numbers separated by
// commas, in any order; an empty text has no values. Throws InputError, naming
// the setting, for a value that is not allowed.
StudyValues StudyValuesOf(const ConvergenceSettings& settings);

// Returns the contact of a study. Throws InputError, naming --contact, unless
// it is none or certified.
ContactKind ParseConvergenceContact(const std::string& text);

// Solves the selected frames of a scene once for every discretisation of the
// studies, and prints the distance of each from the finest one of its study;
// with an output folder, also writes convergence.csv and convergence.json. The
// discretisation that the options set is always included. The row of a
// discretisation that failed states the failure. Returns an exit code: 0 if the
// tables are complete. Throws InputError, before anything is written, for bad
// input.
int ConvergenceCommand(const ConvergenceOptions& options, std::ostream& screen);

}  // namespace musclewarp
