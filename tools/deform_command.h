// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/deformer/deformer.h"
#include "musclewarp/run/frame_files.h"
#include "musclewarp/settings/deformer_settings.h"
#include "musclewarp/settings/scene_settings.h"
#include "musclewarp/settings/thread_settings.h"

namespace musclewarp {

// The settings that a run of musclewarp-deform has in addition to those of the
// scene, the deformer and the files.
struct RunSettings {
  std::string out;
  bool html = false;
  bool resume = false;
  bool overwrite = false;
  bool profile = false;
  std::string record_steps;
};

constexpr const char* HeadingOf(Described<RunSettings>) {
  return "Run and its files";
}

constexpr auto FieldsOf(Described<RunSettings>) {
  using S = RunSettings;
  return std::make_tuple(
      Field(&S::out, "out")
          .Text("folder for the frames and report.json")
          .Path()
          .Changes(Effect::kNothing),
      Field(&S::html, "html")
          .Text("also write report.html, the run as one page to look at")
          .Changes(Effect::kNothing),
      Field(&S::resume, "resume")
          .Text("continue an interrupted run of the same input in {out}")
          .Changes(Effect::kNothing),
      Field(&S::overwrite, "overwrite")
          .Text("remove frames in {out} that belong to no run that report.json "
                "there names; without it they are refused")
          .Changes(Effect::kNothing),
      Field(&S::profile, "profile")
          .Text("write the times of the stages of each frame to report.json "
                "and the page")
          .Changes(Effect::kNothing),
      Field(&S::record_steps, "record_steps")
          .Text("folder to which the steps of certified contact are written, "
                "for step_benchmark (benchmarks/README.md); the preparation is "
                "kept there, too, unless {cache} names another folder")
          .Path()
          .Changes(Effect::kNothing));
}

// The options of a run of musclewarp-deform.
struct DeformOptions : SceneSettings, RunSettings, ThreadSettings {
  DeformerOptions deformer;
  FrameFileOptions files;
  ModelSources sources;      // replace what the scene says of its model
  bool is_terminal = false;  // true if the screen is a terminal

  // The flags that StepRecorder writes beside the recorded steps.
  std::string step_flags;

  // The record of the call: the flags that affect the results, the command line
  // that repeats the run, and all flags with their values.
  std::string result_flags;
  std::string command;
  std::map<std::string, std::string> all_flags;
};

// Throws InputError if an option is not allowed or no scene is given.
void CheckSceneOptions(const DeformOptions& options);

// Deforms the muscles of a scene in every selected pose, and writes the frames
// and report.json to `out` and a summary to `screen`. In a motion, each frame
// starts from the one before, and tables of lengths, volumes and moment arms
// are written as well. The files that are there are complete whenever the
// program is killed. With `resume`, an interrupted run of the same input
// continues where it stopped, and ends with the same result. If a run is
// interrupted (SIGINT, SIGTERM) or cannot write a frame, its report states the
// reason. Returns an exit code. Throws InputError, before anything is written,
// for bad input.
int DeformCommand(const DeformOptions& options, std::ostream& screen);

}  // namespace musclewarp
