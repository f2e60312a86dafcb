// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
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
    std::map<std::string, std::vector<int>> elements;  // of bodies
    for (const RigidSurface& bone : model_.bones) {
      const std::string& name = Name(bone.name);
      text_ += "*ELEMENT, TYPE=R3D3, ELSET=" + name + "\n";
      for (Eigen::Index f = 0; f < bone.surface.triangles.rows(); ++f) {
        elements[bone.body].push_back(element);
        text_ += std::to_string(++element);
        for (const int v : bone.surface.triangles.row(f)) {
          text_ += ", " + std::to_string(node + v + 1);
        }
        text_ += '\n';
      }
      node += static_cast<int>(bone.surface.points.rows());
      text_ += "*SURFACE, NAME=" + name + "_SURFACE, TYPE=ELEMENT\n" + name +
               ", SPOS\n";
    }
    for (const auto& [body, reference] : bodies_) {
      const std::string set = Name("body " + body) + "_BONES";
      // By numbers: meshio confuses the elements of sets of sets.
      text_ += "*ELSET, ELSET=" + set + "\n";
      AppendSet(elements[body]);
      text_ += "*RIGID BODY, ELSET=" + set +
               ", REF NODE=" + std::to_string(reference + 1) + "\n";
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
               "_MATERIAL\n*ELASTIC\n0.1, 0.45\n*DENSITY\n1.06E-9\n"
               "*SOLID SECTION, ELSET=" +
               name + ", MATERIAL=" + name + "_MATERIAL" +
               (has_fibres ? ", ORIENTATION=" + name + "_AXES" : "") + "\n";
    }
  }

  void WriteContacts() {
    if (model_.contacts.empty()) return;
    text_ +=
        "*SURFACE INTERACTION, NAME=CONTACT\n"
        "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n10.\n";
    for (const ContactPair& pair : model_.contacts) {
      text_ += "** " + pair.a + " and " + pair.b + " are at least " +
               AbaqusNumber(pair.gap_mm) +
               " mm apart\n*CONTACT PAIR, INTERACTION=CONTACT, "
               "TYPE=SURFACE TO SURFACE\n" +
               Name(pair.a) + "_SURFACE, " + Name(pair.b) + "_SURFACE\n";
    }
  }

  const ElementModel& model_;
  ElementNames names_;
  int first_bone_node_, first_bone_element_;
  std::map<std::string, int> bodies_;  // to their reference nodes
  std::string text_;
};

}  // namespace

std::string AbaqusText(const ElementModel& model) {
  return AbaqusWriter(model).Text();
}

}  // namespace musclewarp
