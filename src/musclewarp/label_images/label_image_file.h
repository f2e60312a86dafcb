// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// Returns true if the name of a file is that of a label image: .nii, .nii.gz,
// .img or .hdr (.gz), .nrrd (including .seg.nrrd), .nhdr, .mha, .mhd, .mgz or
// .mgh, in upper or lower case. Does not read the file.
bool IsLabelImageFile(const std::string& path);

// Throws InputError, listing the formats of both, unless the name of a file is
// that of a mesh (mesh_io.h) or of a label image.
void CheckIsMeshOrImage(const std::string& path);

// Throws InputError, naming `path`, if this build cannot read label images
// because it was built without VTK.
void CheckLabelImagesAreRead(const std::string& path);

// The formats, for messages: ".nii, .nii.gz, .nrrd, ...".
constexpr char kLabelImageFormats[] =
    ".nii, .nii.gz, .img with .hdr, .nrrd, .nhdr, .mha, .mhd, .mgz, .mgh";

}  // namespace musclewarp
