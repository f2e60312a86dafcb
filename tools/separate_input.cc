// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/separate_input.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/text.h"
#include "musclewarp/label_images/label_image_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/mesh_files/mesh_path.h"
#include "musclewarp/mesh_files/stated_space.h"
#include "musclewarp/preparation/dropped_piece_warnings.h"
#include "musclewarp/preparation/muscle_pieces.h"
#include "musclewarp/scene/scene_names.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// A mesh before it is in the scene: of a file, or of a label.
struct InputMesh {
  std::string name;
  std::string where;  // for messages: the file, or the image and the label
  std::string file;   // empty for a label
  TriangleSoup soup;  // empty for a file
  double delivered_volume = 0;  // mm^3, of a label
};

class InputReader {
 public:
  InputReader(const std::vector<std::string>& files,
              const SeparateOptions& options)
      : files_(files),
        options_(options),
        labels_(OptionsOf<LabelSettings>(options)),
        bones_left_(Split(options.bone, ',')) {}

  SeparateInput Read() {
    FindImage();
    // Names come before anything is read, which may take long. Those of --bone
    // may be labels if there is an image.
    if (input_.image.empty()) CheckBoneFiles();
    if (labels_.pieces == PieceChoice::kLargest) {
      for (const std::string& file : files_) {
        if (file != input_.image) CheckNamedOnce(file, MeshNameOf(file));
      }
    }
    if (!input_.image.empty()) ReadImage();
    FindSpaces();
    for (const std::string& file : bones_left_) {
      AddBone({MeshNameOf(file), file, file, {}});
    }
    for (const std::string& file : files_) {
      if (file == input_.image) continue;
      if (labels_.pieces == PieceChoice::kAll) {
        AddPieces(file);
      } else {
        AddMuscle({MeshNameOf(file), file, file, {}});
      }
    }
    input_.scene.name = "the files";
    return std::move(input_);
  }

 private:
  void FindImage() {
    for (const std::string& file : files_) {
      CheckIsMeshOrImage(file);
      if (!IsLabelImageFile(file)) continue;
      CheckLabelImagesAreRead(file);
      if (!input_.image.empty()) {
        throw InputError(
            file,
            "is a second label image beside " + input_.image + "; allowed: one",
            "join the images, or export meshes of one of them");
      }
      input_.image = file;
    }
    if (!input_.image.empty()) return;
    if (!options_.labels.empty()) {
      throw InputError("--labels=" + options_.labels,
                       "names labels, and no file is a label image",
                       std::string("give an image (") + kLabelImageFormats +
                           "), or leave --labels out");
    }
    if (options_.edge > 0) {
      throw InputError("--edge",
                       "is for the surfaces of labels, and no file is a label "
                       "image",
                       "leave --edge out");
    }
  }

  void ReadImage() {
    input_.labels = ReadLabelMeshes(input_.image, labels_);
    std::vector<InputMesh> muscles;
    for (LabelMesh& label : input_.labels.meshes) {
      InputMesh mesh = {label.name,
                        input_.image + ": label " + std::to_string(label.label),
                        "",
                        std::move(label.mesh),
                        label.delivered_volume};
      CheckNamedOnce(mesh.where, mesh.name);
      const auto named =
          std::find(bones_left_.begin(), bones_left_.end(), label.name);
      if (named != bones_left_.end()) {
        bones_left_.erase(named);
        label.is_bone = true;
      }
      if (label.is_bone) {
        AddBone(std::move(mesh));
      } else {
        muscles.push_back(std::move(mesh));
      }
    }
    CheckBonesAreFiles();
    CheckBoneFiles();
    for (InputMesh& mesh : muscles) AddMuscle(std::move(mesh));
    if (input_.scene.muscles.empty() && files_.size() == 1) {
      throw InputError(input_.image,
                       "has bones only, which do not move",
                       "correct --bone, or the kinds in the table of labels");
    }
  }

  // Surfaces of labels are in LPS, unless the image does not say so.
  void FindSpaces() {
    std::vector<StatedFile> stated;
    if (!input_.image.empty()) {
      stated.push_back(
          {input_.image, input_.labels.frame == "LPS" ? "LPS" : ""});
    }
    for (const std::string& file : files_) {
      if (file != input_.image) stated.push_back({file, StatedSpace(file)});
    }
    for (const std::string& file : bones_left_) {
      stated.push_back({file, StatedSpace(file)});
    }
    CommonSpace common = FindCommonSpace(stated);
    for (size_t i = 0; i < stated.size(); ++i) {
      if (common.is_turned[i]) turned_.insert(stated[i].file);
    }
    input_.scene.warnings = std::move(common.warnings);
  }

  // A name that is no label has to be a file.
  void CheckBonesAreFiles() const {
    for (const std::string& bone : bones_left_) {
      std::error_code error;
      if (IsMeshExtension(fs::path(MeshFileOf(bone)).extension().string()) ||
          IsLabelImageFile(bone) || fs::exists(bone, error)) {
        continue;
      }
      std::string names;
      for (const LabelMesh& label : input_.labels.meshes) {
        names += (names.empty() ? "" : ", ") + label.name;
      }
      throw InputError("--bone",
                       "has " + QuotedName(bone) +
                           ", which is neither a label of " + input_.image +
                           " nor a mesh file",
                       "the labels are " + names);
    }
  }

  void CheckBoneFiles() {
    for (const std::string& file : bones_left_) {
      if (IsLabelImageFile(file)) {
        throw InputError("--bone=" + file,
                         "is a label image; allowed: mesh files and names of "
                         "labels",
                         "give the image without --bone, and the names of its "
                         "bones by --bone");
      }
      CheckNamedOnce(file, MeshNameOf(file));
    }
  }

  void AddBone(InputMesh mesh) {
    SceneBone bone;
    bone.name = mesh.name;
    bone.body = mesh.name;
    bone.mesh_path = mesh.file;
    bone.is_turned = turned_.count(mesh.file) > 0;
    if (!mesh.file.empty()) {
      ReadTriangleSoup(mesh.file);
      bone.rest_from_file.diagonal().head<3>().setConstant(labels_.mm_per_unit);
    }
    bone.points = std::move(mesh.soup.points);
    bone.triangles = std::move(mesh.soup.triangles);
    input_.scene.bones.push_back(std::move(bone));
  }

  void AddMuscle(InputMesh mesh) {
    SceneMuscle muscle;
    muscle.name = mesh.name;
    muscle.mesh_path = mesh.file;
    muscle.is_turned = turned_.count(mesh.file) > 0;
    if (!mesh.file.empty()) {
      muscle.mm_per_unit = labels_.mm_per_unit;
      ReadTriangleSoup(mesh.file);
    }
    muscle.delivered_volume = mesh.delivered_volume;
    muscle.points = std::move(mesh.soup.points);
    muscle.triangles = std::move(mesh.soup.triangles);
    input_.scene.muscles.push_back(std::move(muscle));
  }

  // Adds each piece of a file. One that is all of the file is read later, as
  // with the other choice.
  void AddPieces(const std::string& file) {
    SceneMuscle whole;
    whole.name = MeshNameOf(file);
    whole.mesh_path = file;
    whole.mm_per_unit = labels_.mm_per_unit;
    whole.is_turned = turned_.count(file) > 0;
    MusclePieces found = PiecesOfMuscle(
        whole, OptionsOf<SeparationSettings>(options_).prepare.repair);
    const std::vector<DroppedPiece>& dropped = found.repairs.dropped_pieces;
    const bool has_open =
        std::any_of(dropped.begin(), dropped.end(), [](const auto& piece) {
          return piece.reason == DropReason::kOpen;
        });
    if (found.pieces.size() == 1 && !has_open) {
      CheckNamedOnce(file, whole.name);
      AddMuscle({whole.name, file, file, {}});
      return;
    }
    LostPieces lost = {whole.name, TotalsOf(dropped).volume, 0};
    lost.delivered = lost.volume;
    for (MusclePiece& piece : found.pieces) {
      CheckNamedOnce(file, piece.name);
      lost.delivered += piece.volume;
      AddMuscle({piece.name, file, "", std::move(piece.mesh)});
    }
    input_.lost.push_back(lost);
    std::vector<std::string>& warnings = input_.scene.warnings;
    warnings.insert(warnings.end(), found.notes.begin(), found.notes.end());
    for (std::string& warning :
         DroppedPieceWarnings(whole.name, found.repairs)) {
      warnings.push_back(std::move(warning));
    }
  }

  // Throws InputError unless a mesh has a name of its own, and its result does
  // not replace the file.
  void CheckNamedOnce(const std::string& where, const std::string& name) {
    CheckFileName(where, "mesh", name);
    const auto [other, is_new] = where_of_name_.emplace(name, where);
    if (!is_new) {
      throw InputError(
          where,
          "has the name " + QuotedName(name) + ", as " + other->second + " has",
          "meshes are named by their files without extension, and by the table "
          "of labels; rename one");
    }
    for (const std::string& format : OptionsOf<FormatSettings>(options_)) {
      const fs::path result = fs::path(options_.out) / (name + "." + format);
      std::error_code error;
      if (!fs::equivalent(result, MeshFileOf(where), error)) continue;
      throw InputError("--out=" + options_.out,
                       "has the input " + where + ", which would be replaced",
                       "choose another folder");
    }
  }

  const std::vector<std::string>& files_;
  const SeparateOptions& options_;
  LabelMeshOptions labels_;
  std::vector<std::string> bones_left_;  // that are no labels
  std::map<std::string, std::string> where_of_name_;
  std::set<std::string> turned_;  // files of another space than the others
  SeparateInput input_;
};

}  // namespace

SeparateInput ReadSeparateInput(const std::vector<std::string>& files,
                                const SeparateOptions& options) {
  return InputReader(files, options).Read();
}

}  // namespace musclewarp
