// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/label_image.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkMetaImageWriter.h>
#include <vtkNIFTIImageWriter.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <Eigen/Dense>
#include <fstream>
#include <sstream>
#include <utility>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/made_images.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

// NIfTI keeps its matrices in single precision.
constexpr double kSinglePrecision = 1e-5;

// Labels 0 to 6, so that any change of their order is seen.
MadeImage ManyLabels(const Eigen::Array3i& size) {
  int next = 0;
  return MakeImage(size,
                   TurnedSteps({1, 2, 0.5}, {10, -20, 30}),
                   [&next](const Eigen::Vector3d&) { return next++ % 7; });
}

vtkSmartPointer<vtkImageData> VtkImage(const MadeImage& image, int type) {
  vtkNew<vtkImageData> result;
  result->SetDimensions(image.size[0], image.size[1], image.size[2]);
  result->AllocateScalars(type, 1);
  int at = 0;
  for (int k = 0; k < image.size[2]; ++k) {
    for (int j = 0; j < image.size[1]; ++j) {
      for (int i = 0; i < image.size[0]; ++i) {
        result->SetScalarComponentFromDouble(i, j, k, 0, image.labels[at++]);
      }
    }
  }
  const Eigen::Matrix4d& steps = image.lps_from_index;
  result->SetSpacing(steps.col(0).head<3>().norm(),
                     steps.col(1).head<3>().norm(),
                     steps.col(2).head<3>().norm());
  return result;
}

enum class NiftiForm { kNone, kQform, kSform };

// A negative qfac stores the slices in reverse.
void WriteNifti(const std::string& path,
                const MadeImage& image,
                NiftiForm form,
                double qfac = 1,
                int type = VTK_SHORT) {
  Eigen::Matrix4d ras_from_index = image.lps_from_index;
  ras_from_index.topRows<2>() *= -1;
  vtkNew<vtkMatrix4x4> matrix;
  for (int axis = 0; axis < 4; ++axis) {
    const double length =
        axis < 3 ? ras_from_index.col(axis).head<3>().norm() : 1;
    for (int row = 0; row < 3; ++row) {
      matrix->SetElement(row, axis, ras_from_index(row, axis) / length);
    }
  }
  vtkNew<vtkNIFTIImageWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(VtkImage(image, type));
  if (form == NiftiForm::kQform) writer->SetQFormMatrix(matrix);
  if (form == NiftiForm::kSform) writer->SetSFormMatrix(matrix);
  writer->SetQFac(qfac);
  writer->Write();
}

std::string BytesOf(const std::string& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

// Expects the labels and places of an image, up to rounding, mm.
void ExpectImage(const std::string& path,
                 const MadeImage& expected,
                 double rounding = 1e-9) {
  const LabelImage image = ReadLabelImage(path);
  ASSERT_TRUE((image.grid.size == expected.size).all());
  EXPECT_EQ(image.labels,
            std::vector<int>(expected.labels.begin(), expected.labels.end()));
  EXPECT_TRUE(
      image.grid.world_from_index.isApprox(expected.lps_from_index, rounding))
      << image.grid.world_from_index;
  EXPECT_TRUE(image.grid.is_oriented);
  EXPECT_TRUE(image.notes.empty());
}

void ExpectImageRefused(const std::string& path,
                        const std::vector<std::string>& words) {
  ExpectInputError([&] { ReadLabelImage(path); }, words);
}

}  // namespace

TEST(LabelImage, NiftiIsTurnedFromRas) {
  const std::string dir = TestTempDir();
  const MadeImage image = ManyLabels({12, 5, 4});
  for (const NiftiForm form : {NiftiForm::kQform, NiftiForm::kSform}) {
    for (const char* name : {"/a.nii", "/a.nii.gz"}) {
      WriteNifti(dir + name, image, form);
      ExpectImage(dir + name, image, kSinglePrecision);
    }
  }
}

// VTK reverses such slices, and its matrix with them: labels stay in place.
TEST(LabelImage, ReversedSlicesOfNiftiStayInPlace) {
  const std::string path = TestTempDir() + "/a.nii";
  const MadeImage image = ManyLabels({12, 5, 4});
  WriteNifti(path, image, NiftiForm::kQform, -1);
  ExpectImage(path, image, kSinglePrecision);
}

// The sform of many files is left-handed. VTK then reverses the slices, unless
// the file has a qform, too: the labels have to be where the file says.
TEST(LabelImage, LabelsOfALeftHandedSformStayInPlace) {
  const std::string path = TestTempDir() + "/a.nii";
  MadeImage made = ManyLabels({12, 5, 4});
  WriteNifti(path, made, NiftiForm::kSform);
  std::string bytes = BytesOf(path);
  constexpr int kSform = 280, kQformCode = 252, kFloat = 4;
  for (int row = 0; row < 3; ++row) {
    // The sign of a little-endian number is in its last byte.
    bytes[kSform + kFloat * (4 * row + 2) + 3] ^= '\x80';
  }
  made.lps_from_index.col(2) *= -1;
  const Eigen::Matrix4d index_from_lps = made.lps_from_index.inverse();
  for (const bool has_qform : {false, true}) {
    bytes[kQformCode] = has_qform ? 1 : 0;
    WriteTextAtomically(path, bytes);
    const LabelImage image = ReadLabelImage(path);
    for (int at = 0; at < 12 * 5 * 4; ++at) {
      const int i = at % 12, j = at / 12 % 5, k = at / 12 / 5;
      const Eigen::Vector4d index(i, j, k, 1);
      const Eigen::Array4i there =
          (index_from_lps * (image.grid.world_from_index * index))
              .array()
              .round()
              .cast<int>();
      EXPECT_EQ(image.labels[at],
                made.labels[(there[2] * 5 + there[1]) * 12 + there[0]]);
    }
  }
}

TEST(LabelImage, NiftiWithoutAFrameIsTakenAsItIs) {
  const std::string path = TestTempDir() + "/a.nii";
  WriteNifti(path, ManyLabels({12, 5, 4}), NiftiForm::kNone);
  const LabelImage image = ReadLabelImage(path);
  EXPECT_FALSE(image.grid.is_oriented);
  ASSERT_EQ(image.notes.size(), 1u);
  EXPECT_THAT(image.notes[0], ::testing::HasSubstr("neither sform nor qform"));
  EXPECT_NEAR(image.grid.world_from_index(1, 1), 2, kSinglePrecision);
}

TEST(LabelImage, SlopeInterceptAndUnitsOfNiftiCount) {
  const std::string path = TestTempDir() + "/a.nii";
  MadeImage image = ManyLabels({12, 5, 4});
  WriteNifti(path, image, NiftiForm::kSform);
  std::string bytes = BytesOf(path);
  // scl_slope and scl_inter; xyzt_units.
  for (const auto& [at, number] : {std::pair(112, 2.F), {116, 1.F}}) {
    bytes.replace(at, 4, reinterpret_cast<const char*>(&number), 4);
  }
  bytes[123] = 3;  // micrometres
  WriteTextAtomically(path, bytes);
  ExpectImageRefused(path, {"mm apart along axis 2", "units of the image"});
  bytes[123] = 2;  // millimetres
  WriteTextAtomically(path, bytes);
  for (unsigned char& label : image.labels) label = 2 * label + 1;
  ExpectImage(path, image, kSinglePrecision);
}

TEST(LabelImage, PairsOfNiftiAreReadFromEitherFile) {
  const std::string dir = TestTempDir();
  const MadeImage image = ManyLabels({12, 5, 4});
  WriteNifti(dir + "/a.img", image, NiftiForm::kSform);
  WriteNifti(dir + "/b.img.gz", image, NiftiForm::kSform);
  for (const char* name : {"/a.img", "/a.hdr", "/b.img.gz", "/b.hdr.gz"}) {
    ExpectImage(dir + name, image, kSinglePrecision);
  }
}

TEST(LabelImage, ANoteTellsOfAnotherQform) {
  const std::string path = TestTempDir() + "/a.nii";
  MadeImage image = ManyLabels({12, 5, 4});
  WriteNifti(path, image, NiftiForm::kSform);
  std::string bytes = BytesOf(path);
  bytes[252] = 1;  // qform_code; the qform is not turned
  WriteTextAtomically(path, bytes);
  const LabelImage read = ReadLabelImage(path);
  EXPECT_TRUE(read.grid.world_from_index.isApprox(image.lps_from_index,
                                                  kSinglePrecision));
  ASSERT_EQ(read.notes.size(), 1u);
  EXPECT_THAT(read.notes[0], ::testing::HasSubstr("an sform and a qform"));
}

TEST(LabelImage, ValuesNextToALabelAreThatLabel) {
  const std::string path = TestTempDir() + "/a.nii";
  const MadeImage image = ManyLabels({12, 5, 4});
  WriteNifti(path, image, NiftiForm::kSform);
  const std::string bytes = BytesOf(path);
  const auto with_scale = [&](float slope, float intercept) {
    std::string scaled = bytes;
    scaled.replace(112, 4, reinterpret_cast<const char*>(&slope), 4);
    scaled.replace(116, 4, reinterpret_cast<const char*>(&intercept), 4);
    WriteTextAtomically(path, scaled);
  };
  with_scale(1, -9e-4F);
  const LabelImage read = ReadLabelImage(path);
  EXPECT_EQ(read.labels,
            std::vector<int>(image.labels.begin(), image.labels.end()));
  ASSERT_EQ(read.notes.size(), 1u);
  EXPECT_THAT(read.notes[0], ::testing::HasSubstr("240 voxels"));
  with_scale(1, 2e-3F);
  ExpectImageRefused(path, {"value 0.002", "scl_slope 1, scl_inter 0.002"});
  with_scale(0.37F, 0);
  ExpectImageRefused(path,
                     {"voxel (1, 0, 0) has the value 0.37",
                      "scl_slope 0.37, scl_inter 0",
                      "set scl_slope to 1"});
}

// VTK takes a first axis of at most 9 voxels for the components of a vector.
TEST(LabelImage, NrrdMayBeNarrow) {
  const std::string path = TestTempDir() + "/a.nrrd";
  for (const int width : {3, 9, 12}) {
    const MadeImage image = ManyLabels({width, 5, 4});
    for (const char* space :
         {"left-posterior-superior", "right-anterior-superior"}) {
      WriteTextAtomically(path, NrrdBytes(image, space));
      ExpectImage(path, image);
    }
  }
}

// The image as 3D Slicer writes it, with an axis of one voxel, and with its
// data in a file of their own.
TEST(LabelImage, NrrdMayHaveAnAxisMoreAndDataInAnotherFile) {
  const std::string dir = TestTempDir();
  const MadeImage image = ManyLabels({12, 5, 4});
  std::string bytes = NrrdBytes(image);
  const auto replace = [&](const std::string& text, const std::string& by) {
    bytes.replace(bytes.find(text), text.size(), by);
  };
  replace("dimension: 3", "dimension: 4");
  replace("sizes:", "sizes: 1");
  replace("directions:", "directions: none");
  replace("kinds:", "kinds: list");
  WriteTextAtomically(dir + "/a.seg.nrrd", bytes);
  ExpectImage(dir + "/a.seg.nrrd", image);
  const std::size_t data = bytes.size() - image.labels.size();
  WriteTextAtomically(dir + "/a.raw", bytes.substr(data));
  WriteTextAtomically(dir + "/a.nhdr",
                      bytes.substr(0, data - 1) + "data file: a.raw\n");
  ExpectImage(dir + "/a.nhdr", image);
}

TEST(LabelImage, NrrdWithoutASpaceIsTakenAsItIs) {
  const std::string path = TestTempDir() + "/a.nrrd";
  WriteTextAtomically(path, NrrdBytes(ManyLabels({12, 5, 4}), ""));
  const LabelImage image = ReadLabelImage(path);
  EXPECT_FALSE(image.grid.is_oriented);
  ASSERT_EQ(image.notes.size(), 1u);
  EXPECT_THAT(image.notes[0], ::testing::HasSubstr("frame of the file"));
}

TEST(LabelImage, MetaImageHasItsDirections) {
  const std::string path = TestTempDir() + "/a.mha";
  const MadeImage image = ManyLabels({12, 5, 4});
  WriteTextAtomically(path, MetaImageBytes(image));
  ExpectImage(path, image);
}

TEST(LabelImage, MetaImageMayBeCompressed) {
  const std::string path = TestTempDir() + "/a.mha";
  MadeImage image = ManyLabels({12, 5, 4});
  image.lps_from_index = Eigen::Matrix4d::Identity();
  vtkNew<vtkMetaImageWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(VtkImage(image, VTK_UNSIGNED_SHORT));
  writer->SetCompression(true);
  writer->Write();
  ExpectImage(path, image);
  std::string bytes = BytesOf(path);
  WriteTextAtomically(path, bytes.substr(0, bytes.size() - 3));
  ExpectImageRefused(path, {"a.mha: is truncated"});
  for (std::size_t i = bytes.size() - 12; i < bytes.size(); ++i) bytes[i] = 'x';
  WriteTextAtomically(path, bytes);
  ExpectImageRefused(path,
                     {"a.mha: cannot be read", "copy or export it again"});
}

TEST(LabelImage, RefusesTruncatedNifti) {
  const std::string dir = TestTempDir();
  for (const char* name : {"/a.nii", "/a.nii.gz"}) {
    WriteNifti(dir + name, ManyLabels({40, 30, 20}), NiftiForm::kSform);
    const std::string bytes = BytesOf(dir + name);
    WriteTextAtomically(dir + name, bytes.substr(0, bytes.size() / 2));
    ExpectImageRefused(dir + name, {name, "cannot be read", "copy"});
    WriteTextAtomically(dir + name, bytes.substr(0, 60));
    ExpectImageRefused(dir + name, {name, "cannot be read", "copy"});
  }
}

TEST(LabelImage, RefusesAnEnormousImageBeforeItIsRead) {
  const std::string path = TestTempDir() + "/a.nii";
  WriteNifti(path, ManyLabels({12, 5, 4}), NiftiForm::kSform);
  std::string bytes = BytesOf(path);
  const std::int16_t size = 30000;
  for (const int at : {42, 44, 46}) {
    bytes.replace(at, 2, reinterpret_cast<const char*>(&size), 2);
  }
  WriteTextAtomically(path, bytes);
  ExpectImageRefused(path, {"has 30000 x 30000 x 30000 voxels", "5e8"});
}

TEST(LabelImage, RefusesWhatIsNoFile) {
  const std::string dir = TestTempDir();
  ExpectImageRefused(dir + "/none.nii", {"none.nii: does not exist"});
  WriteTextAtomically(dir + "/a.mha", "");
  ExpectImageRefused(dir + "/a.mha", {"a.mha: is empty"});
  ExpectImageRefused(dir, {"is not a regular file"});
  WriteTextAtomically(dir + "/a.nii", "This is a text of some length.");
  ExpectImageRefused(dir + "/a.nii", {"a.nii: cannot be read"});
}

TEST(LabelImage, RefusesValuesThatAreNoLabels) {
  const std::string path = TestTempDir() + "/a.nrrd";
  std::string bytes = NrrdBytes(ManyLabels({12, 5, 4}));
  const std::string type = "unsigned char";
  bytes.replace(bytes.find(type), type.size(), "int8");
  bytes[bytes.size() - 12 * 5 * 4 + 15] = static_cast<char>(-3);
  WriteTextAtomically(path, bytes);
  ExpectImageRefused(path,
                     {"voxel (3, 1, 0) has the value -3",
                      "whole numbers from 0",
                      "export the segmentation as a label map"});
}

TEST(LabelImage, RefusesFractionsButTakesWholeRealNumbers) {
  const std::string path = TestTempDir() + "/a.nii";
  const MadeImage image = ManyLabels({12, 5, 4});
  WriteNifti(path, image, NiftiForm::kSform, 1, VTK_FLOAT);
  ExpectImage(path, image, kSinglePrecision);
  std::string bytes = BytesOf(path);
  const float half = 0.5F;
  bytes.replace(352, 4, reinterpret_cast<const char*>(&half), 4);
  WriteTextAtomically(path, bytes);
  ExpectImageRefused(path, {"voxel (0, 0, 0) has the value 0.5"});
}

TEST(LabelImage, RefusesSeveralPointsOfTime) {
  const std::string path = TestTempDir() + "/a.nii";
  WriteNifti(path, ManyLabels({12, 5, 4}), NiftiForm::kSform);
  std::string bytes = BytesOf(path);
  bytes[40] = 4;  // dimensions
  bytes[48] = 2;  // points of time
  WriteTextAtomically(path, bytes + bytes.substr(352));
  ExpectImageRefused(path, {"has 2 points of time", "one number a voxel"});
}

}  // namespace musclewarp
