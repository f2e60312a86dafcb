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

// The settings of a run of musclewarp-deform beside those of the scene, the
// deformer and the files.
struct RunSettings {
  std::string out;
  bool html = false;
  bool resume = false;
  bool overwrite = false;
  bool profile = false;
  std::string record_steps;
};

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

// What musclewarp-deform is asked for.
struct DeformOptions : SceneSettings, RunSettings, ThreadSettings {
  DeformerOptions deformer;
  FrameFileOptions files;
  ModelSources sources;      // what is not as the scene has it
  bool is_terminal = false;  // true if the screen is a terminal

  // The flags that are written with recorded steps (StepRecorder).
  std::string step_flags;

  // For the record: the flags that make a difference to the result, the command
  // line that repeats the run, and all flags with their values.
  std::string result_flags;
  std::string command;
  std::map<std::string, std::string> all_flags;
};

// Throws InputError if no scene can be run with the options.
void CheckSceneOptions(const DeformOptions& options);

// Deforms the muscles of a scene in every selected pose, writes the frames and
// report.json to `out` and a summary to `screen`. In a motion each frame starts
// from the one before, and tables of lengths, volumes and moment arms are
// written as well. Whenever the program is killed, the files that are there are
// complete. With `resume` an interrupted run of the same input is continued
// where it was, to the same result. A run that is interrupted (SIGINT, SIGTERM)
// or cannot write a frame says why in its report. Returns an exit code. Throws
// InputError, before anything is written, for bad input.
int DeformCommand(const DeformOptions& options, std::ostream& screen);

}  // namespace musclewarp
