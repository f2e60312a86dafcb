// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/render/image.h"

#include <glog/logging.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include "musclewarp/base/output_file.h"

namespace musclewarp {

Image Downsample(const Image& image, int factor) {
  CHECK_GT(factor, 0);
  CHECK_EQ(image.width % factor, 0);
  CHECK_EQ(image.height % factor, 0);
  Image small{image.width / factor, image.height / factor, {}};
  small.pixels.resize(small.width * small.height);
  const int count = factor * factor;
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      int r = count / 2, g = count / 2, b = count / 2;
      for (int k = 0; k < count; ++k) {
        const Color& c =
            image.At(x * factor + k % factor, y * factor + k / factor);
        r += c.r;
        g += c.g;
        b += c.b;
      }
      small.At(x, y) = {static_cast<std::uint8_t>(r / count),
                        static_cast<std::uint8_t>(g / count),
                        static_cast<std::uint8_t>(b / count)};
    }
  }
  return small;
}

void WritePng(const std::string& path, const Image& image) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      // VTK counts rows from the bottom.
      auto* to = static_cast<std::uint8_t*>(
          data->GetScalarPointer(x, image.height - 1 - y, 0));
      const Color& c = image.At(x, y);
      to[0] = c.r;
      to[1] = c.g;
      to[2] = c.b;
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(data);
  writer->SetCompressionLevel(9);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* png = writer->GetResult();
  WriteTextAtomically(
      path,
      std::string(reinterpret_cast<const char*>(png->GetPointer(0)),
                  png->GetNumberOfValues()));
}

}  // namespace musclewarp
