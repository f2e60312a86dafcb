// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/articulate_input.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/text.h"
#include "musclewarp/joints/bone_names.h"
#include "musclewarp/joints/bone_sides.h"
#include "musclewarp/label_images/label_image_file.h"
#include "musclewarp/label_images/label_meshes.h"
#include "musclewarp/label_images/label_table.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/mesh_files/mesh_path.h"
#include "musclewarp/mesh_files/stated_space.h"
#include "musclewarp/scene/scene_names.h"

namespace musclewarp {
namespace {

class ArticulateReader {
 public:
  ArticulateReader(const std::vector<std::string>& files,
                   const ArticulateOptions& options)
      : options_(options),
        labels_(OptionsOf<LabelSettings>(options)),
        named_bones_(Split(options.bone, ',')),
        muscle_files_(Split(options.muscles, ',')) {
    for (const std::string& file : files) {
      (IsLabelImageFile(file) ? images_ : meshes_).push_back(file);
    }
  }

  ArticulateInput Read() {
    for (const std::string& file : meshes_) CheckIsMeshOrImage(file);
    CheckImages();
    if (!options_.labels.empty()) {
      for (const LabelEntry& entry : ReadLabelTable(options_.labels)) {
        table_[entry.name] = entry;
      }
    }
    for (const std::string& file : meshes_)
      CheckNamedOnce(file, MeshNameOf(file));
    for (const std::string& file : muscle_files_) {
      CheckNamedOnce(file, MeshNameOf(file));
    }
    if (!images_.empty()) ReadImage();
    CheckSpaces();
    for (const std::string& file : meshes_) AddBoneFile(file);
    for (const std::string& file : muscle_files_) AddMuscleFile(file);
    return std::move(input_);
  }

 private:
  void CheckImages() const {
    if (images_.size() > 1) {
      throw InputError(
          images_[1],
          "is a second label image beside " + images_[0] + "; allowed: one",
          "join the images, or export meshes of one of them");
    }
    if (!images_.empty()) CheckLabelImagesAreRead(images_[0]);
  }

  // Bones are measured as they are, and the model names their files.
  void CheckSpaces() const {
    const StatedFile* first = nullptr;
    std::vector<StatedFile> files;
    const bool has_space = !input_.image.empty() && input_.is_oriented;
    if (has_space) files.push_back({input_.image, "LPS"});
    for (const auto* paths : {&meshes_, &muscle_files_}) {
      for (const std::string& path : *paths) {
        files.push_back({path, StatedSpace(path)});
      }
    }
    for (const StatedFile& file : files) {
      if (file.space.empty()) continue;
      if (!first) first = &file;
      if (file.space == first->space) continue;
      throw InputError(file.file,
                       "states the space " + file.space + ", and " +
                           first->file + " " + first->space +
                           "; allowed: one for all meshes",
                       "export all meshes in one space");
    }
  }

  void CheckNamedOnce(const std::string& where, const std::string& name) {
    CheckFileName(where, "mesh", name);
    const auto [other, is_new] = where_of_name_.emplace(name, where);
    if (is_new) return;
    throw InputError(
        where,
        "has the name " + QuotedName(name) + ", as " + other->second + " has",
        "meshes are named by their files without extension, and by the table "
        "of labels; rename one");
  }

  bool IsNamedBone(const std::string& name) const {
    return std::count(named_bones_.begin(), named_bones_.end(), name) > 0;
  }

  bool IsBone(const LabelEntry& entry) const {
    if (IsNamedBone(entry.name) || !entry.bone.empty()) return true;
    return entry.is_bone.value_or(ParseBoneName(entry.name).is_known);
  }

  // What the columns of the table and the name say of a bone.
  NamedBone DescribedBone(const LabelEntry& entry) const {
    NamedBone described = ParseBoneName(entry.name);
    const std::string where =
        options_.labels + ": " + QuotedName(entry.name) + ": column ";
    if (!entry.bone.empty()) {
      const std::optional<BoneKind> kind = ParseBoneKind(entry.bone);
      if (!kind) {
        std::string near;
        for (const std::string& known : NearestBoneNames(entry.bone)) {
          near += (near.empty() ? "" : ", ") + known;
        }
        throw InputError(
            where + "bone",
            "has " + QuotedName(entry.bone) + ", which is not known as a bone",
            "names near it: " + near);
      }
      described.is_known = true;
      described.kind = *kind;
    }
    if (!entry.side.empty()) {
      described.side = ParseSide(entry.side);
      if (!described.side) {
        throw InputError(where + "side",
                         "has " + QuotedName(entry.side),
                         "allowed: right, left, or nothing");
      }
    }
    return described;
  }

  PieceChoice PiecesOf(const LabelEntry& entry) const {
    if (!IsBone(entry)) return PieceChoice::kLargest;
    const NamedBone bone = DescribedBone(entry);
    const bool has_both_sides =
        bone.kind == BoneKind::kPelvis || (HasSide(bone.kind) && !bone.side);
    return has_both_sides ? PieceChoice::kAll : PieceChoice::kLargest;
  }

  void ReadImage() {
    input_.image = images_[0];
    LabelMeshOptions options = labels_;
    options.pieces_of = [this](const LabelEntry& entry) {
      return PiecesOf(entry);
    };
    LabelMeshes labels = ReadLabelMeshes(input_.image, options);
    input_.is_oriented = labels.frame == "LPS";
    input_.notes = labels.notes;
    CheckBonesAreLabels(labels);
    std::map<int, double> volume_of_label;
    for (const LabelMesh& mesh : labels.meshes) {
      volume_of_label[mesh.label] += mesh.volume;
    }
    constexpr double kLeastPiece = 0.01;
    for (LabelMesh& mesh : labels.meshes) {
      if (mesh.volume < kLeastPiece * volume_of_label[mesh.label]) continue;
      CheckNamedOnce(input_.image + ": label " + std::to_string(mesh.label),
                     mesh.name);
      ArticulateMesh source;
      source.name = mesh.name;
      source.soup = std::move(mesh.mesh);
      if (IsBone(mesh.entry)) {
        AddBone(std::move(source), mesh.entry);
      } else {
        source.origin = mesh.entry.origin;
        source.insertion = mesh.entry.insertion;
        input_.muscles.push_back(std::move(source));
      }
    }
  }

  void CheckBonesAreLabels(const LabelMeshes& labels) const {
    for (const std::string& bone : named_bones_) {
      std::string names;
      bool is_label = false;
      for (const LabelMesh& mesh : labels.meshes) {
        is_label = is_label || mesh.entry.name == bone;
        names += (names.empty() ? "" : ", ") + mesh.entry.name;
      }
      if (is_label) continue;
      throw InputError(
          "--bone",
          "has " + QuotedName(bone) + ", which is no label of " + input_.image,
          "the labels are " + names);
    }
  }

  void AddBoneFile(const std::string& file) {
    ArticulateMesh source;
    source.name = MeshNameOf(file);
    source.file = file;
    source.soup = ReadTriangleSoup(file);
    source.soup.points *= labels_.mm_per_unit;
    LabelEntry entry;
    entry.name = source.name;
    const auto row = table_.find(source.name);
    if (row != table_.end()) entry = row->second;
    AddBone(std::move(source), entry);
  }

  void AddBone(ArticulateMesh source, const LabelEntry& entry) {
    const NamedBone described = DescribedBone(entry);
    Bone bone;
    bone.name = source.name;
    bone.kind = described.kind;
    bone.side = described.side;
    bone.body = entry.body;
    bone.mesh = std::move(source.soup);
    source.soup = {};
    const bool is_stated = IsNamedBone(entry.name) || entry.is_bone;
    if (!described.is_known && !is_stated) {
      input_.notes.push_back(NoteOnUnknownBone(bone.name));
    }
    input_.bones.push_back(std::move(bone));
    input_.bone_sources.push_back(std::move(source));
  }

  void AddMuscleFile(const std::string& file) {
    ReadTriangleSoup(file);  // so that a bad file is found early
    ArticulateMesh source;
    source.name = MeshNameOf(file);
    source.file = file;
    const auto row = table_.find(source.name);
    if (row != table_.end()) {
      source.origin = row->second.origin;
      source.insertion = row->second.insertion;
    }
    input_.muscles.push_back(std::move(source));
  }

  const ArticulateOptions& options_;
  const LabelMeshOptions labels_;
  const std::vector<std::string> named_bones_, muscle_files_;
  std::vector<std::string> images_, meshes_;
  std::map<std::string, LabelEntry> table_;  // by name
  std::map<std::string, std::string> where_of_name_;
  ArticulateInput input_;
};

}  // namespace

ArticulateInput ReadArticulateInput(const std::vector<std::string>& files,
                                    const ArticulateOptions& options) {
  return ArticulateReader(files, options).Read();
}

}  // namespace musclewarp
