// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
//
// Looks with CGAL for crossings in a folder of a frame. Nothing of musclewarp
// is in it, reading included: it confirms a certificate, or contradicts it.
//
// usage: frame_check DIR MUSCLE...
//   DIR      a folder of closed surfaces, DIR/NAME.ply
//   MUSCLE   the names of muscles; all others are bones
//
// Prints a line for every muscle that crosses itself, a muscle or a bone, or is
// inside or around one.
// Exit code: 0 there is none, 1 there is, 2 the folder cannot be read.
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Tree = CGAL::AABB_tree<
    CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;

struct Part {
  std::string name;
  bool is_muscle = false;
  Mesh mesh;
  std::unique_ptr<Tree> tree = {};
};

void ReadMesh(const fs::path& path, Part* part) {
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  if (!CGAL::IO::read_PLY(path.string(), points, faces) || faces.empty()) {
    throw std::runtime_error(path.string() + ": is not read");
  }
  namespace pmp = CGAL::Polygon_mesh_processing;
  // A bone may have edges of more than two triangles, which are opened.
  if (!pmp::is_polygon_soup_a_polygon_mesh(faces)) {
    pmp::orient_polygon_soup(points, faces);
  }
  pmp::polygon_soup_to_polygon_mesh(points, faces, part->mesh);
}

std::vector<Part> ReadParts(const fs::path& dir,
                            const std::set<std::string>& muscles) {
  std::vector<Part> parts;
  for (const auto& entry : fs::directory_iterator(dir)) {
    if (entry.path().extension() != ".ply") continue;
    Part part;
    part.name = entry.path().stem().string();
    part.is_muscle = muscles.count(part.name) > 0;
    ReadMesh(entry.path(), &part);
    parts.push_back(std::move(part));
  }
  const auto is_muscle = [](const Part& part) { return part.is_muscle; };
  if (static_cast<std::size_t>(std::count_if(
          parts.begin(), parts.end(), is_muscle)) != muscles.size()) {
    throw std::runtime_error(dir.string() + ": has not every muscle");
  }
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    return a.name < b.name;
  });
  for (Part& part : parts) {  // which do not move any more
    part.tree = std::make_unique<Tree>(
        part.mesh.faces_begin(), part.mesh.faces_end(), part.mesh);
  }
  return parts;
}

int TrianglesThatMeet(const Part& a, const Part& b) {
  int count = 0;
  for (const Mesh::Face_index face : a.mesh.faces()) {
    const auto edge = a.mesh.halfedge(face);
    const Kernel::Triangle_3 triangle(
        a.mesh.point(a.mesh.source(edge)),
        a.mesh.point(a.mesh.target(edge)),
        a.mesh.point(a.mesh.target(a.mesh.next(edge))));
    count += b.tree->do_intersect(triangle);
  }
  return count;
}

int VerticesInside(const Part& a, const Part& b) {
  if (!CGAL::is_closed(b.mesh)) return 0;
  const CGAL::Side_of_triangle_mesh<Mesh, Kernel> side(b.mesh);
  int count = 0;
  for (const Mesh::Vertex_index vertex : a.mesh.vertices()) {
    count += side(a.mesh.point(vertex)) == CGAL::ON_BOUNDED_SIDE;
  }
  return count;
}

// Prints what two parts have in common; returns whether it is nothing.
bool AreApart(const Part& a, const Part& b) {
  if (!CGAL::do_overlap(a.tree->bbox(), b.tree->bbox())) return true;
  const int triangles = TrianglesThatMeet(a, b);
  const int inside = VerticesInside(a, b), around = VerticesInside(b, a);
  if (triangles + inside + around == 0) return true;
  std::cout << a.name << " and " << b.name << ": " << triangles
            << " triangles cross, " << inside + around << " vertices inside\n";
  return false;
}

bool CheckFrame(const std::vector<Part>& parts) {
  bool is_clean = true;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].is_muscle &&
        CGAL::Polygon_mesh_processing::does_self_intersect(parts[i].mesh)) {
      std::cout << parts[i].name << ": crosses itself\n";
      is_clean = false;
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (!parts[i].is_muscle && !parts[j].is_muscle) continue;
      if (!AreApart(parts[i], parts[j])) is_clean = false;
    }
  }
  return is_clean;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: frame_check DIR MUSCLE...\n";
    return 2;
  }
  try {
    return CheckFrame(ReadParts(argv[1], {argv + 2, argv + argc})) ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
