// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <vector>

#include "musclewarp/exchange/abaqus_number.h"
#include "musclewarp/exchange/element_files.h"
#include "musclewarp/exchange/element_names.h"

namespace musclewarp {
namespace {

// Lines of keywords and data, numbers counted from one.
class AbaqusWriter {
 public:
  explicit AbaqusWriter(const ElementModel& model) : model_(model) {
    first_bone_node_ = static_cast<int>(model.mesh.points.rows());
    first_bone_element_ = static_cast<int>(model.mesh.tetrahedra.rows());
  }

  std::string Text() {
    text_ =
        "*HEADING\n" + model_.title +
        "\n** musclewarp-export. Units: mm, N, MPa, tonne, s.\n"
        "** The materials are placeholders: put in your own, and add a step.\n";
    WriteNodes();
    WriteMuscles();
    WriteBones();
    WriteBodies();
    WriteMaterials();
    WriteContacts();
    return std::move(text_);
  }

 private:
  const std::string& Name(const std::string& text) { return names_.Of(text); }

  void AppendPoint(const Eigen::RowVector3d& point) {
    for (const double x : point) {
      text_ += ", " + AbaqusNumber(x);
    }
  }

  // Lines of CalculiX have at most 132 characters, too few for six numbers with
  // all digits.
  void AppendRounded(double x) {
    constexpr int kDigits = 9;
    text_ += ", " + AbaqusNumber(x, kDigits);
  }

  void AppendPoints(const Points& points, int first) {
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      text_ += std::to_string(first + i + 1);
      AppendPoint(points.row(i));
      text_ += '\n';
    }
  }

  // Sets have up to 16 numbers a line.
  void AppendSet(const std::vector<int>& numbers) {
    for (size_t i = 0; i < numbers.size(); ++i) {
      text_ += std::to_string(numbers[i] + 1);
      text_ += i + 1 == numbers.size() || i % 16 == 15 ? "\n" : ", ";
    }
  }

  // A set of nodes that follow each other.
  static std::string NodeRange(const std::string& name,
                               int first,
                               Eigen::Index count) {
    return "*NSET, NSET=" + name + ", GENERATE\n" + std::to_string(first + 1) +
           ", " + std::to_string(first + count) + ", 1\n";
  }

  // A bone is a layer of solid elements, one for each triangle, which CalculiX
  // takes for contact where it takes neither rigid nor shell elements. Returns
  // their inner corners, this far below the triangles, mm.
  static Points InnerCorners(const TriangleSoup& surface) {
    constexpr double kDepth = 0.1;
    Points corners(surface.triangles.rows(), 3);
    for (Eigen::Index f = 0; f < corners.rows(); ++f) {
      const Eigen::RowVector3d a = surface.points.row(surface.triangles(f, 0));
      const Eigen::RowVector3d b = surface.points.row(surface.triangles(f, 1));
      const Eigen::RowVector3d c = surface.points.row(surface.triangles(f, 2));
      corners.row(f) =
          (a + b + c) / 3 - kDepth * (b - a).cross(c - a).normalized();
    }
    return corners;
  }

  // All nodes are in one block: meshio keeps only the last one of several.
  void WriteNodes() {
    text_ += "*NODE\n";
    AppendPoints(model_.mesh.points, 0);
    std::string sets = NodeRange("MUSCLE_NODES", 0, model_.mesh.points.rows());
    int first = first_bone_node_;
    for (const RigidSurface& bone : model_.bones) {
      AppendPoints(bone.surface.points, first);
      const Eigen::Index count = bone.surface.points.rows();
      sets += NodeRange(Name(bone.name) + "_NODES", first, count);
      first += static_cast<int>(count);
    }
    // The reference node of a body is in the middle of its first bone.
    for (const RigidSurface& bone : model_.bones) {
      if (!bodies_.emplace(bone.body, first).second) continue;
      text_ += std::to_string(first + 1);
      AppendPoint(bone.surface.points.colwise().mean());
      text_ += '\n';
      sets += NodeRange(Name("body " + bone.body), first, 1);
      ++first;
    }
    for (const RigidSurface& bone : model_.bones) {
      AppendPoints(InnerCorners(bone.surface), first);
      const Eigen::Index count = bone.surface.triangles.rows();
      sets += NodeRange(Name(bone.name) + "_INNER_NODES", first, count);
      first_inner_.push_back(first);
      first += static_cast<int>(count);
    }
    text_ += sets;
  }

  void WriteMuscles() {
    for (const MuscleElements& muscle : model_.muscles) {
      const std::string& name = Name(muscle.name);
      text_ += "*ELEMENT, TYPE=C3D4, ELSET=" + name + "\n";
      const int end = muscle.first_element + muscle.num_elements;
      for (int t = muscle.first_element; t < end; ++t) {
        text_ += std::to_string(t + 1);
        for (const int v : model_.mesh.tetrahedra.row(t)) {
          text_ += ", " + std::to_string(v + 1);
        }
        text_ += '\n';
      }
      text_ += "*SURFACE, NAME=" + name + "_SURFACE, TYPE=ELEMENT\n";
      for (const ElementFace& face : muscle.faces) {
        text_ += std::to_string(face.tetrahedron + 1) + ", S" +
                 std::to_string(face.face + 1) + '\n';
      }
      for (const AttachedArea& area : muscle.attachments) {
        text_ += "*NSET, NSET=" + Name(muscle.name + " on " + area.body) + "\n";
        AppendSet(area.vertices);
      }
    }
  }

  void WriteBones() {
    int node = first_bone_node_;
    int element = first_bone_element_;
    for (size_t i = 0; i < model_.bones.size(); ++i) {
      const RigidSurface& bone = model_.bones[i];
      const std::string& name = Name(bone.name);
      text_ += "*ELEMENT, TYPE=C3D4, ELSET=" + name + "\n";
      first_elements_[bone.name] = element;
      for (Eigen::Index f = 0; f < bone.surface.triangles.rows(); ++f) {
        elements_of_[bone.body].push_back(element);
        text_ += std::to_string(++element);
        // Counterclockwise seen from inside; the first face is the triangle.
        for (const int k : {0, 2, 1}) {
          text_ +=
              ", " + std::to_string(node + bone.surface.triangles(f, k) + 1);
        }
        text_ += ", " + std::to_string(first_inner_[i] + f + 1) + '\n';
        std::vector<int>& nodes = nodes_of_[bone.body];
        nodes.push_back(first_inner_[i] + static_cast<int>(f));
      }
      for (Eigen::Index v = 0; v < bone.surface.points.rows(); ++v) {
        nodes_of_[bone.body].push_back(node + static_cast<int>(v));
      }
      node += static_cast<int>(bone.surface.points.rows());
      text_ += "*SURFACE, NAME=" + name + "_SURFACE, TYPE=ELEMENT\n" + name +
               ", S1\n";
    }
  }

  // The nodes that a body moves: those of its bones and of what is attached to
  // it.
  void WriteBodies() {
    for (const MuscleElements& muscle : model_.muscles) {
      for (const AttachedArea& area : muscle.attachments) {
        if (nodes_of_.count(area.body) == 0) continue;
        std::vector<int>& nodes = nodes_of_[area.body];
        nodes.insert(nodes.end(), area.vertices.begin(), area.vertices.end());
      }
    }
    for (auto& [body, nodes] : nodes_of_) {
      const std::string& set = Name("body " + body);
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      // By numbers: meshio confuses the elements of sets of sets.
      text_ += "*ELSET, ELSET=" + set + "_BONES\n";
      AppendSet(elements_of_[body]);
      text_ += "*NSET, NSET=" + set + "_RIGID\n";
      AppendSet(nodes);
      text_ += "** Fixed: *BOUNDARY with " + set +
               "_RIGID, 1, 3. Moved: *RIGID BODY, NSET=" + set +
               "_RIGID, REF NODE=" + std::to_string(bodies_.at(body) + 1) +
               "\n";
    }
  }

  // An orientation has its first axis along the fibre.
  void WriteOrientation(const MuscleElements& muscle, const std::string& name) {
    text_ += "*DISTRIBUTION, NAME=" + name +
             "_FIBRES, LOCATION=ELEMENT, TABLE=AXES\n"
             ", 1., 0., 0., 0., 1., 0.\n";
    const int end = muscle.first_element + muscle.num_elements;
    for (int t = muscle.first_element; t < end; ++t) {
      const Eigen::RowVector3d fibre = model_.fibres.row(t);
      const Eigen::RowVector3d across = fibre.unitOrthogonal();
      text_ += std::to_string(t + 1);
      for (const Eigen::RowVector3d& axis : {fibre, across}) {
        for (const double x : axis) AppendRounded(x);
      }
      text_ += '\n';
    }
    text_ += "*ORIENTATION, NAME=" + name + "_AXES, SYSTEM=RECTANGULAR\n" +
             name + "_FIBRES\n";
  }

  void WriteMaterials() {
    text_ += "*DISTRIBUTION TABLE, NAME=AXES\nCOORD3D, COORD3D\n";
    for (const MuscleElements& muscle : model_.muscles) {
      const std::string& name = Name(muscle.name);
      const bool has_fibres = !model_.fibres.row(muscle.first_element).isZero();
      if (has_fibres) WriteOrientation(muscle, name);
      text_ += "*MATERIAL, NAME=" + name +
               "_MATERIAL\n*ELASTIC\n0.5, 0.45\n*DENSITY\n1.06E-9\n"
               "*SOLID SECTION, ELSET=" +
               name + ", MATERIAL=" + name + "_MATERIAL" +
               (has_fibres ? ", ORIENTATION=" + name + "_AXES" : "") + "\n";
    }
    if (model_.bones.empty()) return;
    text_ +=
        "*MATERIAL, NAME=BONE_MATERIAL\n*ELASTIC\n1000., 0.3\n"
        "*DENSITY\n1.E-12\n";
    for (const RigidSurface& bone : model_.bones) {
      text_ += "*SOLID SECTION, ELSET=" + Name(bone.name) +
               ", MATERIAL=BONE_MATERIAL\n";
    }
  }

  // Writes the part of a mesh that may touch another one.
  void WriteContactSurface(const std::string& name,
                           const std::string& mesh,
                           const std::vector<int>& triangles) {
    text_ += "*SURFACE, NAME=" + name + ", TYPE=ELEMENT\n";
    const auto bone = first_elements_.find(mesh);
    for (const int f : triangles) {
      if (bone != first_elements_.end()) {
        text_ += std::to_string(bone->second + f + 1) + ", S1\n";
        continue;
      }
      const ElementFace& face = faces_of_.at(mesh)->at(f);
      text_ += std::to_string(face.tetrahedron + 1) + ", S" +
               std::to_string(face.face + 1) + '\n';
    }
  }

  // MPa/mm. CalculiX takes gaps below 1 / stiffness for closed at the start.
  double ContactStiffness() const {
    constexpr double kLeast = 100;
    double stiffness = kLeast;
    for (const ContactPair& pair : model_.contacts) {
      if (pair.gap_mm > 0) stiffness = std::max(stiffness, 2 / pair.gap_mm);
    }
    return stiffness;
  }

  void WriteContacts() {
    if (model_.contacts.empty()) return;
    for (const MuscleElements& muscle : model_.muscles) {
      faces_of_[muscle.name] = &muscle.faces;
    }
    text_ +=
        "*SURFACE INTERACTION, NAME=CONTACT\n"
        "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n" +
        AbaqusNumber(ContactStiffness()) + "\n";
    for (const ContactPair& pair : model_.contacts) {
      const std::string a = Name(pair.a + " to " + pair.b);
      const std::string b = Name(pair.b + " to " + pair.a);
      WriteContactSurface(a, pair.a, pair.triangles_a);
      WriteContactSurface(b, pair.b, pair.triangles_b);
      text_ += "** " + pair.a + " and " + pair.b + " are at least " +
               AbaqusNumber(pair.gap_mm) +
               " mm apart\n*CONTACT PAIR, INTERACTION=CONTACT, "
               "TYPE=SURFACE TO SURFACE\n" +
               a + ", " + b + "\n";
    }
  }

  const ElementModel& model_;
  ElementNames names_;
  int first_bone_node_, first_bone_element_;
  std::map<std::string, int> bodies_;          // to their reference nodes
  std::vector<int> first_inner_;               // inner corner of each bone
  std::map<std::string, int> first_elements_;  // of bones
  std::map<std::string, std::vector<int>> elements_of_, nodes_of_;  // of bodies
  std::map<std::string, const std::vector<ElementFace>*> faces_of_;
  std::string text_;
};

}  // namespace

std::string AbaqusText(const ElementModel& model) {
  return AbaqusWriter(model).Text();
}

}  // namespace musclewarp
