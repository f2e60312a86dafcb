// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/exchange/measured_run.h"
#include "musclewarp/exchange/path_beyond.h"
#include "musclewarp/opensim/dynamics.h"
#include "musclewarp/opensim/model.h"
#include "musclewarp/path_functions/path_sample.h"

namespace musclewarp {

// What runs measured of a path: a line that a muscle carries, or the mean of a
// band of its fibres.
struct MeasuredPath {
  std::string name;         // of the line, or "psoas_2" of the second band
  std::string muscle;       // that carries it
  std::vector<int> fibres;  // of the band, ascending; none for a line
  double share = 1;  // of the force of `replaces`: by the number of fibres

  // The muscles of the model in whose place it is: the line, or all those that
  // the muscle of a band carries; none if the model has none of them.
  std::vector<std::string> replaces;

  // The line itself, or of a band that of `replaces` which runs closest to it
  // at rest, and by how much the band is longer, on the mean of the samples,
  // mm.
  std::string nearest;
  double longer = 0;

  // The coordinates that it crosses (CrossedCoordinates), as ascending indices
  // into RunPaths::coordinates, and the largest arm of a sample about one that
  // it does not cross, mm per rad or m.
  std::vector<int> coordinates;
  double largest_other_arm = 0;

  std::vector<PathSample> samples;  // over all of RunPaths::coordinates

  // What the samples contain of the path of `nearest` in the model beyond the
  // muscle, such as a tendon with a mesh of its own: as long as at rest in
  // every frame.
  PartsBeyond beyond;
};

// What runs with an OpenSim model measured of all paths.
struct RunPaths {
  Model model;
  std::vector<std::string> coordinates;  // those of the moment arms
  std::vector<MeasuredPath> paths;       // by muscle, in the order of the run

  // The frames of the samples, such as "hip: frame_0007 (posture_7)"; those of
  // a design that count little (WhyDoubtful), and those that were left out
  // (WhyNoSample), with the reason.
  std::vector<std::string> frames;
  std::vector<std::string> frames_doubtful;
  std::vector<std::string> frames_left_out;

  // Lines without moment arms that are no muscles of the model; left out.
  std::vector<std::string> lines_without_arms;
};

// Returns why the frame of a posture says nothing about paths, or nothing.
std::string WhyNoSample(const FrameFigures& frame);

// Returns why a usable frame of a posture says little about paths, or nothing:
// bones lie in each other, which squeezes a muscle between them out of its
// place. Its samples count by kDoubtfulWeight, so that functions stay sane
// there.
std::string WhyDoubtful(const FrameFigures& frame);
constexpr double kDoubtfulWeight = 0.1;

// Returns the largest force of a path, N: its share of the forces of the
// muscles that it replaces, or 0 if the model has none of them.
double ForceOf(const MeasuredPath& path, const ModelDynamics& dynamics);

// Returns the paths of runs of one scene. Coordinates that a run does not give
// are at the default values of the model. Of a design of postures the usable
// frames count. If `paths_per_muscle` is above 0, the paths are bands
// of the fibres of the first run, at most so many of each muscle (FibreBands),
// instead of lines.
//
// Throws InputError that names the run and the field if a run has no usable
// frame, other lines, other coordinates or another contact mode than the first,
// no moment arms (--contact=paper) or ones that mean nothing, or if bands are
// asked for and a muscle has no fibres. Precondition (CHECKed): there is a run.
RunPaths PathsOf(Model model,
                 const std::vector<MeasuredRun>& runs,
                 int paths_per_muscle);

// Reads report.json of one or more runs, of this or another version, and
// returns their paths. The model is that of the first run, or `model_path` if
// that is not empty. Throws InputError as PathsOf() does, and if a motion is
// not usable, if a run is not finished or has no model or another one than the
// first.
RunPaths ReadRunPaths(const std::vector<std::string>& dirs,
                      const std::string& model_path,
                      int paths_per_muscle = 0);

}  // namespace musclewarp
