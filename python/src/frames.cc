// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "python/src/frames.h"

#include <pybind11/stl.h>

#include <set>

#include "musclewarp/scene/scene_names.h"
#include "python/src/arrays.h"
#include "python/src/bindings.h"
#include "python/src/figures.h"
#include "python/src/pickling.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;

// The properties that are not made of the lists of figures.
const std::set<std::string> kOfMuscleByHand = {
    "name", "path_lengths", "attachments", "shape"};
const std::set<std::string> kOfFrameByHand = {"muscles"};

// What help() says.
constexpr char kMuscleFrameDoc[] =
    R"(A muscle in one pose (src/musclewarp/frames/frame.h). Arrays are read-only.

Attributes:
    name: of the muscle.
    points: (n, 3) float64, mm, of the mesh after repair.
    triangles: (m, 3) int32, the same in all frames.
    gaps: (n,) the distance of each point to the nearest other mesh, mm,
        negative inside of one; at most 5.
    lines: the action lines as the muscle carries them, (p, 3) each, mm.
    fibres: the same of fibres.
    bare_tendons: where its lines go on along tendons that have no mesh,
        (p, 3) each, mm.
    path_lengths: of the action lines straight through their points, mm.
    shape: stretch, area ratios, bend (degrees), change (mm), and the quantiles
        and the largest patch (mm2) of the stretch of triangles, by name.
    attachments: how far each attachment area has left its body, mm.)";

constexpr char kBoneFrameDoc[] = R"(A bone in one pose. Arrays are read-only.

Attributes:
    name: of the bone.
    points: (n, 3) float64, mm, of the mesh after repair.
    triangles: (m, 3) int32, the same in all frames.)";

constexpr char kFrameDoc[] =
    R"(A scene in one pose, with all that is known about it.

frame["psoas"] is the MuscleFrame or BoneFrame of that name; iterating gives the
names. A frame is a value of its own: it does not change, and may be used when
its deformer is gone. str(frame) is a report.

Attributes:
    muscles, bones: lists of MuscleFrame and BoneFrame.
    names: of both.
    crossing_pairs: of triangles of different meshes, by exact tests.
    worst_volume_error: the largest size of a volume_error of a muscle.)";

std::vector<MuscleOfFrame> MusclesOf(const SharedFrame& frame) {
  std::vector<MuscleOfFrame> muscles;
  for (size_t i = 0; i < frame->parts->muscles.size(); ++i) {
    muscles.push_back({frame, i});
  }
  return muscles;
}

std::vector<BoneOfFrame> BonesOf(const SharedFrame& frame) {
  std::vector<BoneOfFrame> bones;
  for (size_t i = 0; i < frame->parts->bones.size(); ++i) {
    bones.push_back({frame, i});
  }
  return bones;
}

std::vector<std::string> NamesOf(const FrameOfScene& frame) {
  std::vector<std::string> names;
  for (const auto& part : frame.parts->muscles) names.push_back(part.name);
  for (const auto& part : frame.parts->bones) names.push_back(part.name);
  return names;
}

// The muscle or bone with a name, or a null object.
py::object Find(const SharedFrame& frame, const std::string& name) {
  for (const MuscleOfFrame& muscle : MusclesOf(frame)) {
    if (muscle.part().name == name) return py::cast(muscle);
  }
  for (const BoneOfFrame& bone : BonesOf(frame)) {
    if (bone.part().name == name) return py::cast(bone);
  }
  return py::object();
}

py::object At(const SharedFrame& frame, const std::string& name) {
  py::object part = Find(frame, name);
  if (part) return part;
  std::string names;
  for (const std::string& known : NamesOf(*frame)) {
    names += (names.empty() ? "" : ", ") + known;
  }
  throw py::key_error(QuotedName(name) +
                      " is no muscle or bone of the frame; "
                      "it has " +
                      names);
}

std::vector<py::array> Views(const std::vector<Points>& lines,
                             const SharedFrame& owner) {
  std::vector<py::array> views;
  for (const Points& line : lines) views.push_back(ViewOf(line, owner));
  return views;
}

constexpr char kPolydataDoc[] =
    R"(Returns the vtkPolyData of a mesh; of a frame, a dict of them by name.

They are copies. The points of muscles carry "gap", mm. Raises InputError where
VTK's Python modules are not installed.)";

// Meshes become those of VTK in Python, where VTK is.
py::object Polydata(const py::object& self) {
  return py::module_::import("musclewarp._vtk").attr("polydata")(self);
}

// The numbers of a shape, and of its stretches of triangles by names of their
// own.
py::dict ShapeOf(const ShapeMeasures& shape) {
  py::dict dict;
  VisitFields(shape, [&](const auto& field, const auto& value) {
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(value)>>) {
      dict[field.key] = value;
    }
  });
  dict["stretch_quantile_99"] = shape.triangles.quantile_99;
  dict["stretch_quantile_999"] = shape.triangles.quantile_999;
  dict["largest_triangle_stretch"] = shape.triangles.largest;
  dict["stretch_patch_mm2"] = shape.triangles.largest_patch;
  return dict;
}

// What a report says of attachments, and the same by shorter names.
py::list DriftsOf(const std::vector<AttachmentDrift>& drifts) {
  py::list dicts;
  for (const AttachmentDrift& drift : drifts) {
    py::object dict = ToPython(drift);
    dict["mean_mm"] = drift.mean;
    dict["max_mm"] = drift.max;
    dicts.append(dict);
  }
  return dicts;
}

// In the order of the lines; at rest there are none.
std::vector<double> PathLengthsOf(const MuscleOfFrame& muscle) {
  std::vector<double> lengths;
  for (const std::string& line : muscle.part().lines) {
    const auto length = muscle.muscle().path_lengths.find(line);
    if (length != muscle.muscle().path_lengths.end()) {
      lengths.push_back(length->second);
    }
  }
  return lengths;
}

const MuscleFigures& FiguresOfMuscle(const MuscleOfFrame& muscle) {
  return muscle.muscle();
}

const FiguresOfFrame<MuscleFrame>& FiguresOfPose(const FrameOfScene& frame) {
  return frame.frame;
}

void BindMuscle(py::module_* module) {
  const std::string doc =
      kMuscleFrameDoc + AttributeTexts<MuscleFigures>(kOfMuscleByHand);
  py::class_<MuscleOfFrame> type(*module, "MuscleFrame", doc.c_str());
  BindFigures(&FiguresOfMuscle, kOfMuscleByHand, &type);
  type.def(PickledPartOfFrame<MuscleOfFrame>())
      .def_property_readonly(
          "name", [](const MuscleOfFrame& m) { return m.part().name; })
      .def_property_readonly("points",
                             [](const MuscleOfFrame& m) {
                               return ViewOf(m.muscle().points, m.of);
                             })
      .def_property_readonly("triangles",
                             [](const MuscleOfFrame& m) {
                               return ViewOf(m.part().triangles, m.of);
                             })
      .def_property_readonly(
          "gaps",
          [](const MuscleOfFrame& m) { return ViewOf(m.muscle().gaps, m.of); })
      .def_property_readonly(
          "lines",
          [](const MuscleOfFrame& m) { return Views(m.muscle().lines, m.of); })
      .def_property_readonly(
          "fibres",
          [](const MuscleOfFrame& m) { return Views(m.muscle().fibres, m.of); })
      .def_property_readonly("bare_tendons",
                             [](const MuscleOfFrame& m) {
                               return Views(m.muscle().bare_tendons, m.of);
                             })
      .def_property_readonly("path_lengths", &PathLengthsOf)
      .def_property_readonly(
          "shape",
          [](const MuscleOfFrame& m) { return ShapeOf(m.muscle().shape); })
      .def_property_readonly("attachments",
                             [](const MuscleOfFrame& m) {
                               return DriftsOf(m.muscle().attachments);
                             })
      .def("polydata", &Polydata, kPolydataDoc)
      .def("__repr__", [](const MuscleOfFrame& m) {
        return "<musclewarp.MuscleFrame " + m.part().name + ">";
      });
}

void BindBone(py::module_* module) {
  py::class_<BoneOfFrame>(*module, "BoneFrame", kBoneFrameDoc)
      .def(PickledPartOfFrame<BoneOfFrame>())
      .def_property_readonly("name",
                             [](const BoneOfFrame& b) { return b.part().name; })
      .def_property_readonly(
          "points",
          [](const BoneOfFrame& b) { return ViewOf(b.points(), b.of); })
      .def_property_readonly(
          "triangles",
          [](const BoneOfFrame& b) { return ViewOf(b.part().triangles, b.of); })
      .def("polydata", &Polydata, kPolydataDoc)
      .def("__repr__", [](const BoneOfFrame& b) {
        return "<musclewarp.BoneFrame " + b.part().name + ">";
      });
}

void BindParts(py::class_<FrameOfScene, SharedFrame>* type) {
  type->def_property_readonly("muscles", &MusclesOf)
      .def_property_readonly("bones", &BonesOf)
      .def_property_readonly("names", &NamesOf)
      .def("__getitem__", &At, py::arg("name"))
      .def("__contains__",
           [](const SharedFrame& frame, const std::string& name) {
             return static_cast<bool>(Find(frame, name));
           })
      .def("__iter__",
           [](const FrameOfScene& f) { return py::iter(py::cast(NamesOf(f))); })
      .def("__len__",
           [](const FrameOfScene& f) {
             return f.frame.muscles.size() + f.frame.bones.size();
           })
      .def("polydata", &Polydata, kPolydataDoc)
      .def("__str__",
           [](const FrameOfScene& f) { return f.frame.FullReport(); })
      .def("__repr__", [](const FrameOfScene& f) {
        return "<musclewarp.Frame " + f.frame.BriefReport() + ">";
      });
}

}  // namespace

std::shared_ptr<const SceneParts> PartsOf(
    const PreparedScene& scene,
    const std::map<std::string, std::string>& keywords) {
  const auto parts = std::make_shared<SceneParts>();
  parts->key = KeyOf(scene, keywords);
  for (const PreparedMuscle& muscle : scene.muscles) {
    auto& part = parts->muscles.emplace_back();
    part.name = muscle.model.name;
    part.triangles = muscle.model.fine_triangles;
    for (const ActionLine& line : muscle.model.lines) {
      part.lines.push_back(line.name);
    }
  }
  for (const PreparedBone& bone : scene.bones) {
    parts->bones.push_back({bone.mesh.name, bone.rest.triangles, {}});
  }
  return parts;
}

void BindFrames(py::module_* module) {
  BindMuscle(module);
  BindBone(module);
  const std::string doc =
      kFrameDoc + AttributeTexts<FrameFigures>(kOfFrameByHand);
  py::class_<FrameOfScene, SharedFrame> type(*module, "Frame", doc.c_str());
  BindParts(&type);
  BindFigures(&FiguresOfPose, kOfFrameByHand, &type);
  type.def(Pickled<FrameOfScene>());
  type.def_property_readonly(
          "worst_volume_error",
          [](const FrameOfScene& f) { return f.frame.WorstVolumeError(); })
      .def_property_readonly("crossing_pairs", [](const FrameOfScene& f) {
        return f.frame.intersections.triangle_pairs;
      });
}

}  // namespace musclewarp::python
