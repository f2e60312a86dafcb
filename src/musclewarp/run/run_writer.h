// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "musclewarp/base/stopwatch.h"
#include "musclewarp/figures/frame_figures.h"
#include "musclewarp/frames/frame.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/run/frame_files.h"
#include "musclewarp/run/report_json.h"

namespace musclewarp {

// The report of a run, from its folder on.
constexpr char kReportFile[] = "report.json";

// Returns the intersections of the meshes of a scene as they were delivered;
// `rest`: its rest frame.
const SceneIntersections& AsDelivered(const PreparedScene& scene,
                                      const Frame& rest);

// Writes the files of a run into its folder:
//
//   RunWriter writer(deformer.scene(), {}, dir);
//   writer.WriteRest(deformer.RestFrame());
//   for (...) run.frames.push_back(writer.WriteFrame(frame));
//   writer.WriteTables(run.frames);
//   writer.WriteReport(run);
//
// Everything throws InputError if a file cannot be written. What an earlier run
// has left is removed by RemoveEarlierRun() (earlier_run.h).
class RunWriter {
 public:
  // Keeps a pointer to the scene.
  RunWriter(const PreparedScene& scene,
            FrameFileOptions files,
            std::string dir);

  // Writes the rest pose, the model and the attachments.
  void WriteRest(const Frame& rest) const;

  // Writes a frame, reads its files back and returns its figures. A file that
  // differs from the frame is a shortcoming of it, so that the counts of the
  // figures are those of the files; so is a figure that is no number or out of
  // its range.
  FrameFigures WriteFrame(const Frame& frame) const;

  // Writes what follows from all frames: the tables of a motion, and the
  // collection of .vtp files.
  void WriteTables(const std::vector<FrameFigures>& frames) const;

  // Writes report.json.
  void WriteReport(const RunRecord& run);

  // The same, but for a tenth of the time at most: the report grows with every
  // frame.
  void KeepReportUpToDate(const RunRecord& run);

 private:
  const PreparedScene* scene_;
  const FrameFileOptions files_;
  const std::string dir_;
  double report_ms_ = 0;  // for writing the last report
  std::optional<Stopwatch> since_report_;
};

}  // namespace musclewarp
