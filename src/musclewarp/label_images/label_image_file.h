// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// True if a file is a label image by its name: .nii, .nii.gz, .img or .hdr
// (.gz), .nrrd (with it .seg.nrrd), .nhdr, .mha, .mhd, .mgz or .mgh, in any
// case. Nothing is read.
bool IsLabelImageFile(const std::string& path);

// Throws InputError that lists the formats of both unless a file is a mesh
// (mesh_io.h) or a label image by its name.
void CheckIsMeshOrImage(const std::string& path);

// Throws InputError, with the place `path`, if this build reads no label images
// because it was built without VTK.
void CheckLabelImagesAreRead(const std::string& path);

// The formats, for messages: ".nii, .nii.gz, .nrrd, ...".
constexpr char kLabelImageFormats[] =
    ".nii, .nii.gz, .img with .hdr, .nrrd, .nhdr, .mha, .mhd, .mgz, .mgh";

}  // namespace musclewarp
