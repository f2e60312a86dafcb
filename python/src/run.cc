// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>

#include <filesystem>
#include <memory>
#include <sstream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/page/page.h"
#include "musclewarp/run/earlier_run.h"
#include "musclewarp/run/motion_tables.h"
#include "musclewarp/run/output_folder.h"
#include "musclewarp/run/output_lock.h"
#include "musclewarp/run/run_writer.h"
#include "musclewarp/settings/file_settings.h"
#include "python/src/bindings.h"
#include "python/src/deformer.h"
#include "python/src/json.h"
#include "python/src/pickling.h"
#include "python/src/run_of_deformer.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;
using SharedRun = std::shared_ptr<RunOfDeformer>;

// Frames are numbered by their place in the run.
void Append(RunOfDeformer* run, const SharedFrame& frame) {
  if (frame->parts->key != run->basis->parts->key) {
    throw InputError("frame",
                     "is one of another deformer",
                     "give frames of the deformer of the run");
  }
  const auto numbered = std::make_shared<FrameOfScene>(*frame);
  numbered->frame.index = static_cast<int>(run->frames.size());
  run->frames.push_back(numbered);
}

SharedRun MakeRun(const std::shared_ptr<SharedDeformer>& self) {
  return SharedDeformer::Compute(self, [self](Deformer* deformer) {
    // Shares the ownership of the deformer.
    const std::shared_ptr<const PreparedScene> scene(self, &deformer->scene());
    const auto basis =
        std::make_shared<RunBasis>(RunBasis{self->solver,
                                            self->keywords,
                                            self->parts,
                                            scene,
                                            deformer->contact(),
                                            deformer->RestFrame()});
    return std::make_shared<RunOfDeformer>(RunOfDeformer{basis, {}});
  });
}

// The run as it is now, to be used by another thread.
SharedRun SnapshotOf(const RunOfDeformer& run) {
  return std::make_shared<RunOfDeformer>(run);
}

std::vector<FrameFigures> FiguresOf(const RunOfDeformer& run) {
  std::vector<FrameFigures> figures;
  for (const SharedFrame& frame : run.frames) {
    figures.push_back(FiguresOf(frame->frame));
  }
  return figures;
}

RunRecord RecordOf(const RunOfDeformer& run) {
  const RunBasis& basis = *run.basis;
  RunRecord record;
  record.solver = basis.solver;
  record.command = "musclewarp (Python)";
  record.options = basis.keywords;
  record.inputs_hash = basis.parts->key;
  record.scene = basis.scene.get();
  record.contact = basis.contact;
  record.rest = AsDelivered(*basis.scene, basis.rest);
  record.frames = FiguresOf(run);
  record.frames_planned = static_cast<int>(run.frames.size());
  record.finished = true;
  return record;
}

py::object Report(const RunOfDeformer& run) {
  return FromJson(ComputeFree(
      [run = SnapshotOf(run)] { return ReportJson(RecordOf(*run)); }));
}

// Computes a table of the frames.
template <typename Function>
std::shared_ptr<StorageTable> TableOf(const RunOfDeformer& run,
                                      const Function& function) {
  return ComputeFree([run = SnapshotOf(run), function] {
    return std::make_shared<StorageTable>(
        function(FiguresOf(*run), run->basis->scene->scene));
  });
}

// Writes what musclewarp-deform writes of these frames.
void WriteFiles(const RunOfDeformer& run,
                const FrameFileOptions& files,
                const std::string& dir) {
  RemoveEarlierRun(dir);
  RunWriter writer(*run.basis->scene, files, dir);
  writer.WriteRest(run.basis->rest);
  RunRecord record = RecordOf(run);
  record.dir = dir;
  for (size_t i = 0; i < run.frames.size(); ++i) {
    ThrowIfAbandoned();
    record.frames[i] = writer.WriteFrame(run.frames[i]->frame);
  }
  writer.WriteTables(record.frames);
  writer.WriteReport(record);
}

void Write(const RunOfDeformer& run,
           const std::string& dir,
           const std::string& format,
           bool overwrite,
           const std::string& bones) {
  if (run.frames.empty()) {
    throw InputError("run", "has no frames", "append frames first");
  }
  FileSettings settings;
  settings.format = format;
  settings.bones = bones;
  const FrameFileOptions files = OptionsOf(settings);
  CheckWritable(dir);
  RunFree([run = SnapshotOf(run), files, dir, overwrite] {
    // Held by the thread that writes, even if nobody waits for it.
    const OutputLock lock(dir);
    CheckNoStrangeFrames(dir, overwrite);
    MakeFolder(dir);
    WriteFiles(*run, files, dir);
  });
}

std::string PageOfFolder(const std::string& dir) {
  return ComputeFree([dir] {
    std::ostringstream log;
    return PageHtml({ReadRecordedRun(dir, log)}, PageOptions());
  });
}

}  // namespace

void BindRun(py::module_* module) {
  using Records = std::vector<FrameFigures>;
  py::class_<RunOfDeformer, SharedRun>(*module, "Run")
      .def(py::init(&MakeRun), py::arg("deformer"))
      .def(Pickled<RunOfDeformer>())
      .def("append",
           &Append,
           py::arg("frame"),
           "Adds a frame of the deformer, which gets the next index.")
      .def_property_readonly(
          "frames",
          [](const RunOfDeformer& run) { return run.frames; },
          "The frames, numbered from 0.")
      .def("report",
           &Report,
           "Returns report.json of these frames as a dict (docs/report.md).")
      .def("write",
           &Write,
           py::arg("out"),
           py::arg("format") = FileSettings().format,
           py::arg("overwrite") = false,
           py::arg("bones") = FileSettings().bones)
      .def_property_readonly("lengths",
                             [](const RunOfDeformer& run) {
                               return TableOf(
                                   run, [](const Records& r, const Scene&) {
                                     return LengthTable(r);
                                   });
                             })
      .def_property_readonly("volumes",
                             [](const RunOfDeformer& run) {
                               return TableOf(
                                   run, [](const Records& r, const Scene&) {
                                     return VolumeTable(r);
                                   });
                             })
      .def_property_readonly("fibre_lengths",
                             [](const RunOfDeformer& run) {
                               return TableOf(
                                   run, [](const Records& r, const Scene&) {
                                     return FibreLengthTable(r);
                                   });
                             })
      .def_property_readonly("moment_arms",
                             [](const RunOfDeformer& run) {
                               return TableOf(run, &MomentArmTable);
                             })
      .def_property_readonly("fibre_moment_arms", [](const RunOfDeformer& run) {
        return TableOf(run, &FibreMomentArmTable);
      });
  module->def("page_of_folder", &PageOfFolder, py::arg("dir"));
}

}  // namespace musclewarp::python
