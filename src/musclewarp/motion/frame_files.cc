// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/frame_files.h"

#include <filesystem>
#include <iomanip>
#include <sstream>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh/mesh_io.h"

namespace musclewarp {
namespace {

std::string XmlEscaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

}  // namespace

std::string FrameFolder(int index) {
  std::ostringstream name;
  name << "frame_" << std::setw(4) << std::setfill('0') << index;
  return name.str();
}

void WriteFrame(const PreparedScene& scene,
                const Frame& frame,
                const std::vector<std::string>& formats,
                const std::string& dir) {
  const std::filesystem::path folder =
      std::filesystem::path(dir) / FrameFolder(frame.index);
  std::filesystem::create_directories(folder);
  const auto write = [&](const std::string& name,
                         const Points& points,
                         const Triangles& triangles) {
    for (const std::string& format : formats) {
      WriteTriangleSoup((folder / (name + "." + format)).string(),
                        {points, triangles});
    }
  };
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    const MuscleModel& model = scene.muscles[i].model;
    write(model.name, frame.muscles[i].fine, model.fine_triangles);
  }
  for (size_t i = 0; i < scene.bones.size(); ++i) {
    write(scene.bones[i].mesh.name,
          frame.bones[i],
          scene.bones[i].rest.triangles);
  }
}

void WritePvd(const PreparedScene& scene,
              const std::vector<int>& frames,
              const std::string& dir) {
  std::ostringstream pvd;
  pvd << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" "
         "version=\"0.1\">\n  <Collection>\n";
  for (const int frame : frames) {
    int part = 0;
    const auto add = [&](const std::string& name) {
      // The index, not the time: poses may all be at time 0.
      pvd << "    <DataSet timestep=\"" << frame << "\" part=\"" << part++
          << "\" name=\"" << XmlEscaped(name) << "\" file=\""
          << XmlEscaped(FrameFolder(frame) + "/" + name) << ".vtp\"/>\n";
    };
    for (const auto& muscle : scene.muscles) add(muscle.model.name);
    for (const auto& bone : scene.bones) add(bone.mesh.name);
  }
  pvd << "  </Collection>\n</VTKFile>\n";
  WriteTextAtomically((std::filesystem::path(dir) / "motion.pvd").string(),
                      pvd.str());
}

}  // namespace musclewarp
