// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
//
// Files that VTK itself writes are read.
#include <gtest/gtest.h>
#include <vtkBitArray.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCharArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkLongLongArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkShortArray.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedLongArray.h>
#include <vtkVariantArray.h>

#include "mesh_files/format_checks.h"
#include "musclewarp/mesh_files/legacy_vtk_io.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

void AddTexts(vtkFieldData* field,
              const char* name,
              const std::vector<std::string>& texts) {
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& text : texts) array->InsertNextValue(text);
  field->AddArray(array);
}

// Adds an array of 0 and 1.
template <typename Array>
void AddNumbers(vtkFieldData* field, const char* name, vtkIdType count) {
  vtkNew<Array> array;
  array->SetName(name);
  for (vtkIdType i = 0; i < count; ++i) array->InsertNextTuple1(i % 2);
  field->AddArray(array);
}

vtkSmartPointer<vtkPolyData> PolyDataOf(const TriangleSoup& soup) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (Eigen::Index i = 0; i < soup.points.rows(); ++i) {
    points->InsertNextPoint(soup.points.row(i).data());
  }
  vtkNew<vtkCellArray> cells;
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    cells->InsertNextCell(3);
    for (const int v : soup.triangles.row(f)) cells->InsertCellPoint(v);
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

// Puts arrays of all kinds before the points, and what 3D Slicer adds.
void AddArrays(vtkPolyData* data) {
  constexpr vtkIdType kCount = 11;  // no whole bytes of bits
  vtkFieldData* const field = data->GetFieldData();
  AddTexts(field, "SPACE", {"LPS"});
  AddTexts(field,
           "texts",
           {"a b%\n",
            "",
            std::string(63, 'x'),
            std::string(64, 'y'),
            std::string(20000, 'z')});
  AddTexts(field, "no texts", {});
  AddNumbers<vtkBitArray>(field, "bits", kCount);
  AddNumbers<vtkCharArray>(field, "chars", kCount);
  AddNumbers<vtkUnsignedCharArray>(field, "bytes", kCount);
  AddNumbers<vtkShortArray>(field, "shorts", kCount);
  AddNumbers<vtkIntArray>(field, "ints", kCount);
  AddNumbers<vtkUnsignedLongArray>(field, "longs", kCount);
  AddNumbers<vtkLongLongArray>(field, "long longs", kCount);
  AddNumbers<vtkFloatArray>(field, "floats", kCount);
  AddNumbers<vtkIdTypeArray>(field, "ids", kCount);
  AddNumbers<vtkDoubleArray>(field, "doubles", kCount);
  // Of these come metadata.
  vtkDataArray* const doubles = field->GetArray("doubles");
  doubles->SetComponentName(0, "length");
  doubles->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "mm");
  vtkNew<vtkVariantArray> variants;
  variants->SetName("variants");
  variants->InsertNextValue(vtkVariant(1.5));
  variants->InsertNextValue(vtkVariant("a b"));
  field->AddArray(variants);
  data->GetPoints()->GetData()->SetComponentName(0, "x");
  AddTexts(data->GetPointData(),
           "names",
           std::vector<std::string>(data->GetNumberOfPoints(), "p"));
  AddTexts(data->GetCellData(),
           "names",
           std::vector<std::string>(data->GetNumberOfCells(), "c"));
}

TEST(LegacyVtkWritten, ArraysOfAllTypesArePassedOver) {
  const TriangleSoup soup = Icosphere(10, 1);
  const auto data = PolyDataOf(soup);
  AddArrays(data);
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->WriteToOutputStringOn();
  for (const int version : {vtkPolyDataWriter::VTK_LEGACY_READER_VERSION_4_2,
                            vtkPolyDataWriter::VTK_LEGACY_READER_VERSION_5_1}) {
    for (const int encoding : {VTK_ASCII, VTK_BINARY}) {
      writer->SetFileVersion(version);
      writer->SetFileType(encoding);
      ASSERT_EQ(writer->Write(), 1);
      const TriangleSoup read =
          ReadLegacyVtk("a.vtk", writer->GetOutputStdString());
      EXPECT_EQ(read.triangles, soup.triangles) << version << " " << encoding;
      // As text VTK writes eleven digits.
      EXPECT_LE((read.points - soup.points).cwiseAbs().maxCoeff(), 1e-9);
      if (encoding == VTK_BINARY) {
        EXPECT_TRUE(SameBits(read, soup)) << version;
      }
    }
  }
}

}  // namespace
}  // namespace musclewarp
