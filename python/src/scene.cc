// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "python/src/scene.h"

#include <pybind11/stl.h>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/scene/scene_names.h"
#include "python/src/arrays.h"
#include "python/src/bindings.h"
#include "python/src/call.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;
using Names = std::vector<std::string>;

// Sets the mesh of a muscle or bone: arrays, or a file.
template <typename Part>
void SetMesh(const py::object& points,
             const py::object& triangles,
             const std::string& path,
             const std::string& where,
             Part* part) {
  const bool has_arrays = !points.is_none() || !triangles.is_none();
  if (has_arrays == !path.empty()) {
    throw InputError(where,
                     has_arrays ? "has arrays and a path" : "has no mesh",
                     "give points and triangles, or the path of a mesh file");
  }
  part->mesh_path = path;
  if (!has_arrays) return;
  part->points = PointsFrom(points, where + ": points");
  part->triangles =
      TrianglesFrom(triangles, part->points.rows(), where + ": triangles");
}

// Returns the mesh of a muscle or bone as it was delivered.
template <typename Part>
std::shared_ptr<TriangleSoup> DeliveredMesh(const Part& part) {
  if (part.mesh_path.empty()) {
    return std::make_shared<TriangleSoup>(
        TriangleSoup{part.points, part.triangles});
  }
  return ComputeFree([path = part.mesh_path] {
    return std::make_shared<TriangleSoup>(ReadTriangleSoup(path));
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
                                bool may_penetrate) {
  const std::string where = "attachment to " + QuotedName(body);
  const auto attachment = std::make_shared<Attachment>();
  attachment->body = body;
  attachment->points = PointsFrom(points, where + ": points");
  attachment->radius = radius;
  attachment->may_penetrate = may_penetrate;
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
                        const std::string& path) {
  const auto muscle = std::make_shared<SceneMuscle>();
  muscle->name = name;
  SetMesh(points, triangles, path, "muscle " + QuotedName(name), muscle.get());
  for (const SharedLine& line : lines) muscle->lines.push_back(*line);
  for (const SharedAttachment& attachment : attachments) {
    muscle->attachments.push_back(*attachment);
  }
  return muscle;
}

SharedBone MakeBone(const std::string& name,
                    const py::object& points,
                    const py::object& triangles,
                    const std::string& body,
                    const std::string& path) {
  const auto bone = std::make_shared<SceneBone>();
  bone->name = name;
  bone->body = body.empty() ? name : body;
  SetMesh(points, triangles, path, "bone " + QuotedName(name), bone.get());
  return bone;
}

SharedPose MakePose(const std::string& name,
                    double time,
                    const std::map<std::string, py::object>& bodies,
                    const std::map<std::string, py::object>& lines,
                    const std::map<std::string, double>& coordinates) {
  const std::string where = "pose " + QuotedName(name);
  const auto pose = std::make_shared<ScenePose>();
  pose->name = name;
  pose->time = time;
  if (!std::isfinite(time)) {
    throw InputError(
        where + ": time", "is " + std::to_string(time), "allowed: finite, s");
  }
  for (const auto& [body, motion] : bodies) {
    pose->bodies[body] =
        RigidMotionFrom(motion, where + ": body " + QuotedName(body));
  }
  for (const auto& [line, points] : lines) {
    pose->lines[line] =
        PointsFrom(points, where + ": line " + QuotedName(line));
  }
  pose->coordinates = coordinates;
  return pose;
}

// The scene of a model at values of its coordinates, rad or m; the others are
// as in the rest pose.
SharedPose PoseOfModel(const Scene& scene,
                       const std::map<std::string, double>& coordinates,
                       const std::string& name,
                       double time) {
  if (!scene.model) {
    throw InputError("scene", "has no model", "give poses by their bodies");
  }
  const ModelPoses& model = *scene.model;
  CoordinateValues values = model.rest;
  for (const auto& [coordinate, value] : coordinates) {
    const int c = model.model.FindCoordinate(coordinate);
    if (c < 0 || !std::isfinite(value)) {
      throw InputError(
          "coordinate " + QuotedName(coordinate),
          c < 0 ? "is none of the model" : "is " + std::to_string(value),
          c < 0 ? "Model.coordinates lists them" : "allowed: finite numbers");
    }
    values[c] = value;
  }
  ApplyCouplers(model.model, &values);
  const auto pose = std::make_shared<ScenePose>(PoseAt(model, values));
  pose->name = name;
  pose->time = time;
  return pose;
}

// Puts lists of parts in place of those of a scene.
SharedScene Assemble(const SharedScene& source,
                     const std::string& name,
                     const std::vector<SharedMuscle>& muscles,
                     const std::vector<SharedBone>& bones,
                     const std::vector<SharedPose>& poses,
                     bool is_motion,
                     const std::string& axes,
                     const std::string& side) {
  const auto scene = std::make_shared<Scene>(*source);
  scene->name = name;
  scene->muscles.clear();
  for (const SharedMuscle& muscle : muscles) scene->muscles.push_back(*muscle);
  scene->bones.clear();
  for (const SharedBone& bone : bones) scene->bones.push_back(*bone);
  scene->poses.clear();
  for (const SharedPose& pose : poses) scene->poses.push_back(*pose);
  scene->is_motion = is_motion;
  scene->axes = axes;
  scene->side = side;
  return scene;
}

template <typename Part>
std::vector<std::shared_ptr<Part>> Shared(const std::vector<Part>& parts) {
  std::vector<std::shared_ptr<Part>> shared;
  for (const Part& part : parts) shared.push_back(std::make_shared<Part>(part));
  return shared;
}

std::map<std::string, py::array> Views(
    const std::map<std::string, Points>& lines, const SharedPose& owner) {
  std::map<std::string, py::array> views;
  for (const auto& [name, points] : lines) {
    views.emplace(name, ViewOf(points, owner));
  }
  return views;
}

void BindLines(py::module_* module) {
  py::class_<ActionLine, SharedLine>(*module, "Line")
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
  py::class_<Attachment, SharedAttachment>(*module, "Attachment")
      .def(py::init(&MakeAttachment),
           py::arg("body"),
           py::arg("points"),
           py::arg("radius"),
           py::kw_only(),
           py::arg("may_penetrate") = false)
      .def_readonly("body", &Attachment::body)
      .def_property_readonly("points",
                             [](const SharedAttachment& attachment) {
                               return ViewOf(attachment->points, attachment);
                             })
      .def_readonly("radius", &Attachment::radius)
      .def_readonly("may_penetrate", &Attachment::may_penetrate);
}

void BindMusclesAndBones(py::module_* module) {
  py::class_<SceneMuscle, SharedMuscle>(*module, "Muscle")
      .def(py::init(&MakeMuscle),
           py::arg("name"),
           py::arg("points") = py::none(),
           py::arg("triangles") = py::none(),
           py::kw_only(),
           py::arg("lines") = std::vector<SharedLine>(),
           py::arg("attachments") = std::vector<SharedAttachment>(),
           py::arg("path") = "")
      .def_readonly("name", &SceneMuscle::name)
      .def_readonly("path", &SceneMuscle::mesh_path)
      .def_property_readonly("mesh", &DeliveredMesh<SceneMuscle>)
      .def_property_readonly(
          "lines",
          [](const SceneMuscle& muscle) { return Shared(muscle.lines); })
      .def_property_readonly("attachments", [](const SceneMuscle& muscle) {
        return Shared(muscle.attachments);
      });
  py::class_<SceneBone, SharedBone>(*module, "Bone")
      .def(py::init(&MakeBone),
           py::arg("name"),
           py::arg("points") = py::none(),
           py::arg("triangles") = py::none(),
           py::kw_only(),
           py::arg("body") = "",
           py::arg("path") = "")
      .def_readonly("name", &SceneBone::name)
      .def_readonly("body", &SceneBone::body)
      .def_readonly("path", &SceneBone::mesh_path)
      .def_property_readonly("mesh", [](const SceneBone& bone) {
        const auto mesh = DeliveredMesh(bone);
        mesh->points = Transformed(mesh->points, bone.rest_from_file);
        return mesh;
      });
}

void BindPoses(py::module_* module) {
  py::class_<ScenePose, SharedPose>(*module, "Pose")
      .def(py::init(&MakePose),
           py::arg("name") = "",
           py::kw_only(),
           py::arg("time") = 0.0,
           py::arg("bodies") = std::map<std::string, py::object>(),
           py::arg("lines") = std::map<std::string, py::object>(),
           py::arg("coordinates") = std::map<std::string, double>())
      .def_readonly("name", &ScenePose::name)
      .def_readonly("time", &ScenePose::time)
      .def_readonly("coordinates", &ScenePose::coordinates)
      .def_readonly("path_lengths", &ScenePose::path_lengths)
      .def_property_readonly("bodies",
                             [](const ScenePose& pose) {
                               std::map<std::string, py::array> bodies;
                               for (const auto& [name, motion] : pose.bodies) {
                                 bodies.emplace(name, CopyOf(motion));
                               }
                               return bodies;
                             })
      .def_property_readonly(
          "lines",
          [](const SharedPose& pose) { return Views(pose->lines, pose); })
      .def("__repr__", [](const ScenePose& pose) {
        return "<musclewarp.Pose " + QuotedName(pose.name) + ">";
      });
}

}  // namespace

void BindScene(py::module_* module) {
  BindLines(module);
  BindMusclesAndBones(module);
  BindPoses(module);
  py::class_<Scene, SharedScene>(*module, "SceneSource")
      .def(py::init<>())
      .def_readonly("name", &Scene::name)
      .def_readonly("path", &Scene::path)
      .def_readonly("axes", &Scene::axes)
      .def_readonly("side", &Scene::side)
      .def_readonly("is_motion", &Scene::is_motion)
      .def_readonly("files", &Scene::files)
      .def_readonly("warnings", &Scene::warnings)
      .def_readonly("notes", &Scene::notes)
      .def_property_readonly(
          "muscles", [](const Scene& scene) { return Shared(scene.muscles); })
      .def_property_readonly(
          "bones", [](const Scene& scene) { return Shared(scene.bones); })
      .def_property_readonly(
          "poses", [](const Scene& scene) { return Shared(scene.poses); })
      .def("pose_of_model",
           &PoseOfModel,
           py::arg("coordinates"),
           py::arg("name"),
           py::arg("time"))
      .def("rest_pose",
           [](const Scene& scene) {
             return std::make_shared<ScenePose>(RestPose(scene));
           })
      .def("assemble",
           &Assemble,
           py::arg("name"),
           py::arg("muscles"),
           py::arg("bones"),
           py::arg("poses"),
           py::arg("is_motion"),
           py::arg("axes"),
           py::arg("side"));
  module->def(
      "read_scene",
      [](const std::string& path,
         const std::string& data_root,
         const std::string& motion) {
        return ComputeFree([=] {
          return std::make_shared<Scene>(ReadScene(path, data_root, motion));
        });
      },
      py::arg("path"),
      py::arg("data_root"),
      py::arg("motion"));
  module->def(
      "pose_between",
      [](const SharedScene& scene,
         const SharedPose& from,
         const SharedPose& to,
         double part) {
        if (!(part >= 0 && part <= 1)) {
          throw InputError(
              "part", "is " + std::to_string(part), "allowed: 0 to 1");
        }
        return std::make_shared<ScenePose>(
            PoseBetween(*scene, *from, *to, part));
      },
      py::arg("scene"),
      py::arg("first"),
      py::arg("last"),
      py::arg("part"));
}

}  // namespace musclewarp::python
