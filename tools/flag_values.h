// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/deformer/deformer.h"
#include "musclewarp/run/frame_files.h"

namespace musclewarp {

// Convert the text of a flag to its value. Throw InputError that names the flag
// and what is allowed.
SolverConfiguration ParseSolver(const std::string& text);
ContactKind ParseContact(const std::string& text);
ContactLevel ParseContactLevel(const std::string& text);
ReconstructionKind ParseRemake(const std::string& text);
LaplacianWeights ParseLaplacian(const std::string& text);
LineRule ParseLines(const std::string& text);
AttachmentKind ParseAttachments(const std::string& text);
std::vector<std::string> ParseFormats(const std::string& text);

// Convert the texts of --format and --bones, which have to fit each other.
FrameFileOptions ParseFrameFiles(const std::string& format,
                                 const std::string& bones);

// Convert the text of the flag `flag`: "yes" or "no", and folders with commas,
// which have to exist.
bool ParseYesNo(const std::string& flag, const std::string& text);
std::vector<std::string> ParseFolders(const std::string& flag,
                                      const std::string& text);

// Throws InputError, naming --edge, unless the edge of the surfaces of labels
// is 0 (twice a voxel) to 100 mm.
void CheckLabelEdge(double edge);

// Returns the millimetres in the unit that --units names.
double ParseUnits(const std::string& text);

}  // namespace musclewarp
