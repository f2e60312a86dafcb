// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/run_writer.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "musclewarp/base/described_checks.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/run/attachments_file.h"
#include "musclewarp/run/kept_model.h"
#include "musclewarp/run/motion_tables.h"

namespace musclewarp {

namespace fs = std::filesystem;

const SceneIntersections& AsDelivered(const PreparedScene& scene,
                                      const Frame& rest) {
  return scene.as_delivered ? *scene.as_delivered : rest.intersections;
}

RunWriter::RunWriter(const PreparedScene& scene,
                     FrameFileOptions files,
                     std::string dir)
    : scene_(&scene), files_(std::move(files)), dir_(std::move(dir)) {}

void RunWriter::WriteRest(const Frame& rest) const {
  musclewarp::WriteFrame(*scene_, rest, files_, dir_);
  KeepModel(scene_->scene, dir_);
  WriteAttachments((fs::path(dir_) / kAttachmentsFile).string(),
                   AttachmentsOf(*scene_));
}

FrameFigures RunWriter::WriteFrame(const Frame& frame) const {
  musclewarp::WriteFrame(*scene_, frame, files_, dir_);
  FrameFigures figures = FiguresOf(frame);
  for (const std::string& file :
       FilesThatDiffer(*scene_, frame, files_, dir_)) {
    figures.shortcomings.push_back(file +
                                   ": differs from the frame that was counted");
  }
  std::string error;
  if (!IsValid(figures, &error)) {
    figures.shortcomings.push_back("a figure makes no sense: " + error);
  }
  return figures;
}

void RunWriter::WriteTables(const std::vector<FrameFigures>& frames) const {
  if (files_.HasFormat("vtp")) {
    std::vector<int> indices;
    for (const FrameFigures& frame : frames) indices.push_back(frame.index);
    WritePvd(*scene_, indices, dir_);
  }
  if (scene_->scene.is_motion) {
    WriteMotionTables(frames, scene_->scene, dir_);
  }
}

void RunWriter::WriteReport(const RunRecord& run) {
  const Stopwatch writing;
  // Texts of files that are not UTF-8 may be in warnings.
  const auto on_error = nlohmann::ordered_json::error_handler_t::replace;
  WriteTextAtomically((fs::path(dir_) / kReportFile).string(),
                      ReportJson(run).dump(2, ' ', false, on_error) + "\n");
  report_ms_ = writing.Milliseconds();
  since_report_.emplace();
}

void RunWriter::KeepReportUpToDate(const RunRecord& run) {
  constexpr double kPause = 10;  // times as long as writing took
  if (since_report_ && since_report_->Milliseconds() < kPause * report_ms_) {
    return;
  }
  WriteReport(run);
}

}  // namespace musclewarp
