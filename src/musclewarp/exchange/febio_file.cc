// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <map>

#include "musclewarp/exchange/element_files.h"
#include "musclewarp/exchange/element_names.h"
#include "musclewarp/mesh_files/text_cursor.h"
#include "musclewarp/run/frame_files.h"

namespace musclewarp {
namespace {

// Writes the sections of febio_spec 4.0 in the order in which FEBio needs them.
class FebioWriter {
 public:
  explicit FebioWriter(const ElementModel& model) : model_(model) {}

  std::string Text() {
    text_ =
        "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n"
        "<febio_spec version=\"4.0\">\n"
        "<!-- musclewarp-export, " +
        FrameFolder(model_.frame) +
        ". Units: mm, N, MPa, tonne, s. The materials are placeholders: put in "
        "your own, and add a step. -->\n"
        "<Module type=\"solid\"/>\n";
    WriteMaterials();
    WriteMesh();
    WriteDomains();
    WriteFibres();
    WriteBoundary();
    WriteContacts();
    text_ += "</febio_spec>\n";
    return std::move(text_);
  }

 private:
  const std::string& Name(const std::string& text) { return names_.Of(text); }

  void AppendPoint(const Eigen::RowVector3d& point) {
    for (int k = 0; k < 3; ++k) {
      if (k > 0) text_ += ',';
      AppendReal(point[k], &text_);
    }
  }

  template <typename Numbers>
  void AppendNumbers(const Numbers& numbers, int first) {
    bool is_first = true;
    for (const int v : numbers) {
      if (!is_first) text_ += ',';
      is_first = false;
      text_ += std::to_string(first + v + 1);
    }
  }

  std::string BodyMaterial(const std::string& body) {
    return Name("body " + body);
  }

  void WriteMaterials() {
    text_ += "<Material>\n";
    int id = 0;
    const auto open = [&](const std::string& name, const std::string& type) {
      text_ += "<material id=\"" + std::to_string(++id) + "\" name=\"" + name +
               "\" type=\"" + type + "\">";
    };
    for (const MuscleElements& muscle : model_.muscles) {
      open(Name(muscle.name + " material"), "trans iso Mooney-Rivlin");
      text_ +=
          "<density>1.06e-9</density><c1>0.01</c1><c2>0</c2><c3>0.01</c3>"
          "<c4>10</c4><c5>1</c5><k>1</k><lam_max>1.4</lam_max></material>\n";
    }
    for (const RigidSurface& bone : model_.bones) {
      if (!bodies_.emplace(bone.body, id + 1).second) continue;
      open(BodyMaterial(bone.body), "rigid body");
      text_ += "<density>1.9e-9</density></material>\n";
    }
    text_ += "</Material>\n";
  }

  void AppendNodes(const std::string& name, const Points& points, int first) {
    text_ += "<Nodes name=\"" + name + "\">\n";
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      text_ += "<node id=\"" + std::to_string(first + i + 1) + "\">";
      AppendPoint(points.row(i));
      text_ += "</node>\n";
    }
    text_ += "</Nodes>\n";
  }

  // Adds rows of node numbers, each as <tag id="">; returns the last id.
  template <typename Rows>
  int AppendRows(const Rows& rows,
                 const std::string& tag,
                 int first_node,
                 int last_id) {
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      text_ += "<" + tag + " id=\"" + std::to_string(++last_id) + "\">";
      AppendNumbers(rows.row(i), first_node);
      text_ += "</" + tag + ">\n";
    }
    return last_id;
  }

  void AppendSurface(const std::string& name,
                     const Triangles& triangles,
                     int first_node) {
    text_ += "<Surface name=\"" + name + "_surface\">\n";
    AppendRows(triangles, "tri3", first_node, 0);
    text_ += "</Surface>\n";
  }

  void WriteMesh() {
    text_ += "<Mesh>\n";
    const int muscle_nodes = static_cast<int>(model_.mesh.points.rows());
    AppendNodes("muscle_nodes", model_.mesh.points, 0);
    int node = muscle_nodes;
    for (const RigidSurface& bone : model_.bones) {
      AppendNodes(Name(bone.name) + "_nodes", bone.surface.points, node);
      node += static_cast<int>(bone.surface.points.rows());
    }
    for (const MuscleElements& muscle : model_.muscles) {
      text_ += "<Elements type=\"tet4\" name=\"" + Name(muscle.name) + "\">\n";
      AppendRows(model_.mesh.tetrahedra.middleRows(muscle.first_element,
                                                   muscle.num_elements),
                 "elem",
                 0,
                 muscle.first_element);
      text_ += "</Elements>\n";
    }
    int element = static_cast<int>(model_.mesh.tetrahedra.rows());
    node = muscle_nodes;
    for (const RigidSurface& bone : model_.bones) {
      text_ += "<Elements type=\"tri3\" name=\"" + Name(bone.name) + "\">\n";
      element = AppendRows(bone.surface.triangles, "elem", node, element);
      text_ += "</Elements>\n";
      node += static_cast<int>(bone.surface.points.rows());
    }
    WriteSets(muscle_nodes);
    text_ += "</Mesh>\n";
  }

  void WriteSets(int node) {
    for (const MuscleElements& muscle : model_.muscles) {
      for (const AttachedArea& area : muscle.attachments) {
        text_ +=
            "<NodeSet name=\"" + Name(muscle.name + " on " + area.body) + "\">";
        AppendNumbers(area.vertices, 0);
        text_ += "</NodeSet>\n";
      }
    }
    for (const MuscleElements& muscle : model_.muscles) {
      AppendSurface(Name(muscle.name), muscle.surface, 0);
    }
    for (const RigidSurface& bone : model_.bones) {
      AppendSurface(Name(bone.name), bone.surface.triangles, node);
      node += static_cast<int>(bone.surface.points.rows());
    }
    for (const ContactPair& pair : model_.contacts) {
      text_ += "<SurfacePair name=\"" + PairName(pair) + "\"><primary>" +
               Name(pair.a) + "_surface</primary><secondary>" + Name(pair.b) +
               "_surface</secondary></SurfacePair>\n";
    }
  }

  std::string PairName(const ContactPair& pair) {
    return Name(pair.a + " to " + pair.b);
  }

  void WriteDomains() {
    text_ += "<MeshDomains>\n";
    for (const MuscleElements& muscle : model_.muscles) {
      text_ += "<SolidDomain name=\"" + Name(muscle.name) + "\" mat=\"" +
               Name(muscle.name + " material") + "\"/>\n";
    }
    for (const RigidSurface& bone : model_.bones) {
      text_ += "<ShellDomain name=\"" + Name(bone.name) + "\" mat=\"" +
               BodyMaterial(bone.body) +
               "\"><shell_thickness>0.01</shell_thickness></ShellDomain>\n";
    }
    text_ += "</MeshDomains>\n";
  }

  // a is the direction of the fibre, d any other one in a plane with it.
  void WriteFibres() {
    text_ += "<MeshData>\n";
    for (const MuscleElements& muscle : model_.muscles) {
      if (model_.fibres.row(muscle.first_element).isZero()) continue;
      text_ += "<ElementData type=\"mat_axis\" name=\"" +
               Name(muscle.name + " fibres") + "\" elem_set=\"" +
               Name(muscle.name) + "\">\n";
      for (int i = 0; i < muscle.num_elements; ++i) {
        const Eigen::RowVector3d fibre =
            model_.fibres.row(muscle.first_element + i);
        text_ += "<elem lid=\"" + std::to_string(i + 1) + "\"><a>";
        AppendPoint(fibre);
        text_ += "</a><d>";
        AppendPoint(fibre.unitOrthogonal());
        text_ += "</d></elem>\n";
      }
      text_ += "</ElementData>\n";
    }
    text_ += "</MeshData>\n";
  }

  // Attachments to bodies that have no bone have nothing to be fixed to.
  void WriteBoundary() {
    text_ += "<Boundary>\n";
    for (const MuscleElements& muscle : model_.muscles) {
      for (const AttachedArea& area : muscle.attachments) {
        if (bodies_.count(area.body) == 0) continue;
        const std::string& name = Name(muscle.name + " on " + area.body);
        text_ += "<bc name=\"" + name + "\" type=\"rigid\" node_set=\"" + name +
                 "\"><rb>" + BodyMaterial(area.body) + "</rb></bc>\n";
      }
    }
    text_ += "</Boundary>\n";
  }

  void WriteContacts() {
    text_ += "<Contact>\n";
    for (const ContactPair& pair : model_.contacts) {
      text_ += "<!-- at least ";
      AppendReal(pair.gap_mm, &text_);
      text_ += " mm apart -->\n<contact name=\"" + PairName(pair) +
               "\" type=\"sliding-elastic\" surface_pair=\"" + PairName(pair) +
               "\"><auto_penalty>1</auto_penalty><penalty>1</penalty>"
               "</contact>\n";
    }
    text_ += "</Contact>\n";
  }

  const ElementModel& model_;
  ElementNames names_;
  std::map<std::string, int> bodies_;  // those of bones, to their materials
  std::string text_;
};

}  // namespace

std::string FebioText(const ElementModel& model) {
  return FebioWriter(model).Text();
}

}  // namespace musclewarp
