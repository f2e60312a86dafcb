// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/opensim/storage_table.h"
#include "musclewarp/report/frame_record.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// The figures of a run over time as OpenSim tables, in its units (m, m^3, s).
// Time is that of the poses if it rises, else the index of the frame.

// "glut_med1_r": the line as its muscle carries it; "glut_med1_r_path":
// straight through the path points.
StorageTable LengthTable(const std::vector<FrameRecord>& frames);

// By muscle.
StorageTable VolumeTable(const std::vector<FrameRecord>& frames);

// "psoas_major_r_fibre_1"; no columns without fibres.
StorageTable FibreLengthTable(const std::vector<FrameRecord>& frames);

// -dl/dq, "glut_med1_r.hip_flexion_r" and "glut_med1_r_path.hip_flexion_r", m
// for angles. Of straight paths by central differences of the model in every
// coordinate that the motion moves. Of carried lines by central differences
// over the frames (three points, one-sided at the ends), which has a meaning
// only where one coordinate moves; they are left out where several do. No
// columns without a model.
StorageTable MomentArmTable(const std::vector<FrameRecord>& frames,
                            const Scene& scene);
StorageTable FibreMomentArmTable(const std::vector<FrameRecord>& frames,
                                 const Scene& scene);

// Writes lengths.sto, volumes.sto and, where they have columns,
// moment_arms.sto, fibre_lengths.sto and fibre_moment_arms.sto.
void WriteMotionTables(const std::vector<FrameRecord>& frames,
                       const Scene& scene,
                       const std::string& dir);

// -dl/dq at each of a series of values: the slope of the parabola through the
// value and the nearest ones on both sides of it, or of the straight line where
// there is one side only. Precondition (CHECKed): equal sizes.
std::vector<double> SeriesMomentArms(const std::vector<double>& lengths,
                                     const std::vector<double>& coordinates);

}  // namespace musclewarp
