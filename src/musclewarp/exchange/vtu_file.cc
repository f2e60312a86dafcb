// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <glog/logging.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <vector>

#include "musclewarp/exchange/element_files.h"
#include "musclewarp/exchange/element_names.h"
#include "musclewarp/mesh_files/vtk_errors.h"

namespace musclewarp {
namespace {

void AddNumbers(const char* name,
                const std::vector<int>& numbers,
                vtkDataSetAttributes* attributes) {
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  for (const int i : numbers) array->InsertNextValue(i);
  attributes->AddArray(array);
}

// Field data of one number. Names of parts are names of fields, not texts in
// them: meshio takes numbers only, and shows the names of fields as ParaView
// does.
template <typename Array>
void AddField(const std::string& name,
              double value,
              vtkUnstructuredGrid* grid) {
  vtkNew<Array> array;
  array->SetName(name.c_str());
  array->InsertNextTuple1(value);
  grid->GetFieldData()->AddArray(array);
}

void AddPartNumber(const std::string& part,
                   size_t number,
                   ElementNames* names,
                   vtkUnstructuredGrid* grid) {
  AddField<vtkIntArray>(names->Of(part), static_cast<double>(number), grid);
}

void AddCells(const ElementModel& model, vtkUnstructuredGrid* grid) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto add_points = [&](const Points& rows) {
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      points->InsertNextPoint(rows.row(i).data());
    }
  };
  add_points(model.mesh.points);
  for (Eigen::Index t = 0; t < model.mesh.tetrahedra.rows(); ++t) {
    vtkIdType corners[4];
    for (int k = 0; k < 4; ++k) corners[k] = model.mesh.tetrahedra(t, k);
    grid->InsertNextCell(VTK_TETRA, 4, corners);
  }
  for (const RigidSurface& bone : model.bones) {
    const vtkIdType first = points->GetNumberOfPoints();
    add_points(bone.surface.points);
    for (Eigen::Index f = 0; f < bone.surface.triangles.rows(); ++f) {
      vtkIdType corners[3];
      for (int k = 0; k < 3; ++k) {
        corners[k] = first + bone.surface.triangles(f, k);
      }
      grid->InsertNextCell(VTK_TRIANGLE, 3, corners);
    }
  }
  grid->SetPoints(points);
}

// The numbers of the muscle and of the bone of each cell.
void AddParts(const ElementModel& model, vtkUnstructuredGrid* grid) {
  std::vector<int> muscles, bones;
  for (size_t i = 0; i < model.muscles.size(); ++i) {
    muscles.insert(
        muscles.end(), model.muscles[i].num_elements, static_cast<int>(i) + 1);
  }
  bones.resize(muscles.size(), 0);
  for (size_t i = 0; i < model.bones.size(); ++i) {
    bones.insert(bones.end(),
                 model.bones[i].surface.triangles.rows(),
                 static_cast<int>(i) + 1);
  }
  muscles.resize(bones.size(), 0);
  AddNumbers("muscle", muscles, grid->GetCellData());
  AddNumbers("bone", bones, grid->GetCellData());
  vtkNew<vtkDoubleArray> fibres;
  fibres->SetName("fibre");
  fibres->SetNumberOfComponents(3);
  const double none[3] = {0, 0, 0};
  for (size_t t = 0; t < muscles.size(); ++t) {
    const auto row = static_cast<Eigen::Index>(t);
    fibres->InsertNextTuple(
        row < model.fibres.rows() ? model.fibres.row(row).data() : none);
  }
  grid->GetCellData()->AddArray(fibres);
}

void AddAttachments(const ElementModel& model,
                    ElementNames* names,
                    vtkUnstructuredGrid* grid) {
  std::vector<std::string> bodies;
  std::vector<int> body_of(grid->GetNumberOfPoints(), 0);
  for (const MuscleElements& muscle : model.muscles) {
    for (const AttachedArea& area : muscle.attachments) {
      auto body = std::find(bodies.begin(), bodies.end(), area.body);
      if (body == bodies.end()) body = bodies.insert(body, area.body);
      for (const int v : area.vertices) {
        body_of[v] = static_cast<int>(body - bodies.begin()) + 1;
      }
    }
  }
  AddNumbers("attachment", body_of, grid->GetPointData());
  for (size_t i = 0; i < bodies.size(); ++i) {
    AddPartNumber("body " + bodies[i], i + 1, names, grid);
  }
}

// ParaView takes TimeValue as the time of a file in a series.
void AddFields(const ElementModel& model,
               ElementNames* names,
               vtkUnstructuredGrid* grid) {
  AddField<vtkIntArray>("frame", model.frame, grid);
  AddField<vtkDoubleArray>("TimeValue", model.time, grid);
  for (size_t i = 0; i < model.muscles.size(); ++i) {
    AddPartNumber("muscle " + model.muscles[i].name, i + 1, names, grid);
  }
  for (size_t i = 0; i < model.bones.size(); ++i) {
    AddPartNumber("bone " + model.bones[i].name, i + 1, names, grid);
  }
}

}  // namespace

std::string VtuBytes(const ElementModel& model) {
  vtkNew<vtkUnstructuredGrid> grid;
  ElementNames names;
  AddCells(model, grid);
  AddParts(model, grid);
  AddFields(model, &names, grid);
  AddAttachments(model, &names, grid);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  const VtkErrorScope errors;
  writer->WriteToOutputStringOn();
  writer->SetDataModeToBinary();
  writer->SetCompressionLevel(1);
  writer->SetInputData(grid);
  CHECK_EQ(writer->Write(), 1) << errors.FirstError();
  return writer->GetOutputString();
}

}  // namespace musclewarp
