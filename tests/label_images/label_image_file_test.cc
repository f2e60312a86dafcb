// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/label_image_file.h"

#include <gtest/gtest.h>

#include "musclewarp/label_images/label_meshes.h"
#include "support/input_errors.h"

namespace musclewarp {

TEST(LabelImageFile, IsKnownByItsName) {
  for (const char* name : {"a.nii",
                           "b/a.NII.GZ",
                           "a.seg.nrrd",
                           "a.nhdr",
                           "a.mha",
                           "a.MHD",
                           "a.img",
                           "a.HDR.gz",
                           "a.mgz",
                           "a.mgh"}) {
    EXPECT_TRUE(IsLabelImageFile(name)) << name;
  }
  for (const char* name :
       {"a.ply", "nii", ".nrrd", "a.gz", "a.nrrd.ply", "a.mgz.txt", ""}) {
    EXPECT_FALSE(IsLabelImageFile(name)) << name;
  }
}

#ifdef MUSCLEWARP_WITH_VTK
TEST(LabelImageFile, IsReadWithVtk) {
  EXPECT_NO_THROW(CheckLabelImagesAreRead("a.nii"));
}
#else
TEST(LabelImageFile, NeedsVtk) {
  ExpectInputError(
      [] { CheckLabelImagesAreRead("a.nii"); },
      {"a.nii: label images need VTK", "-DMUSCLEWARP_WITH_VTK=ON"});
  ExpectInputError([] { ReadLabelMeshes("a.nii", {}); },
                   {"a.nii: label images need VTK"});
}
#endif

}  // namespace musclewarp
