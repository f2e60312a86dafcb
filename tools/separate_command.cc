// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/separate_command.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <iomanip>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/base/setting_names.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/base/text.h"
#include "musclewarp/deformer/mesh_separation.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/program/interruption.h"
#include "musclewarp/program/program.h"
#include "musclewarp/report/screen_progress.h"
#include "musclewarp/report/screen_report.h"
#include "musclewarp/run/output_folder.h"
#include "musclewarp/run/output_lock.h"
#include "musclewarp/run/paths_in_json.h"
#include "musclewarp/run/report_json.h"
#include "musclewarp/settings/checked_settings.h"
#include "musclewarp/subject/subject.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

void CheckSeparateOptions(const std::vector<std::string>& files,
                          const SeparateOptions& options) {
  if (files.empty()) {
    throw InputError(
        "files", "none given", "name at least one mesh file, or a label image");
  }
  OptionsOf(PartOf<LabelSettings>(options));
  OptionsOf(PartOf<FormatSettings>(options));
  OptionsOf(PartOf<SeparationSettings>(options));
  CheckSettings<ThreadSettings>(options);
  CheckWritable(options.out);
}

// The result of a separation, with the figures that are reported.
struct Separation {
  MeshSeparation meshes;
  std::vector<double> mean_displacements;  // by muscle, mm
  OrderedJson report;                      // the result as report.json has it
};

// Adds shortcomings that a frame does not have: the volume that was lost by
// labels of bones, which do not move, and by files that were taken apart.
void AddLosses(const Subject& subject,
               double max_loss,
               std::vector<std::string>* shortcomings) {
  const auto add = [&](const std::string& name, double loss, double delivered) {
    if (!(loss > max_loss)) return;
    shortcomings->push_back(
        name + ": " + MeasureText(100 * loss) + " % of its volume of " +
        MeasureText(delivered / 1000) + " cm3 is lost, allowed " +
        MeasureText(100 * max_loss) + " %");
  };
  for (const LostVolume& lost : subject.lost) {
    add(lost.name, lost.volume / lost.delivered, lost.delivered);
  }
}

// Returns the entry "contact" of the report.
ContactReport ContactReportOf(double gap, const RestResult& rest) {
  ContactReport contact;
  contact.kind = ContactKind::kCertified;
  contact.name = ToString(contact.kind);
  contact.gap = gap;
  contact.prepare_ms = rest.wall_ms;
  contact.rest = rest.intersections;
  return contact;
}

Separation Separate(const Subject& subject,
                    const SeparateOptions& options,
                    const ProgressCallback& on_progress) {
  Separation result;
  MeshSeparation& meshes = result.meshes;
  meshes = SeparateMeshes(SceneOfSubject(subject, options.MmPerUnit()),
                          OptionsOf(PartOf<SeparationSettings>(options)),
                          on_progress,
                          LengthsInMillimetres<SeparationSettings>(options));
  AddLosses(subject, options.max_loss, &meshes.frame.shortcomings);
  for (size_t i = 0; i < meshes.frame.muscles.size(); ++i) {
    result.mean_displacements.push_back(
        (meshes.frame.muscles[i].points -
         meshes.scene.muscles[i].model.fine_rest)
            .rowwise()
            .norm()
            .mean());
  }
  RunRecord run;
  run.scene = &meshes.scene;
  run.contact = ContactReportOf(meshes.gap, meshes.rest);
  run.rest = meshes.before;
  run.frames.push_back(FiguresOf(meshes.frame));
  result.report = ReportJson(run);
  return result;
}

// Returns the entry "label_image" of separation.json.
OrderedJson LabelImageJson(const Subject& subject) {
  OrderedJson labels = OrderedJson::array();
  for (const LabelMesh& label : subject.labels.meshes) {
    labels.push_back({{"label", label.label},
                      {"name", label.name},
                      {"bone", label.is_bone},
                      {"voxel_volume_mm3", label.voxel_volume},
                      {"delivered_volume_mm3", label.delivered_volume},
                      {"volume_mm3", label.volume}});
  }
  return {{"file", subject.image},
          {"frame", subject.labels.frame},
          {"labels", labels},
          {"notes", subject.notes}};
}

// Returns separation.json, with the keys of report.json.
OrderedJson SeparationJson(const Subject& subject,
                           const Separation& result,
                           double wall_ms) {
  const OrderedJson& report = result.report;
  const OrderedJson& frame = report.at("frames").at(0);
  OrderedJson muscles = OrderedJson::array();
  for (size_t i = 0; i < result.meshes.frame.muscles.size(); ++i) {
    const OrderedJson& prepared = report.at("prepare").at("muscles").at(i);
    const OrderedJson& moved = frame.at("muscles").at(i);
    OrderedJson entry;
    for (const char* key : {"name", "mesh"}) entry[key] = prepared.at(key);
    entry["volume_before_mm3"] =
        result.meshes.scene.muscles[i].mesh.delivered_volume;
    for (const char* key : {"volume_mm3",
                            "volume_ratio",
                            "volume_error",
                            "max_displacement_mm",
                            "depth_without_contact_mm",
                            "folded_triangles",
                            "self_pairs"}) {
      entry[key] = moved.at(key);
    }
    entry["mean_displacement_mm"] = result.mean_displacements[i];
    for (const char* key : {"dropped_pieces", "defects", "repairs", "remade"}) {
      entry[key] = prepared.at(key);
    }
    muscles.push_back(std::move(entry));
  }
  return {{"version", report.at("version")},
          {"label_image",
           subject.image.empty() ? OrderedJson() : LabelImageJson(subject)},
          {"machine", report.at("machine")},
          {"wall_ms", wall_ms},
          {"body_size", report.at("body_size")},
          {"gap_mm", report.at("contact_options").at("gap_mm")},
          {"warnings", report.at("prepare").at("warnings")},
          {"before", report.at("rest").at("intersections")},
          {"after", frame.at("intersections")},
          {"delivered_crossings", frame.at("delivered_crossings")},
          {"gaps", frame.at("gaps")},
          {"smallest_gap_mm", frame.at("smallest_gap_mm")},
          {"muscles", muscles},
          {"bones", report.at("prepare").at("bones")},
          {"bone_crossings", report.at("prepare").at("bone_crossings")},
          {"shortcomings", frame.at("shortcomings")},
          {"usable", frame.at("usable")}};
}

void WriteMeshes(const Separation& result, const SeparateOptions& options) {
  for (const std::string& format : OptionsOf(PartOf<FormatSettings>(options))) {
    const auto path = [&](const std::string& name) {
      return (fs::path(options.out) / (name + "." + format)).string();
    };
    for (size_t i = 0; i < result.meshes.frame.muscles.size(); ++i) {
      const MuscleModel& model = result.meshes.scene.muscles[i].model;
      WriteTriangleSoup(
          path(model.name),
          {result.meshes.frame.muscles[i].points, model.fine_triangles});
    }
    for (const PreparedBone& bone : result.meshes.scene.bones) {
      WriteTriangleSoup(path(bone.mesh.name), bone.rest);
    }
  }
}

int NameWidth(const PreparedScene& scene) {
  size_t width = 4;
  for (const auto& mesh : scene.muscles)
    width = std::max(width, mesh.model.name.size());
  for (const auto& bone : scene.bones)
    width = std::max(width, bone.mesh.name.size());
  return static_cast<int>(width);
}

void PrintLabels(const Subject& subject, std::ostream& screen) {
  if (subject.image.empty()) return;
  screen << subject.image << ": " << subject.labels.meshes.size()
         << " labels became meshes, in mm, frame " << subject.labels.frame
         << "\n";
  for (const std::string& note : subject.notes) {
    screen << WithFlags(note) << "\n";
  }
  screen << "\n";
}

void PrintPairs(const Separation& result, int width, std::ostream& screen) {
  std::map<std::pair<std::string, std::string>, const PairFigures*> after;
  for (const PairFigures& pair : result.meshes.frame.intersections.pairs) {
    after[{pair.a, pair.b}] = &pair;
  }
  const auto print = [&](const PairFigures& pair, int before, int now) {
    screen << std::left << std::setw(width) << pair.a << "  "
           << std::setw(width) << pair.b << std::right << std::setw(16)
           << before << std::setw(10) << FixedText(pair.max_depth_mm, 2)
           << std::setw(7) << now << "\n";
  };
  if (result.meshes.before.pairs.empty() && after.empty()) {
    screen << "no meshes cross\n";
    return;
  }
  screen << std::fixed << std::setprecision(2) << std::left << std::setw(width)
         << "a"
         << "  " << std::setw(width) << "b" << std::right
         << "  crossing pairs  depth mm  after\n";
  for (const PairFigures& pair : result.meshes.before.pairs) {
    const auto now = after.find({pair.a, pair.b});
    const bool is_left = now != after.end();
    print(pair, pair.triangle_pairs, is_left ? now->second->triangle_pairs : 0);
    if (is_left) after.erase(now);
  }
  for (const auto& [names, pair] : after) print(*pair, 0, pair->triangle_pairs);
  screen << "all: " << result.meshes.before.triangle_pairs
         << " crossing pairs of triangles before, "
         << result.meshes.frame.intersections.triangle_pairs << " after\n";
}

void PrintMeshes(const Separation& result, int width, std::ostream& screen) {
  screen << "\n"
         << std::left << std::setw(width) << "mesh" << std::right
         << "  delivered cm3    after  depth mm  largest move mm   mean mm\n";
  for (size_t i = 0; i < result.meshes.frame.muscles.size(); ++i) {
    const MeshPreparation& mesh = result.meshes.scene.muscles[i].mesh;
    const MuscleFrame& moved = result.meshes.frame.muscles[i];
    const double cm3 = mesh.delivered_volume / 1000;
    screen << std::left << std::setw(width) << mesh.name << std::right
           << std::setw(15) << FixedText(cm3, 3) << std::setw(9)
           << FixedText(moved.volume_ratio * cm3, 3) << std::setw(10)
           << FixedText(moved.depth_without_contact, 3) << std::setw(17)
           << FixedText(moved.max_displacement, 3) << std::setw(10)
           << FixedText(result.mean_displacements[i], 3);
    if (mesh.reconstruction.is_done) {
      screen << "  made anew, " << FixedText(mesh.reconstruction.farthest, 1)
             << " mm off the old surface at most";
    }
    screen << FilledCavities(mesh.repairs) << "\n";
  }
}

void PrintSeparation(const Separation& result, std::ostream& screen) {
  const Scene& scene = result.meshes.scene.scene;
  const Frame& frame = result.meshes.frame;
  for (const std::string& note : scene.notes) {
    screen << WithFlags(note) << "\n";
  }
  const int width = NameWidth(result.meshes.scene);
  PrintPairs(result, width, screen);
  PrintMeshes(result, width, screen);
  screen << "\n";
  PrintBoneCrossings(result.meshes.scene, screen);
  if (!frame.intersections.IsClean()) {
    screen << "meshes cross: there is no gap to prove\n";
  } else if (const auto gap = frame.intersections.SmallestGap()) {
    screen << "smallest gap: " << std::defaultfloat << std::setprecision(4)
           << *gap << " mm (proved)\n";
  } else {
    screen << "all gaps are above "
           << LengthText(kMeshGapLimit, scene.body_size) << " (proved)\n";
  }
  for (const std::string& shortcoming : frame.shortcomings) {
    screen << "not usable: " << shortcoming << "\n";
  }
}

SubjectInput InputOf(const std::vector<std::string>& files,
                     const SeparateOptions& options) {
  SubjectInput input;
  input.files = files;
  input.bones = Split(options.bone, ',');
  input.labels = OptionsOf(PartOf<LabelSettings>(options));
  input.repair = OptionsOf(PartOf<SeparationSettings>(options)).prepare.repair;
  return input;
}

// A run of SeparateCommand(): reads, separates and writes, and reports its
// progress on the screen.
class SeparateRun {
 public:
  SeparateRun(const std::vector<std::string>& files,
              const SeparateOptions& options,
              OutputLock* lock,
              std::ostream& screen)
      : files_(files),
        options_(options),
        lock_(lock),
        screen_(screen),
        progress_(options.is_terminal, &screen) {}

  int Execute() {
    const InterruptionScope interruption([this](const std::string& reason) {
      SayStopped(reason);
      lock_->Release();
    });
    try {
      const Stopwatch stopwatch;
      const Subject subject = ReadSubject(InputOf(files_, options_));
      std::vector<std::string> read = Split(options_.bone, ',');
      read.insert(read.end(), files_.begin(), files_.end());
      CheckInputsStay(read, options_.out, ResultFiles(subject));
      PrintLabels(subject, screen_);
      const Separation result =
          Separate(subject, options_, [this](const Progress& progress) {
            ThrowIfInterrupted();
            progress_.Say(progress);
          });
      ThrowIfInterrupted();
      progress_.Clear();
      Write(subject, result, stopwatch.Milliseconds());
      PrintSeparation(result, screen_);
      return result.meshes.frame.IsUsable() ? kExitUsable : kExitNotUsable;
    } catch (const Interrupted& interrupted) {
      progress_.Clear();
      SayStopped(interrupted.what());
      return kExitNotUsable;
    }
  }

 private:
  std::vector<std::string> ResultFiles(const Subject& subject) const {
    std::vector<std::string> names;
    for (const std::string& format :
         OptionsOf(PartOf<FormatSettings>(options_))) {
      for (const auto* meshes : {&subject.bones, &subject.muscles}) {
        for (const SubjectMesh& mesh : *meshes) {
          names.push_back(mesh.name + "." + format);
        }
      }
    }
    return names;
  }

  void Write(const Subject& subject, const Separation& result, double wall_ms) {
    is_writing_ = true;
    MakeFolder(options_.out);
    RemovePartialOutput(options_.out);
    WriteMeshes(result, options_);
    if (!options_.json) return;
    OrderedJson json = SeparationJson(subject, result, wall_ms);
    AdaptTexts(options_.out, &json);
    WriteTextAtomically(
        (fs::path(options_.out) / "separation.json").string(),
        json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n");
  }

  void SayStopped(const std::string& reason) {
    screen_ << reason
            << (is_writing_ ? ": not all meshes were written\n"
                            : ": nothing was written\n")
            << std::flush;
  }

  const std::vector<std::string>& files_;
  const SeparateOptions& options_;
  OutputLock* lock_;  // on the output folder
  std::ostream& screen_;
  ScreenProgress progress_;
  std::atomic<bool> is_writing_ = false;
};

}  // namespace

int SeparateCommand(const std::vector<std::string>& files,
                    const SeparateOptions& options,
                    std::ostream& screen) {
  CheckSeparateOptions(files, options);
  UseThreads(options);
  OutputLock lock(options.out);
  return SeparateRun(files, options, &lock, screen).Execute();
}

}  // namespace musclewarp
