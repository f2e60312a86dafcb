// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "python/src/scene.h"

#include <pybind11/stl.h>

#include <algorithm>

#include "musclewarp/base/input_error.h"
#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/phantom/demo_scene.h"
#include "musclewarp/scene/scene_names.h"
#include "musclewarp/scene/scene_space.h"
#include "python/src/arrays.h"
#include "python/src/bindings.h"
#include "python/src/call.h"
#include "python/src/pickling.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;

// What help() says.
constexpr char kPoseDoc[] =
    R"(Where the bodies and lines of a scene are. It does not change.

Args:
    name: for reports.
    time: s.
    bodies: the rigid motion (4, 4) of each body from rest, by its name, mm. A
        body that is not named stays.
    lines: the points (p, 3), mm, of each line by its name. A line that is not
        named moves with its bodies.
    coordinates: values to show and record; nothing moves by them.
Attributes:
    path_lengths: of lines that are paths of a model, mm.
Raises:
    InputError: names the pose, the body and what is wrong with its motion.)";

constexpr char kSceneSourceDoc[] =
    R"(A scene as the library has it. Scene is the one for users.)";

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

// Returns true if the poses of `scene` are those of `source`.
bool HasPosesOf(const Scene& source, const Scene& scene) {
  return std::equal(source.poses.begin(),
                    source.poses.end(),
                    scene.poses.begin(),
                    scene.poses.end(),
                    [](const ScenePose& a, const ScenePose& b) {
                      return a.name == b.name &&
                             a.model_values == b.model_values;
                    });
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
  if (is_motion || !HasPosesOf(*source, *scene)) {
    scene->design.clear();
    scene->reached_from.clear();
  }
  scene->states_axes = source->states_axes || axes != source->axes;
  scene->axes = axes;
  scene->side = side;
  BringIntoOneSpace(scene.get());
  return scene;
}

std::map<std::string, py::array> Views(
    const std::map<std::string, Points>& lines, const SharedPose& owner) {
  std::map<std::string, py::array> views;
  for (const auto& [name, points] : lines) {
    views.emplace(name, ViewOf(points, owner));
  }
  return views;
}

void BindPoses(py::module_* module) {
  py::class_<ScenePose, SharedPose>(*module, "Pose", kPoseDoc)
      .def(Pickled<ScenePose>())
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

void BindSceneFunctions(py::module_* module) {
  module->def(
      "read_scene",
      [](const std::string& path,
         const std::string& data_root,
         const std::string& motion,
         const std::vector<std::string>& geometry,
         const std::optional<bool>& motion_in_degrees) {
        const ModelSources sources = {motion, geometry, motion_in_degrees};
        return ComputeFree([=] {
          return std::make_shared<Scene>(ReadScene(path, data_root, sources));
        });
      },
      py::arg("path"),
      py::arg("data_root"),
      py::arg("motion"),
      py::arg("geometry"),
      py::arg("motion_in_degrees"));
  module->def(
      "write_demo_scene",
      [](const std::string& dir) {
        RunFree([dir] { WriteDemoScene(dir); });
        return DemoScenePath(dir);
      },
      py::arg("dir"));
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

}  // namespace

void BindScene(py::module_* module) {
  BindPoses(module);
  py::class_<Scene, SharedScene>(*module, "SceneSource", kSceneSourceDoc)
      .def(Pickled<Scene>())
      .def(py::init<>())
      .def_readonly("name", &Scene::name)
      .def_readonly("path", &Scene::path)
      .def_readonly("axes", &Scene::axes)
      .def_readonly("side", &Scene::side)
      .def_readonly("is_motion", &Scene::is_motion)
      .def_readonly("design", &Scene::design)
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
  BindSceneFunctions(module);
}

}  // namespace musclewarp::python
