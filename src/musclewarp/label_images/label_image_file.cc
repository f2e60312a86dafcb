// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/label_image_file.h"

#include <filesystem>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/mesh_files/mesh_path.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {

bool IsLabelImageFile(const std::string& path) {
  const std::string name = LowerCase(path);
  for (const std::string ending : {".nii",
                                   ".nii.gz",
                                   ".img",
                                   ".img.gz",
                                   ".hdr",
                                   ".hdr.gz",
                                   ".nrrd",
                                   ".nhdr",
                                   ".mha",
                                   ".mhd",
                                   ".mgz",
                                   ".mgh",
                                   ".mgh.gz"}) {
    if (name.size() > ending.size() &&
        name.compare(name.size() - ending.size(), ending.size(), ending) == 0) {
      return true;
    }
  }
  return false;
}

void CheckIsMeshOrImage(const std::string& path) {
  const std::string extension =
      std::filesystem::path(MeshFileOf(path)).extension().string();
  // The reader of .vtp files states their requirements.
  const bool is_mesh =
      IsMeshExtension(extension) || LowerCase(extension) == ".vtp";
  if (is_mesh || IsLabelImageFile(path)) return;
  throw InputError(path,
                   extension.empty()
                       ? "has no extension to tell its format"
                       : Quoted(extension) +
                             " is not a known format of meshes or label images",
                   "use " + MeshFormats() + " for a mesh, and " +
                       kLabelImageFormats + " for a label image");
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
