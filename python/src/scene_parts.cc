// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <filesystem>

#include "musclewarp/base/input_error.h"
#include "musclewarp/preparation/delivered_mesh.h"
#include "musclewarp/scene/scene_names.h"
#include "python/src/arrays.h"
#include "python/src/bindings.h"
#include "python/src/call.h"
#include "python/src/pickling.h"
#include "python/src/scene.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;
using Names = std::vector<std::string>;

// What help() says.
constexpr char kLineDoc[] =
    R"(A line of action of a muscle in the rest pose, from origin to insertion.

Args:
    name: different from those of all other lines.
    points: (p, 3), mm, at least two.
    bodies: the name of the body that each point is fixed to; none if the lines
        of poses say where the points go.
    slides: True if only the ends are fixed to the muscle, which slides along
        the line between them.
Raises:
    InputError: the points are not allowed.)";

constexpr char kAttachmentDoc[] =
    R"(An area of a muscle that follows a body (docs/scene.md).

Args:
    body: its name.
    points: (p, 3), mm, in the rest pose.
    radius: mm. What of the muscle is as near to one of the points is attached.
    may_penetrate: True if triangles of the area may cross bones of the body.
    outline: True if the points go round the area, in order.
Raises:
    InputError: names the argument.)";

constexpr char kMuscleDoc[] =
    R"(A muscle of a scene, in the rest pose. It does not change.

Args:
    name: also of its files.
    points: (n, 3), in `units`.
    triangles: (m, 3) indices of points.
    lines: Lines of action. Without any they are made from the meshes.
    attachments: Attachments. Without any they are found on the meshes.
    ends_on: names of the muscles on which it ends instead of on bones. None:
        found on the meshes.
    end_bodies: the bodies on whose bones it ends, that of its origin and that
        of its insertion. Empty: found on the meshes.
    path: of a mesh file, in place of points and triangles, or of one of its
        named parts: "muscles.obj#gluteus_medius".
    units: of the points or the file: "mm", "cm" or "m".
Attributes:
    mesh: the Mesh as it was given, in mm; a file is read each time.
Raises:
    InputError: names the muscle and the array.)";

constexpr char kBoneDoc[] =
    R"(A bone of a scene, in the rest pose. It does not change.

Args:
    name: also of its files.
    points: (n, 3), in `units`.
    triangles: (m, 3) indices of points.
    body: the body that it moves with; by default one of its own name.
    path: of a mesh file, in place of points and triangles, or of one of its
        named parts: "muscles.obj#gluteus_medius".
    units: of the points or the file: "mm", "cm" or "m".
Attributes:
    mesh: the Mesh as it was given, in mm; a file is read each time.
Raises:
    InputError: names the bone and the array.)";

// Sets the mesh of a muscle or bone: arrays, or a file.
template <typename Part>
void SetMesh(const py::object& points,
             const py::object& triangles,
             const std::filesystem::path& path,
             double mm_per_unit,
             const std::string& where,
             Part* part) {
  const bool has_arrays = !points.is_none() || !triangles.is_none();
  if (has_arrays == !path.empty()) {
    throw InputError(where,
                     has_arrays ? "has arrays and a path" : "has no mesh",
                     "give points and triangles, or the path of a mesh file");
  }
  part->mesh_path = path.string();
  if (!has_arrays) return;
  part->points = mm_per_unit * PointsFrom(points, where + ": points");
  part->triangles =
      TrianglesFrom(triangles, part->points.rows(), where + ": triangles");
}

// Returns the mesh of a muscle or bone as it was delivered.
template <typename Part>
std::shared_ptr<TriangleSoup> MeshOf(const Part& part) {
  return ComputeFree([&part] {
    std::vector<std::string> notes;  // a Deformer gives them
    return std::make_shared<TriangleSoup>(DeliveredMesh(part, &notes));
  });
}

SharedLine MakeLine(const std::string& name,
                    const py::object& points,
                    const Names& bodies,
                    bool slides) {
  const auto line = std::make_shared<ActionLine>();
  line->name = name;
  line->rest = PointsFrom(points, "line " + QuotedName(name) + ": points");
  line->bodies = bodies;
  line->slides = slides;
  return line;
}

SharedAttachment MakeAttachment(const std::string& body,
                                const py::object& points,
                                double radius,
                                bool may_penetrate,
                                bool outline) {
  const std::string where = "attachment to " + QuotedName(body);
  const auto attachment = std::make_shared<Attachment>();
  attachment->body = body;
  attachment->points = PointsFrom(points, where + ": points");
  attachment->radius = radius;
  attachment->may_penetrate = may_penetrate;
  attachment->is_outline = outline;
  if (!(radius > 0 && std::isfinite(radius))) {
    throw InputError(where + ": radius",
                     "is " + std::to_string(radius),
                     "allowed: above 0, mm");
  }
  return attachment;
}

SharedMuscle MakeMuscle(const std::string& name,
                        const py::object& points,
                        const py::object& triangles,
                        const std::vector<SharedLine>& lines,
                        const std::vector<SharedAttachment>& attachments,
                        const std::optional<Names>& ends_on,
                        const Names& end_bodies,
                        const std::filesystem::path& path,
                        const std::string& units) {
  const auto muscle = std::make_shared<SceneMuscle>();
  muscle->name = name;
  const std::string where = "muscle " + QuotedName(name);
  muscle->mm_per_unit = MillimetresFrom(units, where);
  SetMesh(points, triangles, path, muscle->mm_per_unit, where, muscle.get());
  for (const SharedLine& line : lines) muscle->lines.push_back(*line);
  for (const SharedAttachment& attachment : attachments) {
    muscle->attachments.push_back(*attachment);
  }
  muscle->ends_on = ends_on;
  muscle->end_bodies = end_bodies;
  return muscle;
}

SharedBone MakeBone(const std::string& name,
                    const py::object& points,
                    const py::object& triangles,
                    const std::string& body,
                    const std::filesystem::path& path,
                    const std::string& units) {
  const auto bone = std::make_shared<SceneBone>();
  bone->name = name;
  bone->body = body.empty() ? name : body;
  const std::string where = "bone " + QuotedName(name);
  const double mm_per_unit = MillimetresFrom(units, where);
  SetMesh(points, triangles, path, mm_per_unit, where, bone.get());
  if (!bone->mesh_path.empty()) {
    bone->rest_from_file.diagonal().head<3>().setConstant(mm_per_unit);
  }
  return bone;
}

void BindLines(py::module_* module) {
  py::class_<ActionLine, SharedLine>(*module, "Line", kLineDoc)
      .def(Pickled<ActionLine>())
      .def(py::init(&MakeLine),
           py::arg("name"),
           py::arg("points"),
           py::arg("bodies") = Names(),
           py::kw_only(),
           py::arg("slides") = false)
      .def_readonly("name", &ActionLine::name)
      .def_property_readonly(
          "points",
          [](const SharedLine& line) { return ViewOf(line->rest, line); })
      .def_readonly("bodies", &ActionLine::bodies)
      .def_readonly("slides", &ActionLine::slides);
  py::class_<Attachment, SharedAttachment>(
      *module, "Attachment", kAttachmentDoc)
      .def(Pickled<Attachment>())
      .def(py::init(&MakeAttachment),
           py::arg("body"),
           py::arg("points"),
           py::arg("radius"),
           py::kw_only(),
           py::arg("may_penetrate") = false,
           py::arg("outline") = false)
      .def_readonly("body", &Attachment::body)
      .def_property_readonly("points",
                             [](const SharedAttachment& attachment) {
                               return ViewOf(attachment->points, attachment);
                             })
      .def_readonly("radius", &Attachment::radius)
      .def_readonly("may_penetrate", &Attachment::may_penetrate)
      .def_readonly("outline", &Attachment::is_outline);
}

void BindMuscles(py::module_* module) {
  py::class_<SceneMuscle, SharedMuscle>(*module, "Muscle", kMuscleDoc)
      .def(Pickled<SceneMuscle>())
      .def(py::init(&MakeMuscle),
           py::arg("name"),
           py::arg("points") = py::none(),
           py::arg("triangles") = py::none(),
           py::kw_only(),
           py::arg("lines") = std::vector<SharedLine>(),
           py::arg("attachments") = std::vector<SharedAttachment>(),
           py::arg("ends_on") = py::none(),
           py::arg("end_bodies") = Names(),
           py::arg("path") = "",
           py::arg("units") = "mm")
      .def_readonly("name", &SceneMuscle::name)
      .def_readonly("path", &SceneMuscle::mesh_path)
      .def_property_readonly("mesh", &MeshOf<SceneMuscle>)
      .def_property_readonly(
          "lines",
          [](const SceneMuscle& muscle) { return Shared(muscle.lines); })
      .def_property_readonly(
          "attachments",
          [](const SceneMuscle& muscle) { return Shared(muscle.attachments); })
      .def_readonly("ends_on", &SceneMuscle::ends_on)
      .def_readonly("end_bodies", &SceneMuscle::end_bodies);
}

void BindBones(py::module_* module) {
  py::class_<SceneBone, SharedBone>(*module, "Bone", kBoneDoc)
      .def(Pickled<SceneBone>())
      .def(py::init(&MakeBone),
           py::arg("name"),
           py::arg("points") = py::none(),
           py::arg("triangles") = py::none(),
           py::kw_only(),
           py::arg("body") = "",
           py::arg("path") = "",
           py::arg("units") = "mm")
      .def_readonly("name", &SceneBone::name)
      .def_readonly("body", &SceneBone::body)
      .def_readonly("path", &SceneBone::mesh_path)
      .def_property_readonly("mesh", &MeshOf<SceneBone>);
}

}  // namespace

void BindSceneParts(py::module_* module) {
  BindLines(module);
  BindMuscles(module);
  BindBones(module);
}

}  // namespace musclewarp::python
