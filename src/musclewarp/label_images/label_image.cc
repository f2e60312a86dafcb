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

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <sstream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/label_images/meta_image_header.h"
#include "musclewarp/label_images/mgh_image.h"
#include "musclewarp/label_images/nifti_frame.h"
#include "musclewarp/label_images/nifti_pair.h"
#include "musclewarp/label_images/nrrd_voxels.h"
#include "musclewarp/mesh_files/export_advice.h"
#include "musclewarp/mesh_files/text_cursor.h"
#include "musclewarp/mesh_files/vtk_errors.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// The transformation of the values of a file: slope * value + intercept.
struct Rescale {
  double slope = 1, intercept = 0;

  bool IsAny() const { return slope != 1 || intercept != 0; }
};

// Keeps messages that are printed to std::cerr during its lifetime. VTK's
// library for MetaImage prints errors there, and returns as if there were none.
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

// Calls `read` and throws InputError if VTK reports an error.
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

bool IsMghFile(const std::string& path) {
  const std::string extension = LowerCase(fs::path(path).extension().string());
  return extension == ".mgh" || extension == ".mgz" ||
         LowerCase(fs::path(path).stem().extension().string()) == ".mgh";
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

[[noreturn]] void ThrowNoLabel(const LabelImage& image,
                               std::int64_t voxel,
                               double value,
                               const Rescale& rescale) {
  const Eigen::Array3i& size = image.grid.size;
  std::ostringstream text;
  text << "voxel (" << voxel % size[0] << ", " << voxel / size[0] % size[1]
       << ", " << voxel / size[0] / size[1] << ") has the value " << value;
  if (rescale.IsAny()) {
    text << ", as its header scales what is stored (scl_slope " << rescale.slope
         << ", scl_inter " << rescale.intercept << ")";
  }
  text << "; allowed: labels, which are whole numbers from 0 to 2147483647";
  throw InputError(
      image.path,
      text.str(),
      rescale.IsAny()
          ? "set scl_slope to 1 and scl_inter to 0, or save the label map "
            "without scaling"
          : "export the segmentation as a label map, not the image that it was "
            "made on");
}

// Sets the labels to the values of the voxels. Values in floating point, or
// with a scale, may deviate slightly from integers.
template <typename ValueOf>
void SetLabels(const ValueOf& value_of,
               LabelImage* image,
               const Rescale& rescale = {}) {
  constexpr double kRounding = 1e-3;
  const std::int64_t count = image->grid.NumVoxels();
  image->labels.resize(count);
  std::int64_t num_rounded = 0;
  double most = 0;
  for (std::int64_t i = 0; i < count; ++i) {
    const double value = value_of(i);
    const double label = std::round(value);
    const double off = std::abs(value - label);
    if (!(label >= 0 && label <= std::numeric_limits<int>::max() &&
          off <= kRounding)) {
      ThrowNoLabel(*image, i, value, rescale);
    }
    if (off > 0) ++num_rounded;
    most = std::max(most, off);
    image->labels[i] = static_cast<int>(label);
  }
  if (num_rounded == 0) return;
  std::ostringstream note;
  note << image->path << " has " << num_rounded
       << " voxels whose values are whole numbers but for " << most
       << " at most: these are taken as the labels";
  image->notes.push_back(note.str());
}

// Copies the voxels. VTK may have interpreted the first axis as components,
// which does not change their order.
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
  SetLabels(value_of, image, rescale);
}

// Returns the unit of length of a NIfTI file in mm; `unstated` if it has none.
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
  const auto world_from_index = [&](vtkMatrix4x4& world_from_vtk) {
    Eigen::Matrix4d matrix;
    for (int i = 0; i < 16; ++i) {
      matrix(i / 4, i % 4) = world_from_vtk.GetElement(i / 4, i % 4);
    }
    for (int axis = 0; axis < 3; ++axis) {
      matrix.col(axis) *= reader->GetDataSpacing()[axis];
    }
    return matrix;
  };
  vtkMatrix4x4* const sform = reader->GetSFormMatrix();
  vtkMatrix4x4* const qform = reader->GetQFormMatrix();
  if (sform || qform) {
    grid.world_from_index = world_from_index(sform ? *sform : *qform);
    TurnFromRas(&grid);
  } else {
    image->notes.push_back(
        image->path +
        " has neither sform nor qform: the surfaces are along the axes of the "
        "image, with the first voxel at the origin");
    for (int axis = 0; axis < 3; ++axis) {
      grid.world_from_index(axis, axis) = reader->GetDataSpacing()[axis];
    }
  }
  if (sform && qform) {
    const std::string note = NoteOnOtherQform(image->path,
                                              grid.size,
                                              world_from_index(*sform),
                                              world_from_index(*qform));
    if (!note.empty()) image->notes.push_back(note);
  }
  grid.world_from_index.topRows<3>() *=
      NiftiUnit(*reader->GetNIFTIHeader(), mm_per_unit);
}

void ReadNifti(double mm_per_unit, LabelImage* image) {
  const std::string path = IsNiftiPairFile(image->path)
                               ? CheckedNiftiHeader(image->path)
                               : image->path;
  CheckNiftiFields(path);
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

void NoteIfNotOriented(LabelImage* image) {
  if (image->grid.is_oriented) return;
  image->notes.push_back(image->path +
                         " does not say where the patient's left, back and "
                         "head are: the surfaces are in the frame of the file");
}

void ReadNrrd(double mm_per_unit, LabelImage* image) {
  const NrrdHeader header = ReadNrrdHeader(image->path, mm_per_unit);
  image->grid = header.grid;
  NoteIfNotOriented(image);
  const NrrdVoxels voxels =
      ReadNrrdVoxels(header.source, header.grid.NumVoxels());
  SetLabels([&](std::int64_t i) { return voxels.At(i); }, image);
}

void ReadMgh(LabelImage* image) {
  const MghImage mgh = ReadMghImage(image->path);
  image->grid = mgh.grid;
  if (!mgh.grid.is_oriented) {
    image->notes.push_back(image->path +
                           " does not say how it lies (goodRASFlag is 0): it "
                           "is taken as coronal slices of 1 mm");
  }
  SetLabels([&](std::int64_t i) { return mgh.At(i); }, image);
}

void ReadMetaImage(double mm_per_unit, LabelImage* image) {
  image->grid = ReadMetaImageHeader(image->path, mm_per_unit);
  NoteIfNotOriented(image);
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
  } else if (IsMghFile(path)) {
    ReadMgh(&image);
  } else {
    ReadNifti(mm_per_unit, &image);
  }
  return image;
}

}  // namespace musclewarp
