// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "fuzz/readers.h"

#include <glog/logging.h>

#include <filesystem>
#include <vector>

#include "musclewarp/joints/joints_file.h"
#include "musclewarp/label_images/label_image.h"
#include "musclewarp/label_images/label_table.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/opensim/model.h"
#include "musclewarp/opensim/storage_table.h"
#include "musclewarp/run/lines_file.h"
#include "musclewarp/run/run_reader.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {
namespace {

void ReadMesh(const std::string& path) {
  std::vector<std::string> notes;
  ReadTriangleSoup(path, &notes);
}

void ReadImage(const std::string& path) { ReadLabelImage(path); }

void ReadReportOf(const std::string& path) {
  const std::string dir = std::filesystem::path(path).parent_path().string();
  OutlineOf(dir, ReadReport(dir));
}

const std::vector<FuzzedReader>& Readers() {
  static const std::vector<FuzzedReader> kReaders = {
      {"ply", "mesh.ply", ReadMesh},
      {"obj", "mesh.obj", ReadMesh},
      {"off", "mesh.off", ReadMesh},
      {"stl", "mesh.stl", ReadMesh},
      {"vtk", "mesh.vtk", ReadMesh},
      {"vtp", "mesh.vtp", ReadMesh},
      {"osim", "model.osim", [](const auto& path) { ReadModel(path); }},
      {"mot", "motion.mot", [](const auto& path) { ReadStorageTable(path); }},
      {"scene", "scene.json", [](const auto& path) { ReadScene(path, ""); }},
      {"joints", "joints.json", [](const auto& path) { ReadJoints(path); }},
      {"lines", "lines.json", [](const auto& path) { ReadLinesFile(path); }},
      {"report", "report.json", ReadReportOf},
      {"labels", "labels.csv", [](const auto& path) { ReadLabelTable(path); }},
      {"nii", "image.nii", ReadImage},
      {"nrrd", "image.nrrd", ReadImage},
      {"mha", "image.mha", ReadImage}};
  return kReaders;
}

}  // namespace

const FuzzedReader& ReaderNamed(const std::string& name) {
  for (const FuzzedReader& reader : Readers()) {
    if (reader.name == name) return reader;
  }
  LOG(FATAL) << "no reader " << name;
}

}  // namespace musclewarp
