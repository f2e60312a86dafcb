// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gflags/gflags.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "tools/deform_command.h"
#include "tools/deformer_settings.h"
#include "tools/demo_scene.h"
#include "tools/flag_values.h"
#include "tools/model_listing.h"
#include "tools/output_folder.h"
#include "tools/output_lock.h"
#include "tools/program.h"
#include "tools/scene_flags.h"

DECLARE_string(scene);
DECLARE_string(data_root);
DEFINE_string(out, "", "folder for the frames and report.json");
DEFINE_bool(demo,
            false,
            "deform the scene that is inside the program, which is written to "
            "OUT/scene; sets --html");
DEFINE_bool(list,
            false,
            "print the bodies, muscles, coordinates and meshes of the OpenSim "
            "model --model, and where its meshes are; with --motion also what "
            "the motion moves");
DEFINE_string(model, "", "the OpenSim model (.osim) for --list");
DEFINE_string(solver,
              "ceres",
              "ceres, or reference (Gauss-Newton with Lagrange multiplier)");
DEFINE_string(
    contact,
    "certified",
    "certified: no triangles of muscles cross each other or bones; "
    "paper: muscles keep out of each other and of bones as "
    "Kellnhofer and Kohout have it; none: every muscle deforms on its "
    "own");
DEFINE_string(format, "ply", "mesh files to write: ply, obj, vtp; commas");
DEFINE_string(
    bones,
    musclewarp::ToString(musclewarp::FrameFileOptions().bones),
    "where the meshes of bones are written: every (in every frame) or "
    "once (to OUT/rest only, and how a frame moves them to "
    "bones.json there; vtp keeps them in every frame)");

DEFINE_int32(fibres,
             0,
             "fibres of each muscle to carry along, written with vtp and as "
             "tables");
DEFINE_bool(resume,
            false,
            "go on with an interrupted run of the same input in --out");
DEFINE_bool(overwrite,
            false,
            "remove frames in --out that are of no run that report.json there "
            "names; without it they are refused");
DEFINE_string(cache,
              "none",
              "folder in which the preparation of the scene is kept for later "
              "runs; none: it is made in every run");
DEFINE_bool(profile,
            false,
            "write how long the stages of each frame take to report.json and "
            "the page");
DEFINE_string(record_steps,
              "",
              "folder to which the steps of certified contact are written, for "
              "step_benchmark (benchmarks/README.md); the preparation is kept "
              "there, too, unless --cache names another folder");
DEFINE_bool(html,
            false,
            "also write report.html, the run as one page to look at");

namespace musclewarp {
namespace {

void RecordSteps(DeformOptions* options) {
  if (FLAGS_record_steps.empty()) return;
  if (options->deformer.frames.contact != ContactKind::kCertified) {
    throw InputError("--record_steps",
                     "is given with --contact=" + FLAGS_contact,
                     "only certified contact has steps to record");
  }
  CheckWritable(FLAGS_record_steps);
  options->record_steps = FLAGS_record_steps;
  options->step_flags = SceneFlagFile();
  std::string* cache = &options->deformer.cache.folder;
  if (cache->empty()) {
    *cache =
        (std::filesystem::path(FLAGS_record_steps) / "preparations").string();
  }
}

DeformOptions OptionsFromFlags() {
  DeformOptions options = SceneOptionsFromFlags();
  options.out = FLAGS_out;
  options.deformer.solver = ParseSolver(FLAGS_solver);
  SetIterationLimit(&options.deformer.solver);
  options.deformer.frames.contact = ParseContact(FLAGS_contact);
  options.files = ParseFrameFiles(FLAGS_format, FLAGS_bones);
  options.deformer.prepare.fibres.fibres = FLAGS_fibres;
  options.resume = FLAGS_resume;
  options.overwrite = FLAGS_overwrite;
  options.html = FLAGS_html;
  options.deformer.cache.folder = CacheFolderOf(FLAGS_cache);
  options.deformer.record_stages = FLAGS_profile;
  RecordSteps(&options);
  options.is_terminal = isatty(STDOUT_FILENO);
  return options;
}

// The path of a file that is relative to --data_root.
std::string InDataRoot(const std::string& path) {
  return path.empty()
             ? path
             : (std::filesystem::path(FLAGS_data_root) / path).string();
}

int ListModel() {
  if (FLAGS_model.empty()) {
    throw InputError("--list", "needs a model", "give --model=FILE.osim");
  }
  ModelSources sources = ModelSourcesFromFlags();
  sources.motion = InDataRoot(sources.motion);
  PrintModel(InDataRoot(FLAGS_model), sources, std::cout);
  return kExitUsable;
}

// Puts the scene that is inside the program in place of a scene of the user's,
// once nothing else can be wrong.
void PrepareDemo(DeformOptions* options) {
  for (const auto& [flag, value] :
       {std::pair("--scene", FLAGS_scene),
        std::pair("--data_root", FLAGS_data_root)}) {
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

}  // namespace
}  // namespace musclewarp

int main(int argc, char** argv) {
  return musclewarp::RunProgram(
      argc,
      argv,
      "musclewarp-deform --scene=FILE --out=DIR [flags]\n"
      "       musclewarp-deform --demo --out=DIR [flags]\n"
      "       musclewarp-deform --list --model=FILE [--motion=FILE]\n\n"
      "Deforms the muscles of a scene so that they follow their lines of "
      "action and\nkeep their volume, in each pose or along a motion "
      "(OpenSim .osim and .mot, or poses\nwith times). Writes "
      "DIR/frame_0000/<name>.ply, ..., DIR/report.json and, of motions,\n"
      "DIR/lengths.sto, moment_arms.sto and volumes.sto.\n"
      "Exit code: 0 usable, 1 not usable (the summary says why), 2 bad input.",
      [](const std::vector<std::string>& arguments) {
        musclewarp::RefuseArguments(arguments);
        if (FLAGS_list) return musclewarp::ListModel();
        if (!FLAGS_model.empty()) {
          throw musclewarp::InputError(
              "--model",
              "is given without --list",
              "name the model in the scene, or add --list");
        }
        musclewarp::DeformOptions options = musclewarp::OptionsFromFlags();
        if (FLAGS_demo) musclewarp::PrepareDemo(&options);
        return musclewarp::DeformCommand(options, std::cout);
      });
}
