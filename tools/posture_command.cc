// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/posture_command.h"

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/near_name.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/base/short_list.h"
#include "musclewarp/build_info/build_info.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/mesh_repair/repair.h"
#include "musclewarp/proximity/surface_comparison.h"
#include "musclewarp/run/output_folder.h"
#include "musclewarp/run/run_files.h"
#include "musclewarp/settings/checked_settings.h"
#ifdef MUSCLEWARP_WITH_VTK
#include "musclewarp/mesh_files/vtp_writer.h"
#endif

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

// If the volumes of a muscle in two postures differ by more than this factor,
// the meshes are most likely in different units.
constexpr double kLargestVolumeRatio = 100;

void CheckOptions(const PostureOptions& options) {
  CheckSettings<PostureSettings>(options);
  std::string error;
  if (!options.repair.IsValid(&error)) {
    throw InputError("options", error, "see --help");
  }
  if (options.posture.empty()) {
    throw InputError("--posture",
                     "is missing",
                     "give the mesh of the muscle as segmented in the posture");
  }
  if (!options.mesh.empty() &&
      !(options.in + options.muscle + options.frame).empty()) {
    throw InputError("--mesh=" + options.mesh,
                     "cannot be used with --in, --frame and --muscle",
                     "compare either a mesh file or a muscle of a run");
  }
  if (options.mesh.empty() && options.in.empty()) {
    throw InputError("--posture",
                     "needs something to compare with",
                     "give --mesh=FILE, or --in=RUN and --muscle=NAME");
  }
  if (options.mesh.empty() && options.muscle.empty()) {
    throw InputError("--muscle", "is missing", "name a muscle of --in");
  }
}

// A mesh in the comparison.
struct ComparedMesh {
  std::string file;
  TriangleSoup soup;
};

ComparedMesh ReadComparedMesh(const PostureOptions& options) {
  if (!options.mesh.empty()) {
    return {options.mesh, ReadTriangleSoup(options.mesh)};
  }
  const std::string frame = options.frame.empty() ? "last" : options.frame;
  const RunFiles run = FindRunFiles(options.in, frame);
  if (run.frames.size() != 1) {
    throw InputError(
        "--frame=" + options.frame,
        "names " + std::to_string(run.frames.size()) + " frames, allowed: one",
        "give the number of a frame, or last");
  }
  const MeshFiles& meshes = run.frames[0].meshes;
  const auto found = meshes.find(options.muscle);
  if (found != meshes.end()) {
    return {found->second, ReadMeshOfFrame(run.frames[0], options.muscle)};
  }
  std::vector<std::string> names;
  for (const auto& [name, file] : meshes) names.push_back(name);
  throw InputError("--muscle=" + options.muscle,
                   "is no mesh of frame " + frame + " of " + options.in,
                   DidYouMean(options.muscle, names) +
                       "its meshes: " + ShortList(names, names.size()));
}

// Throws InputError if the spacing gives more samples than memory should hold.
void CheckSpacing(const std::string& file,
                  const TriangleSoup& mesh,
                  double spacing) {
  constexpr double kMostSamples = 2e7;
  if (spacing == 0 || NumSamples(mesh, spacing) <= kMostSamples) return;
  throw InputError("--posture_spacing",
                   "would compare " + file +
                       " at more than 20 million places, which is the limit",
                   "give a larger one");
}

OrderedJson ToJson(const SurfaceDistances& distances) {
  return {{"mean_mm", distances.mean},
          {"root_mean_square_mm", distances.root_mean_square},
          {"percentile_95_mm", distances.percentile_95},
          {"hausdorff_mm", distances.largest}};
}

OrderedJson WithSignedMean(const SurfaceDistances& distances) {
  OrderedJson json = ToJson(distances);
  json["signed_mean_mm"] = distances.signed_mean;
  return json;
}

std::vector<std::string> WarningsOf(const SurfaceComparison& found) {
  const double ratio = found.volume_a / found.volume_b;
  if (std::max(ratio, 1 / ratio) <= kLargestVolumeRatio) return {};
  return {
      "the volumes differ by more than a factor of 100: are both files in "
      "millimetres?"};
}

OrderedJson PostureJson(const std::string& file,
                        const PostureOptions& options,
                        const SurfaceComparison& found) {
  return {{"version", kVersion},
          {"muscle", file},
          {"posture", options.posture},
          {"spacing_mm", found.spacing},
          {"muscle_to_posture", WithSignedMean(found.a_to_b)},
          {"posture_to_muscle", WithSignedMean(found.b_to_a)},
          {"symmetric", ToJson(found.symmetric)},
          {"muscle_volume_mm3", found.volume_a},
          {"posture_volume_mm3", found.volume_b},
          {"volume_ratio", found.volume_a / found.volume_b},
          {"dice", found.dice},
          {"jaccard", found.jaccard},
          {"grid_spacing_mm", found.grid_spacing},
          {"warnings", WarningsOf(found)}};
}

void PrintRow(const std::string& name,
              const SurfaceDistances& distances,
              bool has_sign,
              std::ostream& screen) {
  screen << std::left << std::setw(20) << name << std::right << std::fixed
         << std::setprecision(2);
  for (const double figure : {distances.mean,
                              distances.root_mean_square,
                              distances.percentile_95,
                              distances.largest}) {
    screen << std::setw(10) << figure;
  }
  if (has_sign) screen << std::setw(10) << distances.signed_mean;
  screen << "\n";
}

void Print(const SurfaceComparison& found, std::ostream& screen) {
  screen << "distance, mm              mean       rms       95 % Hausdorff    "
            "signed\n";
  PrintRow("muscle to posture", found.a_to_b, true, screen);
  PrintRow("posture to muscle", found.b_to_a, true, screen);
  PrintRow("both", found.symmetric, false, screen);
  constexpr double kCubicCentimetre = 1000;  // mm^3
  screen << "(places at most " << found.spacing
         << " mm apart; signed: negative inside)\n\nvolume "
         << found.volume_a / kCubicCentimetre << " cm3, in the posture "
         << found.volume_b / kCubicCentimetre << " cm3, ratio "
         << std::setprecision(3) << found.volume_a / found.volume_b
         << "\noverlap: Dice " << found.dice << ", Jaccard " << found.jaccard
         << " (on a grid of " << std::setprecision(2) << found.grid_spacing
         << " mm)\n";
  for (const std::string& warning : WarningsOf(found)) {
    screen << "warning: " << warning << "\n";
  }
}

void WriteResults(const std::string& file,
                  const PostureOptions& options,
                  const TriangleSoup& muscle,
                  const SurfaceComparison& found) {
  MakeFolder(options.out);
  WriteTextAtomically(
      (fs::path(options.out) / "posture.json").string(),
      PostureJson(file, options, found)
              .dump(2, ' ', false, OrderedJson::error_handler_t::replace) +
          "\n");
#ifdef MUSCLEWARP_WITH_VTK
  WriteTextAtomically(
      (fs::path(options.out) / "posture.vtp").string(),
      VtpOfMesh(muscle, {{"distance_mm", found.vertex_distances}}));
#else
  (void)muscle;
#endif
}

}  // namespace

int PostureCommand(const PostureOptions& options, std::ostream& screen) {
  CheckOptions(options);
  if (!options.out.empty()) CheckWritable(options.out);
  const ComparedMesh compared = ReadComparedMesh(options);
  const std::string& file = compared.file;
  const TriangleSoup muscle =
      RepairMesh(compared.soup, file, options.repair, nullptr);
  const TriangleSoup posture = RepairMesh(ReadTriangleSoup(options.posture),
                                          options.posture,
                                          options.repair,
                                          nullptr);
  CheckSpacing(file, muscle, options.posture_spacing);
  CheckSpacing(options.posture, posture, options.posture_spacing);
  SurfaceComparisonOptions comparison;
  comparison.spacing = options.posture_spacing;
  const SurfaceComparison found = CompareSurfaces(muscle, posture, comparison);
  screen << file << " against " << options.posture << "\n\n";
  Print(found, screen);
  if (!options.out.empty()) WriteResults(file, options, muscle, found);
  return 0;
}

}  // namespace musclewarp
