// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <vector>

#include "musclewarp/exchange/element_files.h"
#include "musclewarp/exchange/element_names.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

constexpr int kTriangleType = 2;
constexpr int kTetrahedronType = 4;

// A part of the mesh with a name, or several.
struct GmshEntity {
  int dimension = 0;
  std::vector<int> groups;  // the numbers of its names
  std::vector<int> border;  // of volumes: their surfaces
  std::vector<int> nodes;   // that are in this entity and in none of its border
  Eigen::MatrixXi elements;  // by nodes
};

struct GmshGroup {
  int dimension;
  std::string name;
};

// Elements of volumes have the numbers of the other formats; those of surfaces
// follow.
struct GmshNumbers {
  int64_t last_in_volumes = 0;
  int64_t last_in_surfaces = 0;

  int64_t Next(const GmshEntity& entity) {
    return entity.dimension == 3 ? ++last_in_volumes : ++last_in_surfaces;
  }
};

class GmshWriter {
 public:
  explicit GmshWriter(const ElementModel& model) : model_(model) {
    const std::vector<int> muscle_of = MuscleOfNodes();
    for (size_t i = 0; i < model.muscles.size(); ++i) {
      AddMuscle(static_cast<int>(i), muscle_of);
    }
    num_nodes_ = static_cast<int>(model.mesh.points.rows());
    for (const RigidSurface& bone : model.bones) AddBone(bone);
  }

  std::string Text() {
    text_ = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\n" + model_.title +
            "\n$EndComments\n$PhysicalNames\n" +
            std::to_string(groups_.size()) + "\n";
    for (size_t i = 0; i < groups_.size(); ++i) {
      text_ += std::to_string(groups_[i].dimension) + ' ' +
               std::to_string(i + 1) + " \"" + groups_[i].name + "\"\n";
    }
    text_ += "$EndPhysicalNames\n";
    WriteEntities();
    WriteNodes();
    WriteElements();
    WriteFibres();
    return std::move(text_);
  }

 private:
  // Returns the muscle of each node.
  std::vector<int> MuscleOfNodes() const {
    std::vector<int> muscle_of(model_.mesh.points.rows(), -1);
    for (size_t i = 0; i < model_.muscles.size(); ++i) {
      const MuscleElements& muscle = model_.muscles[i];
      const int end = muscle.first_element + muscle.num_elements;
      for (int t = muscle.first_element; t < end; ++t) {
        for (const int v : model_.mesh.tetrahedra.row(t)) {
          muscle_of[v] = static_cast<int>(i);
        }
      }
    }
    return muscle_of;
  }

  int AddGroup(int dimension, const std::string& text) {
    groups_.push_back({dimension, names_.Of(text)});
    return static_cast<int>(groups_.size());
  }

  int AddEntity(GmshEntity entity) {
    entities_.push_back(std::move(entity));
    return static_cast<int>(entities_.size());
  }

  // The number of the attachment that has all corners of each triangle, or -1.
  static std::vector<int> AttachmentOfTriangles(const MuscleElements& muscle) {
    std::vector<int> attachment(muscle.surface.rows(), -1);
    for (size_t a = 0; a < muscle.attachments.size(); ++a) {
      const std::vector<int>& area = muscle.attachments[a].vertices;
      for (Eigen::Index f = 0; f < muscle.surface.rows(); ++f) {
        bool is_in = true;
        for (const int v : muscle.surface.row(f)) {
          is_in = is_in && std::binary_search(area.begin(), area.end(), v);
        }
        if (is_in) attachment[f] = static_cast<int>(a);
      }
    }
    return attachment;
  }

  void AddMuscle(int number, const std::vector<int>& muscle_of) {
    const MuscleElements& muscle = model_.muscles[number];
    GmshEntity volume;
    volume.dimension = 3;
    volume.groups = {AddGroup(3, muscle.name)};
    volume.elements = model_.mesh.tetrahedra.middleRows(muscle.first_element,
                                                        muscle.num_elements);
    const int surface_group = AddGroup(2, muscle.name + " surface");
    const std::vector<int> attachment_of = AttachmentOfTriangles(muscle);
    const int attachments = static_cast<int>(muscle.attachments.size());
    std::vector<char> is_on_surface(model_.mesh.points.rows(), 0);
    for (const int v : muscle.surface.reshaped()) is_on_surface[v] = 1;
    for (int a = -1; a < attachments; ++a) {
      GmshEntity patch;
      patch.dimension = 2;
      patch.groups = {surface_group};
      std::vector<int> rows;
      for (Eigen::Index f = 0; f < muscle.surface.rows(); ++f) {
        if (attachment_of[f] == a) rows.push_back(static_cast<int>(f));
      }
      if (a >= 0) {
        if (rows.empty()) continue;
        patch.groups.push_back(
            AddGroup(2, muscle.name + " on " + muscle.attachments[a].body));
      } else {
        patch.nodes = NodesOf(number, muscle_of, is_on_surface, 1);
      }
      patch.elements = muscle.surface(rows, Eigen::all);
      volume.border.push_back(AddEntity(std::move(patch)));
    }
    volume.nodes = NodesOf(number, muscle_of, is_on_surface, 0);
    AddEntity(std::move(volume));
  }

  static std::vector<int> NodesOf(int muscle,
                                  const std::vector<int>& muscle_of,
                                  const std::vector<char>& is_on_surface,
                                  char on_surface) {
    std::vector<int> nodes;
    for (size_t v = 0; v < muscle_of.size(); ++v) {
      if (muscle_of[v] == muscle && is_on_surface[v] == on_surface) {
        nodes.push_back(static_cast<int>(v));
      }
    }
    return nodes;
  }

  void AddBone(const RigidSurface& bone) {
    GmshEntity surface;
    surface.dimension = 2;
    surface.groups = {AddGroup(2, bone.name)};
    for (Eigen::Index v = 0; v < bone.surface.points.rows(); ++v) {
      surface.nodes.push_back(num_nodes_ + static_cast<int>(v));
    }
    surface.elements = bone.surface.triangles.array() + num_nodes_;
    num_nodes_ += static_cast<int>(bone.surface.points.rows());
    AddEntity(std::move(surface));
  }

  Eigen::RowVector3d PointOf(int node) const {
    if (node < model_.mesh.points.rows()) return model_.mesh.points.row(node);
    node -= static_cast<int>(model_.mesh.points.rows());
    for (const RigidSurface& bone : model_.bones) {
      const int count = static_cast<int>(bone.surface.points.rows());
      if (node < count) return bone.surface.points.row(node);
      node -= count;
    }
    return Eigen::RowVector3d::Zero();
  }

  void AppendPoint(const Eigen::RowVector3d& point) {
    for (int k = 0; k < 3; ++k) {
      if (k > 0) text_ += ' ';
      AppendReal(point[k], &text_);
    }
  }

  void AppendList(const std::vector<int>& numbers) {
    text_ += ' ' + std::to_string(numbers.size());
    for (const int i : numbers) text_ += ' ' + std::to_string(i);
  }

  // Surfaces come before volumes.
  template <typename Visit>
  void ForEachEntity(const Visit& visit) const {
    for (const int dimension : {2, 3}) {
      for (size_t i = 0; i < entities_.size(); ++i) {
        if (entities_[i].dimension == dimension) {
          visit(static_cast<int>(i) + 1, entities_[i]);
        }
      }
    }
  }

  void WriteEntities() {
    const auto volumes = std::count_if(
        entities_.begin(), entities_.end(), [](const GmshEntity& entity) {
          return entity.dimension == 3;
        });
    text_ += "$Entities\n0 0 " + std::to_string(entities_.size() - volumes) +
             ' ' + std::to_string(volumes) + "\n";
    ForEachEntity([&](int tag, const GmshEntity& entity) {
      Eigen::RowVector3d low = Eigen::RowVector3d::Zero(), high = low;
      bool is_first = true;
      for (const int v : entity.elements.reshaped()) {
        const Eigen::RowVector3d point = PointOf(v);
        low = is_first ? point : low.cwiseMin(point);
        high = is_first ? point : high.cwiseMax(point);
        is_first = false;
      }
      text_ += std::to_string(tag) + ' ';
      AppendPoint(low);
      text_ += ' ';
      AppendPoint(high);
      AppendList(entity.groups);
      AppendList(entity.border);
      text_ += '\n';
    });
    text_ += "$EndEntities\n";
  }

  // The line that says how many blocks and numbers follow.
  void AppendCounts(int64_t numbers) {
    text_ += std::to_string(entities_.size()) + ' ' + std::to_string(numbers) +
             " 1 " + std::to_string(numbers) + "\n";
  }

  void WriteNodes() {
    text_ += "$Nodes\n";
    AppendCounts(num_nodes_);
    ForEachEntity([&](int tag, const GmshEntity& entity) {
      text_ += std::to_string(entity.dimension) + ' ' + std::to_string(tag) +
               " 0 " + std::to_string(entity.nodes.size()) + "\n";
      for (const int v : entity.nodes) text_ += std::to_string(v + 1) + '\n';
      for (const int v : entity.nodes) {
        AppendPoint(PointOf(v));
        text_ += '\n';
      }
    });
    text_ += "$EndNodes\n";
  }

  int64_t CountElements() const {
    int64_t count = 0;
    for (const GmshEntity& entity : entities_) count += entity.elements.rows();
    return count;
  }

  void WriteElements() {
    text_ += "$Elements\n";
    AppendCounts(CountElements());
    GmshNumbers numbers{0, model_.mesh.tetrahedra.rows()};
    ForEachEntity([&](int tag, const GmshEntity& entity) {
      text_ += std::to_string(entity.dimension) + ' ' + std::to_string(tag) +
               ' ' +
               std::to_string(entity.dimension == 3 ? kTetrahedronType
                                                    : kTriangleType) +
               ' ' + std::to_string(entity.elements.rows()) + "\n";
      for (Eigen::Index i = 0; i < entity.elements.rows(); ++i) {
        text_ += std::to_string(numbers.Next(entity));
        for (const int v : entity.elements.row(i)) {
          text_ += ' ' + std::to_string(v + 1);
        }
        text_ += '\n';
      }
    });
    text_ += "$EndElements\n";
  }

  // All elements have a direction, in the order in which they were written:
  // meshio takes no data of some elements only. Those of surfaces are zero.
  void WriteFibres() {
    if (model_.fibres.isZero()) return;
    // Their name, the time, the step, and how many numbers there are. The step
    // is not the frame: Gmsh would open with the steps before it, all empty.
    text_ += "$ElementData\n1\n\"fibre\"\n1\n";
    AppendReal(model_.time, &text_);
    text_ += "\n3\n0\n3\n" + std::to_string(CountElements()) + "\n";
    GmshNumbers numbers{0, model_.mesh.tetrahedra.rows()};
    ForEachEntity([&](int, const GmshEntity& entity) {
      for (Eigen::Index i = 0; i < entity.elements.rows(); ++i) {
        const int64_t number = numbers.Next(entity);
        Eigen::RowVector3d fibre = Eigen::RowVector3d::Zero();
        if (entity.dimension == 3) fibre = model_.fibres.row(number - 1);
        text_ += std::to_string(number) + ' ';
        AppendPoint(fibre);
        text_ += '\n';
      }
    });
    text_ += "$EndElementData\n";
  }

  const ElementModel& model_;
  ElementNames names_;
  std::vector<GmshGroup> groups_;
  std::vector<GmshEntity> entities_;
  int num_nodes_ = 0;
  std::string text_;
};

}  // namespace

std::string GmshText(const ElementModel& model) {
  return GmshWriter(model).Text();
}

}  // namespace musclewarp
