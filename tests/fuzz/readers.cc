// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "fuzz/readers.h"

#include <glog/logging.h>

#include <filesystem>
#include <vector>

#include "musclewarp/deformer/preparation_cache.h"
#include "musclewarp/joints/joints_file.h"
#include "musclewarp/label_images/label_image.h"
#include "musclewarp/label_images/label_table.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/motion/recorded_step.h"
#include "musclewarp/opensim/model.h"
#include "musclewarp/opensim/storage_table.h"
#include "musclewarp/run/lines_file.h"
#include "musclewarp/run/resume_log.h"
#include "musclewarp/run/run_reader.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

void ReadMesh(const std::string& path) {
  std::vector<std::string> notes;
  ReadTriangleSoup(path, &notes);
}

void ReadImage(const std::string& path) { ReadLabelImage(path); }

void ReadReportOf(const std::string& path) {
  const std::string dir = fs::path(path).parent_path().string();
  OutlineOf(dir, ReadReport(dir));
}

// Returns a folder beside the file, which is made on the first call.
std::string FolderBeside(const std::string& path, const char* name) {
  const fs::path folder = fs::path(path).parent_path() / name;
  fs::create_directories(folder);
  return folder.string();
}

// As the log of frame 0 of an interrupted run.
void ReadLogOfFrame(const std::string& path) {
  static const std::string run = FolderBeside(path, "run");
  const ResumeLog log(run, "inputs");
  if (!ResumeLog::IsIn(run)) log.StartAnew();
  FolderBeside(path, "run/frame_0000");
  fs::copy_file(path,
                run + "/.resume/frame_0000.cbor",
                fs::copy_options::overwrite_existing);
  SceneState state;
  log.Continue({0}, &state);
}

// As the preparation of a scene without muscles.
void ReadCached(const std::string& path) {
  static const PreparationCache cache({FolderBeside(path, "cache"), "options"},
                                      Scene());
  fs::copy_file(path, cache.path(), fs::copy_options::overwrite_existing);
  cache.Read(Scene());
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
      {"mha", "image.mha", ReadImage},
      {"log", "log.cbor", ReadLogOfFrame},
      {"cache", "scene.preparation", ReadCached},
      {"step", "step.bin", [](const auto& path) { ReadRecordedStep(path); }}};
  return kReaders;
}

}  // namespace

const FuzzedReader& ReaderNamed(const std::string& name) {
  for (const FuzzedReader& reader : Readers()) {
    if (reader.name == name) return reader;
  }
  LOG(FATAL) << "no reader " << name;
}

std::vector<std::string> NamesOfReaders() {
  std::vector<std::string> names;
  for (const FuzzedReader& reader : Readers()) names.push_back(reader.name);
  return names;
}

}  // namespace musclewarp
