// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "python/src/frames.h"

#include <pybind11/stl.h>

#include "musclewarp/report/frame_record.h"
#include "musclewarp/scene/scene_names.h"
#include "python/src/arrays.h"
#include "python/src/bindings.h"
#include "python/src/json.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;

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
    path_lengths: of the action lines straight through their points, mm.
    volume: mm^3.
    volume_ratio: of the volume to that of the mesh as it was delivered.
    volume_error: how far the volume is off the one the solver keeps, as a
        share of it.
    folded_triangles: that point the wrong way.
    self_pairs: pairs of triangles of the muscle that cross each other.
    max_displacement: of a point from rest, mm.
    max_contact_displacement, mean_contact_displacement: how far contact moved
        points, mm.
    depth_without_contact: how deep the muscle would be in others, mm.
    torn_patch: the largest patch that contact stretches beyond twice its
        length at rest, mm2.
    pushed_by, push_depth: the muscles that push it, which comes last, and the
        depth of their overlaps without contact, mm.
    iterations, stop_reason: of the solver; "converged" if it did.
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
    name, time: of the pose; s.
    index: of the pose in its run, or -1.
    coordinates: of the model, rad or m, by name.
    usable: True if every solve converged and there are no shortcomings.
    shortcomings: what a frame has to hold and this one does not, a sentence
        each; only with certified contact.
    crossing_pairs: of triangles of different meshes, by exact tests.
    smallest_gap: of two meshes, mm, proved; None if all are above 2 mm.
    intersections: all that crosses, as in docs/report.md.
    muscles, bones: lists of MuscleFrame and BoneFrame.
    names: of both.
    worst_volume_error: the largest |volume ratio - 1| of a muscle.
    path_moment_arms: -dl/dq of straight lines by line and coordinate, mm/rad.
    iterations, stop_reason: of the solver, of all muscles together.
    pose_steps: on the way from the frame before.
    wall_ms, solve_ms, certify_ms: times.)";
using SharedFrame = std::shared_ptr<FrameOfScene>;

// A muscle of a frame, and a bone.
struct MuscleOfFrame {
  SharedFrame of;
  size_t idx;

  const MuscleFrame& muscle() const { return of->frame.muscles[idx]; }
  const SceneParts::Part& part() const { return of->parts->muscles[idx]; }
};

struct BoneOfFrame {
  SharedFrame of;
  size_t idx;

  const Points& points() const { return of->frame.bones[idx]; }
  const SceneParts::Part& part() const { return of->parts->bones[idx]; }
};

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

py::dict ShapeOf(const ShapeMeasures& shape) {
  py::dict dict;
  dict["max_stretch"] = shape.max_stretch;
  dict["max_stretch_along"] = shape.max_stretch_along;
  dict["max_stretch_across"] = shape.max_stretch_across;
  dict["min_area_ratio"] = shape.min_area_ratio;
  dict["max_area_ratio"] = shape.max_area_ratio;
  dict["max_bend_deg"] = shape.max_bend;
  dict["max_change_mm"] = shape.max_change;
  dict["stretch_quantile_99"] = shape.triangles.quantile_99;
  dict["stretch_quantile_999"] = shape.triangles.quantile_999;
  dict["largest_triangle_stretch"] = shape.triangles.largest;
  dict["stretch_patch_mm2"] = shape.triangles.largest_patch;
  return dict;
}

std::vector<py::dict> DriftsOf(const std::vector<AttachmentDrift>& drifts) {
  std::vector<py::dict> dicts;
  for (const AttachmentDrift& drift : drifts) {
    py::dict dict;
    dict["body"] = drift.body;
    dict["vertices"] = drift.vertices;
    dict["mean_mm"] = drift.mean;
    dict["max_mm"] = drift.max;
    dicts.push_back(dict);
  }
  return dicts;
}

// A property that is a field of MuscleFrame.
template <typename Class, typename Value>
void Field(Class* type, const char* name, Value MuscleFrame::*field) {
  type->def_property_readonly(
      name, [field](const MuscleOfFrame& m) { return m.muscle().*field; });
}

// The figures of a muscle.
void BindMeasures(py::class_<MuscleOfFrame>* type) {
  Field(type, "volume_ratio", &MuscleFrame::volume_ratio);
  Field(type, "volume_error", &MuscleFrame::volume_error);
  Field(type, "folded_triangles", &MuscleFrame::folded_triangles);
  Field(type, "self_pairs", &MuscleFrame::self_pairs);
  Field(type, "max_displacement", &MuscleFrame::max_displacement);
  Field(
      type, "max_contact_displacement", &MuscleFrame::max_contact_displacement);
  Field(type,
        "mean_contact_displacement",
        &MuscleFrame::mean_contact_displacement);
  Field(type, "depth_without_contact", &MuscleFrame::depth_without_contact);
  Field(type, "pushed_by", &MuscleFrame::pushed_by);
  Field(type, "push_depth", &MuscleFrame::push_depth);
  Field(type, "path_lengths", &MuscleFrame::path_lengths);
  type->def_property_readonly("torn_patch", [](const MuscleOfFrame& m) {
    return m.muscle().torn_patch.area;
  });
}

void BindMuscle(py::module_* module) {
  py::class_<MuscleOfFrame> type(*module, "MuscleFrame", kMuscleFrameDoc);
  type.def_property_readonly(
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
      .def_property_readonly("volume",
                             [](const MuscleOfFrame& m) {
                               return m.muscle().volume_ratio *
                                      m.part().delivered_volume;
                             })
      .def_property_readonly(
          "iterations",
          [](const MuscleOfFrame& m) { return m.muscle().solver.iterations; })
      .def_property_readonly("stop_reason",
                             [](const MuscleOfFrame& m) {
                               return ToString(m.muscle().solver.stop_reason);
                             })
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
  BindMeasures(&type);
}

void BindBone(py::module_* module) {
  py::class_<BoneOfFrame>(*module, "BoneFrame", kBoneFrameDoc)
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

// A property that is a field or a method of Frame.
template <typename Class, typename Member>
void OfFrame(Class* type, const char* name, Member member) {
  type->def_property_readonly(name, [member](const FrameOfScene& f) {
    return std::invoke(member, f.frame);
  });
}

}  // namespace

std::shared_ptr<const SceneParts> PartsOf(const PreparedScene& scene) {
  const auto parts = std::make_shared<SceneParts>();
  for (const PreparedMuscle& muscle : scene.muscles) {
    parts->muscles.push_back({muscle.model.name,
                              muscle.model.fine_triangles,
                              muscle.mesh.delivered_volume});
  }
  for (const PreparedBone& bone : scene.bones) {
    parts->bones.push_back({bone.mesh.name, bone.rest.triangles});
  }
  return parts;
}

void BindFrames(py::module_* module) {
  BindMuscle(module);
  BindBone(module);
  py::class_<FrameOfScene, SharedFrame> type(*module, "Frame", kFrameDoc);
  BindParts(&type);
  OfFrame(&type, "name", &Frame::name);
  OfFrame(&type, "index", &Frame::index);
  OfFrame(&type, "time", &Frame::time);
  OfFrame(&type, "coordinates", &Frame::coordinates);
  OfFrame(&type, "usable", &Frame::IsUsable);
  OfFrame(&type, "shortcomings", &Frame::shortcomings);
  OfFrame(&type, "iterations", &Frame::iterations);
  OfFrame(&type, "stop_reason", &Frame::stop_reason);
  OfFrame(&type, "worst_volume_error", &Frame::WorstVolumeError);
  OfFrame(&type, "path_moment_arms", &Frame::path_moment_arms);
  OfFrame(&type, "pose_steps", &Frame::pose_steps);
  OfFrame(&type, "wall_ms", &Frame::wall_ms);
  OfFrame(&type, "solve_ms", &Frame::solve_ms);
  OfFrame(&type, "certify_ms", &Frame::certify_ms);
  type.def_property_readonly("crossing_pairs",
                             [](const FrameOfScene& f) {
                               return f.frame.intersections.triangle_pairs;
                             })
      .def_property_readonly("smallest_gap",
                             [](const FrameOfScene& f) {
                               return f.frame.intersections.SmallestGap();
                             })
      .def_property_readonly("intersections", [](const FrameOfScene& f) {
        return FromJson(ToJson(f.frame.intersections));
      });
}

}  // namespace musclewarp::python
