// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/phantom_command.h"

#include <iomanip>
#include <ostream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/phantom/phantom_scene.h"
#include "musclewarp/settings/checked_settings.h"

namespace musclewarp {
namespace {

void PrintRow(const PhantomMesh& mesh, std::ostream& log) {
  const TriangleSoup& soup = mesh.delivered;
  const double volume =
      SignedVolume(mesh.surface.points, mesh.surface.triangles);
  log << std::left << std::setw(18) << mesh.name << std::right << std::setw(9)
      << soup.points.rows() << std::setw(10) << soup.triangles.rows()
      << std::setw(8) << std::fixed << std::setprecision(1) << volume / 1000
      << std::setw(10) << mesh.defects.duplicate_points << std::setw(11)
      << mesh.defects.degenerate_triangles << std::setw(6) << mesh.defects.flaps
      << std::setw(6) << mesh.defects.stray_pieces << std::setw(8)
      << mesh.defects.missing_triangles << "\n";
}

}  // namespace

void MakePhantom(const PhantomRequest& request, std::ostream& log) {
  if (request.out.empty()) {
    throw InputError("--out", "is not given", "name the folder to write to");
  }
  CheckSettings(request);
  const PhantomScene scene =
      MakePhantomScene(request.scene, request.seed, request);
  WritePhantomScene(scene, request.out);
  log << "mesh               vertices triangles    cm^3 duplicate degenerate "
         "flaps stray missing\n";
  for (const PhantomMesh& mesh : scene.meshes) PrintRow(mesh, log);
  log << "wrote " << request.out
      << "/scene.json: " << scene.scene.muscles.size() << " muscles, "
      << scene.scene.bones.size() << " bones, " << scene.scene.poses.size()
      << " poses\n";
}

}  // namespace musclewarp
