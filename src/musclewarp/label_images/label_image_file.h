// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// True if a file is a label image by its name: .nii, .nii.gz, .nrrd (with it
// .seg.nrrd), .nhdr, .mha or .mhd, in any case. Nothing is read.
bool IsLabelImageFile(const std::string& path);

// Throws InputError, with the place `path`, if this build reads no label images
// because it was built without VTK.
void CheckLabelImagesAreRead(const std::string& path);

// The formats, for messages: ".nii, .nii.gz, .nrrd, ...".
constexpr char kLabelImageFormats[] = ".nii, .nii.gz, .nrrd, .nhdr, .mha, .mhd";

}  // namespace musclewarp
