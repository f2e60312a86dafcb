// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/element_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <pugixml.hpp>
#include <sstream>

#include "exchange/small_model.h"
#ifdef MUSCLEWARP_WITH_VTK
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#endif

namespace musclewarp {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Numbers = std::vector<double>;

// The numbers of a line, whatever separates them.
Numbers NumbersIn(std::string line) {
  std::replace(line.begin(), line.end(), ',', ' ');
  std::istringstream in(line);
  Numbers numbers;
  for (double x = 0; in >> x;) numbers.push_back(x);
  return numbers;
}

std::vector<Numbers> RowsAfter(const std::string& text,
                               const std::string& keyword,
                               const std::string& end) {
  const size_t at = text.find(keyword + "\n");
  if (at == std::string::npos) {
    ADD_FAILURE() << "no " << keyword;
    return {};
  }
  std::istringstream in(text.substr(at + keyword.size() + 1));
  std::vector<Numbers> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind(end, 0) == 0) break;
    rows.push_back(NumbersIn(line));
  }
  return rows;
}

Eigen::RowVector3d PointIn(const Numbers& row, size_t first) {
  return {row[first], row[first + 1], row[first + 2]};
}

// A mesh read from a file by numbers of its nodes.
struct ReadMesh {
  std::map<int, Eigen::RowVector3d> nodes;
  std::vector<std::array<int, 4>> elements;

  double Volume() const {
    double volume = 0;
    for (const auto& e : elements) {
      const Eigen::RowVector3d a = nodes.at(e[0]);
      const Eigen::RowVector3d u = nodes.at(e[1]) - a;
      const Eigen::RowVector3d v = nodes.at(e[2]) - a;
      const double part = u.cross(v).dot(nodes.at(e[3]) - a) / 6;
      EXPECT_GT(part, 0);
      volume += part;
    }
    return volume;
  }
};

class ElementFiles : public ::testing::Test {
 protected:
  size_t NumNodes() const {
    return model_.mesh.points.rows() + model_.bones[0].surface.points.rows();
  }
  double ExpectedVolume() const { return Volumes(model_.mesh).sum(); }
  void ExpectSameMesh(const ReadMesh& read) const {
    ASSERT_EQ(read.elements.size(),
              static_cast<size_t>(model_.mesh.tetrahedra.rows()));
    EXPECT_EQ(read.nodes.size(), NumNodes());
    EXPECT_EQ(read.nodes.at(44), model_.mesh.points.row(43));
    // Every bit is there; the sums are made in another order.
    EXPECT_NEAR(read.Volume() / ExpectedVolume(), 1, 1e-13);
  }

  ElementModel model_ = MakeSmallModel().Model();
};

TEST_F(ElementFiles, AbaqusHasAllPartsByName) {
  const std::string text = AbaqusText(model_);
  ReadMesh read;
  for (const Numbers& row : RowsAfter(text, "*NODE", "*")) {
    read.nodes[static_cast<int>(row[0])] = PointIn(row, 1);
  }
  // The sets of nodes, which follow each other.
  const auto set = [&](const std::string& name) {
    const auto rows =
        RowsAfter(text, "*NSET, NSET=" + name + ", GENERATE", "*");
    EXPECT_EQ(rows.size(), 1u);
    return rows.empty() ? Numbers{0, 0, 0} : rows[0];
  };
  const auto last_muscle = static_cast<double>(model_.mesh.points.rows());
  const double last_bone = last_muscle + model_.bones[0].surface.points.rows();
  EXPECT_EQ(set("MUSCLE_NODES"), Numbers({1, last_muscle, 1}));
  EXPECT_EQ(set("femur_NODES"), Numbers({last_muscle + 1, last_bone, 1}));
  EXPECT_EQ(set("body_thigh"), Numbers({last_bone + 1, last_bone + 1, 1}));
  EXPECT_EQ(read.nodes.count(static_cast<int>(last_bone) + 1), 1u);
  const auto inner = set("femur_INNER_NODES");
  EXPECT_EQ(inner[0], last_bone + 2);
  EXPECT_EQ(inner[1] - last_bone - 1,
            static_cast<double>(model_.bones[0].surface.triangles.rows()));
  read.nodes.erase(read.nodes.upper_bound(static_cast<int>(last_bone)),
                   read.nodes.end());
  for (const std::string muscle : {"psoas", "iliacus"}) {
    for (const Numbers& row :
         RowsAfter(text, "*ELEMENT, TYPE=C3D4, ELSET=" + muscle, "*")) {
      ASSERT_EQ(row.size(), 5u);
      read.elements.push_back({static_cast<int>(row[1]),
                               static_cast<int>(row[2]),
                               static_cast<int>(row[3]),
                               static_cast<int>(row[4])});
    }
  }
  ExpectSameMesh(read);
  const auto attached = RowsAfter(text, "*NSET, NSET=psoas_on_pelvis", "*");
  ASSERT_EQ(attached.size(), 1u);
  ASSERT_EQ(attached[0].size(), 3u);
  EXPECT_EQ(attached[0][0], model_.muscles[0].attachments[0].vertices[0] + 1);
  EXPECT_THAT(text, HasSubstr("\npsoas_to_iliacus, iliacus_to_psoas\n"));
  const auto near =
      RowsAfter(text, "*SURFACE, NAME=psoas_to_iliacus, TYPE=ELEMENT", "*");
  EXPECT_GT(near.size(), 0u);
  EXPECT_LT(near.size(), model_.muscles[0].faces.size());
  EXPECT_THAT(text, HasSubstr("at least 1.25 mm apart"));
  EXPECT_THAT(text, HasSubstr("*NSET, NSET=body_thigh_RIGID\n"));
  EXPECT_THAT(text, HasSubstr("ORIENTATION=psoas_AXES"));
  EXPECT_THAT(text, Not(HasSubstr("iliacus_AXES")));  // it has no fibres
  EXPECT_EQ(
      RowsAfter(text, "*SURFACE, NAME=psoas_SURFACE, TYPE=ELEMENT", "*").size(),
      model_.muscles[0].faces.size());
}

TEST_F(ElementFiles, AbaqusBonesOfABodyAreOneSet) {
  model_.bones.push_back(model_.bones[0]);
  model_.bones[1].name = "other";
  model_.bones[1].body = "shank";
  model_.bones.push_back(model_.bones[0]);
  model_.bones[2].name = "patella";
  const std::string text = AbaqusText(model_);
  Numbers elements, expected;
  for (const Numbers& row :
       RowsAfter(text, "*ELSET, ELSET=body_thigh_BONES", "*")) {
    elements.insert(elements.end(), row.begin(), row.end());
  }
  for (const std::string bone : {"femur", "patella"}) {
    for (const Numbers& row :
         RowsAfter(text, "*ELEMENT, TYPE=C3D4, ELSET=" + bone, "*")) {
      expected.push_back(row[0]);
    }
  }
  EXPECT_EQ(elements, expected);
}

// The first face of the element of each triangle of a bone is the triangle, and
// the element lies inside.
TEST_F(ElementFiles, AbaqusBonesAreLayersBelowTheirSurfaces) {
  const std::string text = AbaqusText(model_);
  std::map<int, Eigen::RowVector3d> nodes;
  for (const Numbers& row : RowsAfter(text, "*NODE", "*")) {
    nodes[static_cast<int>(row[0])] = PointIn(row, 1);
  }
  const TriangleSoup& bone = model_.bones[0].surface;
  const auto elements =
      RowsAfter(text, "*ELEMENT, TYPE=C3D4, ELSET=femur", "*");
  ASSERT_EQ(elements.size(), static_cast<size_t>(bone.triangles.rows()));
  std::set<int> rigid;
  for (const Numbers& row :
       RowsAfter(text, "*NSET, NSET=body_thigh_RIGID", "*")) {
    rigid.insert(row.begin(), row.end());
  }
  for (Eigen::Index f = 0; f < bone.triangles.rows(); ++f) {
    std::array<Eigen::RowVector3d, 4> c;
    for (int k = 0; k < 4; ++k) {
      const int node = static_cast<int>(elements[f][k + 1]);
      c[k] = nodes.at(node);
      EXPECT_EQ(rigid.count(node), 1u);
    }
    EXPECT_EQ(c[0], bone.points.row(bone.triangles(f, 0)));
    EXPECT_EQ(c[1], bone.points.row(bone.triangles(f, 2)));
    EXPECT_EQ(c[2], bone.points.row(bone.triangles(f, 1)));
    EXPECT_GT((c[1] - c[0]).cross(c[2] - c[0]).dot(c[3] - c[0]), 0);
  }
}

TEST_F(ElementFiles, AbaqusLinesHaveAtMostSixteenNumbers) {
  model_.muscles[0].attachments[0].vertices.clear();
  for (int v = 0; v < 33; ++v) {
    model_.muscles[0].attachments[0].vertices.push_back(v);
  }
  const auto rows =
      RowsAfter(AbaqusText(model_), "*NSET, NSET=psoas_on_pelvis", "*");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].size(), 16u);
  EXPECT_EQ(rows[2], Numbers{33});
}

TEST_F(ElementFiles, AbaqusLinesFitCalculix) {
  model_.fibres.setConstant(-1 / std::sqrt(3));
  model_.mesh.points.array() *= -1e5 / 3;
  std::istringstream in(AbaqusText(model_));
  for (std::string line; std::getline(in, line);) {
    EXPECT_LE(line.size(), 132u);  // its limit
  }
}

TEST_F(ElementFiles, FebioIsAWholeModel) {
  pugi::xml_document document;
  const std::string text = FebioText(model_);
  ASSERT_TRUE(document.load_string(text.c_str()));
  const pugi::xml_node spec = document.child("febio_spec");
  EXPECT_STREQ(spec.attribute("version").value(), "4.0");
  const pugi::xml_node mesh = spec.child("Mesh");
  ReadMesh read;
  for (const pugi::xml_node part : mesh.children("Nodes")) {
    for (const pugi::xml_node node : part.children("node")) {
      read.nodes[node.attribute("id").as_int()] =
          PointIn(NumbersIn(node.text().as_string()), 0);
    }
  }
  for (const pugi::xml_node part : mesh.children("Elements")) {
    for (const pugi::xml_node element : part.children("elem")) {
      const Numbers n = NumbersIn(element.text().as_string());
      if (n.size() != 4) continue;
      read.elements.push_back({static_cast<int>(n[0]),
                               static_cast<int>(n[1]),
                               static_cast<int>(n[2]),
                               static_cast<int>(n[3])});
    }
  }
  ExpectSameMesh(read);
}

TEST_F(ElementFiles, FebioNamesWhatIsThere) {
  pugi::xml_document document;
  const std::string text = FebioText(model_);
  ASSERT_TRUE(document.load_string(text.c_str()));
  const pugi::xml_node spec = document.child("febio_spec");
  const pugi::xml_node mesh = spec.child("Mesh");
  const auto has = [&](const char* tag, const char* name) {
    return !mesh.find_child_by_attribute(tag, "name", name).empty();
  };
  for (const pugi::xml_node domain : spec.child("MeshDomains").children()) {
    EXPECT_TRUE(has("Elements", domain.attribute("name").value()));
    EXPECT_FALSE(spec.child("Material")
                     .find_child_by_attribute(
                         "material", "name", domain.attribute("mat").value())
                     .empty());
  }
  for (const pugi::xml_node pair : mesh.children("SurfacePair")) {
    EXPECT_TRUE(has("Surface", pair.child("primary").text().as_string()));
    EXPECT_TRUE(has("Surface", pair.child("secondary").text().as_string()));
  }
  for (const pugi::xml_node contact :
       spec.child("Contact").children("contact")) {
    EXPECT_TRUE(has("SurfacePair", contact.attribute("surface_pair").value()));
  }
  const pugi::xml_node fibres = spec.child("MeshData").child("ElementData");
  EXPECT_STREQ(fibres.attribute("elem_set").value(), "psoas");
  const pugi::xml_node first = fibres.child("elem");
  const Eigen::RowVector3d a =
      PointIn(NumbersIn(first.child("a").text().get()), 0);
  const Eigen::RowVector3d d =
      PointIn(NumbersIn(first.child("d").text().get()), 0);
  EXPECT_EQ(a, model_.fibres.row(0));
  EXPECT_NEAR(a.dot(d), 0, 1e-15);
  EXPECT_NEAR(d.norm(), 1, 1e-15);
  EXPECT_TRUE(has("NodeSet", "psoas_on_pelvis"));
  // The pelvis has no bone here, so that nothing is fixed to it.
  EXPECT_TRUE(spec.child("Boundary").child("bc").empty());
  model_.muscles[0].attachments[0].body = "thigh";
  EXPECT_THAT(FebioText(model_), HasSubstr("<rb>body_thigh</rb>"));
}

TEST_F(ElementFiles, GmshHasEntitiesAndGroups) {
  const std::string text = GmshText(model_);
  EXPECT_EQ(text.find("$MeshFormat\n4.1 0 8\n"), 0u);
  for (const char* name :
       {"psoas", "psoas_surface", "psoas_on_pelvis", "iliacus", "femur"}) {
    EXPECT_THAT(text, HasSubstr(" \"" + std::string(name) + "\"\n"));
  }
  ReadMesh read;
  const auto nodes = RowsAfter(text, "$Nodes", "$EndNodes");
  for (size_t at = 1; at < nodes.size();) {
    const auto count = static_cast<size_t>(nodes[at++][3]);
    for (size_t i = 0; i < count; ++i) {
      read.nodes[static_cast<int>(nodes[at + i][0])] =
          PointIn(nodes[at + count + i], 0);
    }
    at += 2 * count;
  }
  const auto elements = RowsAfter(text, "$Elements", "$EndElements");
  std::map<int, int> triangles;  // by entity
  size_t at = 1;
  while (at < elements.size()) {
    const Numbers& block = elements[at++];
    for (int i = 0; i < static_cast<int>(block[3]); ++i, ++at) {
      const Numbers& n = elements[at];
      if (block[2] == 2) {
        ++triangles[static_cast<int>(block[1])];
        continue;
      }
      ASSERT_EQ(n.size(), 5u);
      EXPECT_EQ(n[0], static_cast<double>(read.elements.size() + 1));
      read.elements.push_back({static_cast<int>(n[1]),
                               static_cast<int>(n[2]),
                               static_cast<int>(n[3]),
                               static_cast<int>(n[4])});
    }
  }
  ExpectSameMesh(read);
  // The first surface lacks the one triangle that is attached.
  EXPECT_EQ(triangles[2], 1);
  EXPECT_EQ(triangles[1], model_.muscles[0].surface.rows() - 1);
  const auto fibres = RowsAfter(text, "$ElementData", "$EndElementData");
  // In the order of the elements, of which those of surfaces come first.
  const auto count = static_cast<size_t>(elements[0][1]);
  ASSERT_EQ(fibres.size(), count + 8);
  const auto first = static_cast<Eigen::Index>(count) - model_.fibres.rows();
  for (Eigen::Index i = 0; i < first; ++i) {
    EXPECT_TRUE(PointIn(fibres[8 + i], 1).isZero());
  }
  EXPECT_EQ(fibres[8 + first][0], 1);
  EXPECT_EQ(PointIn(fibres[8 + first], 1), model_.fibres.row(0));
}

#ifdef MUSCLEWARP_WITH_VTK
TEST_F(ElementFiles, VtuHasDataOfCellsAndPoints) {
  model_.frame = 7;
  model_.time = 0.07;
  const std::string bytes = VtuBytes(model_);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(bytes);
  reader->Update();
  vtkUnstructuredGrid* const grid = reader->GetOutput();
  ReadMesh read;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i) {
    const double* const p = grid->GetPoint(i);
    read.nodes[static_cast<int>(i) + 1] = {p[0], p[1], p[2]};
  }
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i) {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    grid->GetCellPoints(i, count, corners);
    if (count != 4) continue;
    std::array<int, 4> element;
    for (int k = 0; k < 4; ++k) element[k] = static_cast<int>(corners[k]) + 1;
    read.elements.push_back(element);
  }
  ExpectSameMesh(read);
  vtkDataArray* const muscle = grid->GetCellData()->GetArray("muscle");
  EXPECT_EQ(muscle->GetTuple1(0), 1);
  EXPECT_EQ(muscle->GetTuple1(model_.muscles[1].first_element), 2);
  const vtkIdType last = grid->GetNumberOfCells() - 1;
  EXPECT_EQ(muscle->GetTuple1(last), 0);
  EXPECT_EQ(grid->GetCellData()->GetArray("bone")->GetTuple1(last), 1);
  EXPECT_EQ(grid->GetCellData()->GetArray("fibre")->GetComponent(0, 2),
            model_.fibres(0, 2));
  vtkDataArray* const attachment = grid->GetPointData()->GetArray("attachment");
  int attached = 0;
  for (vtkIdType i = 0; i < attachment->GetNumberOfTuples(); ++i) {
    attached += attachment->GetTuple1(i) == 1;
  }
  EXPECT_EQ(attached, 3);
  vtkFieldData* const fields = grid->GetFieldData();
  const std::map<std::string, int> numbers = {{"muscle_psoas", 1},
                                              {"muscle_iliacus", 2},
                                              {"bone_femur", 1},
                                              {"body_pelvis", 1},
                                              {"frame", 7}};
  for (const auto& [name, number] : numbers) {
    ASSERT_NE(fields->GetArray(name.c_str()), nullptr) << name;
    EXPECT_EQ(fields->GetArray(name.c_str())->GetTuple1(0), number) << name;
  }
  EXPECT_EQ(fields->GetArray("TimeValue")->GetTuple1(0), 0.07);
}
#endif

}  // namespace
}  // namespace musclewarp
