// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "python/src/meshes.h"

#include <pybind11/stl/filesystem.h>

#include <filesystem>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/mesh_repair/repair.h"
#include "musclewarp/run/report_json.h"
#include "python/src/arrays.h"
#include "python/src/bindings.h"
#include "python/src/call.h"
#include "python/src/json.h"
#include "python/src/pickling.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;

// What help() says.
constexpr char kMeshDoc[] =
    R"(A triangle mesh, which does not change (src/musclewarp/mesh/triangle_soup.h).

Args:
    points: (n, 3), mm.
    triangles: (m, 3) indices of points; their corners run counterclockwise seen
        from outside.
Attributes:
    points: (n, 3) float64, mm.
    triangles: (m, 3) int32.
    volume: that the mesh encloses, mm^3; negative if it is inside out.
    area: mm^2.
Raises:
    InputError: names the array and the row.)";

constexpr char kDefectsDoc[] =
    R"(Counts what keeps the mesh from being one closed 2-manifold.

Returns:
    A dict with the keys of "defects" in docs/report.md, "closed_manifold" and
    "clean" (True if nothing needs repair).)";

constexpr char kReadMeshDoc[] =
    R"(Reads a mesh file: .ply, .obj, .off, .stl, .vtk, .vtp.

Points and triangles are those of the file; polygons are split into triangles.
"muscles.obj#gluteus" is one object of an .obj, or one solid of an ASCII .stl.
What of a file is skipped is a UserWarning.

Raises:
    InputError: names the file and the place in it.)";

constexpr char kWriteMeshDoc[] =
    R"(Writes a mesh file, by the extension of `path`; all or nothing.

All formats but .stl keep every bit.

Args:
    path: .ply, .obj, .off, .stl, .vtk or .vtp.
    mesh: a Mesh, or anything with points (n, 3) and triangles (m, 3).
Raises:
    InputError: the file cannot be written.)";

// pybind11 cannot hold pointers to constants.
std::shared_ptr<TriangleSoup> ToPython(TriangleSoup soup) {
  return std::make_shared<TriangleSoup>(std::move(soup));
}

py::tuple Repair(const py::object& object,
                 double max_hole,
                 double stitch_tolerance,
                 const std::string& name) {
  const SharedMesh mesh = MeshFrom(object, name);
  RepairOptions options;
  options.holes.max_perimeter = max_hole;
  options.stitch_tolerance = stitch_tolerance;
  std::string error;
  if (!options.IsValid(&error)) {
    throw InputError("repair", error, "correct the option");
  }
  const auto repaired = ComputeFree([=] {
    MeshPreparation done;
    TriangleSoup result = RepairMesh(*mesh, name, options, &done.repairs);
    return std::make_pair(ToPython(std::move(result)), done);
  });
  py::dict report = FromJson(RepairsJson(repaired.second));
  // Those concern what is done to a mesh for certified contact.
  for (const auto& key : py::list(report)) {
    const auto text = key.cast<std::string>();
    if (text.rfind("self_crossing", 0) == 0 || text.rfind("sliver", 0) == 0) {
      report.attr("pop")(key);
    }
  }
  return py::make_tuple(repaired.first, report);
}

void BindMeshFunctions(py::module_* module) {
  module->def(
      "read_mesh",
      [](const std::filesystem::path& path) {
        std::vector<std::string> notes;
        auto mesh = ComputeFree([&notes, file = path.string()] {
          return ToPython(ReadTriangleSoup(file, &notes));
        });
        for (const std::string& note : notes) {
          if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 1) != 0) {
            throw py::error_already_set();
          }
        }
        return mesh;
      },
      py::arg("path"),
      kReadMeshDoc);
  module->def(
      "write_mesh",
      [](const std::filesystem::path& path, const py::object& object) {
        const SharedMesh mesh = MeshFrom(object, "mesh");
        RunFree([=] { WriteTriangleSoup(path.string(), *mesh); });
      },
      py::arg("path"),
      py::arg("mesh"),
      kWriteMeshDoc);
  module->def("repair",
              &Repair,
              py::arg("mesh"),
              py::arg("max_hole"),
              py::arg("stitch_tolerance"),
              py::arg("name"));
}

}  // namespace

std::shared_ptr<TriangleSoup> MeshOfArrays(const py::object& points,
                                           const py::object& triangles,
                                           const std::string& where) {
  TriangleSoup soup;
  soup.points = PointsFrom(points, where + ": points");
  soup.triangles =
      TrianglesFrom(triangles, soup.points.rows(), where + ": triangles");
  if (soup.triangles.rows() == 0) {
    throw InputError(where + ": triangles", "are none", "give at least one");
  }
  return ToPython(std::move(soup));
}

SharedMesh MeshFrom(const py::handle& object, const std::string& where) {
  if (py::isinstance<TriangleSoup>(object)) {
    return object.cast<std::shared_ptr<TriangleSoup>>();
  }
  if (py::hasattr(object, "points") && py::hasattr(object, "triangles")) {
    return MeshOfArrays(object.attr("points"), object.attr("triangles"), where);
  }
  if (py::hasattr(object, "mesh")) return MeshFrom(object.attr("mesh"), where);
  throw InputError(
      where,
      "is no mesh, but " +
          py::str(py::type::of(object).attr("__name__")).cast<std::string>(),
      "give a musclewarp.Mesh, or anything that has points and triangles");
}

void BindMeshes(py::module_* module) {
  py::class_<TriangleSoup, std::shared_ptr<TriangleSoup>>(
      *module, "Mesh", kMeshDoc)
      .def(Pickled<TriangleSoup>())
      .def(py::init([](const py::object& points, const py::object& triangles) {
             return MeshOfArrays(points, triangles, "mesh");
           }),
           py::arg("points"),
           py::arg("triangles"))
      .def_property_readonly("points",
                             [](const std::shared_ptr<TriangleSoup>& mesh) {
                               return ViewOf(mesh->points, mesh);
                             })
      .def_property_readonly("triangles",
                             [](const std::shared_ptr<TriangleSoup>& mesh) {
                               return ViewOf(mesh->triangles, mesh);
                             })
      .def_property_readonly("volume",
                             [](const TriangleSoup& mesh) {
                               return SignedVolume(mesh.points, mesh.triangles);
                             })
      .def_property_readonly("area",
                             [](const TriangleSoup& mesh) {
                               return SurfaceArea(mesh.points, mesh.triangles);
                             })
      .def(
          "defects",
          [](const std::shared_ptr<TriangleSoup>& mesh) {
            const MeshDefects defects =
                ComputeFree([mesh] { return CountDefects(*mesh); });
            nlohmann::ordered_json json = DefectsJson(defects);
            json["closed_manifold"] = defects.is_closed_manifold;
            json["clean"] = defects.IsClean();
            return FromJson(json);
          },
          kDefectsDoc)
      .def("__repr__", [](const TriangleSoup& mesh) {
        return "<musclewarp.Mesh of " + std::to_string(mesh.points.rows()) +
               " points and " + std::to_string(mesh.triangles.rows()) +
               " triangles>";
      });
  BindMeshFunctions(module);
}

}  // namespace musclewarp::python
