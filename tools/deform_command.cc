// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/deform_command.h"

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
#include "musclewarp/base/short_list.h"
#include "musclewarp/build_info/build_info.h"
#include "musclewarp/deformer/pose_walk.h"
#include "musclewarp/program/interruption.h"
#include "musclewarp/program/program.h"
#include "musclewarp/report/screen_progress.h"
#include "musclewarp/report/screen_report.h"
#include "musclewarp/run/earlier_run.h"
#include "musclewarp/run/output_folder.h"
#include "musclewarp/run/output_lock.h"
#include "musclewarp/run/pose_name.h"
#include "musclewarp/run/resume_log.h"
#include "musclewarp/run/run_writer.h"
#include "musclewarp/run/step_recorder.h"
#include "musclewarp/scene/frame_selection.h"
#include "musclewarp/settings/checked_settings.h"
#include "tools/report_command.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

constexpr char kAdviceOnLoss[] = "--resume computes them again";

// Returns a hash of everything except the code on which the result depends.
std::string InputsHash(const Scene& scene, const DeformOptions& options) {
  ContentHash hash;
  hash.Add(options.result_flags);
  for (const std::string& file : scene.files) hash.Add(ReadFile(file));
  return hash.Hex();
}

// Returns the finished run in `dir`, if there is one. Throws InputError if it
// is a run of other input or other code, which --resume must not take for this
// one.
std::optional<EarlierRun> FinishedRun(const std::string& dir,
                                      const std::string& inputs_hash) {
  const std::optional<EarlierRun> run = ReadEarlierRun(dir);
  if (!run || !run->is_finished) return std::nullopt;
  const char* advice = "run without --resume, or choose another --out";
  if (run->inputs_hash != inputs_hash) {
    throw InputError("--resume",
                     dir + " has a finished run with other input or options",
                     advice);
  }
  if (run->code_key != CodeKey()) {
    throw InputError("--resume",
                     dir + " has a finished run by other code of musclewarp (" +
                         run->code_key + "); this is " + CodeKey(),
                     advice);
  }
  return run;
}

// A run of DeformCommand(), step by step.
class DeformRun {
 public:
  DeformRun(const DeformOptions& options,
            OutputLock* lock,
            std::ostream& screen)
      : options_(options),
        lock_(lock),
        screen_(screen),
        report_((fs::path(options.out) / kReportFile).string()),
        progress_(options.is_terminal, &screen) {}

  int Execute() {
    const InterruptionScope interruption(
        [this](const std::string& reason) { GiveUp(reason); });
    const Scene scene =
        ReadScene(options_.scene, options_.data_root, options_.sources);
    selected_ = SelectFrames(options_.frames, scene.poses);
    run_.dir = options_.out;
    run_.solver = options_.deformer.solver.name;
    run_.command = options_.command;
    run_.options = options_.all_flags;
    run_.inputs_hash = InputsHash(scene, options_);
    run_.frames_planned = static_cast<int>(selected_.size());
    log_.emplace(options_.out, run_.inputs_hash);
    SceneState state;
    if (options_.resume) {
      run_.frames = log_->Continue(selected_, &state);
      if (const auto run = FinishedRun(options_.out, run_.inputs_hash)) {
        log_->Finish();  // the run may have been killed before this call
        screen_ << "finished already: " << report_ << "\n";
        if (options_.html) WriteRunPage(options_.out, screen_);
        return run->is_usable ? kExitUsable : kExitNotUsable;
      }
    }
    if (run_.frames.empty()) {
      CheckNoStrangeFrames(options_.out, options_.overwrite);
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
      if (const std::string lost = Lost(); !lost.empty()) {
        throw InputError("{out}=" + options_.out, lost, kAdviceOnLoss);
      }
      writer_->WriteTables(run_.frames);
      run_.finished = true;
    } catch (const std::exception& error) {
      const std::string lost = Lost();
      run_.stopped = error.what() + (lost.empty() ? "" : "; " + lost);
    }
    return Finish();
  }

 private:
  void Prepare(const Scene& scene) {
    DeformerOptions options = options_.deformer;
    if (options.cache.folder.empty()) {
      options.cache = {log_->PreparationFolder(), run_.inputs_hash};
    }
    options.on_progress = [this](const Progress& progress) {
      ThrowIfInterrupted();
      progress_.Say(progress);
    };
    // Only .vtp files contain the gaps of vertices.
    options.frames.measures.vertex_gaps = options_.files.HasFormat("vtp");
    if (!options_.record_steps.empty()) {
      recorder_.emplace(options_.record_steps, options_.step_flags);
      options.frames.certified.on_step = [this](int number,
                                                const RecordedStep& step) {
        recorder_->Write(number, step);
      };
    }
    deformer_.emplace(scene, options);
    walk_.emplace(&*deformer_);
    progress_.Clear();
    PrintPreparation(deformer_->scene(), deformer_->contact(), screen_);
  }

  // Makes the output folder, writes the rest pose, and restores the state from
  // which the next frame starts.
  void Start(SceneState state) {
    const Frame& rest = deformer_->RestFrame();
    MakeFolder(options_.out);
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      run_.scene = &deformer_->scene();
      run_.contact = deformer_->contact();
      run_.rest = AsDelivered(deformer_->scene(), rest);
      writer_.emplace(deformer_->scene(), options_.files, options_.out);
    }
    RemovePartialOutput(options_.out);
    if (run_.frames.empty()) {
      log_->StartAnew();
      const int removed = RemoveEarlierRun(options_.out);
      if (removed > 0) {
        screen_ << "removed " << removed << " frames of an earlier run in "
                << options_.out << "\n";
      }
    }
    writer_->WriteRest(rest);
    if (run_.frames.empty()) return;
    screen_ << "resumed after frame " << run_.frames.size() << "\n";
    deformer_->set_state(std::move(state));
  }

  // Returns the expected number of steps of each missing frame.
  std::vector<double> ExpectedWork() const {
    std::vector<double> work;
    const ScenePose rest = RestPose(deformer_->scene().scene);
    for (size_t i = run_.frames.size(); i < selected_.size(); ++i) {
      const ScenePose* from = nullptr;
      if (is_motion()) from = i == 0 ? &rest : &poses()[selected_[i - 1]];
      if (is_design()) {
        const int before = PoseBefore(deformer_->scene().scene, selected_[i]);
        from = before < 0 ? &rest : &poses()[before];
      }
      work.push_back(deformer_->ExpectedSteps(from, poses()[selected_[i]]));
    }
    return work;
  }

  // Solves, writes and records the missing frames.
  void ComputeFrames() {
    progress_.StartFrames(static_cast<int>(run_.frames.size()), ExpectedWork());
    for (size_t i = run_.frames.size(); i < selected_.size(); ++i) {
      ThrowIfInterrupted();
      if (recorder_) recorder_->BeginFrame(selected_[i]);
      const Frame frame = walk_->Solve(selected_[i]);
      FrameFigures figures = writer_->WriteFrame(frame);
      const std::lock_guard<std::mutex> lock(mutex_);
      run_.frames.push_back(std::move(figures));
      // A design finds the way to a posture again.
      log_->FrameDone(run_.frames.back(),
                      is_design() ? SceneState() : deformer_->state());
      writer_->KeepReportUpToDate(run_);
      const FrameFigures& done = run_.frames.back();
      progress_.FrameDone(
          done,
          PoseName(done.name,
                   done.coordinates,
                   MovingCoordinatesOf(deformer_->scene().scene)));
    }
  }

  // Returns what is no longer there of what has been written, as text.
  std::string Lost() const {
    std::vector<int> indices;
    for (const FrameFigures& frame : run_.frames) {
      indices.push_back(frame.index);
    }
    const std::vector<std::string> missing = log_->Missing(indices);
    constexpr size_t kMostNamed = 5;
    return missing.empty() ? ""
                           : ShortList(missing, kMostNamed) +
                                 " were removed during the run";
  }

  // Writes the report and the summary. A failure here is not a matter of bad
  // input, as frames have been written.
  int Finish() {
    if (!run_.finished) SayStopped();
    try {
      SaveReport();
      PrintFrames(run_, screen_);
      screen_ << "report: " << report_ << "\n";
      if (options_.html) WriteRunPage(options_.out, screen_);
    } catch (const InputError& error) {
      screen_ << error.WithFlags() << "\n";
      return kExitNotUsable;
    }
    return run_.finished && TotalsOf(run_).usable ? kExitUsable
                                                  : kExitNotUsable;
  }

  // Writes the report, after which GiveUp() has nothing left to save.
  void SaveReport() {
    const std::lock_guard<std::mutex> lock(mutex_);
    writer_->WriteReport(run_);
    if (run_.finished) log_->Finish();
    is_saved_ = true;
  }

  void SayStopped() {
    progress_.Clear();
    screen_ << "stopped after " << run_.frames.size() << " of "
            << run_.frames_planned << " frames: " << run_.stopped
            << "\n--resume goes on from there\n";
  }

  // Saves the frames that are done, while another thread computes a frame that
  // takes too long to wait for.
  void GiveUp(const std::string& reason) {
    // Waits until a frame that is being recorded is complete.
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_saved_) return;
    if (!run_.scene) {
      screen_ << reason << " before the first frame; nothing was written"
              << std::endl;
      lock_->Release();
      return;
    }
    run_.stopped = reason;
    SayStopped();
    try {
      writer_->WriteReport(run_);
    } catch (const InputError& error) {
      screen_ << error.WithFlags() << "\n";
    }
    screen_ << std::flush;
    lock_->Release();
  }

  bool is_motion() const { return deformer_->scene().scene.is_motion; }
  bool is_design() const { return !deformer_->scene().scene.design.empty(); }
  const std::vector<ScenePose>& poses() const {
    return deformer_->scene().scene.poses;
  }

  const DeformOptions& options_;
  OutputLock* lock_;  // on the output folder
  std::ostream& screen_;
  const std::string report_;
  std::optional<RunWriter> writer_;
  ScreenProgress progress_;
  std::vector<int> selected_;
  std::optional<ResumeLog> log_;
  std::optional<StepRecorder> recorder_;
  std::optional<Deformer> deformer_;
  std::optional<PoseWalk> walk_;
  std::mutex mutex_;  // guards run_ and is_saved_, which GiveUp() reads
  RunRecord run_;
  bool is_saved_ = false;
};

}  // namespace

void CheckSceneOptions(const DeformOptions& options) {
  std::string error;
  if (!options.deformer.IsValid(&error)) {
    throw InputError("options", error, "see --help");
  }
  if (options.scene.empty()) {
    throw InputError("--scene", "is missing", "give a scene file");
  }
  CheckSettings<ThreadSettings>(options);
}

int DeformCommand(const DeformOptions& options, std::ostream& screen) {
  CheckSceneOptions(options);
  CheckWritable(options.out);
  UseThreads(options);
  OutputLock lock(options.out);
  return DeformRun(options, &lock, screen).Execute();
}

}  // namespace musclewarp
