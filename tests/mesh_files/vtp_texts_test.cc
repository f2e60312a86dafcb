// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/vtp_texts.h"

#include <gtest/gtest.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <string>

#include "musclewarp/mesh_files/stated_space.h"

namespace musclewarp {
namespace {

// As VTK writes a file with field data in one of its ways.
std::string WrittenVtp(int mode, bool is_compressed, bool is_encoded) {
  vtkNew<vtkPolyData> data;
  for (const std::string name : {"OTHER", "SPACE"}) {
    vtkNew<vtkStringArray> array;
    array->SetName(name.c_str());
    array->InsertNextValue(name == "SPACE" ? "RAS" : "something");
    array->InsertNextValue("second");
    data->GetFieldData()->AddArray(array);
  }
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->WriteToOutputStringOn();
  writer->SetDataMode(mode);
  writer->SetCompressorType(is_compressed ? vtkXMLWriter::ZLIB
                                          : vtkXMLWriter::NONE);
  writer->SetEncodeAppendedData(is_encoded);
  EXPECT_EQ(writer->Write(), 1);
  return writer->GetOutputString();
}

TEST(VtpFieldText, IsReadHoweverItIsWritten) {
  for (const int mode :
       {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended}) {
    for (const bool is_compressed : {false, true}) {
      for (const bool is_encoded : {false, true}) {
        const std::string bytes = WrittenVtp(mode, is_compressed, is_encoded);
        EXPECT_EQ(VtpFieldText(bytes, "SPACE"), "RAS") << mode;
        EXPECT_EQ(VtpFieldText(bytes, "OTHER"), "something") << mode;
        EXPECT_EQ(VtpFieldText(bytes, "ABSENT"), "");
        EXPECT_EQ(StatedSpaceIn(".vtp", bytes), "RAS");
      }
    }
  }
}

// The reader of the mesh tells of the damage.
TEST(VtpFieldText, OfADamagedFileIsEmptyOrWhole) {
  const std::string bytes = WrittenVtp(vtkXMLWriter::Appended, true, true);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::string text = VtpFieldText(bytes.substr(0, size), "SPACE");
    EXPECT_TRUE(text.empty() || text == "RAS") << size;
  }
}

}  // namespace
}  // namespace musclewarp
