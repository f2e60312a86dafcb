// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/near_name.h"
#include "musclewarp/base/short_list.h"
#include "musclewarp/base/text.h"
#include "musclewarp/joints/bone_sides.h"
#include "musclewarp/label_images/label_image_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/mesh_files/mesh_path.h"
#include "musclewarp/mesh_files/stated_space.h"
#include "musclewarp/preparation/dropped_piece_warnings.h"
#include "musclewarp/preparation/muscle_pieces.h"
#include "musclewarp/scene/scene_names.h"
#include "musclewarp/subject/described_bone.h"
#include "musclewarp/subject/subject.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

class SubjectReader {
 public:
  SubjectReader(const SubjectInput& input, const LabelImage* image)
      : input_(input), image_(image) {
    if (!is_for_joints()) named_left_ = input.bones;
  }

  Subject Read() {
    CheckNames();
    FindImage();
    ReadTable();
    // Names are checked before the files are read, which may take long.
    if (!HasImage()) CheckBoneFiles();
    for (const std::string& file : files_) {
      if (!TakesApart()) CheckNamedOnce(file, MeshNameOf(file));
    }
    for (const std::string& file : input_.muscle_files) {
      CheckNamedOnce(file, MeshNameOf(file));
    }
    if (HasImage()) ReadImage();
    if (is_for_joints()) CheckNamedAreKnown();
    FindSpaces();
    for (const std::string& file : named_left_) AddBoneFile(file);
    for (const std::string& file : files_) {
      if (is_for_joints()) {
        AddBoneFile(file);
      } else if (TakesApart()) {
        AddPieces(file);
      } else {
        AddMuscleFile(file);
      }
    }
    for (const std::string& file : input_.muscle_files) AddMuscleFile(file);
    return std::move(subject_);
  }

 private:
  bool is_for_joints() const { return input_.use == SubjectUse::kJoints; }
  bool HasImage() const { return !subject_.image.empty(); }

  // Returns true if each piece of a file of muscles becomes a mesh.
  bool TakesApart() const {
    return !is_for_joints() && input_.labels.pieces == PieceChoice::kAll;
  }

  void CheckNames() const {
    if (std::count(input_.bones.begin(), input_.bones.end(), "") == 0) return;
    throw InputError("{bone}",
                     "has a comma without a name before it",
                     "allowed: mesh files and names of labels with commas "
                     "between them");
  }

  void FindImage() {
    if (image_) subject_.image = image_->path;
    for (const std::string& file : input_.files) {
      CheckIsMeshOrImage(file);
      if (!IsLabelImageFile(file)) {
        files_.push_back(file);
        continue;
      }
      if (HasImage()) {
        throw InputError(file,
                         "is a second label image beside " + subject_.image +
                             "; allowed: one",
                         "join the images, or export meshes of one of them");
      }
      CheckLabelImagesAreRead(file);
      subject_.image = file;
    }
    if (HasImage() || is_for_joints()) return;
    if (!input_.labels.table.empty()) {
      throw InputError("{labels}=" + input_.labels.table,
                       "names labels, and no file is a label image",
                       std::string("give an image (") + kLabelImageFormats +
                           "), or leave {labels} out");
    }
    if (input_.labels.edge_length > 0) {
      throw InputError("{edge}",
                       "is for the surfaces of labels, and no file is a label "
                       "image",
                       "leave {edge} out");
    }
  }

  // Reads the table, whose rows also describe mesh files by their names.
  void ReadTable() {
    if (input_.labels.table.empty()) return;
    rows_ = RowsOfTable(input_.labels);
    for (const LabelEntry& entry : rows_) table_[entry.name] = entry;
  }

  LabelEntry EntryOf(const std::string& name) const {
    const auto row = table_.find(name);
    if (row != table_.end()) return row->second;
    LabelEntry entry;
    entry.name = name;
    return entry;
  }

  bool IsNamed(const std::string& label) const {
    return std::count(input_.bones.begin(), input_.bones.end(), label) > 0;
  }

  bool IsBone(const LabelEntry& entry) const {
    if (IsNamed(entry.name)) return true;
    if (!is_for_joints()) return entry.is_bone.value_or(false);
    return !entry.bone.empty() ||
           entry.is_bone.value_or(ParseBoneName(entry.name).is_known);
  }

  PieceChoice PiecesOf(const LabelEntry& entry) const {
    if (!IsBone(entry)) return input_.labels.pieces;
    const NamedBone bone = DescribedBone(entry, input_.labels.table);
    const bool has_both_sides =
        bone.kind == BoneKind::kPelvis || (HasSide(bone.kind) && !bone.side);
    return has_both_sides ? PieceChoice::kAll : input_.labels.pieces;
  }

  void ReadImage() {
    LabelMeshOptions options = input_.labels;
    options.rows = rows_;
    if (is_for_joints()) {
      options.pieces_of = [this](const LabelEntry& entry) {
        return PiecesOf(entry);
      };
    }
    LabelMeshes& labels = subject_.labels;
    labels = image_ ? MeshesOfLabels(*image_, options)
                    : ReadLabelMeshes(subject_.image, options);
    subject_.notes = labels.notes;
    LeaveSmallPiecesOut();
    for (LabelMesh& label : labels.meshes) AddLabel(&label);
    if (is_for_joints()) return;
    CheckNamedAreFiles();
    CheckBoneFiles();
    if (subject_.muscles.empty() && files_.empty()) {
      throw InputError(subject_.image,
                       "has bones only, which do not move",
                       "correct {bone}, or the kinds in the table of labels");
    }
  }

  // Leaves small pieces of labels out, which are no bones.
  void LeaveSmallPiecesOut() {
    if (!is_for_joints()) return;
    constexpr double kLeastPiece = 0.01;  // of the volume of the label
    std::map<int, double> volumes;
    std::vector<LabelMesh>& meshes = subject_.labels.meshes;
    for (const LabelMesh& mesh : meshes) volumes[mesh.label] += mesh.volume;
    const auto is_small = [&](const LabelMesh& mesh) {
      return mesh.volume < kLeastPiece * volumes[mesh.label];
    };
    for (const LabelMesh& mesh : meshes) {
      if (!is_small(mesh)) continue;
      subject_.notes.push_back(mesh.name + " is left out: a piece of " +
                               MeasureText(mesh.volume / 1000) +
                               " cm3, less than 1 % of " +
                               QuotedName(mesh.entry.name));
    }
    meshes.erase(std::remove_if(meshes.begin(), meshes.end(), is_small),
                 meshes.end());
  }

  void AddLabel(LabelMesh* label) {
    CheckNamedOnce(subject_.image + ": label " + std::to_string(label->label),
                   label->name);
    SubjectMesh mesh;
    mesh.name = label->name;
    mesh.mesh = std::move(label->mesh);
    mesh.delivered_volume = label->delivered_volume;
    label->mesh = {};
    for (const std::string& name : {label->name, label->entry.name}) {
      const auto named =
          std::find(named_left_.begin(), named_left_.end(), name);
      if (named != named_left_.end()) named_left_.erase(named);
    }
    label->is_bone = IsBone(label->entry) || IsNamed(label->name);
    if (label->is_bone) {
      subject_.lost.push_back({label->name,
                               label->delivered_volume - label->volume,
                               label->delivered_volume});
      AddBone(std::move(mesh), label->entry);
    } else {
      AddMuscle(std::move(mesh), label->entry);
    }
  }

  // Throws InputError unless all named bones are labels or files.
  void CheckNamedAreKnown() const {
    std::vector<std::string> known;
    for (const LabelMesh& mesh : subject_.labels.meshes) {
      known.push_back(mesh.entry.name);
    }
    for (const std::string& file : files_) known.push_back(MeshNameOf(file));
    for (const std::string& bone : input_.bones) {
      if (std::count(known.begin(), known.end(), bone) > 0) continue;
      throw InputError(
          "{bone}",
          "has " + QuotedName(bone) + ", which is no label" +
              (HasImage() ? " of " + subject_.image : std::string(" or mesh")),
          DidYouMean(bone, known) + "the names are " + ShortList(known));
    }
  }

  // Throws InputError unless all named bones that are no labels are files.
  void CheckNamedAreFiles() const {
    for (const std::string& bone : named_left_) {
      std::error_code error;
      if (IsMeshExtension(fs::path(MeshFileOf(bone)).extension().string()) ||
          IsLabelImageFile(bone) || fs::exists(bone, error)) {
        continue;
      }
      std::vector<std::string> names;
      for (const LabelMesh& label : subject_.labels.meshes) {
        names.push_back(label.name);
      }
      throw InputError("{bone}",
                       "has " + QuotedName(bone) +
                           ", which is neither a label of " + subject_.image +
                           " nor a mesh file",
                       DidYouMean(bone, names) + "the labels are " +
                           ShortList(names, names.size()));
    }
  }

  void CheckBoneFiles() {
    for (const std::string& file : named_left_) {
      if (IsLabelImageFile(file)) {
        throw InputError("{bone}=" + file,
                         "is a label image; allowed: mesh files and names of "
                         "labels",
                         "give the image without {bone}, and the names of its "
                         "bones by {bone}");
      }
      CheckNamedOnce(file, MeshNameOf(file));
    }
  }

  // Finds the files that have to be turned. Surfaces of labels are in LPS if
  // the image is oriented.
  void FindSpaces() {
    std::vector<StatedFile> stated;
    if (HasImage()) {
      stated.push_back({subject_.image, subject_.IsOriented() ? "LPS" : ""});
    }
    for (const std::vector<std::string>& files :
         {files_, input_.muscle_files, named_left_}) {
      for (const std::string& file : files) {
        stated.push_back({file, StatedSpace(file)});
      }
    }
    if (is_for_joints()) {
      CheckOneSpace(stated);
      return;
    }
    CommonSpace common = FindCommonSpace(stated);
    for (size_t i = 0; i < stated.size(); ++i) {
      if (common.is_turned[i]) turned_.insert(stated[i].file);
    }
    subject_.warnings = std::move(common.warnings);
  }

  SubjectMesh ReadFile(const std::string& file) const {
    SubjectMesh mesh;
    mesh.name = MeshNameOf(file);
    mesh.file = file;
    mesh.is_turned = turned_.count(file) > 0;
    mesh.mesh = ReadTriangleSoup(file);
    mesh.mesh.points *= input_.labels.mm_per_unit;
    return mesh;
  }

  void AddBoneFile(const std::string& file) {
    AddBone(ReadFile(file), EntryOf(MeshNameOf(file)));
  }

  void AddMuscleFile(const std::string& file) {
    AddMuscle(ReadFile(file), EntryOf(MeshNameOf(file)));
  }

  void AddBone(SubjectMesh mesh, const LabelEntry& entry) {
    if (is_for_joints()) {
      mesh.bone = DescribedBone(entry, input_.labels.table);
      mesh.body = entry.body;
      if (!mesh.bone.is_known && !IsNamed(entry.name) && !entry.is_bone) {
        subject_.notes.push_back(NoteOnUnknownBone(mesh.name));
      }
    }
    subject_.bones.push_back(std::move(mesh));
  }

  void AddMuscle(SubjectMesh mesh, const LabelEntry& entry) {
    mesh.origin = entry.origin;
    mesh.insertion = entry.insertion;
    subject_.muscles.push_back(std::move(mesh));
  }

  // Adds each piece of a file. If the file is a single closed piece, it is
  // added as a file.
  void AddPieces(const std::string& file) {
    SceneMuscle whole;
    whole.name = MeshNameOf(file);
    whole.mesh_path = file;
    whole.mm_per_unit = input_.labels.mm_per_unit;
    whole.is_turned = turned_.count(file) > 0;
    MusclePieces found = PiecesOfMuscle(whole, input_.repair);
    const std::vector<DroppedPiece>& dropped = found.repairs.dropped_pieces;
    const bool has_open =
        std::any_of(dropped.begin(), dropped.end(), [](const auto& piece) {
          return piece.reason == DropReason::kOpen;
        });
    if (found.pieces.size() == 1 && !has_open) {
      CheckNamedOnce(file, whole.name);
      AddMuscleFile(file);
      return;
    }
    LostVolume lost = {whole.name, TotalsOf(dropped).volume, 0};
    lost.delivered = lost.volume;
    for (MusclePiece& piece : found.pieces) {
      CheckNamedOnce(file, piece.name);
      lost.delivered += piece.volume;
      SubjectMesh mesh;
      mesh.name = piece.name;
      mesh.mesh = std::move(piece.mesh);
      AddMuscle(std::move(mesh), EntryOf(piece.name));
    }
    subject_.lost.push_back(lost);
    std::vector<std::string>& warnings = subject_.warnings;
    warnings.insert(warnings.end(), found.notes.begin(), found.notes.end());
    for (std::string& warning :
         DroppedPieceWarnings(whole.name, found.repairs)) {
      warnings.push_back(std::move(warning));
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

  const SubjectInput& input_;
  const LabelImage* image_;                  // in memory, or null
  std::vector<std::string> files_;           // without the image
  std::vector<std::string> named_left_;      // named bones that are no labels
  std::vector<LabelEntry> rows_;             // of the table
  std::map<std::string, LabelEntry> table_;  // by name
  std::map<std::string, std::string> where_of_name_;
  std::set<std::string> turned_;  // files of another space than the others
  Subject subject_;
};

}  // namespace

Subject ReadSubject(const SubjectInput& input) {
  return SubjectReader(input, nullptr).Read();
}

Subject ReadSubject(const SubjectInput& input, const LabelImage& image) {
  return SubjectReader(input, &image).Read();
}

}  // namespace musclewarp
