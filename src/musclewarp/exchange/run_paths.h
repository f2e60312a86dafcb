// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "musclewarp/exchange/path_fit.h"
#include "musclewarp/opensim/model.h"

namespace musclewarp {

// What runs with an OpenSim model measured of the lines that muscles carry.
struct RunPaths {
  Model model;
  std::vector<std::string> coordinates;  // those of the moment arms
  std::map<std::string, std::vector<PathSample>> lines;

  // What the samples of a line contain of its path beyond its muscle, such as a
  // tendon with a mesh of its own, mm (path_beyond.h): as long as at rest in
  // every frame. Only lines of which there is such a part.
  std::map<std::string, double> beyond;

  // Lines of the scene that the model does not have as muscles; left out.
  std::set<std::string> lines_without_muscle;
};

// Reads report.json of one or more runs, of this or another version. The model
// is that of the first run, or `model_path` if that is not empty. Coordinates
// that a run does not give are at their default values.
//
// Throws InputError that names the run and the field if a run is not usable or
// not finished, has no model, other lines, other coordinates, another model or
// another contact mode than the first, no moment arms (--contact=paper) or ones
// that mean nothing, or if the model has none of the lines as a muscle.
RunPaths ReadRunPaths(const std::vector<std::string>& dirs,
                      const std::string& model_path);

}  // namespace musclewarp
