// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/flag_values.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/text.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/scene/length_unit.h"
#include "tools/split.h"

namespace musclewarp {
namespace {

BoneFiles ParseBones(const std::string& text) {
  for (const BoneFiles bones : {BoneFiles::kEvery, BoneFiles::kOnce}) {
    if (text == ToString(bones)) return bones;
  }
  throw InputError(
      "--bones=" + text, "is not a way to write bones", "allowed: every, once");
}

}  // namespace

SolverConfiguration ParseSolver(const std::string& text) {
  if (text != "ceres" && text != "reference") {
    throw InputError(
        "--solver=" + text, "is not a solver", "allowed: ceres, reference");
  }
  return SolverConfigurationNamed(text);
}

ContactKind ParseContact(const std::string& text) {
  for (const ContactKind kind :
       {ContactKind::kNone, ContactKind::kPaper, ContactKind::kCertified}) {
    if (text == ToString(kind)) return kind;
  }
  throw InputError("--contact=" + text,
                   "is not a kind of contact",
                   "allowed: certified, paper, none");
}

ContactLevel ParseContactLevel(const std::string& text) {
  if (text == "coarse") return ContactLevel::kCoarse;
  if (text == "fine") return ContactLevel::kFine;
  throw InputError(
      "--contact_level=" + text, "is not a level", "allowed: coarse, fine");
}

ReconstructionKind ParseRemake(const std::string& text) {
  if (text == "auto") return ReconstructionKind::kAuto;
  if (text == "never") return ReconstructionKind::kNever;
  throw InputError("--remake=" + text,
                   "is not a way to treat muscles that cannot be separated",
                   "allowed: auto, never");
}

LaplacianWeights ParseLaplacian(const std::string& text) {
  for (const LaplacianWeights weights :
       {LaplacianWeights::kArea, LaplacianWeights::kPaper}) {
    if (text == ToString(weights)) return weights;
  }
  throw InputError("--laplacian=" + text,
                   "is not a way to weigh the rows of a shape",
                   "allowed: area, paper");
}

LineRule ParseLines(const std::string& text) {
  for (const LineRule rule :
       {LineRule::kTendon, LineRule::kSlide, LineRule::kFixed}) {
    if (text == ToString(rule)) return rule;
  }
  throw InputError("--lines=" + text,
                   "is not a way to follow lines",
                   "allowed: tendon, slide, fixed");
}

AttachmentKind ParseAttachments(const std::string& text) {
  if (text == "auto") return AttachmentKind::kAuto;
  if (text == "scene") return AttachmentKind::kScene;
  if (text == "none") return AttachmentKind::kNone;
  throw InputError("--attachments=" + text,
                   "is not a choice of attachments",
                   "allowed: auto, scene, none");
}

std::vector<std::string> ParseFormats(const std::string& text) {
  const std::vector<std::string> formats = Split(text, ',');
  for (const std::string& format : formats) {
    if ((format != "ply" && format != "obj" && format != "vtp") ||
        !IsMeshExtension(format)) {
      throw InputError("--format=" + text,
                       "\"" + format + "\" cannot be written by this build",
                       "allowed: ply, obj, vtp (with VTK), or several with "
                       "commas");
    }
  }
  if (formats.empty()) {
    throw InputError("--format", "is empty", "allowed: ply, obj, vtp");
  }
  return formats;
}

FrameFileOptions ParseFrameFiles(const std::string& format,
                                 const std::string& bones) {
  FrameFileOptions files;
  files.formats = ParseFormats(format);
  files.bones = ParseBones(bones);
  const auto has_bones = [&](const std::string& f) {
    return files.HasBonesInFrames(f);
  };
  if (files.bones == BoneFiles::kOnce &&
      std::all_of(files.formats.begin(), files.formats.end(), has_bones)) {
    throw InputError("--bones=once",
                     "changes nothing with --format=" + format +
                         ": ParaView plays .vtp files as they are, so bones "
                         "have to be in every frame",
                     "add ply or obj to --format, or use --bones=every");
  }
  return files;
}

bool ParseYesNo(const std::string& flag, const std::string& text) {
  if (text == "yes" || text == "true") return true;
  if (text == "no" || text == "false") return false;
  throw InputError(flag + "=" + text, "is no answer", "allowed: yes, no");
}

std::vector<std::string> ParseFolders(const std::string& flag,
                                      const std::string& text) {
  std::vector<std::string> folders = Split(text, ',');
  for (const std::string& folder : folders) {
    if (std::filesystem::is_directory(folder)) continue;
    throw InputError(flag + "=" + text,
                     "\"" + folder + "\" is not a folder",
                     "give folders that exist, with commas between them");
  }
  return folders;
}

double ParseUnits(const std::string& text) {
  const std::optional<double> mm_per_unit = MillimetresPer(text);
  if (mm_per_unit) return *mm_per_unit;
  throw InputError("--units=" + text,
                   "is not a unit of length",
                   std::string("allowed: ") + kLengthUnits);
}

void CheckLabelEdge(double edge) {
  constexpr double kLongest = 100;  // mm
  if (edge >= 0 && edge <= kLongest) return;
  throw InputError("--edge",
                   "is " + NumberText(edge),
                   "allowed: 0 (twice a voxel) to 100 mm");
}

}  // namespace musclewarp
