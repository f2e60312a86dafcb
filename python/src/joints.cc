// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>

#include "musclewarp/anatomy/bone_names.h"
#include "musclewarp/base/angles.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/base/setting_names.h"
#include "musclewarp/joints/articulated_model.h"
#include "musclewarp/joints/articulated_scene.h"
#include "musclewarp/joints/articulation.h"
#include "musclewarp/joints/joints_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/scene/scene_names.h"
#include "musclewarp/settings/articulation_settings.h"
#include "python/src/arrays.h"
#include "python/src/bindings.h"
#include "python/src/call.h"
#include "python/src/json.h"
#include "python/src/labels.h"
#include "python/src/meshes.h"
#include "python/src/scene.h"
#include "python/src/settings.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;

using MeshesByName = std::vector<std::pair<std::string, py::object>>;
using SharedJoint = std::shared_ptr<FoundJoint>;

// From where to where coordinates move, degrees.
using Sweeps = std::vector<std::tuple<std::string, double, double>>;

// What help() says.
constexpr char kJointDoc[] =
    R"(A joint that was found on bones. It does not change.

Attributes:
    name: kind and side, such as "hip_r".
    kind: "hip", "knee", "patella", "ankle", "subtalar", "shoulder", "elbow" or
        "forearm".
    side: "right" or "left".
    parent, child: the bodies that it connects.
    center: (3,), mm, in the frame of the bones.
    axes: (3, 3), the frame of the joint on the parent in the pose of the scan.
        Columns are forward, up and to the right, of unit length.
    child_axes: the same on the child. Coordinates are 0 where both are
        parallel.
    quality: "good", "weak" (to be looked at) or "failed" (the child stays fixed
        to the parent).
    reasons: what the quality rests on, sentences.
    given: True if it was given, not found.
    coordinates: for each by name a dict with "scan", the value in the pose of
        the scan, and "range", the usual range as (lowest, highest); rad.
A joint that failed has None for center, axes and child_axes, and no
coordinates.)";

constexpr char kArticulationSourceDoc[] =
    R"(An articulation as the library has it. Articulation is the one for users.)";

// An articulation and what belongs to its report.
struct ArticulationSource {
  Articulation articulation;
  std::string axes;  // empty if they are not known

  // Of muscles of labels: the bodies or bones on which they end.
  std::map<std::string, std::pair<std::string, std::string>> ends;
};
using SharedArticulation = std::shared_ptr<ArticulationSource>;

bool IsPath(const py::handle& object) {
  return py::isinstance<py::str>(object) || py::hasattr(object, "__fspath__");
}

// Returns the mesh of a path, a pair of points and triangles, or what MeshFrom
// takes.
SharedMesh BoneMeshFrom(const py::object& object, const std::string& where) {
  if (IsPath(object)) {
    const std::string file = object.cast<std::filesystem::path>().string();
    return ComputeFree([file]() -> SharedMesh {
      return std::make_shared<TriangleSoup>(ReadTriangleSoup(file));
    });
  }
  if (py::isinstance<py::tuple>(object) && py::len(object) == 2) {
    const py::tuple arrays(object);
    return MeshOfArrays(arrays[0], arrays[1], where);
  }
  return MeshFrom(object, where);
}

std::vector<Bone> BonesFrom(const MeshesByName& meshes,
                            double mm_per_unit,
                            std::vector<std::string>* notes) {
  if (meshes.empty()) {
    throw InputError("bones", "are none", "give meshes by the names of bones");
  }
  std::vector<Bone> bones;
  for (const auto& [name, object] : meshes) {
    CheckFileName("bones", "bone", name);
    const SharedMesh mesh = BoneMeshFrom(object, "bone " + QuotedName(name));
    bones.push_back(BoneOfName(name, *mesh));
    bones.back().mesh.points *= mm_per_unit;
    if (!ParseBoneName(name).is_known) {
      notes->push_back(NoteOnUnknownBone(name));
    }
  }
  return bones;
}

// `given_text` is what a file of joints may have, in place of the setting
// `given`, or empty.
SharedArticulation FindJoints(const MeshesByName& meshes,
                              const SharedSubject& subject,
                              const py::dict& keywords,
                              const std::string& units,
                              const std::string& given_text) {
  ArticulationOptions options =
      OptionsOf(SettingsFrom<ArticulationSettings>(keywords));
  if (!given_text.empty()) {
    options.given = ReadJoints(JsonField::Parse(given_text, "given"));
  }
  const auto source = std::make_shared<ArticulationSource>();
  std::vector<std::string> notes;
  std::vector<Bone> bones;
  if (subject) {
    // A label image says itself where its axes point.
    options.axes = subject->IsOriented() ? "LPS" : "";
    notes = subject->notes;
    bones = BonesOf(*subject);
    for (const SubjectMesh& muscle : subject->muscles) {
      source->ends[muscle.name] = {muscle.origin, muscle.insertion};
    }
  } else {
    bones = BonesFrom(meshes, MillimetresFrom(units, "units"), &notes);
  }
  source->axes = options.axes;
  return ComputeFree([source, bones = std::move(bones), notes, options] {
    source->articulation = Articulate(bones, options);
    std::vector<std::string>& all = source->articulation.notes;
    all.insert(all.begin(), notes.begin(), notes.end());
    return source;
  });
}

JointMotion MotionOf(const Sweeps& sweeps,
                     int frames,
                     const Articulation& articulation) {
  if (frames < 1 || frames > kMostMotionFrames) {
    throw InputError("frames",
                     "is " + std::to_string(frames),
                     "allowed: 1 to " + std::to_string(kMostMotionFrames));
  }
  JointMotion motion;
  for (const auto& [coordinate, from, to] : sweeps) {
    if (!std::isfinite(from) || !std::isfinite(to)) {
      throw InputError("motion",
                       "takes " + QuotedName(coordinate) + " from " +
                           std::to_string(from) + " to " + std::to_string(to),
                       "allowed: finite numbers, degrees");
    }
    motion.sweeps.push_back({coordinate, from, to});
  }
  CheckCoordinates(motion, articulation, "motion");
  if (sweeps.empty()) {
    motion = FirstMotion(articulation);
    if (motion.sweeps.empty()) {
      throw InputError("motion",
                       "has nothing to move: no joint was found",
                       "the reasons of the joints say why");
    }
  }
  motion.frames = frames;
  return motion;
}

void CheckMuscleNames(const std::vector<SharedMuscle>& muscles,
                      const std::vector<Bone>& bones) {
  if (muscles.empty()) {
    throw InputError("muscles", "are none", "give at least one");
  }
  std::set<std::string> names;
  for (const Bone& bone : bones) names.insert(bone.name);
  for (const SharedMuscle& muscle : muscles) {
    CheckFileName("muscles", "muscle", muscle->name);
    if (names.insert(muscle->name).second) continue;
    throw InputError("muscle " + QuotedName(muscle->name),
                     "has the name of a bone or of another muscle",
                     "rename one");
  }
}

std::vector<SceneBone> BonesOfScene(const Articulation& articulation) {
  std::vector<SceneBone> bones;
  for (const Bone& bone : articulation.bones) {
    bones.push_back(
        {bone.name, bone.mesh.points, bone.mesh.triangles, bone.body});
  }
  return bones;
}

// Forgets the files that a scene was read from.
void KeepInMemory(Scene* scene) {
  scene->path.clear();
  scene->motion_path.clear();
  scene->files.clear();
  const auto model = std::make_shared<ModelPoses>(*scene->model);
  model->model.path.clear();
  scene->model = model;
}

// Returns the scene that musclewarp-articulate would write, by way of `folder`.
SharedScene ArticulatedScene(const SharedArticulation& source,
                             const std::vector<SharedMuscle>& muscles,
                             const Sweeps& sweeps,
                             int frames,
                             const std::string& name,
                             const std::string& folder) {
  CheckMuscleNames(muscles, source->articulation.bones);
  const JointMotion motion = MotionOf(sweeps, frames, source->articulation);
  return ComputeFree([=] {
    namespace fs = std::filesystem;
    ArticulatedSceneParts parts;
    parts.name = name;
    parts.axes = source->axes;
    for (const Bone& bone : source->articulation.bones) {
      parts.bones.push_back({bone.name, "Geometry/" + bone.name + ".obj"});
    }
    // Their meshes are not read.
    for (const SharedMuscle& muscle : muscles) {
      parts.muscles.push_back({muscle->name, muscle->name + ".ply"});
      const auto ends = source->ends.find(muscle->name);
      if (ends == source->ends.end() || !muscle->end_bodies.empty()) continue;
      parts.muscles.back().origin = ends->second.first;
      parts.muscles.back().insertion = ends->second.second;
    }
    WriteArticulatedModel(
        source->articulation, name, (fs::path(folder) / parts.model).string());
    const std::string file = (fs::path(folder) / "scene.json").string();
    WriteTextAtomically(
        file, ArticulatedSceneJson(source->articulation, parts, motion).dump());
    const auto scene = std::make_shared<Scene>(ReadScene(file, ""));
    for (size_t i = 0; i < muscles.size(); ++i) {
      const std::vector<std::string> end_bodies = scene->muscles[i].end_bodies;
      scene->muscles[i] = *muscles[i];
      if (!end_bodies.empty()) scene->muscles[i].end_bodies = end_bodies;
    }
    scene->bones = BonesOfScene(source->articulation);
    KeepInMemory(scene.get());
    return scene;
  });
}

py::dict CoordinatesFrom(const FoundJoint& joint) {
  py::dict coordinates;
  if (!joint.IsFound()) return coordinates;
  const std::vector<double> scan = ScanCoordinates(joint);
  const auto entries = CoordinatesOf(joint.kind, joint.side);
  for (size_t i = 0; i < entries.size(); ++i) {
    py::dict coordinate;
    coordinate["scan"] = scan[i];
    coordinate["range"] =
        py::make_tuple(entries[i].lowest * kRadiansPerDegree,
                       entries[i].highest * kRadiansPerDegree);
    coordinates[py::str(entries[i].name)] = coordinate;
  }
  return coordinates;
}

// A getter of a part that only joints have that were found.
template <typename Part>
auto PartOfFound(Part FoundJoint::*part) {
  return [part](const SharedJoint& joint) -> py::object {
    if (!joint->IsFound()) return py::none();
    return ViewOf((*joint).*part, joint);
  };
}

void BindJointClass(py::module_* module) {
  py::class_<FoundJoint, SharedJoint>(*module, "Joint", kJointDoc)
      .def_property_readonly("name", &FoundJoint::name)
      .def_property_readonly(
          "kind", [](const FoundJoint& joint) { return ToString(joint.kind); })
      .def_property_readonly(
          "side", [](const FoundJoint& joint) { return ToString(joint.side); })
      .def_readonly("parent", &FoundJoint::parent)
      .def_readonly("child", &FoundJoint::child)
      .def_property_readonly("center", PartOfFound(&FoundJoint::center))
      .def_property_readonly("axes", PartOfFound(&FoundJoint::parent_axes))
      .def_property_readonly("child_axes", PartOfFound(&FoundJoint::child_axes))
      .def_property_readonly("quality",
                             [](const FoundJoint& joint) {
                               return ToString(joint.verdict.quality);
                             })
      .def_property_readonly("reasons",
                             [](const FoundJoint& joint) {
                               return WithFieldNames(joint.verdict.reasons);
                             })
      .def_readonly("given", &FoundJoint::is_given)
      .def_property_readonly("coordinates", &CoordinatesFrom)
      .def("__repr__", [](const FoundJoint& joint) {
        return "<musclewarp.Joint " + QuotedName(joint.name()) + ": " +
               ToString(joint.verdict.quality) + ">";
      });
}

}  // namespace

void BindJoints(py::module_* module) {
  BindJointClass(module);
  py::class_<ArticulationSource, SharedArticulation>(
      *module, "ArticulationSource", kArticulationSourceDoc)
      .def_property_readonly("joints",
                             [](const ArticulationSource& source) {
                               return Shared(source.articulation.joints);
                             })
      .def_property_readonly("notes",
                             [](const ArticulationSource& source) {
                               return WithFieldNames(source.articulation.notes);
                             })
      .def("report",
           [](const ArticulationSource& source) {
             return FromJson(JointsJson(source.articulation, source.axes));
           })
      .def(
          "write_model",
          [](const SharedArticulation& source,
             const std::string& path,
             const std::string& name) {
            RunFree([=] {
              WriteArticulatedModel(source->articulation, name, path);
            });
          },
          py::arg("path"),
          py::arg("name"))
      .def("scene",
           &ArticulatedScene,
           py::arg("muscles"),
           py::arg("sweeps"),
           py::arg("frames"),
           py::arg("name"),
           py::arg("folder"));
  module->def("articulate",
              &FindJoints,
              py::arg("bones"),
              py::arg("subject"),
              py::arg("settings"),
              py::arg("units"),
              py::arg("given_text"));
}

}  // namespace musclewarp::python
