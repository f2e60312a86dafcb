// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/export_command.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/base/text.h"
#include "musclewarp/build_info/build_info.h"
#include "musclewarp/exchange/animation.h"
#include "musclewarp/exchange/crossing_files.h"
#include "musclewarp/exchange/crossing_places.h"
#include "musclewarp/exchange/glb_file.h"
#include "musclewarp/exchange/point_cache.h"
#include "musclewarp/exchange/run_table.h"
#include "musclewarp/exchange/searchable_scene.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/mesh_files/mesh_path.h"
#include "musclewarp/program/program.h"
#include "musclewarp/run/frame_files.h"
#include "musclewarp/run/output_folder.h"
#include "musclewarp/run/output_lock.h"
#include "musclewarp/run/run_reader.h"
#include "musclewarp/scene/frame_selection.h"
#include "musclewarp/settings/checked_settings.h"
#include "tools/export_mjcf.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

size_t AddCrossings(const std::string& label,
                    const SearchableScene& scene,
                    CrossingFiles* files) {
  const std::vector<CrossingPlace> places =
      FindCrossingPlaces(scene.muscles, scene.bones);
  std::vector<NamedMesh> meshes = scene.muscles;
  meshes.insert(meshes.end(), scene.bones.begin(), scene.bones.end());
  files->Add(label, meshes, places);
  return places.size();
}

std::vector<int> SelectedFrames(const ExportRequest& request,
                                const RunOutline& run) {
  std::vector<ScenePose> poses;
  std::vector<int> numbers;
  for (const RecordedFrame& frame : run.frames) {
    ScenePose& pose = poses.emplace_back();
    pose.name = frame.figures.name;
    pose.time = frame.figures.time;
    numbers.push_back(frame.figures.index);
  }
  return SelectFrames(request.frames, poses, numbers);
}

RunOutline OpenRun(const ExportRequest& request, std::ostream& screen) {
  RunOutline run = ReadRunForExport(request.in, kVersion);
  for (const std::string& warning : run.warnings) {
    screen << "warning: " << warning << "\n";
  }
  return run;
}

void CheckMeshFormat(const std::string& format) {
  const bool is_known = format == "ply" || format == "obj" || format == "vtp";
  if (is_known && IsMeshExtension(format)) return;
  throw InputError("--mesh_format=" + format,
                   "is not a format for crossings in this build",
                   "allowed: ply, obj, and with VTK vtp");
}

int ExportCrossings(const ExportRequest& request, std::ostream& screen) {
  CheckMeshFormat(request.mesh_format);
  CrossingFiles files(request.out, request.mesh_format);
  size_t places = 0;
  if (request.in.empty()) {
    SearchableScene scene;
    std::vector<std::string> notes;
    for (const std::string& file : request.files) {
      scene.Add(
          MeshNameOf(file), ReadTriangleSoup(file, &notes), &scene.muscles);
    }
    for (const std::string& note : notes) screen << note << "\n";
    MakeFolder(request.out);
    const OutputLock lock(request.out);
    places = AddCrossings("meshes", scene, &files);
  } else {
    const RunOutline run = OpenRun(request, screen);
    const std::vector<int> selected = SelectedFrames(request, run);
    const RecordedPose rest = ReadRestPose(run.rest, run.names);
    MakeFolder(request.out);
    const OutputLock lock(request.out);
    for (const int i : selected) {
      const RecordedFrame& frame = run.frames[i];
      const std::string label = FrameFolder(frame.figures.index);
      const size_t found = AddCrossings(
          label,
          SceneOf(run.names, ReadPose(frame.folder, run.names, rest)),
          &files);
      screen << label << "  " << found << " places" << AtTime(run, frame)
             << std::endl;
      places += found;
    }
  }
  files.WriteTable();
  screen << places << " places where meshes cross: "
         << (fs::path(request.out) / "crossings.csv").string() << "\n";
  return kExitUsable;
}

int ExportAnimation(
    const ExportRequest& request,
    const std::function<void(const std::string&, const Animation&)>& write,
    std::ostream& screen) {
  const RunOutline run = OpenRun(request, screen);
  const std::vector<int> selected = SelectedFrames(request, run);
  Animation animation = AnimationOf(run, selected);
  const auto read = animation.read;
  animation.read = [&](int i) {
    const RecordedFrame& frame = run.frames[selected[i]];
    screen << FrameFolder(frame.figures.index) << "  " << i + 1 << " of "
           << selected.size() << AtTime(run, frame) << std::endl;
    return read(i);
  };
  write(request.out, animation);
  screen << "wrote " << request.out << ": " << animation.names.muscles.size()
         << " muscles, " << animation.names.bones.size() << " bones, "
         << animation.times.size()
         << " frames; metres, +x left, +y up, +z to the front (the axes of the "
            "run are "
         << run.axes << ")\n";
  return kExitUsable;
}

int ExportGlb(const ExportRequest& request, std::ostream& screen) {
  if (fs::path(request.out).extension() != ".glb") {
    throw InputError("--out=" + request.out,
                     "is not a .glb file",
                     "use for example --out=motion.glb");
  }
  return ExportAnimation(request, WriteGlb, screen);
}

int ExportPointCaches(const ExportRequest& request, std::ostream& screen) {
  return ExportAnimation(request, WritePointCaches, screen);
}

void CheckAllFrames(const ExportRequest& request) {
  if (request.frames == "all") return;
  throw InputError(
      "--frames=" + request.frames,
      "is not for --format=" + request.format + ", which takes all frames",
      "choose frames with --frames of musclewarp-deform");
}

int ExportModel(const ExportRequest& request, std::ostream& screen) {
  CheckAllFrames(request);
  return ExportOsim(request.in, request.out, request.paths, screen);
}

int ExportFunctions(const ExportRequest& request, std::ostream& screen) {
  CheckAllFrames(request);
  return ExportFit(request.in, request.out, request.paths, screen);
}

int ExportTable(const ExportRequest& request, std::ostream& screen) {
  if (fs::path(request.out).extension() != ".csv") {
    throw InputError("--out=" + request.out,
                     "is not a .csv file",
                     "use for example --out=motion.csv");
  }
  const RunOutline run = OpenRun(request, screen);
  const std::vector<int> selected = SelectedFrames(request, run);
  const std::string text = RunTableText(
      run, TableCoordinatesOf(ReadReport(request.in)), selected, [&](int i) {
        const RecordedFrame& frame = run.frames[i];
        screen << FrameFolder(frame.figures.index) << AtTime(run, frame)
               << std::endl;
      });
  WriteTextAtomically(request.out, text);
  screen << "wrote " << request.out << ": a row for each line of "
         << run.names.muscles.size() << " muscles in " << selected.size()
         << " frames\n";
  return kExitUsable;
}

int ExportMujoco(const ExportRequest& request, std::ostream& screen) {
  CheckAllFrames(request);
  return ExportMjcf(request.in, request.out, request.paths, screen);
}

using Exporter = int (*)(const ExportRequest&, std::ostream&);

const std::map<std::string, Exporter>& Exporters() {
  static const std::map<std::string, Exporter> kExporters = {
      {"crossings", ExportCrossings},
      {"csv", ExportTable},
      {"fit", ExportFunctions},
      {"glb", ExportGlb},
      {"mjcf", ExportMujoco},
      {"osim", ExportModel},
      {"pc2", ExportPointCaches}};
  return kExporters;
}

// Returns the formats of a request. Several formats must all be for finite
// elements.
std::vector<std::string> FormatsOf(const ExportRequest& request) {
  const std::vector<std::string>& elements = ElementFormats();
  const std::vector<std::string> formats = Split(request.format, ',');
  bool is_fine = !formats.empty();
  for (const std::string& format : formats) {
    const bool is_element =
        std::count(elements.begin(), elements.end(), format) > 0;
    is_fine =
        is_fine &&
        (is_element || (formats.size() == 1 && Exporters().count(format) > 0));
  }
  if (is_fine) return formats;
  throw InputError("--format=" + request.format,
                   "is not a format",
                   "allowed: " + ExportFormats() +
                       "; of those for finite elements also several, with "
                       "commas");
}

void CheckRequest(const ExportRequest& request) {
  if (!request.files.empty() && request.format != "crossings") {
    throw InputError(request.files[0],
                     "mesh files are taken with --format=crossings only",
                     "name the folder of a run in --in");
  }
  if (request.in.empty() == request.files.empty()) {
    throw InputError(
        "--in",
        request.in.empty() ? "is missing" : "is given together with mesh files",
        "name the folder of a run, or mesh files with "
        "--format=crossings");
  }
  if (request.out.empty()) {
    throw InputError("--out", "is missing", "name what is to be written");
  }
  CheckSettings(request);
}

}  // namespace

std::string ExportFormats() {
  std::string names;
  for (const auto& entry : Exporters()) names += entry.first + ", ";
  for (const std::string& format : ElementFormats()) names += format + ", ";
  return names.substr(0, names.size() - 2);
}

int ExportCommand(const ExportRequest& request, std::ostream& screen) {
  const std::vector<std::string> formats = FormatsOf(request);
  CheckRequest(request);
  UseThreads(request);
  const auto exporter = Exporters().find(formats[0]);
  if (exporter != Exporters().end()) return exporter->second(request, screen);
  const RunOutline run = OpenRun(request, screen);
  return ExportElements(run,
                        SelectedFrames(request, run),
                        formats,
                        request.elements,
                        request.out,
                        screen);
}

}  // namespace musclewarp
