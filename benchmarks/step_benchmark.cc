// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
//
// Takes recorded steps of a scene in contact again (musclewarp-deform
// --record_steps=FOLDER), compares their ends with the recorded ones, and says
// where their time goes:
//
//   step_benchmark --flagfile=FOLDER/flags FOLDER/frame_0003_step_01.step ...

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/base/text.h"
#include "musclewarp/build_info/build_info.h"
#include "musclewarp/program/flags.h"
#include "musclewarp/program/program.h"
#include "musclewarp/run/machine.h"
#include "musclewarp/settings/deformer_settings.h"
#include "musclewarp/settings/scene_settings.h"
#include "step_replay.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

struct BenchmarkSettings {
  int repeats = 5;
  std::string json;
  std::string baseline;
};

constexpr auto FieldsOf(Described<BenchmarkSettings>) {
  using S = BenchmarkSettings;
  return std::make_tuple(
      Field(&S::repeats, "repeats")
          .Text("how often a step is taken; the median counts")
          .AtLeast(1),
      Field(&S::json, "json").Text("file for the figures as JSON").Path(),
      Field(&S::baseline, "baseline")
          .Text("such a file of another build, to compare with")
          .Path());
}

// All settings of the program.
struct Settings {
  BenchmarkSettings benchmark;
  SceneSettings scene;
  DeformerSettings deformer;
};

// One step with one and with two threads.
struct MeasuredStep {
  std::string name;
  StepDifference difference;
  StepTimes one, two;
};

OrderedJson ToJson(const StepTimes& times) {
  OrderedJson stages = OrderedJson::array();
  for (const StageTime& stage : times.stages) {
    OrderedJson work = OrderedJson::object();
    for (int i = 0; i < kNumWorkUnits; ++i) {
      if (stage.work[i] == 0) continue;
      work[ToString(static_cast<WorkUnit>(i))] = stage.work[i];
    }
    stages.push_back({{"name", stage.name},
                      {"visits", stage.visits},
                      {"ms", stage.ms},
                      {"processor_ms", stage.processor_ms},
                      {"work", work}});
  }
  return {{"threads", times.threads},
          {"ms", times.Milliseconds()},
          {"processor_ms", times.ProcessorMilliseconds()},
          {"stages", stages}};
}

OrderedJson ToJson(const MeasuredStep& step) {
  return {{"step", step.name},
          {"same", step.difference.is_same},
          {"other_outcome", step.difference.is_other_outcome},
          {"points_differ_mm", step.difference.points},
          {"targets_differ_mm", step.difference.targets},
          {"times", {ToJson(step.one), ToJson(step.two)}}};
}

// "8787 planes, 1764 ns each; ...", by the time of one thread.
std::string WorkText(const StageTime& stage) {
  std::ostringstream text;
  const char* separator = "";
  for (int i = 0; i < kNumWorkUnits; ++i) {
    if (stage.work[i] == 0) continue;
    text << separator << stage.work[i] << " "
         << ToString(static_cast<WorkUnit>(i)) << ", " << std::setprecision(3)
         << 1e6 * stage.processor_ms / static_cast<double>(stage.work[i])
         << " ns each";
    separator = "; ";
  }
  return text.str();
}

// The processor time of one thread that a baseline has for a stage of a step,
// or for all of it if `stage` is empty; 0 if it has none.
double BaselineMs(const OrderedJson& baseline,
                  const std::string& step,
                  const std::string& stage) {
  for (const OrderedJson& of_step : baseline.value("steps", OrderedJson())) {
    if (of_step.at("step") != step) continue;
    const OrderedJson& times = of_step.at("times").at(0);
    if (stage.empty()) return times.at("processor_ms");
    for (const OrderedJson& entry : times.at("stages")) {
      if (entry.at("name") == stage) return entry.at("processor_ms");
    }
  }
  return 0;
}

std::string RatioText(double ms, double baseline_ms) {
  if (baseline_ms <= 0) return "";
  return RoundedText(ms / baseline_ms, 2);
}

void PrintRow(const std::string& name,
              double processor_one,
              double one,
              double two,
              const std::string& ratio,
              const std::string& work) {
  std::cout << "  " << std::left << std::setw(26) << name << std::right
            << std::fixed << std::setprecision(1) << std::setw(9)
            << processor_one << std::setw(9) << one << std::setw(9) << two
            << std::setw(7) << ratio << "  " << work << "\n";
}

void Print(const MeasuredStep& step, const OrderedJson& baseline) {
  const StepDifference& difference = step.difference;
  std::cout << step.name << ": ";
  if (difference.is_same) {
    std::cout << "the same to the last bit\n";
  } else if (difference.is_other_outcome) {
    std::cout << "given up by one of the two programs\n";
  } else {
    std::cout << std::defaultfloat << "points differ by " << difference.points
              << " mm at most, targets by " << difference.targets << " mm\n";
  }
  std::cout << "  " << std::left << std::setw(26) << "ms" << std::right
            << std::setw(9) << "processor" << std::setw(9) << "1 thread"
            << std::setw(9) << "2" << std::setw(7) << "ratio"
            << "\n";
  for (const StageTime& stage : step.one.stages) {
    const auto two = std::find_if(
        step.two.stages.begin(), step.two.stages.end(), [&](const auto& other) {
          return other.name == stage.name;
        });
    PrintRow(stage.name,
             stage.processor_ms,
             stage.ms,
             two == step.two.stages.end() ? 0 : two->ms,
             RatioText(stage.processor_ms,
                       BaselineMs(baseline, step.name, stage.name)),
             WorkText(stage));
  }
  const double processor_ms = step.one.ProcessorMilliseconds();
  PrintRow("all",
           processor_ms,
           step.one.Milliseconds(),
           step.two.Milliseconds(),
           RatioText(processor_ms, BaselineMs(baseline, step.name, "")),
           "");
}

OrderedJson ReadBaseline(const std::string& file) {
  if (file.empty()) return OrderedJson::object();
  OrderedJson baseline = OrderedJson::parse(ReadFile(file), nullptr, false);
  if (!baseline.is_object()) {
    throw InputError(
        "--baseline", file + " is no file of --json", "make one with --json");
  }
  return baseline;
}

// Steps of two scenes may have the same name.
std::string NameOf(const std::string& path) {
  const std::filesystem::path file = std::filesystem::absolute(path);
  return (file.parent_path().filename() / file.stem()).string();
}

int Run(const std::vector<std::string>& files, Settings settings) {
  if (files.empty()) {
    throw InputError("files", "none given", "name recorded steps");
  }
  CheckSettings(settings.benchmark);
  const int repeats = settings.benchmark.repeats;
  const OrderedJson baseline = ReadBaseline(settings.benchmark.baseline);
  settings.deformer.given = GivenFlags();
  DeformerOptions options = OptionsOf(settings.deformer);
  options.frames.measures.vertex_gaps = false;
  options.cache.folder =
      (std::filesystem::absolute(files[0]).parent_path() / "preparations")
          .string();
  const StepReplay replay(ReadScene(settings.scene.scene,
                                    settings.scene.data_root,
                                    OptionsOf(settings.scene)),
                          options);
  const Machine machine = ThisMachine();
  std::cout << machine.processor << ", " << machine.cores << " cores\n";
  OrderedJson steps = OrderedJson::array();
  bool are_same = true;
  for (const std::string& file : files) {
    const RecordedStep recorded = ReadRecordedStep(file);
    MeasuredStep step;
    step.name = NameOf(file);
    step.two = replay.Take(file, recorded, 2, repeats, &step.difference);
    step.one = replay.Take(file, recorded, 1, repeats, &step.difference);
    Print(step, baseline);
    steps.push_back(ToJson(step));
    are_same &= step.difference.is_same;
  }
  if (!settings.benchmark.json.empty()) {
    const OrderedJson json = {{"processor", machine.processor},
                              {"code", CodeKey()},
                              {"steps", steps}};
    WriteTextAtomically(settings.benchmark.json, json.dump(2) + "\n");
  }
  return are_same ? kExitUsable : kExitNotUsable;
}

}  // namespace
}  // namespace musclewarp

int main(int argc, char** argv) {
  using namespace musclewarp;
  Settings settings;
  RegisterFlags(&settings.benchmark);
  RegisterFlags(&settings.scene);
  RegisterFlags(&settings.deformer);
  return RunProgram(
      argc,
      argv,
      {"step_benchmark --flagfile=FOLDER/flags FOLDER/*.step [--json=FILE]\n"
       "       [--baseline=FILE] [--repeats=N] [--solver=NAME]\n\n"
       "Takes recorded steps again and prints where their time goes. FOLDER is "
       "that of\nmusclewarp-deform --record_steps. Exit code: 0 if all of them "
       "end in the recorded\nstate to the last bit, 1 if not, 2 bad input.",
       {{"step_benchmark --flagfile=steps/flags steps/*.step",
         "takes all recorded steps again"}},
       {"json", "baseline", "repeats", "solver"}},
      [&](const std::vector<std::string>& files) {
        return Run(files, settings);
      });
}
