// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/figures/frame_figures.h"
#include "musclewarp/frames/scene_state.h"

namespace musclewarp {

// The log by which an interrupted run can be continued. Until a run is
// finished, DIR/.resume holds the figures of every frame that is written and
// the state that the next frame starts from, to the last bit, and the
// preparation of the scene.
//
//   const ResumeLog log(dir, inputs_hash);
//   std::vector<FrameFigures> frames = log.Continue(selected, &state);
//   if (frames.empty()) log.StartAnew();
//   ...                              // for every frame: write its files, then
//   log.FrameDone(record, state);
//   ...                              // once all frames are there
//   log.Finish();
class ResumeLog {
 public:
  ResumeLog(const std::string& dir, const std::string& inputs_hash);

  // Returns true if a run was interrupted in `dir`, of whatever input.
  static bool IsIn(const std::string& dir);

  // Returns the frames of an interrupted run of the same input, from the first
  // of `selected` on without a gap: up to the first whose folder is missing or
  // whose log is damaged, which is logged. `state` becomes the one that was
  // kept with the last of them, if there is one. Throws InputError if DIR holds
  // an interrupted run of other input or options, or of other code of
  // musclewarp.
  std::vector<FrameFigures> Continue(const std::vector<int>& selected,
                                     SceneState* state) const;

  // Returns the folder for the preparation of the scene, a cache for
  // PreparationCache. It is valid before and after StartAnew().
  std::string PreparationFolder() const;

  // Deletes the frames of an interrupted run and begins a new log.
  void StartAnew() const;

  // Adds a frame, with the state that the next one starts from, empty if none
  // does (a design of postures). To be called once its files are complete.
  void FrameDone(const FrameFigures& record, const SceneState& state) const;

  // Returns the folders of the rest pose and of these frames that are not
  // there, as someone has removed them.
  std::vector<std::string> Missing(const std::vector<int>& indices) const;

  // Deletes the log, as the run is complete.
  void Finish() const;

 private:
  std::string FrameFile(int index) const;
  std::string FramePath(int index) const;  // the folder of its meshes
  // The file that names the layout, the input and the code, and its text.
  std::string KeyFile() const;
  std::string KeyText() const;

  std::string folder_;
  std::string inputs_hash_;
};

}  // namespace musclewarp
