// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/label_image.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkImageReader2.h>
#include <vtkMatrix4x4.h>
#include <vtkMetaImageReader.h>
#include <vtkNIFTIImageHeader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <sstream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/label_images/meta_image_header.h"
#include "musclewarp/label_images/nrrd_voxels.h"
#include "musclewarp/mesh_files/export_advice.h"
#include "musclewarp/mesh_files/text_cursor.h"
#include "musclewarp/mesh_files/vtk_errors.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// What the values of a file become: slope * value + intercept.
struct Rescale {
  double slope = 1, intercept = 0;
};

// The library of VTK for MetaImage prints its errors and returns as if there
// were none. As long as this lives, they are kept.
class StandardErrorCatcher {
 public:
  StandardErrorCatcher() : previous_(std::cerr.rdbuf(text_.rdbuf())) {}
  ~StandardErrorCatcher() { std::cerr.rdbuf(previous_); }
  StandardErrorCatcher(const StandardErrorCatcher&) = delete;
  StandardErrorCatcher& operator=(const StandardErrorCatcher&) = delete;

  std::string FirstLine() const {
    return text_.str().substr(0, text_.str().find('\n'));
  }

 private:
  std::ostringstream text_;
  std::streambuf* previous_;
};

// Lets VTK do `read` and throws InputError if it complains.
template <typename Read>
void WithVtkErrors(const std::string& path, const Read& read) {
  std::string error;
  {
    const VtkErrorScope scope;
    const StandardErrorCatcher printed;
    read();
    error = scope.FirstError();
    if (error.empty()) error = printed.FirstLine();
  }
  if (error.empty()) return;
  if (error.back() == '.') error.pop_back();
  throw InputError(path, "cannot be read: " + error, kCopyAgain);
}

void CheckIsImageFile(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    throw InputError(path, "does not exist", "check the name and the folder");
  }
  if (!fs::is_regular_file(status)) {
    throw InputError(path, "is not a regular file", "name a file");
  }
  if (fs::file_size(path, error) == 0) {
    throw InputError(path, "is empty (0 bytes)", kCopyAgain);
  }
}

// Sets the labels to the values `value_of` the voxels.
template <typename ValueOf>
void SetLabels(const ValueOf& value_of, LabelImage* image) {
  const std::int64_t count = image->grid.NumVoxels();
  image->labels.resize(count);
  for (std::int64_t i = 0; i < count; ++i) {
    const double value = value_of(i);
    if (!(value >= 0 && value <= std::numeric_limits<int>::max() &&
          value == std::floor(value))) {
      const Eigen::Array3i& size = image->grid.size;
      std::ostringstream text;
      text << "voxel (" << i % size[0] << ", " << i / size[0] % size[1] << ", "
           << i / size[0] / size[1] << ") has the value " << value
           << "; allowed: labels, which are whole numbers from 0 to 2147483647";
      throw InputError(image->path,
                       text.str(),
                       "export the segmentation as a label map, not the image "
                       "that it was made on");
    }
    image->labels[i] = static_cast<int>(value);
  }
}

// Copies the voxels. VTK may have taken the first axis for components, which
// does not change their order.
void TakeLabels(vtkImageReader2* reader,
                const Rescale& rescale,
                LabelImage* image) {
  vtkDataArray* values = reader->GetOutput()->GetPointData()->GetScalars();
  const std::int64_t count = image->grid.NumVoxels();
  if (!values || values->GetNumberOfValues() != count) {
    throw InputError(
        image->path,
        "has " + std::to_string(values ? values->GetNumberOfValues() : 0) +
            " values for " + std::to_string(count) +
            " voxels; allowed: one a voxel",
        "export one label map");
  }
  const int components = values->GetNumberOfComponents();
  const auto value_of = [&](std::int64_t i) {
    return rescale.slope *
               values->GetComponent(i / components, i % components) +
           rescale.intercept;
  };
  SetLabels(value_of, image);
}

// What a unit of length of a NIfTI file is in mm; `unstated` if it has none.
double NiftiUnit(const vtkNIFTIImageHeader& header, double unstated) {
  constexpr int kLengthMask = 7, kMetre = 1, kMillimetre = 2, kMicrometre = 3;
  const int unit =
      const_cast<vtkNIFTIImageHeader&>(header).GetXYZTUnits() & kLengthMask;
  switch (unit) {
    case kMetre:
      return 1000;
    case kMillimetre:
      return 1;
    case kMicrometre:
      return 1e-3;
    default:
      return unstated;
  }
}

void TakeNiftiGrid(double mm_per_unit,
                   vtkNIFTIImageReader* reader,
                   LabelImage* image) {
  ImageGrid& grid = image->grid;
  const int* extent = reader->GetDataExtent();
  for (int axis = 0; axis < 3; ++axis) {
    grid.size[axis] = extent[2 * axis + 1] + 1;
  }
  vtkMatrix4x4* world_from_vtk = reader->GetSFormMatrix()
                                     ? reader->GetSFormMatrix()
                                     : reader->GetQFormMatrix();
  if (world_from_vtk) {
    for (int i = 0; i < 16; ++i) {
      grid.world_from_index(i / 4, i % 4) =
          world_from_vtk->GetElement(i / 4, i % 4);
    }
    TurnFromRas(&grid);
  } else {
    image->notes.push_back(
        image->path +
        " has neither sform nor qform: the surfaces are along the axes of the "
        "image, with the first voxel at the origin");
  }
  for (int axis = 0; axis < 3; ++axis) {
    grid.world_from_index.col(axis) *= reader->GetDataSpacing()[axis];
  }
  grid.world_from_index.topRows<3>() *=
      NiftiUnit(*reader->GetNIFTIHeader(), mm_per_unit);
}

void ReadNifti(double mm_per_unit, LabelImage* image) {
  const std::string& path = image->path;
  vtkNew<vtkNIFTIImageReader> reader;
  reader->SetFileName(path.c_str());
  WithVtkErrors(path, [&] { reader->UpdateInformation(); });
  if (reader->GetTimeDimension() > 1 ||
      reader->GetNumberOfScalarComponents() > 1) {
    throw InputError(path,
                     "has " + std::to_string(reader->GetTimeDimension()) +
                         " points of time "
                         "with " +
                         std::to_string(reader->GetNumberOfScalarComponents()) +
                         " numbers a voxel; allowed: one number a voxel",
                     "export one label map");
  }
  TakeNiftiGrid(mm_per_unit, reader, image);
  CheckGrid(path, image->grid);
  WithVtkErrors(path, [&] { reader->Update(); });
  Rescale rescale;
  if (reader->GetRescaleSlope() != 0) {
    rescale = {reader->GetRescaleSlope(), reader->GetRescaleIntercept()};
  }
  TakeLabels(reader, rescale, image);
}

void ReadNrrd(double mm_per_unit, LabelImage* image) {
  const NrrdHeader header = ReadNrrdHeader(image->path, mm_per_unit);
  image->grid = header.grid;
  const NrrdVoxels voxels =
      ReadNrrdVoxels(header.source, header.grid.NumVoxels());
  SetLabels([&](std::int64_t i) { return voxels.At(i); }, image);
}

void ReadMetaImage(double mm_per_unit, LabelImage* image) {
  image->grid = ReadMetaImageHeader(image->path, mm_per_unit);
  vtkNew<vtkMetaImageReader> reader;
  reader->SetFileName(image->path.c_str());
  WithVtkErrors(image->path, [&] { reader->Update(); });
  TakeLabels(reader, Rescale(), image);
}

}  // namespace

LabelImage ReadLabelImage(const std::string& path, double mm_per_unit) {
  CheckIsImageFile(path);
  LabelImage image;
  image.path = path;
  const std::string extension = LowerCase(fs::path(path).extension().string());
  if (extension == ".nrrd" || extension == ".nhdr") {
    ReadNrrd(mm_per_unit, &image);
  } else if (extension == ".mha" || extension == ".mhd") {
    ReadMetaImage(mm_per_unit, &image);
  } else {
    ReadNifti(mm_per_unit, &image);
  }
  if (!image.grid.is_oriented && image.notes.empty()) {
    image.notes.push_back(
        path +
        " does not say where the patient's left, back and "
        "head are: the surfaces are in the frame of the file");
  }
  return image;
}

}  // namespace musclewarp
