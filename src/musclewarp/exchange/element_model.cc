// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/element_model.h"

#include <glog/logging.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "musclewarp/exchange/near_triangles.h"
#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/skeleton/nearest_segment.h"

namespace musclewarp {
namespace {

// Returns the muscle of each tetrahedron. Those of one muscle hang together
// through their corners, and those of two do not, as muscles do not touch.
// `first_points`: where the points of each muscle begin, and where the last
// ones end.
std::vector<int> MuscleOfElements(const TetrahedralMesh& mesh,
                                  const std::vector<int>& first_points) {
  DisjointSets sets(static_cast<int>(mesh.points.rows()));
  for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t) {
    for (int k = 1; k < 4; ++k) {
      sets.Join(mesh.tetrahedra(t, 0), mesh.tetrahedra(t, k));
    }
  }
  std::vector<int> muscles;
  for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t) {
    // The lowest point of a set is on a surface: these come first.
    const int root = sets.Find(mesh.tetrahedra(t, 0));
    const auto next =
        std::upper_bound(first_points.begin(), first_points.end(), root);
    CHECK(next != first_points.end()) << "elements without a surface";
    muscles.push_back(static_cast<int>(next - first_points.begin()) - 1);
  }
  return muscles;
}

// Puts the elements of each muscle together; returns where those of each
// begin, and the end of the last.
std::vector<int> SortElements(const std::vector<int>& muscle_of,
                              size_t muscles,
                              Tetrahedra* tetrahedra) {
  std::vector<int> order(muscle_of.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return muscle_of[a] < muscle_of[b];
  });
  *tetrahedra = Tetrahedra((*tetrahedra)(order, Eigen::all));
  std::vector<int> first(muscles + 1, 0);
  for (const int m : muscle_of) ++first[m + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  return first;
}

// Returns the fibres of a muscle, or else its action lines. Pieces without
// length have no direction and are left out.
std::vector<ActionLine> DirectionLines(const MuscleLines& muscle) {
  std::vector<Points> lines = muscle.fibres;
  if (lines.empty()) {
    for (const NamedLine& line : muscle.lines) lines.push_back(line.points);
  }
  std::vector<ActionLine> result;
  for (const Points& points : lines) {
    std::vector<int> kept;
    for (int i = 0; i < points.rows(); ++i) {
      if (kept.empty() || points.row(i) != points.row(kept.back())) {
        kept.push_back(i);
      }
    }
    if (kept.size() < 2) continue;
    ActionLine line;
    line.rest = points(kept, Eigen::all);
    result.push_back(std::move(line));
  }
  return result;
}

void FindFibres(const MuscleElements& muscle,
                const MuscleLines& muscle_lines,
                const TetrahedralMesh& mesh,
                Points* fibres) {
  const std::vector<ActionLine> lines = DirectionLines(muscle_lines);
  if (lines.empty()) return;
  const int end = muscle.first_element + muscle.num_elements;
#pragma omp parallel for schedule(static)
  for (int t = muscle.first_element; t < end; ++t) {
    Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
    for (const int v : mesh.tetrahedra.row(t)) {
      middle += mesh.points.row(v) / 4;
    }
    const SegmentPoint nearest = NearestSegment(middle, lines);
    const Points& points = lines[nearest.line].rest;
    fibres->row(t) =
        (points.row(nearest.segment + 1) - points.row(nearest.segment))
            .normalized();
  }
}

template <typename Map>
typename Map::mapped_type Lookup(const Map& map,
                                 const std::string& name,
                                 typename Map::mapped_type otherwise) {
  const auto found = map.find(name);
  return found == map.end() ? otherwise : found->second;
}

std::vector<int> NumbersOf(const std::vector<bool>& is_there) {
  std::vector<int> numbers;
  for (size_t i = 0; i < is_there.size(); ++i) {
    if (is_there[i]) numbers.push_back(static_cast<int>(i));
  }
  return numbers;
}

std::vector<ContactPair> ContactsOf(const RecordedNames& names,
                                    const RecordedPose& pose,
                                    const std::vector<MeshGap>& gaps,
                                    double reach) {
  std::map<std::string, const TriangleSoup*> soups;
  for (size_t i = 0; i < names.muscles.size(); ++i) {
    soups[names.muscles[i]] = &pose.muscles[i];
  }
  for (size_t i = 0; i < names.bones.size(); ++i) {
    soups[names.bones[i]] = &pose.bones[i];
  }
  std::map<std::string, TriangleBvh> trees;
  for (const auto& [name, soup] : soups) {
    trees.emplace(std::piecewise_construct,
                  std::forward_as_tuple(name),
                  std::forward_as_tuple(soup->points, soup->triangles));
  }
  std::vector<ContactPair> contacts;
  for (const MeshGap& gap : gaps) {
    const auto near = [&](const std::string& of, const std::string& to) {
      return NumbersOf(TrianglesWithin(reach, *soups.at(of), {&trees.at(to)}));
    };
    contacts.push_back({gap.a,
                        gap.b,
                        gap.at_least_mm,
                        near(gap.a, gap.b),
                        near(gap.b, gap.a)});
  }
  return contacts;
}

}  // namespace

TriangleSoup JoinedSurface(const std::vector<TriangleSoup>& muscles) {
  TriangleSoup joined;
  for (const TriangleSoup& soup : muscles) {
    const Eigen::Index points = joined.points.rows();
    joined.points.conservativeResize(points + soup.points.rows(), 3);
    joined.points.bottomRows(soup.points.rows()) = soup.points;
    joined.triangles.conservativeResize(
        joined.triangles.rows() + soup.triangles.rows(), 3);
    joined.triangles.bottomRows(soup.triangles.rows()) =
        soup.triangles.array() + static_cast<int>(points);
  }
  return joined;
}

ElementModel ElementModelOf(const std::string& title,
                            const RecordedNames& names,
                            const RecordedPose& pose,
                            const RecordedAttachments& attachments,
                            const std::vector<MeshGap>& gaps,
                            double contact_reach,
                            TetrahedralMesh mesh) {
  ElementModel model;
  model.title = title;
  model.mesh = std::move(mesh);
  std::vector<int> first_points = {0};
  for (const TriangleSoup& soup : pose.muscles) {
    first_points.push_back(first_points.back() +
                           static_cast<int>(soup.points.rows()));
  }
  const std::vector<int> first_elements =
      SortElements(MuscleOfElements(model.mesh, first_points),
                   names.muscles.size(),
                   &model.mesh.tetrahedra);
  const std::vector<ElementFace> faces =
      BorderFaces(model.mesh.tetrahedra, JoinedSurface(pose.muscles).triangles);
  CHECK(!faces.empty()) << "the mesh has another surface";
  model.fibres = Points::Zero(model.mesh.tetrahedra.rows(), 3);
  auto face = faces.begin();
  for (size_t i = 0; i < names.muscles.size(); ++i) {
    MuscleElements muscle;
    muscle.name = names.muscles[i];
    muscle.first_element = first_elements[i];
    muscle.num_elements = first_elements[i + 1] - first_elements[i];
    muscle.surface = pose.muscles[i].triangles.array() + first_points[i];
    muscle.faces.assign(face, face + muscle.surface.rows());
    face += muscle.surface.rows();
    muscle.attachments = Lookup(attachments.muscles, muscle.name, {});
    for (AttachedArea& area : muscle.attachments) {
      for (int& v : area.vertices) v += first_points[i];
    }
    FindFibres(muscle, pose.lines[i], model.mesh, &model.fibres);
    model.muscles.push_back(std::move(muscle));
  }
  for (size_t i = 0; i < names.bones.size(); ++i) {
    const std::string& name = names.bones[i];
    model.bones.push_back(
        {name, Lookup(attachments.bones, name, name), pose.bones[i]});
  }
  model.contacts = ContactsOf(names, pose, gaps, contact_reach);
  return model;
}

}  // namespace musclewarp
