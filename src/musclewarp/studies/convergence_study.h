// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/frames/triangle_stretch.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The discretisation of a scene.
struct Discretisation {
  int coarse_vertices = 0;    // approximate number, of the hull of a muscle
  double sample_spacing = 0;  // of samples along action lines, mm
  double density = 1;         // of triangles, relative to the prepared meshes

  bool operator==(const Discretisation& other) const {
    return coarse_vertices == other.coarse_vertices &&
           sample_spacing == other.sample_spacing && density == other.density;
  }
};

// The value that a study of convergence varies.
enum class StudyKind { kVertices, kSpacing, kDensity };

// Returns "vertices", "spacing" or "density", as in reports.
std::string ToString(StudyKind kind);

// Returns the value of a discretisation that a study varies.
double ValueOf(StudyKind kind, const Discretisation& discretisation);

// The values of each study; a study without values is left out.
struct StudyValues {
  std::vector<int> vertices;
  std::vector<double> spacings;  // mm
  std::vector<double> densities;
};

// Discretisations that differ in one value, from the coarsest to the finest.
struct ConvergenceStudy {
  StudyKind kind = StudyKind::kVertices;
  std::vector<Discretisation> discretisations;
};

// Returns the studies that have values. Each includes `as_set`, the
// discretisation that the flags set, and no value twice.
std::vector<ConvergenceStudy> StudiesOf(const StudyValues& values,
                                        const Discretisation& as_set);

// Returns every discretisation of the studies once, `as_set` first.
std::vector<Discretisation> AllDiscretisations(
    const std::vector<ConvergenceStudy>& studies, const Discretisation& as_set);

// A muscle in one frame, with one discretisation.
struct DiscretisedMuscle {
  int coarse_vertices = 0, samples = 0, fine_vertices = 0;  // actual numbers
  bool is_reconstructed = false;  // true if certified contact made a new mesh

  // The displacements from rest of the vertices of the base mesh, #V x 3, mm.
  // Vertices move with the nearest places on the surface (CarriedPoints), which
  // are at most `rest_distance` (mm) away at rest. The base mesh is that of the
  // prepared scene, so that all discretisations are compared at the same
  // points.
  Points displacements;
  double rest_distance = 0;

  double volume_ratio = 1;  // to the volume at rest
  StretchMeasures stretch;

  // By line and coordinate; empty without a model (MuscleFigures).
  std::map<std::string, std::map<std::string, double>> moment_arms;
};

// One frame, with one discretisation.
struct DiscretisedFrame {
  double ms = 0;  // time to move the muscles to the pose
  bool is_usable = false;
  std::vector<DiscretisedMuscle> muscles;  // in the order of the scene
};

// The result of one discretisation.
struct DiscretisationResult {
  Discretisation discretisation;
  std::string failure;  // empty if the scene was solved
  double prepare_ms = 0;
  std::vector<DiscretisedFrame> frames;  // in the order of the compared frames
};

// A row of the tables: one muscle in one frame, with one value of a study. A
// discretisation that could not be solved has one row, without a muscle.
struct ConvergenceRow {
  StudyKind study = StudyKind::kVertices;
  double value = 0;
  bool is_as_set = false;  // the discretisation that the flags set
  bool is_finest = false;  // the one with which the others are compared
  std::string failure;     // if not empty, the fields below are undefined
  int frame = 0;
  std::string pose;
  std::string muscle;
  int coarse_vertices = 0, samples = 0, fine_vertices = 0;
  bool is_reconstructed = false;
  double rest_distance = 0;

  // The distance of a vertex of the base mesh from its position with the finest
  // discretisation, mm.
  double largest_distance = 0, mean_distance = 0;
  double volume_ratio = 1;
  StretchMeasures stretch;

  // The largest difference between the moment arm of a line and that of the
  // finest discretisation, mm (mm/m for a coordinate that is a length). Empty
  // without a model.
  std::optional<double> moment_arm_difference;
  double ms = 0;
  bool is_usable = false;
};

// The compared frames and the muscles of a scene.
struct StudiedFrames {
  std::vector<int> frames;         // their indices
  std::vector<std::string> poses;  // their names
  std::vector<std::string> muscles;
};

// Compares the results of a study with those of its finest discretisation that
// was solved. Precondition (CHECKed): every discretisation of the study has a
// result.
std::vector<ConvergenceRow> RowsOf(
    const ConvergenceStudy& study,
    const std::vector<DiscretisationResult>& results,
    const Discretisation& as_set,
    const StudiedFrames& studied);

}  // namespace musclewarp
