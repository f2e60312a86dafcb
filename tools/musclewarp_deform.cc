// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/phantom/demo_scene.h"
#include "musclewarp/program/flags.h"
#include "musclewarp/program/program.h"
#include "musclewarp/run/output_folder.h"
#include "musclewarp/run/output_lock.h"
#include "musclewarp/settings/file_settings.h"
#include "tools/deform_command.h"
#include "tools/model_listing.h"

namespace musclewarp {
namespace {

const ProgramText kText = {
    "musclewarp-deform --scene=FILE --out=DIR [flags]\n"
    "       musclewarp-deform --demo --out=DIR [flags]\n"
    "       musclewarp-deform --list --model=FILE [--motion=FILE]\n\n"
    "Deforms the muscles of a scene so that they follow their lines of "
    "action and\nkeep their volume, in each pose or along a motion "
    "(OpenSim .osim and .mot, or poses\nwith times). Writes "
    "DIR/frame_0000/<name>.ply, ..., DIR/report.json and, of motions,\n"
    "DIR/lengths.sto, moment_arms.sto and volumes.sto.\n"
    "Exit code: 0 usable, 1 not usable (the summary says why), 2 bad input.",
    {{"musclewarp-deform --demo --out=demo",
      "deforms a hip that is inside the program; demo/report.html shows it"},
     {"musclewarp-deform --scene=hip.json --out=run --frames=0:10 --html",
      "deforms the first eleven poses of a scene, with a page to look at"}},
    {"scene", "out", "frames", "motion", "html"}};

// The settings of what the program can do other than deforming the scene of a
// user.
struct OtherJobs {
  bool demo = false;
  bool list = false;
  std::string model;
};

constexpr const char* HeadingOf(Described<OtherJobs>) {
  return "Other than deforming a scene";
}

constexpr auto FieldsOf(Described<OtherJobs>) {
  using S = OtherJobs;
  return std::make_tuple(
      Field(&S::demo, "demo")
          .Text("deform the scene that is inside the program, which is written "
                "to OUT/scene; sets {html}")
          .Changes(Effect::kNothing),
      Field(&S::list, "list")
          .Text("print the bodies, muscles, coordinates and meshes of the "
                "OpenSim model {model}, and where its meshes are; with "
                "{motion} also what the motion moves")
          .Changes(Effect::kNothing),
      Field(&S::model, "model")
          .Text("the OpenSim model (.osim) for {list}")
          .Path()
          .Changes(Effect::kNothing));
}

// All settings of the program.
struct Settings {
  DeformOptions run;
  DeformerSettings deformer;
  FileSettings files;
  OtherJobs jobs;
};

void RecordSteps(const Settings& settings, DeformOptions* options) {
  if (options->record_steps.empty()) return;
  if (options->deformer.frames.contact != ContactKind::kCertified) {
    throw InputError("--record_steps",
                     "is given with --contact=" + settings.deformer.contact,
                     "only certified contact has steps to record");
  }
  CheckWritable(options->record_steps);
  options->step_flags = FlagFileOf<SceneSettings>(settings.run, {"frames"}) +
                        FlagFileOf(settings.deformer, {"cache"});
  std::string* cache = &options->deformer.cache.folder;
  if (cache->empty()) {
    *cache = (std::filesystem::path(options->record_steps) / "preparations")
                 .string();
  }
}

DeformOptions OptionsOf(Settings settings) {
  DeformOptions options = settings.run;
  settings.deformer.given = GivenFlags();
  options.deformer = OptionsOf(settings.deformer);
  options.deformer.record_stages = options.profile;
  options.files = OptionsOf(settings.files);
  options.sources = OptionsOf(PartOf<SceneSettings>(options));
  options.command = CommandLine({"resume", "overwrite"});
  options.result_flags = ResultFlagsText();
  options.all_flags = AllFlagValues();
  RecordSteps(settings, &options);
  options.is_terminal = isatty(STDOUT_FILENO);
  return options;
}

// Returns the path of a file that is named relative to --data_root.
std::string InDataRoot(const Settings& settings, const std::string& path) {
  return path.empty()
             ? path
             : (std::filesystem::path(settings.run.data_root) / path).string();
}

int ListModel(const Settings& settings) {
  if (settings.jobs.model.empty()) {
    throw InputError("--list", "needs a model", "give --model=FILE.osim");
  }
  ModelSources sources = OptionsOf(PartOf<SceneSettings>(settings.run));
  sources.motion = InDataRoot(settings, sources.motion);
  PrintModel(InDataRoot(settings, settings.jobs.model), sources, std::cout);
  return kExitUsable;
}

// Writes the embedded scene, and sets it as the scene of the run. Throws
// InputError, before anything is written, for options that are not allowed.
void PrepareDemo(DeformOptions* options) {
  for (const auto& [flag, value] :
       {std::pair("--scene", options->scene),
        std::pair("--data_root", options->data_root)}) {
    if (value.empty()) continue;
    throw InputError("--demo",
                     std::string("is given with ") + flag,
                     "give one of them; --demo has a scene of its own");
  }
  options->html = true;
  options->scene = DemoScenePath(options->out);
  CheckSceneOptions(*options);
  CheckWritable(options->out);
  const OutputLock lock(options->out);
  WriteDemoScene(options->out);
}

int Run(const Settings& settings) {
  if (settings.jobs.list) return ListModel(settings);
  if (!settings.jobs.model.empty()) {
    throw InputError("--model",
                     "is given without --list",
                     "name the model in the scene, or add --list");
  }
  DeformOptions options = OptionsOf(settings);
  if (settings.jobs.demo) PrepareDemo(&options);
  return DeformCommand(options, std::cout);
}

}  // namespace
}  // namespace musclewarp

int main(int argc, char** argv) {
  using namespace musclewarp;
  Settings settings;
  RegisterFlags<SceneSettings>(&settings.run);
  RegisterFlags<RunSettings>(&settings.run);
  RegisterFlags(&settings.files);
  RegisterFlags(&settings.deformer);
  RegisterFlags<ThreadSettings>(&settings.run);
  RegisterFlags(&settings.jobs);
  return RunProgram(
      argc, argv, kText, [&](const std::vector<std::string>& arguments) {
        RefuseArguments(arguments);
        return Run(settings);
      });
}
