// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/prepared_scene.h"

#include <glog/logging.h>

#include <sstream>

#include "musclewarp/base/stopwatch.h"
#include "musclewarp/geometry/outer_hull.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/mesh_io.h"
#include "musclewarp/scene/line_targets.h"
#include "musclewarp/skeleton/sampling.h"

namespace musclewarp {
namespace {

// Reads and repairs the mesh of a muscle or bone.
TriangleSoup ReadRepaired(const std::string& name,
                          const std::string& path,
                          const Eigen::Matrix4d& rest_from_file,
                          const RepairOptions& options,
                          MeshPreparation* preparation) {
  TriangleSoup delivered = ReadTriangleSoup(path);
  if (!rest_from_file.isIdentity(0)) {
    delivered.points = Transformed(delivered.points, rest_from_file);
  }
  preparation->name = name;
  preparation->path = path;
  preparation->defects = CountDefects(delivered);
  return SoupFromMesh(
      RepairMesh(delivered, path, options, &preparation->repairs));
}

// The action lines at the places of the skeleton samples.
CarriedLines CarryActionLines(const MuscleModel& model) {
  std::vector<Points> lines(model.lines.size());
  for (const SegmentPoint& sample : model.samples) {
    Points& line = lines[sample.line];
    line.conservativeResize(line.rows() + 1, 3);
    line.bottomRows<1>() =
        PointOnSegment(model.lines[sample.line].rest, sample);
  }
  return CarryLines(lines, model.coarse_rest, model.coarse_triangles);
}

PreparedMuscle PrepareOne(const SceneMuscle& muscle,
                          const PrepareOptions& options) {
  PreparedMuscle prepared;
  const TriangleSoup fine = ReadRepaired(
      muscle.name,
      muscle.mesh_path,
      Eigen::Matrix4d::Identity(),
      options.repair,
      &prepared.mesh);
  const TriangleSoup hull = OuterHull(fine, options.muscle.hull);
  prepared.hull_encloses = Encloses(hull, fine);
  prepared.model = PrepareMuscle(muscle, fine, hull, options.muscle);
  prepared.lines = CarryActionLines(prepared.model);
  return prepared;
}

struct MeshSize {
  std::string name;
  double diagonal;  // mm
};

// A mesh in metres among others in millimetres is a thousand times too small.
std::vector<std::string> ScaleWarnings(const std::vector<MeshSize>& sizes,
                                       double ratio) {
  std::vector<std::string> warnings;
  for (size_t a = 0; a < sizes.size(); ++a) {
    for (size_t b = 0; b < sizes.size(); ++b) {
      if (sizes[a].diagonal <= ratio * sizes[b].diagonal) continue;
      std::ostringstream text;
      text << sizes[a].name << " is " << sizes[a].diagonal << " mm across, "
           << sizes[b].name << " " << sizes[b].diagonal
           << " mm: are both files in millimetres?";
      warnings.push_back(text.str());
    }
  }
  return warnings;
}

}  // namespace

PreparedScene PrepareScene(const Scene& scene, const PrepareOptions& options) {
  const Stopwatch stopwatch;
  PreparedScene prepared;
  prepared.scene = scene;
  std::vector<MeshSize> sizes;
  // Bones first: reading them is quick, so that bad files are found early.
  for (const SceneBone& bone : scene.bones) {
    PreparedBone one;
    one.rest =
        ReadRepaired(bone.name,
                     bone.mesh_path,
                     bone.rest_from_file,
                     options.repair,
                     &one.mesh);
    one.body = bone.body;
    sizes.push_back({bone.name, BoundingBoxDiagonal(one.rest.points)});
    prepared.bones.push_back(std::move(one));
  }
  for (const SceneMuscle& muscle : scene.muscles) {
    prepared.muscles.push_back(PrepareOne(muscle, options));
    sizes.push_back(
        {muscle.name,
         BoundingBoxDiagonal(prepared.muscles.back().model.fine_rest)});
  }
  prepared.warnings = scene.warnings;
  for (const std::string& warning :
       ScaleWarnings(sizes, options.scale_warning_ratio)) {
    prepared.warnings.push_back(warning);
  }
  for (const std::string& warning : prepared.warnings) LOG(WARNING) << warning;
  prepared.wall_ms = stopwatch.Milliseconds();
  return prepared;
}

}  // namespace musclewarp
