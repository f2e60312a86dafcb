// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>

#include "musclewarp/base/input_error.h"
#include "musclewarp/deformer/mesh_separation.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "musclewarp/scene/scene_names.h"
#include "musclewarp/settings/separation_settings.h"
#include "python/src/arrays.h"
#include "python/src/bindings.h"
#include "python/src/deformer.h"
#include "python/src/meshes.h"
#include "python/src/settings.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;

// What help() says.
constexpr char kCrossingsClassDoc[] =
    R"(Where two meshes a and b cross, by exact tests; false if nowhere.

Attributes:
    triangle_pairs: (k, 2) int32, a triangle of a and one of b, which share a
        point; ascending.
    a_inside_b: int32, the points of a that are inside b; ascending.
    b_inside_a: the same the other way.
    a_depth, b_depth: of the deepest of these points, mm; 0 without any.)";

constexpr char kCrossingsDoc[] =
    R"(Finds where two meshes cross (src/musclewarp/proximity/mesh_intersection.h).

Args:
    a, b: Meshes, muscles of a frame, or anything with points (n, 3), mm, and
        triangles (m, 3).
Returns:
    Crossings.
Raises:
    InputError: one of them is no mesh.)";

constexpr char kSelfCrossingsDoc[] =
    R"(Returns the pairs of triangles at which a mesh crosses itself, (k, 2) int32.

They share a point beyond the corner or edge they have in common, by an exact
test. The first of a pair is the lower.)";
using MeshesByName = std::vector<std::pair<std::string, py::object>>;

// The volumes that labels had before their surfaces were made, mm^3.
using VolumesByName = std::map<std::string, double>;

// What is found once, so that arrays can show it.
struct Crossings {
  Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor> pairs;
  Eigen::VectorXi a_inside_b, b_inside_a;
  double a_depth = 0, b_depth = 0;
};
using SharedCrossings = std::shared_ptr<Crossings>;

Eigen::VectorXi VectorOf(const std::vector<int>& numbers) {
  return Eigen::Map<const Eigen::VectorXi>(
      numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

void SetPairs(const std::vector<std::pair<int, int>>& pairs,
              Crossings* crossings) {
  crossings->pairs.resize(static_cast<Eigen::Index>(pairs.size()), 2);
  for (Eigen::Index i = 0; i < crossings->pairs.rows(); ++i) {
    crossings->pairs.row(i) << pairs[i].first, pairs[i].second;
  }
}

SharedCrossings FindCrossings(const py::object& first,
                              const py::object& second) {
  const SharedMesh a = MeshFrom(first, "a"), b = MeshFrom(second, "b");
  return ComputeFree([=] {
    const MeshIntersection found = IntersectMeshes(*a, *b);
    const auto crossings = std::make_shared<Crossings>();
    SetPairs(found.triangle_pairs, crossings.get());
    crossings->a_inside_b = VectorOf(found.a_inside_b);
    crossings->b_inside_a = VectorOf(found.b_inside_a);
    crossings->a_depth = found.a_depth_mm;
    crossings->b_depth = found.b_depth_mm;
    return crossings;
  });
}

py::array FindSelfCrossings(const py::object& object) {
  const SharedMesh mesh = MeshFrom(object, "mesh");
  const SharedCrossings found = ComputeFree([=] {
    const auto crossings = std::make_shared<Crossings>();
    SetPairs(SelfIntersections(*mesh), crossings.get());
    return crossings;
  });
  return ViewOf(found->pairs, found);
}

// A scene whose muscles may move and whose bones stay.
Scene SceneOf(const MeshesByName& meshes,
              const MeshesByName& bones,
              const VolumesByName& volumes,
              const std::string& units) {
  const double mm_per_unit = MillimetresFrom(units, "units");
  Scene scene;
  scene.name = "the meshes";
  for (const auto& [name, object] : meshes) {
    const std::string where = "mesh " + QuotedName(name);
    const SharedMesh mesh = MeshFrom(object, where);
    SceneMuscle muscle = {name, mm_per_unit * mesh->points, mesh->triangles};
    muscle.mm_per_unit = mm_per_unit;
    const auto volume = volumes.find(name);
    if (volume != volumes.end()) muscle.delivered_volume = volume->second;
    scene.muscles.push_back(std::move(muscle));
  }
  for (const auto& [name, object] : bones) {
    const SharedMesh mesh = MeshFrom(object, "bone " + QuotedName(name));
    scene.bones.push_back(
        {name, mm_per_unit * mesh->points, mesh->triangles, /*body=*/name});
  }
  return scene;
}

std::shared_ptr<FrameOfScene> Separate(const MeshesByName& meshes,
                                       const MeshesByName& bones,
                                       const VolumesByName& volumes,
                                       const py::dict& keywords,
                                       const std::string& units,
                                       const py::object& progress) {
  if (meshes.empty()) {
    throw InputError("meshes", "are none", "give at least one");
  }
  const auto settings = SettingsFrom<SeparationSettings>(keywords);
  return ComputeFree([scene = SceneOf(meshes, bones, volumes, units),
                      options = OptionsOf(settings),
                      lengths_in_mm = LengthsInMillimetres(settings),
                      on_progress = CallbackOf(progress)] {
    MeshSeparation separated =
        SeparateMeshes(scene, options, on_progress, lengths_in_mm);
    return std::make_shared<FrameOfScene>(
        FrameOfScene{std::move(separated.frame), PartsOf(separated.scene)});
  });
}

}  // namespace

void BindChecks(py::module_* module) {
  py::class_<Crossings, SharedCrossings>(*module, "Crossings", kCrossingsDoc)
      .def_property_readonly(
          "triangle_pairs",
          [](const SharedCrossings& c) { return ViewOf(c->pairs, c); })
      .def_property_readonly(
          "a_inside_b",
          [](const SharedCrossings& c) { return ViewOf(c->a_inside_b, c); })
      .def_property_readonly(
          "b_inside_a",
          [](const SharedCrossings& c) { return ViewOf(c->b_inside_a, c); })
      .def_readonly("a_depth", &Crossings::a_depth)
      .def_readonly("b_depth", &Crossings::b_depth)
      .def("__bool__",
           [](const Crossings& c) {
             return c.pairs.rows() + c.a_inside_b.size() + c.b_inside_a.size() >
                    0;
           })
      .def("__repr__", [](const Crossings& c) {
        return "<musclewarp.Crossings of " + std::to_string(c.pairs.rows()) +
               " pairs of triangles>";
      });
  module->def(
      "crossings", &FindCrossings, py::arg("a"), py::arg("b"), kCrossingsDoc);
  module->def(
      "self_crossings", &FindSelfCrossings, py::arg("mesh"), kSelfCrossingsDoc);
  module->def("separate",
              &Separate,
              py::arg("meshes"),
              py::arg("bones"),
              py::arg("volumes"),
              py::arg("settings"),
              py::arg("units"),
              py::arg("progress"));
}

}  // namespace musclewarp::python
