// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/deform_command.h"

#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <sstream>
#include <utility>

#include "musclewarp/base/content_hash.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/mesh/mesh_io.h"
#include "musclewarp/motion/frame.h"
#include "musclewarp/motion/frame_files.h"
#include "musclewarp/report/motion_tables.h"
#include "musclewarp/report/progress.h"
#include "musclewarp/report/report_json.h"
#include "musclewarp/report/resume_log.h"
#include "musclewarp/report/screen_report.h"
#include "musclewarp/scene/json_fields.h"
#include "tools/program.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> Split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) {
    parts.push_back(part);
  }
  return parts;
}

[[noreturn]] void FailFrames(const std::string& frames,
                             const std::string& problem) {
  throw InputError("--frames=" + frames,
                   problem,
                   "allowed: all, last, N, FIRST:LAST, FIRST:LAST:STEP; FIRST "
                   "and LAST may be times (0.1s)");
}

int ParseFrameNumber(const std::string& text, const std::string& frames) {
  if (text.empty() || text.size() > 8 ||
      !std::all_of(text.begin(), text.end(), [](unsigned char c) {
        return std::isdigit(c);
      })) {
    FailFrames(frames, "\"" + text + "\" is not a frame number");
  }
  return std::stoi(text);
}

// An end of a range: a frame number, or a time with its unit.
int ParseRangeEnd(const std::string& text,
                  bool is_first,
                  const std::vector<ScenePose>& poses,
                  const std::string& frames) {
  if (text.empty() || text.back() != 's') {
    return ParseFrameNumber(text, frames);
  }
  double time = 0;
  const char* const end = text.data() + text.size() - 1;
  const auto result = std::from_chars(text.data(), end, time);
  if (result.ptr != end || result.ec != std::errc()) {
    FailFrames(frames, "\"" + text + "\" is not a time");
  }
  // Half of the last digit of usual files.
  constexpr double kSlack = 1e-9;
  const int count = static_cast<int>(poses.size());
  if (is_first) {
    int i = 0;
    while (i < count && poses[i].time < time - kSlack) ++i;
    return i;
  }
  int i = count - 1;
  while (i >= 0 && poses[i].time > time + kSlack) --i;
  return i;
}

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
    WriteTextAtomically(path_, ReportJson(run).dump(2) + "\n");
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
  throw InputError("--contact=" + text,
                   "is not something this version does",
                   "allowed: none, paper");
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

std::vector<int> SelectFrames(const std::string& frames,
                              const std::vector<ScenePose>& poses) {
  const int count = static_cast<int>(poses.size());
  int first = 0;
  int last = count - 1;
  int step = 1;
  if (frames == "last") {
    first = last;
  } else if (frames != "all") {
    const std::vector<std::string> parts = Split(frames, ':');
    if (parts.empty() || parts.size() > 3 || frames.back() == ':') {
      ParseFrameNumber("", frames);
    }
    first = ParseRangeEnd(parts[0], true, poses, frames);
    last = ParseRangeEnd(
        parts.size() > 1 ? parts[1] : parts[0], false, poses, frames);
    if (parts.size() > 2) step = ParseFrameNumber(parts[2], frames);
  }
  if (first > last || last >= count || step < 1) {
    std::ostringstream range;
    range << "the scene has frames 0 to " << count - 1;
    if (poses.front().time < poses.back().time) {
      range << ", " << poses.front().time << "s to " << poses.back().time
            << "s";
    }
    throw InputError("--frames=" + frames,
                     "selects no frame or one that is not there",
                     range.str());
  }
  std::vector<int> selected;
  for (int frame = first; frame <= last; frame += step) {
    selected.push_back(frame);
  }
  return selected;
}

void CheckSceneOptions(const DeformOptions& options) {
  std::string error;
  if (!options.prepare.IsValid(&error) || !options.solver.IsValid(&error) ||
      !options.frame.IsValid(&error) ||
      !options.scene_contact.IsValid(&error)) {
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
  run.inputs_hash = InputsHash(scene, options);
  const ResumeLog log(options.out, run.inputs_hash);
  SceneState state;
  if (options.resume) run.frames = log.Continue(selected, &state.muscles);
  if (options.resume && IsFinished(options.out, run.inputs_hash)) {
    screen << "finished already: " << report << "\n";
    return JsonField::ParseFile(report).At("summary").At("usable").AsBool()
               ? kExitUsable
               : kExitNotUsable;
  }
  const PreparedScene prepared = PrepareScene(scene, options.prepare);
  std::optional<SceneContact> contact;
  if (options.contact == DeformContact::kPaper) {
    contact = PrepareContact(prepared, options.scene_contact);
  }
  PrintPreparation(prepared, screen);

  MakeFolder(options.out);
  RemovePartialOutput(options.out);
  if (run.frames.empty()) log.StartAnew();
  SceneMeshes meshes(prepared);
  if (contact) {
    run.contact = &*contact;
    run.rest_after_fix = RestIntersectionsAfterFix(prepared, *contact, &meshes);
  }
  run.scene = &prepared;
  run.rest = RestIntersections(prepared, &meshes);
  const GroupSolver solver = SolverOf(options.solver, contact.has_value());
  const bool writes_vtp =
      std::count(options.formats.begin(), options.formats.end(), "vtp") > 0;
  const int done = static_cast<int>(run.frames.size());
  const int total = static_cast<int>(selected.size());
  if (done > 0) screen << "resumed after frame " << done << "\n";
  const SceneContact* const contact_or_none = contact ? &*contact : nullptr;
  if (done > 0) {
    state.pose = scene.poses[selected[done - 1]];
  } else if (scene.is_motion) {
    state = StartState(prepared, contact_or_none, options.frame, solver);
  }
  Progress progress(done, total, options.is_terminal, &screen);
  ReportWriter writer(report);
  for (int i = done; i < total; ++i) {
    const Frame frame = SolveFrame(prepared,
                                   contact_or_none,
                                   selected[i],
                                   options.frame,
                                   solver,
                                   &meshes,
                                   scene.is_motion ? &state : nullptr);
    WriteFrame(prepared, frame, options.formats, options.out);
    run.frames.push_back(RecordOf(prepared, frame));
    log.FrameDone(run.frames.back(), state.muscles);
    writer.WriteNowAndThen(run);
    progress.FrameDone(run.frames.back());
  }
  if (writes_vtp) WritePvd(prepared, selected, options.out);
  if (scene.is_motion) WriteMotionTables(run.frames, scene, options.out);
  run.finished = true;
  writer.Write(run);
  log.Finish();
  PrintFrames(run, screen);
  screen << "report: " << report << "\n";
  return TotalsOf(run).usable ? kExitUsable : kExitNotUsable;
}

}  // namespace musclewarp
