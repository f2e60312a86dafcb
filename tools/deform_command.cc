// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/deform_command.h"

#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "musclewarp/base/content_hash.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/motion/certified_frame.h"
#include "musclewarp/motion/frame.h"
#include "musclewarp/motion/frame_files.h"
#include "musclewarp/report/motion_tables.h"
#include "musclewarp/report/progress.h"
#include "musclewarp/report/report_json.h"
#include "musclewarp/report/resume_log.h"
#include "musclewarp/report/screen_report.h"
#include "musclewarp/scene/json_fields.h"
#include "tools/frame_selection.h"
#include "tools/interruption.h"
#include "tools/program.h"
#include "tools/report_command.h"
#include "tools/split.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// Of everything the result depends on.
std::string InputsHash(const Scene& scene, const DeformOptions& options) {
  ContentHash hash;
  hash.Add(MUSCLEWARP_VERSION);
  hash.Add(options.result_flags);
  for (const std::string& file : scene.files) hash.Add(ReadFile(file));
  return hash.Hex();
}

// True if `dir` holds the finished run of the same input.
bool IsFinished(const std::string& dir, const std::string& inputs_hash) {
  const std::string report = (fs::path(dir) / "report.json").string();
  if (!fs::exists(report)) return false;
  const JsonField field = JsonField::ParseFile(report);
  return field.Has("inputs_hash") &&
         field.At("inputs_hash").AsString() == inputs_hash &&
         field.At("summary").At("finished").AsBool();
}

// Keeps the report up to date while a run goes on, for a tenth of the time at
// most: it grows with every frame.
class ReportWriter {
 public:
  explicit ReportWriter(std::string path) : path_(std::move(path)) {}

  void Write(const RunRecord& run) {
    const Stopwatch writing;
    // Texts of files that are not UTF-8 may be in warnings.
    const auto on_error = nlohmann::ordered_json::error_handler_t::replace;
    WriteTextAtomically(path_,
                        ReportJson(run).dump(2, ' ', false, on_error) + "\n");
    write_ms_ = writing.Milliseconds();
    since_.emplace();
  }
  void WriteNowAndThen(const RunRecord& run) {
    constexpr double kPause = 10;  // times as long as writing took
    if (!since_ || since_->Milliseconds() >= kPause * write_ms_) Write(run);
  }

 private:
  const std::string path_;
  double write_ms_ = 0;
  std::optional<Stopwatch> since_;
};

int ExitCodeOfFinished(const std::string& report) {
  const JsonField summary = JsonField::ParseFile(report).At("summary");
  return summary.At("usable").AsBool() ? kExitUsable : kExitNotUsable;
}

bool HasFormat(const DeformOptions& options, const std::string& format) {
  return std::count(options.formats.begin(), options.formats.end(), format) > 0;
}

// Solves, writes and records the selected frames that the run does not have
// yet; `state` is that of the last it has.
void ComputeFrames(const DeformOptions& options,
                   const std::vector<int>& selected,
                   const ResumeLog& log,
                   SceneState* state,
                   SceneMeshes* meshes,
                   ReportWriter* writer,
                   RunRecord* run,
                   std::ostream& screen) {
  const PreparedScene& scene = *run->scene;
  const bool is_motion = scene.scene.is_motion;
  const GroupSolver solver = SolverOf(options.solver, run->contact != nullptr);
  const int done = static_cast<int>(run->frames.size());
  const int total = run->frames_planned;
  if (done > 0) {
    screen << "resumed after frame " << done << "\n";
    state->pose = scene.scene.poses[selected[done - 1]];
  } else if (run->certified) {
    *state = run->certified->rest;
  } else if (is_motion) {
    *state = StartState(scene, run->contact, options.frame, solver);
  }
  SceneState* start = is_motion ? state : nullptr;
  const auto solve = [&](int index) {
    if (run->certified) {
      return SolveCertifiedFrame(
          scene, *run->certified, index, options.frame, solver, meshes, start);
    }
    return SolveFrame(
        scene, run->contact, index, options.frame, solver, meshes, start);
  };
  Progress progress(done, total, options.is_terminal, &screen);
  for (int i = done; i < total; ++i) {
    ThrowIfInterrupted();
    Frame frame = solve(selected[i]);
    WriteFrame(scene, frame, options.formats, options.out);
    if (run->certified) {
      // The certificate is that of the files.
      for (const std::string& file :
           FilesThatDiffer(scene, frame, options.formats, options.out)) {
        frame.shortcomings.push_back(file + ": is not as it was counted");
      }
    }
    run->frames.push_back(RecordOf(scene, frame));
    log.FrameDone(run->frames.back(), *state);
    writer->WriteNowAndThen(*run);
    progress.FrameDone(run->frames.back());
  }
}

}  // namespace

SolverConfiguration ParseSolver(const std::string& text) {
  if (text != "ceres" && text != "reference") {
    throw InputError(
        "--solver=" + text, "is not a solver", "allowed: ceres, reference");
  }
  return SolverConfigurationNamed(text);
}

DeformContact ParseDeformContact(const std::string& text) {
  if (text == "none") return DeformContact::kNone;
  if (text == "paper") return DeformContact::kPaper;
  if (text == "certified") return DeformContact::kCertified;
  throw InputError("--contact=" + text,
                   "is not a kind of contact",
                   "allowed: certified, paper, none");
}

ContactLevel ParseContactLevel(const std::string& text) {
  if (text == "coarse") return ContactLevel::kCoarse;
  if (text == "fine") return ContactLevel::kFine;
  throw InputError(
      "--contact_level=" + text, "is not a level", "allowed: coarse, fine");
}

std::vector<std::string> ParseFormats(const std::string& text) {
  const std::vector<std::string> formats = Split(text, ',');
  for (const std::string& format : formats) {
    if ((format != "ply" && format != "obj" && format != "vtp") ||
        !IsMeshExtension(format)) {
      throw InputError("--format=" + text,
                       "\"" + format + "\" cannot be written by this build",
                       "allowed: ply, obj, vtp (with VTK), or several with "
                       "commas");
    }
  }
  if (formats.empty()) {
    throw InputError("--format", "is empty", "allowed: ply, obj, vtp");
  }
  return formats;
}

void CheckSceneOptions(const DeformOptions& options) {
  std::string error;
  if (!options.prepare.IsValid(&error) || !options.solver.IsValid(&error) ||
      !options.frame.IsValid(&error) ||
      !options.scene_contact.IsValid(&error) ||
      !options.certified_contact.IsValid(&error)) {
    throw InputError("flags", error, "see --help");
  }
  if (options.scene.empty()) {
    throw InputError("--scene", "is missing", "give a scene file");
  }
  if (options.threads < 0) {
    throw InputError("--threads",
                     "is " + std::to_string(options.threads),
                     "allowed: 0 (all cores) or above");
  }
}

void CheckWritable(const std::string& dir) {
  if (dir.empty()) {
    throw InputError("--out", "is missing", "give the folder for the results");
  }
  fs::path existing = fs::absolute(dir);
  std::error_code error;
  while (!fs::exists(existing, error) && existing.has_relative_path()) {
    existing = existing.parent_path();
  }
  if (!fs::is_directory(existing, error) ||
      access(existing.c_str(), W_OK | X_OK) != 0) {
    throw InputError("--out=" + dir,
                     existing.string() + " is not a folder that can be written",
                     "choose another folder");
  }
}

void MakeFolder(const std::string& dir) {
  std::error_code error;
  fs::create_directories(dir, error);
  if (error) {
    throw InputError("--out=" + dir,
                     "cannot be made (" + error.message() + ")",
                     "choose another folder");
  }
}

int DeformCommand(const DeformOptions& options, std::ostream& screen) {
  CheckSceneOptions(options);
  CheckWritable(options.out);
  if (options.threads > 0) omp_set_num_threads(options.threads);
  const Scene scene =
      ReadScene(options.scene, options.data_root, options.motion);
  const std::vector<int> selected = SelectFrames(options.frames, scene.poses);
  const std::string report = (fs::path(options.out) / "report.json").string();
  RunRecord run;
  run.solver = options.solver.name;
  run.command = options.command;
  run.options = options.all_flags;
  run.inputs_hash = InputsHash(scene, options);
  run.frames_planned = static_cast<int>(selected.size());
  const ResumeLog log(options.out, run.inputs_hash);
  SceneState state;
  if (options.resume) {
    run.frames = log.Continue(selected, &state);
    if (IsFinished(options.out, run.inputs_hash)) {
      log.Finish();  // the run may have been killed before it did
      screen << "finished already: " << report << "\n";
      if (options.html) WriteRunPage(options.out, screen);
      return ExitCodeOfFinished(report);
    }
  }
  PrepareOptions prepare = options.prepare;
  prepare.remove_slivers = options.contact == DeformContact::kCertified;
  const PreparedScene prepared = PrepareScene(scene, prepare);
  std::optional<SceneContact> contact;
  if (options.contact == DeformContact::kPaper) {
    contact = PrepareContact(prepared, options.scene_contact);
  }
  std::optional<CertifiedContact> certified;
  if (options.contact == DeformContact::kCertified) {
    certified = PrepareCertifiedContact(prepared,
                                        options.certified_contact,
                                        options.frame.pre_rotation,
                                        SolverOf(options.solver, false));
  }
  PrintPreparation(prepared, screen);

  MakeFolder(options.out);
  RemovePartialOutput(options.out);
  if (run.frames.empty()) log.StartAnew();
  SceneMeshes meshes(prepared);
  run.scene = &prepared;
  const Frame rest = RestFrame(prepared, &meshes);
  WriteFrame(prepared, rest, options.formats, options.out);
  run.rest = rest.intersections;
  if (contact) {
    run.contact = &*contact;
    run.rest_after_fix = RestIntersectionsAfterFix(prepared, *contact, &meshes);
  }
  if (certified) {
    run.certified = &*certified;
    run.rest_after_fix =
        CertifiedRestIntersections(prepared, *certified, &meshes);
  }
  ReportWriter writer(report);
  try {
    const InterruptionScope interruption;
    ComputeFrames(
        options, selected, log, &state, &meshes, &writer, &run, screen);
    if (HasFormat(options, "vtp")) WritePvd(prepared, selected, options.out);
    if (scene.is_motion) WriteMotionTables(run.frames, scene, options.out);
    run.finished = true;
  } catch (const std::exception& error) {
    run.stopped = error.what();
  }
  if (!run.finished) {
    screen << "stopped after " << run.frames.size() << " of "
           << run.frames_planned << " frames: " << run.stopped
           << "\n--resume goes on from there\n";
  }
  // Frames are there: what fails now is no bad input.
  try {
    writer.Write(run);
    if (run.finished) log.Finish();
    PrintFrames(run, screen);
    screen << "report: " << report << "\n";
    if (options.html) WriteRunPage(options.out, screen);
  } catch (const InputError& error) {
    screen << error.what() << "\n";
    return kExitNotUsable;
  }
  return run.finished && TotalsOf(run).usable ? kExitUsable : kExitNotUsable;
}

}  // namespace musclewarp
