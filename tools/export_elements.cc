// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/export_elements.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/base/portable_path.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/build_info/build_info.h"
#include "musclewarp/exchange/element_files.h"
#include "musclewarp/exchange/element_surfaces.h"
#include "musclewarp/exchange/mesher.h"
#include "musclewarp/exchange/moved_mesh.h"
#include "musclewarp/exchange/searchable_scene.h"
#include "musclewarp/exchange/sharp_points.h"
#include "musclewarp/program/program.h"
#include "musclewarp/run/frame_files.h"
#include "musclewarp/run/output_folder.h"
#include "musclewarp/run/output_lock.h"
#include "musclewarp/settings/checked_settings.h"
#include "tools/element_figures.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

// Twice the gap of pairs that may come into contact, so that surfaces can slide
// a little, mm at the size of a human.
constexpr double kContactReach = 2 * kMeshGapLimit;

using ElementWriter = std::string (*)(const ElementModel&);

const std::map<std::string, ElementWriter>& ElementWriters() {
  static const std::map<std::string, ElementWriter> kWriters = {
      {"inp", AbaqusText},
      {"feb", FebioText},
#ifdef MUSCLEWARP_WITH_VTK
      {"vtu", VtuBytes},
#endif
      {"msh", GmshText}};
  return kWriters;
}

MesherOptions MesherOf(const ElementOptions& options) {
  CheckSettings(options);
  if (options.one_mesh && options.element_size > 0) {
    throw InputError("--one_mesh",
                     "moves the vertices of the run, which --element_size "
                     "replaces",
                     "give one of the two");
  }
  MesherOptions mesher = FindMesher(options.mesher);
  mesher.timeout_s = options.mesher_timeout_s;
  // Twice that of a regular tetrahedron: TetGen makes them half as large as
  // they may be, on average.
  const double size = options.element_size;
  mesher.max_volume = size * size * size / (3 * std::sqrt(2.0));
  return mesher;
}

// Returns a text on the crossings that prevent a mesh, empty if there are none.
std::string WhatCrosses(const SceneIntersections& found) {
  if (found.IsClean() && found.self_pairs == 0) return "";
  std::ostringstream text;
  text << found.triangle_pairs << " pairs of triangles of two meshes cross, "
       << found.self_pairs << " of a muscle with itself, "
       << found.vertices_inside
       << " vertices are inside another mesh (--format=crossings shows where)";
  return text.str();
}

// Thrown if a frame fails.
struct FrameFailure {
  std::string reason;
};

class ElementExport {
 public:
  ElementExport(const RunOutline& run,
                const std::vector<std::string>& formats,
                const ElementOptions& options,
                const std::string& dir,
                std::ostream& screen)
      : run_(run),
        formats_(formats),
        options_(options),
        mesher_(MesherOf(options)),
        dir_(dir),
        screen_(screen) {}

  int Execute(const std::vector<int>& frames) {
    rest_ = ReadRestPose(run_.rest, run_.names);
    ReadAttachmentsIfThere();
    MakeFolder(dir_);
    const OutputLock lock(dir_);
    if (options_.resume) ReadRecord();
    if (options_.bones && options_.bone_tolerance > 0) CoarsenBones(frames);
    PrintElementHeading(screen_);
    int failed = 0;
    for (const int i : frames) failed += !ExportFrame(run_.frames[i]);
    PrintSmallAngles(records_, screen_);
    screen_ << frames.size() - failed << " of " << frames.size()
            << " frames written: " << dir_ << "\n";
    return failed == 0 ? kExitUsable : kExitNotUsable;
  }

 private:
  std::string PathOf(const std::string& label,
                     const std::string& format) const {
    return (fs::path(dir_) / (label + "." + format)).string();
  }

  std::string RecordPath() const {
    return (fs::path(dir_) / "export.json").string();
  }

  void ReadAttachmentsIfThere() {
    const fs::path path = fs::path(run_.dir) / kAttachmentsFile;
    if (fs::exists(path)) {
      attachments_ = ReadAttachments(path.string());
      return;
    }
    screen_ << "warning: " << path.string()
            << " is not there (runs of older versions have none): there will "
               "be no node sets of attachments\n";
  }

  // Returns the inputs on which the meshes depend. The mesher is not among
  // them, as the conditions on the meshes are the same for all.
  OrderedJson Inputs() const {
    return {{"inputs_hash", run_.inputs_hash},
            {"min_dihedral_deg", options_.min_dihedral_deg},
            {"element_size", options_.element_size},
            {"bones", options_.bones},
            {"bone_tolerance", options_.bone_tolerance},
            {"one_mesh", options_.one_mesh}};
  }

  void ReadRecord() {
    if (!fs::exists(RecordPath())) return;
    try {
      const OrderedJson record = OrderedJson::parse(ReadFile(RecordPath()));
      if (record.at("inputs") != Inputs()) {
        throw InputError(RecordPath(),
                         "is of another run, or of other flags",
                         "export without --resume, or to another folder");
      }
      for (const OrderedJson& frame : record.at("frames")) {
        records_[frame.at("frame").get<std::string>()] = frame;
      }
    } catch (const nlohmann::json::exception& error) {
      throw InputError(RecordPath(),
                       std::string("is damaged (") + error.what() + ")",
                       "export again without --resume");
    }
  }

  void WriteRecord() const {
    OrderedJson frames = OrderedJson::array();
    bool is_usable = true;
    for (const auto& [label, frame] : records_) {
      frames.push_back(frame);
      is_usable = is_usable && frame.at("failure").is_null();
    }
    const OrderedJson record = {{"version", kVersion},
                                {"run", PathFrom(dir_, run_.dir)},
                                {"mesher", mesher_.program},
                                {"inputs", Inputs()},
                                {"frames", frames},
                                {"usable", is_usable}};
    WriteTextAtomically(RecordPath(), record.dump(2) + "\n");
  }

  bool IsThere(const std::string& label) const {
    const auto record = records_.find(label);
    if (record == records_.end()) return false;
    const OrderedJson& failure =
        record->second.value("failure", OrderedJson(""));
    if (!failure.is_null()) return false;
    for (const std::string& format : formats_) {
      if (!fs::exists(PathOf(label, format))) return false;
    }
    return true;
  }

  // Returns false if the frame failed.
  bool ExportFrame(const RecordedFrame& frame) {
    const std::string label = FrameFolder(frame.figures.index);
    // With one_mesh, all other frames are made by moving the mesh of the first.
    const bool is_needed = options_.one_mesh && !mover_;
    if (IsThere(label) && !is_needed) {
      screen_ << label << "  is there" << AtTime(run_, frame) << "\n";
      return true;
    }
    const Stopwatch watch;
    OrderedJson record = {{"frame", label}, {"failure", nullptr}};
    if (run_.has_times) record["time"] = frame.figures.time;
    try {
      Fill(frame, label, watch, &record);
    } catch (const FrameFailure& failure) {
      record["failure"] = failure.reason;
      for (const std::string& format : formats_) {
        fs::remove(PathOf(label, format));
      }
      screen_ << label << "  failed: " << failure.reason << AtTime(run_, frame)
              << std::endl;
    }
    records_[label] = record;
    WriteRecord();
    return record["failure"].is_null();
  }

  void Fill(const RecordedFrame& frame,
            const std::string& label,
            const Stopwatch& watch,
            OrderedJson* record) {
    RecordedPose pose = ReadPose(frame.folder, run_.names, rest_);
    RecordedNames names = run_.names;
    if (!options_.bones) {
      pose.bones.clear();
      names.bones.clear();
    }
    RecordedAttachments attachments = attachments_;
    SceneIntersections found = Intersected(names, pose, "");
    if (ReplaceSurfaces(names, &pose, &attachments, record)) {
      found = Intersected(names, pose, " with the new surfaces");
    }
    const auto gap = found.SmallestGap();
    (*record)["smallest_gap_mm"] = gap ? OrderedJson(*gap) : OrderedJson();
    const TriangleSoup surface = JoinedSurface(pose.muscles);
    TetrahedralMesh mesh = MeshOf(surface);
    const ElementQuality quality = QualityOf(mesh, SharpPoints(surface));
    AddElementFigures(mesh, quality, surface.points.rows(), record);
    (*record)["wall_ms"] = watch.Milliseconds();
    CheckQuality(quality);
    ElementModel model =
        ElementModelOf(run_.scene + ", " + label + ", " + frame.figures.name,
                       names,
                       pose,
                       attachments,
                       found.gaps,
                       kContactReach * run_.body_size,
                       std::move(mesh));
    model.frame = frame.figures.index;
    model.time = run_.has_times ? frame.figures.time : frame.figures.index;
    for (const std::string& format : formats_) {
      WriteTextAtomically(PathOf(label, format),
                          ElementWriters().at(format)(model));
    }
    Print(frame, *record);
  }

  // Returns the intersections of a pose without crossings; with any the frame
  // fails. `which` says which surfaces they are.
  static SceneIntersections Intersected(const RecordedNames& names,
                                        const RecordedPose& pose,
                                        const std::string& which) {
    const SearchableScene scene = SceneOf(names, pose);
    SceneIntersections found = IntersectScene(scene.muscles, scene.bones);
    const std::string crosses = WhatCrosses(found);
    if (!crosses.empty()) throw FrameFailure{crosses + which};
    return found;
  }

  // Simplifies the bones, once for all frames.
  void CoarsenBones(const std::vector<int>& frames) {
    const double tolerance = options_.bone_tolerance * run_.body_size;
    coarsening_.emplace(kMeshGapLimit * run_.body_size + tolerance);
    for (const int i : frames) {
      coarsening_->AddPose(ReadPose(run_.frames[i].folder, run_.names, rest_));
    }
    bone_error_ = coarsening_->Coarsen(tolerance, rest_);
  }

  // Makes the surfaces fit for finite elements. Returns false if they stay.
  bool ReplaceSurfaces(const RecordedNames& names,
                       RecordedPose* pose,
                       RecordedAttachments* attachments,
                       OrderedJson* record) const {
    if (options_.element_size > 0) {
      const MuscleRemeshing remeshed = RemeshMuscles(
          options_.element_size, run_.body_size, names, pose, attachments);
      (*record)["surface_error_mm"] = remeshed.max_error;
      (*record)["surfaces_unchanged"] = remeshed.unchanged;
      for (const std::string& name : remeshed.unchanged) {
        screen_ << name << " keeps its triangles: new ones would cross\n";
      }
    }
    if (coarsening_) {
      coarsening_->Apply(pose);
      (*record)["bone_error_mm"] = bone_error_;
    }
    return options_.element_size > 0 || coarsening_;
  }

  TetrahedralMesh MeshOf(const TriangleSoup& surface) {
    if (mover_) return mover_->MoveTo(surface.points);
    MesherResult result = FillWithTetrahedra(surface, mesher_);
    if (!result.mesh) throw FrameFailure{result.failure};
    if (options_.one_mesh && QualityOf(*result.mesh).inverted == 0) {
      mover_.emplace(*result.mesh, surface.points.rows());
    }
    return std::move(*result.mesh);
  }

  void CheckQuality(const ElementQuality& quality) const {
    std::ostringstream text;
    if (quality.inverted > 0) {
      text << quality.inverted << " elements are inverted";
    } else if (quality.smallest_dihedral_deg < options_.min_dihedral_deg) {
      text << "the smallest dihedral angle is " << quality.smallest_dihedral_deg
           << " degrees, --min_dihedral_deg is " << options_.min_dihedral_deg;
    } else {
      return;
    }
    throw FrameFailure{text.str()};
  }

  void Print(const RecordedFrame& frame, const OrderedJson& record) const {
    screen_ << FrameFolder(frame.figures.index);
    PrintElementFigures(record, screen_);
    screen_ << AtTime(run_, frame) << std::endl;
  }

  const RunOutline& run_;
  const std::vector<std::string>& formats_;
  const ElementOptions& options_;
  MesherOptions mesher_;
  std::string dir_;
  std::ostream& screen_;
  RecordedPose rest_;
  RecordedAttachments attachments_;
  std::optional<BoneCoarsening> coarsening_;
  double bone_error_ = 0;  // mm
  std::optional<HarmonicMover> mover_;
  std::map<std::string, OrderedJson> records_;
};

}  // namespace

const std::vector<std::string>& ElementFormats() {
  static const std::vector<std::string> kFormats = [] {
    std::vector<std::string> names;
    for (const auto& entry : ElementWriters()) names.push_back(entry.first);
    return names;
  }();
  return kFormats;
}

int ExportElements(const RunOutline& run,
                   const std::vector<int>& frames,
                   const std::vector<std::string>& formats,
                   const ElementOptions& options,
                   const std::string& dir,
                   std::ostream& screen) {
  return ElementExport(run, formats, options, dir, screen).Execute(frames);
}

}  // namespace musclewarp
