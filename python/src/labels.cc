// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "python/src/labels.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/setting_names.h"
#include "musclewarp/base/text.h"
#include "musclewarp/label_images/label_image.h"
#include "musclewarp/label_images/label_image_file.h"
#include "musclewarp/scene/scene_names.h"
#include "musclewarp/settings/label_settings.h"
#include "python/src/arrays.h"
#include "python/src/bindings.h"
#include "python/src/call.h"
#include "python/src/meshes.h"
#include "python/src/scene.h"
#include "python/src/settings.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;

// What Python says of a label: its name, or columns of a table by name.
using LabelColumns = std::map<std::string, std::string>;
using LabelsByNumber = std::map<int, LabelColumns>;

constexpr char kSubjectDoc[] =
    R"(The meshes of a label image (musclewarp.Labels).)";

// Sets a column of a row. Throws InputError for one that is not known.
void SetColumn(const std::string& where,
               const std::string& column,
               const std::string& value,
               LabelEntry* entry) {
  const std::map<std::string, std::string*> texts = {
      {"name", &entry->name},
      {"bone", &entry->bone},
      {"side", &entry->side},
      {"body", &entry->body},
      {"origin", &entry->origin},
      {"insertion", &entry->insertion}};
  const auto text = texts.find(column);
  if (text != texts.end()) {
    *text->second = value;
  } else if (column == "kind" && (value == "bone" || value == "muscle")) {
    entry->is_bone = value == "bone";
  } else if (column == "kind") {
    throw InputError(where,
                     "has the kind " + QuotedName(value),
                     "allowed: \"bone\", \"muscle\"");
  } else {
    throw InputError(where,
                     "has " + QuotedName(column),
                     "allowed: name, kind, bone, side, body, origin, "
                     "insertion");
  }
}

std::vector<LabelEntry> RowsFrom(const LabelsByNumber& names) {
  std::vector<LabelEntry> rows;
  std::set<std::string> known;
  for (const auto& [label, columns] : names) {
    const std::string where = "names: label " + std::to_string(label);
    if (label < 1) {
      throw InputError(where, "is no label", "allowed: 1 to 2147483647");
    }
    LabelEntry entry;
    entry.label = label;
    for (const auto& [column, value] : columns) {
      SetColumn(where, column, value, &entry);
    }
    CheckFileName(where, "label", entry.name);
    if (!known.insert(entry.name).second) {
      throw InputError(
          where,
          "has the name " + QuotedName(entry.name) + ", as another label has",
          "rename one");
    }
    rows.push_back(entry);
  }
  return rows;
}

SubjectInput InputFrom(const py::dict& keywords, const LabelsByNumber& names) {
  const auto settings = SettingsFrom<LabelSettings>(keywords);
  SubjectInput input;
  input.use = SubjectUse::kJoints;
  input.labels = OptionsOf(settings);
  input.bones = Split(settings.bone, ',');
  if (!names.empty()) {
    input.labels.rows = RowsFrom(names);
    input.labels.table = "names";
  }
  return input;
}

SharedSubject ReadLabelFile(const std::string& path,
                            const py::dict& keywords,
                            const LabelsByNumber& names) {
  SubjectInput input = InputFrom(keywords, names);
  input.files = {path};
  if (!IsLabelImageFile(path)) {
    throw InputError(path,
                     "is no label image by its name",
                     std::string("allowed: ") + kLabelImageFormats);
  }
  return ComputeFree([input]() -> SharedSubject {
    return std::make_shared<Subject>(ReadSubject(input));
  });
}

// `labels` are the voxels of an image of `size`, the first index fastest.
SharedSubject ReadLabelArray(const py::array_t<int>& labels,
                             const std::array<int, 3>& size,
                             const std::array<std::array<double, 4>, 4>& affine,
                             const std::string& space,
                             const py::dict& keywords,
                             const LabelsByNumber& names) {
  const SubjectInput input = InputFrom(keywords, names);
  const auto image = std::make_shared<LabelImage>();
  image->path = "image";
  image->grid.size = {size[0], size[1], size[2]};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      image->grid.world_from_index(row, column) = affine[row][column];
    }
  }
  image->grid.is_oriented = !space.empty();
  if (space == "RAS") TurnFromRas(&image->grid);
  CheckGrid(image->path, image->grid);
  image->labels.assign(labels.data(), labels.data() + labels.size());
  return ComputeFree([input, image]() -> SharedSubject {
    return std::make_shared<Subject>(ReadSubject(input, *image));
  });
}

py::dict BonesOfSubject(const SharedSubject& subject) {
  py::dict bones;
  for (const SubjectMesh& mesh : subject->bones) {
    bones[py::str(mesh.name)] = std::make_shared<TriangleSoup>(mesh.mesh);
  }
  return bones;
}

py::dict MusclesOfSubject(const SharedSubject& subject) {
  py::dict muscles;
  for (const SubjectMesh& mesh : subject->muscles) {
    const auto muscle = std::make_shared<SceneMuscle>();
    muscle->name = mesh.name;
    muscle->points = mesh.mesh.points;
    muscle->triangles = mesh.mesh.triangles;
    muscle->delivered_volume = mesh.delivered_volume;
    muscles[py::str(mesh.name)] = muscle;
  }
  return muscles;
}

py::dict VolumesOfSubject(const SharedSubject& subject) {
  py::dict volumes;
  for (const auto* meshes : {&subject->bones, &subject->muscles}) {
    for (const SubjectMesh& mesh : *meshes) {
      volumes[py::str(mesh.name)] = mesh.delivered_volume;
    }
  }
  return volumes;
}

}  // namespace

void BindLabels(py::module_* module) {
  py::class_<Subject, std::shared_ptr<Subject>>(*module, "Subject", kSubjectDoc)
      .def_property_readonly("bones", &BonesOfSubject)
      .def_property_readonly("muscles", &MusclesOfSubject)
      .def_property_readonly("volumes", &VolumesOfSubject)
      .def_property_readonly(
          "is_oriented",
          [](const Subject& subject) { return subject.IsOriented(); })
      .def_property_readonly("notes", [](const Subject& subject) {
        return WithFieldNames(subject.notes);
      });
  module->def("read_label_file",
              &ReadLabelFile,
              py::arg("path"),
              py::arg("settings"),
              py::arg("names"));
  module->def("read_label_array",
              &ReadLabelArray,
              py::arg("labels"),
              py::arg("size"),
              py::arg("affine"),
              py::arg("space"),
              py::arg("settings"),
              py::arg("names"));
}

}  // namespace musclewarp::python
