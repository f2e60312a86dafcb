// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/figures/frame_figures.h"
#include "musclewarp/opensim/storage_table.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// These functions make OpenSim tables of the figures of a run over time, in the
// units of OpenSim (m, m^3, s). The time is that of the poses if it rises, else
// the index of the frame.

// Returns the lengths of action lines. Column "glut_med1_r" has the length of
// the line as its muscle carries it, "glut_med1_r_path" the straight one
// through its path points.
StorageTable LengthTable(const std::vector<FrameFigures>& frames);

// Returns the volumes of the muscles, a column for each.
StorageTable VolumeTable(const std::vector<FrameFigures>& frames);

// Returns the lengths of fibres, in columns such as "psoas_major_r_fibre_1".
// There are no columns without fibres.
StorageTable FibreLengthTable(const std::vector<FrameFigures>& frames);

// Returns moment arms -dl/dq of action lines and of fibres, in metres for
// angles, in columns such as "glut_med1_r.hip_flexion_r" and
// "glut_med1_r_path.hip_flexion_r", for every coordinate that can change on its
// own or that the motion moves (MomentArmCoordinates). Those of straight paths
// are central differences of the model, those of carried lines are exact
// derivatives of the shapes in each frame. Frames of the paper's contact have
// no such derivatives: carried lines then have central differences over the
// frames (three points, one-sided at the ends), if a single coordinate moves.
// There are no columns without a model.
StorageTable MomentArmTable(const std::vector<FrameFigures>& frames,
                            const Scene& scene);
StorageTable FibreMomentArmTable(const std::vector<FrameFigures>& frames,
                                 const Scene& scene);

// Returns the names of the files that WriteMotionTables() may write.
std::vector<std::string> MotionTableNames();

// Writes lengths.sto, volumes.sto and, where they have columns,
// moment_arms.sto, fibre_lengths.sto and fibre_moment_arms.sto.
void WriteMotionTables(const std::vector<FrameFigures>& frames,
                       const Scene& scene,
                       const std::string& dir);

// Returns -dl/dq at each of a series of values: the slope of the parabola
// through the value and the nearest ones on both sides of it, or of the
// straight line where there is one side only. Precondition (CHECKed): equal
// sizes.
std::vector<double> SeriesMomentArms(const std::vector<double>& lengths,
                                     const std::vector<double>& coordinates);

}  // namespace musclewarp
