// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/vtk_io.h"

#include <glog/logging.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkXMLPolyDataWriter.h>

#include "musclewarp/mesh/vtk_errors.h"

namespace musclewarp {

vtkSmartPointer<vtkPolyData> PolyDataFromSoup(const TriangleSoup& soup) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(soup.points.rows());
  for (Eigen::Index i = 0; i < soup.points.rows(); ++i) {
    points->SetPoint(i, soup.points.row(i).data());
  }
  vtkNew<vtkCellArray> polygons;
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    polygons->InsertNextCell(
        {soup.triangles(f, 0), soup.triangles(f, 1), soup.triangles(f, 2)});
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}

std::string VtpBytes(vtkPolyData* data) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  const VtkErrorScope errors;
  writer->WriteToOutputStringOn();
  writer->SetDataModeToBinary();
  writer->SetInputData(data);
  CHECK_EQ(writer->Write(), 1) << errors.FirstError();
  return writer->GetOutputString();
}

}  // namespace musclewarp
