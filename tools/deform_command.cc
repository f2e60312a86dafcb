// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/deform_command.h"

#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <optional>
#include <utility>

#include "musclewarp/base/content_hash.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/motion/frame_files.h"
#include "musclewarp/page/recorded_attachments.h"
#include "musclewarp/report/motion_tables.h"
#include "musclewarp/report/report_json.h"
#include "musclewarp/report/resume_log.h"
#include "musclewarp/report/screen_progress.h"
#include "musclewarp/report/screen_report.h"
#include "musclewarp/scene/json_fields.h"
#include "tools/frame_selection.h"
#include "tools/interruption.h"
#include "tools/option_flags.h"
#include "tools/program.h"
#include "tools/report_command.h"
#include "tools/split.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// Returns a hash of everything that the result depends on.
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

// Everything of a run but its options: what DeformCommand does, step by step.
class DeformRun {
 public:
  DeformRun(const DeformOptions& options, std::ostream& screen)
      : options_(options),
        screen_(screen),
        report_((fs::path(options.out) / "report.json").string()),
        writer_(report_),
        progress_(options.is_terminal, &screen) {}

  int Execute() {
    const InterruptionScope interruption(
        [this](const std::string& reason) { GiveUp(reason); });
    const Scene scene =
        ReadScene(options_.scene, options_.data_root, options_.motion);
    selected_ = SelectFrames(options_.frames, scene.poses);
    run_.solver = options_.deformer.solver.name;
    run_.command = options_.command;
    run_.options = options_.all_flags;
    run_.inputs_hash = InputsHash(scene, options_);
    run_.frames_planned = static_cast<int>(selected_.size());
    log_.emplace(options_.out, run_.inputs_hash);
    SceneState state;
    if (options_.resume) {
      run_.frames = log_->Continue(selected_, &state);
      if (IsFinished(options_.out, run_.inputs_hash)) {
        log_->Finish();  // the run may have been killed before it did
        screen_ << "finished already: " << report_ << "\n";
        if (options_.html) WriteRunPage(options_.out, screen_);
        return ExitCodeOfFinished(report_);
      }
    }
    try {
      Prepare(scene);
    } catch (const Interrupted& interrupted) {
      screen_ << interrupted.what() << " before the first frame; nothing was "
              << "written\n";
      return kExitNotUsable;
    }
    Start(std::move(state));
    try {
      ComputeFrames();
      if (HasFormat(options_, "vtp")) {
        WritePvd(deformer_->scene(), selected_, options_.out);
      }
      if (scene.is_motion) WriteMotionTables(run_.frames, scene, options_.out);
      run_.finished = true;
    } catch (const std::exception& error) {
      run_.stopped = error.what();
    }
    return Finish();
  }

 private:
  void Prepare(const Scene& scene) {
    DeformerOptions options = options_.deformer;
    options.on_progress = [this](const Progress& progress) {
      ThrowIfInterrupted();
      progress_.Say(progress);
    };
    deformer_.emplace(scene, options);
    progress_.Clear();
    PrintPreparation(deformer_->scene(), deformer_->contact(), screen_);
  }

  // Makes the folder of the results, and puts the muscles where the next frame
  // starts.
  void Start(SceneState state) {
    const Frame& rest = deformer_->RestFrame();
    MakeFolder(options_.out);
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      run_.scene = &deformer_->scene();
      run_.contact = deformer_->contact();
      run_.rest = deformer_->scene().as_delivered
                      ? *deformer_->scene().as_delivered
                      : rest.intersections;
    }
    RemovePartialOutput(options_.out);
    WriteFrame(deformer_->scene(), rest, options_.formats, options_.out);
    WriteAttachments((fs::path(options_.out) / kAttachmentsFile).string(),
                     AttachmentsOf(deformer_->scene()));
    if (run_.frames.empty()) {
      log_->StartAnew();
      return;
    }
    screen_ << "resumed after frame " << run_.frames.size() << "\n";
    deformer_->set_state(std::move(state));
  }

  // The number of steps that each frame which is not there yet will take.
  std::vector<double> ExpectedWork() const {
    std::vector<double> work;
    const ScenePose rest = RestPose(deformer_->scene().scene);
    for (size_t i = run_.frames.size(); i < selected_.size(); ++i) {
      const ScenePose* from = nullptr;
      if (is_motion()) from = i == 0 ? &rest : &poses()[selected_[i - 1]];
      work.push_back(deformer_->ExpectedSteps(from, poses()[selected_[i]]));
    }
    return work;
  }

  // Solves, writes and records the frames that the run does not have yet.
  void ComputeFrames() {
    progress_.StartFrames(static_cast<int>(run_.frames.size()), ExpectedWork());
    for (size_t i = run_.frames.size(); i < selected_.size(); ++i) {
      ThrowIfInterrupted();
      const ScenePose& pose = poses()[selected_[i]];
      Frame frame =
          is_motion() ? deformer_->MoveTo(pose) : deformer_->SolveAlone(pose);
      frame.index = selected_[i];
      WriteFrame(deformer_->scene(), frame, options_.formats, options_.out);
      CompareFiles(&frame);
      const std::lock_guard<std::mutex> lock(mutex_);
      run_.frames.push_back(RecordOf(deformer_->scene(), frame));
      log_->FrameDone(run_.frames.back(), deformer_->state());
      writer_.WriteNowAndThen(run_);
      progress_.FrameDone(run_.frames.back());
    }
  }

  // Reads the files back, so that the counts are those of the files.
  void CompareFiles(Frame* frame) const {
    for (const std::string& file : FilesThatDiffer(
             deformer_->scene(), *frame, options_.formats, options_.out)) {
      frame->shortcomings.push_back(
          file + ": differs from the frame that was counted");
    }
  }

  // Writes the report. Frames are there: what fails now is no bad input.
  int Finish() {
    if (!run_.finished) SayStopped();
    try {
      SaveReport();
      PrintFrames(run_, screen_);
      screen_ << "report: " << report_ << "\n";
      if (options_.html) WriteRunPage(options_.out, screen_);
    } catch (const InputError& error) {
      screen_ << error.what() << "\n";
      return kExitNotUsable;
    }
    return run_.finished && TotalsOf(run_).usable ? kExitUsable
                                                  : kExitNotUsable;
  }

  // From then on there is nothing left for GiveUp() to save.
  void SaveReport() {
    const std::lock_guard<std::mutex> lock(mutex_);
    writer_.Write(run_);
    if (run_.finished) log_->Finish();
    is_saved_ = true;
  }

  void SayStopped() {
    progress_.Clear();
    screen_ << "stopped after " << run_.frames.size() << " of "
            << run_.frames_planned << " frames: " << run_.stopped
            << "\n--resume goes on from there\n";
  }

  // On another thread, while a frame is computed that takes too long to wait
  // for: saves the frames before it.
  void GiveUp(const std::string& reason) {
    // A frame that is being recorded will be recorded in a moment.
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_saved_) return;
    if (!run_.scene) {
      screen_ << reason << " before the first frame; nothing was written"
              << std::endl;
      return;
    }
    run_.stopped = reason;
    SayStopped();
    try {
      writer_.Write(run_);
    } catch (const InputError& error) {
      screen_ << error.what() << "\n";
    }
    screen_ << std::flush;
  }

  bool is_motion() const { return deformer_->scene().scene.is_motion; }
  const std::vector<ScenePose>& poses() const {
    return deformer_->scene().scene.poses;
  }

  const DeformOptions& options_;
  std::ostream& screen_;
  const std::string report_;
  ReportWriter writer_;
  ScreenProgress progress_;
  std::vector<int> selected_;
  std::optional<ResumeLog> log_;
  std::optional<Deformer> deformer_;
  std::mutex mutex_;  // of what GiveUp() reads: run_ and is_saved_
  RunRecord run_;
  bool is_saved_ = false;
};

}  // namespace

SolverConfiguration ParseSolver(const std::string& text) {
  if (text != "ceres" && text != "reference") {
    throw InputError(
        "--solver=" + text, "is not a solver", "allowed: ceres, reference");
  }
  return SolverConfigurationNamed(text);
}

ContactKind ParseContact(const std::string& text) {
  for (const ContactKind kind :
       {ContactKind::kNone, ContactKind::kPaper, ContactKind::kCertified}) {
    if (text == ToString(kind)) return kind;
  }
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

RemakeKind ParseRemake(const std::string& text) {
  if (text == "auto") return RemakeKind::kAuto;
  if (text == "never") return RemakeKind::kNever;
  throw InputError("--remake=" + text,
                   "is not a way to treat muscles that cannot be separated",
                   "allowed: auto, never");
}

AttachmentKind ParseAttachments(const std::string& text) {
  if (text == "auto") return AttachmentKind::kAuto;
  if (text == "scene") return AttachmentKind::kScene;
  if (text == "none") return AttachmentKind::kNone;
  throw InputError("--attachments=" + text,
                   "is not a choice of attachments",
                   "allowed: auto, scene, none");
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
  CheckValid(options);
  if (options.scene.empty()) {
    throw InputError("--scene", "is missing", "give a scene file");
  }
  CheckThreads(options.threads);
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
  return DeformRun(options, screen).Execute();
}

}  // namespace musclewarp
