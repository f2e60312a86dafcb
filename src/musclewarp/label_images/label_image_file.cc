// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/label_image_file.h"

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {

bool IsLabelImageFile(const std::string& path) {
  const std::string name = LowerCase(path);
  for (const std::string ending :
       {".nii", ".nii.gz", ".nrrd", ".nhdr", ".mha", ".mhd"}) {
    if (name.size() > ending.size() &&
        name.compare(name.size() - ending.size(), ending.size(), ending) == 0) {
      return true;
    }
  }
  return false;
}

void CheckLabelImagesAreRead([[maybe_unused]] const std::string& path) {
#ifndef MUSCLEWARP_WITH_VTK
  throw InputError(
      path,
      "label images need VTK, which this build of musclewarp lacks",
      "build with -DMUSCLEWARP_WITH_VTK=ON, or export meshes of the labels");
#endif
}

}  // namespace musclewarp
