// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/label_meshes.h"

#include "musclewarp/label_images/label_image_file.h"
#include "musclewarp/label_images/label_table.h"
#ifdef MUSCLEWARP_WITH_VTK
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/short_list.h"
#include "musclewarp/label_images/label_regions.h"
#include "musclewarp/label_images/label_surface.h"
#include "musclewarp/scene/scene_names.h"
#endif

namespace musclewarp {

std::vector<LabelEntry> RowsOfTable(const LabelMeshOptions& options) {
  return options.rows.empty() ? ReadLabelTable(options.table) : options.rows;
}

bool IsLossWorthANote(double lost_volume, double voxel_volume) {
  constexpr double kLostWorthANote = 0.02;  // of the voxels
  return lost_volume > kLostWorthANote * voxel_volume;
}

#ifdef MUSCLEWARP_WITH_VTK
namespace {

// An image with more labels, and without a table, is not a segmentation.
constexpr std::size_t kMostLabels = 1000;

// The default edge length of triangles, in edges of a cube with the volume of a
// voxel.
constexpr double kEdgesOfVoxel = 2;

// Larger boxes take too much memory: about 20 bytes per voxel.
constexpr double kMostBoxVoxels = 3e8;

using Boxes = std::map<int, LabelBox>;

// Returns a row for every label of the image, which replaces the table.
std::vector<LabelEntry> EntriesOf(const LabelImage& image, const Boxes& boxes) {
  if (boxes.size() > kMostLabels) {
    throw InputError(
        image.path,
        "has " + std::to_string(boxes.size()) +
            " different values above 0; allowed: at most 1000 labels",
        "export the segmentation as a label map, or name the labels that are "
        "meant by {labels}");
  }
  std::vector<LabelEntry> entries;
  std::set<std::string> names;
  for (const auto& [label, box] : boxes) {
    LabelEntry entry;
    entry.label = label;
    const auto name = image.grid.names.find(label);
    entry.name = name == image.grid.names.end()
                     ? "label_" + std::to_string(label)
                     : name->second;
    const std::string where = image.path + ": label " + std::to_string(label);
    CheckFileName(where, "label", entry.name);
    if (!names.insert(entry.name).second) {
      throw InputError(
          where,
          "has the name " + QuotedName(entry.name) + ", as another label has",
          "name the labels by {labels}");
    }
    entries.push_back(entry);
  }
  return entries;
}

// "label 3 (femur)" or "3 labels (4 (tibia), 5 (fibula), 6 (patella))".
std::string LabelsText(const std::vector<LabelEntry>& entries,
                       const std::string& kind) {
  std::vector<std::string> texts;
  for (const LabelEntry& entry : entries) {
    texts.push_back(std::to_string(entry.label) + " (" + entry.name + ")");
  }
  return texts.size() == 1 ? kind + " " + texts[0]
                           : std::to_string(texts.size()) + " " + kind +
                                 "s: " + ShortList(texts);
}

// Returns the rows of the table whose labels occur in the image, by label. Adds
// labels that occur in only one of them to `notes`.
std::vector<LabelEntry> EntriesInBoth(const LabelImage& image,
                                      const Boxes& boxes,
                                      const LabelMeshOptions& options,
                                      std::vector<std::string>* notes) {
  const std::string& table = options.table;
  std::vector<LabelEntry> entries, absent;
  std::set<int> named;
  for (const LabelEntry& entry : RowsOfTable(options)) {
    named.insert(entry.label);
    (boxes.count(entry.label) ? entries : absent).push_back(entry);
  }
  if (!absent.empty()) {
    notes->push_back("not in the image, but in " + table + ": " +
                     LabelsText(absent, "label"));
  }
  std::vector<std::string> unnamed;
  for (const auto& [label, box] : boxes) {
    if (!named.count(label)) unnamed.push_back(std::to_string(label));
  }
  if (entries.empty()) {
    throw InputError(table,
                     "has none of the labels of " + image.path + " (" +
                         ShortList(unnamed) + ")",
                     "check that the table belongs to the image");
  }
  if (!unnamed.empty()) {
    notes->push_back("labels of the image that are not in " + table +
                     " are left out: " + ShortList(unnamed));
  }
  std::sort(entries.begin(),
            entries.end(),
            [](const LabelEntry& a, const LabelEntry& b) {
              return a.label < b.label;
            });
  return entries;
}

std::string Cm3(double volume) {
  std::ostringstream text;
  text << volume / 1000 << " cm3";
  return text.str();
}

// Makes the meshes of a label, with notes on pieces that are left out or
// separated and on cavities that are filled.
class MeshesOfLabel {
 public:
  MeshesOfLabel(const LabelImage& image,
                const LabelEntry& entry,
                const LabelMeshOptions& options,
                std::vector<std::string>* notes)
      : image_(image),
        entry_(entry),
        options_(options),
        voxel_(image.grid.VoxelVolume()),
        notes_(notes) {}

  // Returns the number of voxels of the largest piece, including cavities.
  std::int64_t LargestPiece(const LabelBox& box) const {
    CheckBoxFits(box);
    return PiecesOfLabel(image_, entry_.label, box).regions[0].voxels;
  }

  std::vector<LabelMesh> Make(const LabelBox& box) {
    CheckBoxFits(box);
    LabelPieces pieces = PiecesOfLabel(image_, entry_.label, box);
    const size_t found = pieces.regions.size();
    std::int64_t left_out = pieces.small_voxels;
    const PieceChoice choice =
        options_.pieces_of ? options_.pieces_of(entry_) : options_.pieces;
    if (choice == PieceChoice::kLargest) {
      for (size_t i = 1; i < found; ++i) {
        left_out += pieces.regions[i].voxels - pieces.regions[i].cavity_voxels;
      }
      pieces.regions.resize(1);
    }
    NotePieces(pieces, found, left_out);
    std::vector<LabelMesh> meshes;
    for (size_t i = 0; i < pieces.regions.size(); ++i) {
      const std::string name = pieces.regions.size() == 1
                                   ? entry_.name
                                   : entry_.name + "_" + std::to_string(i + 1);
      meshes.push_back(MeshOf(pieces.regions[i], name));
    }
    // Voxels of pieces that do not become meshes count as lost by the largest.
    meshes[0].delivered_volume += static_cast<double>(left_out) * voxel_;
    return meshes;
  }

 private:
  void Note(const std::string& name, const std::string& text) {
    notes_->push_back(name + " (label " + std::to_string(entry_.label) + ") " +
                      text);
  }

  // Returns the place that messages name.
  std::string Where(const std::string& name) const {
    return image_.path + ": label " + std::to_string(entry_.label) + " (" +
           name + ")";
  }

  void CheckBoxFits(const LabelBox& box) const {
    const Eigen::Array3i size = box.highest - box.lowest + 1;
    if (size.cast<double>().prod() <= kMostBoxVoxels) return;
    std::ostringstream problem;
    problem << "spans " << size[0] << " x " << size[1] << " x " << size[2]
            << " voxels; allowed: " << kMostBoxVoxels << " in all";
    throw InputError(Where(entry_.name),
                     problem.str(),
                     "crop the image, or save it with larger voxels");
  }

  void NotePieces(const LabelPieces& kept,
                  size_t found,
                  std::int64_t left_out) {
    const size_t all = found + kept.small_pieces;
    if (all == 1) return;
    std::string text =
        "has " + std::to_string(all) +
        " pieces, which do not hang together by faces of voxels: ";
    if (kept.regions.size() == 1) {
      text += "the largest, of " +
              Cm3(static_cast<double>(kept.regions[0].voxels) * voxel_) +
              ", is kept";
    } else {
      text += std::to_string(kept.regions.size()) + " become meshes";
    }
    const size_t others = all - kept.regions.size();
    if (others > 0) {
      text += "; " + Cm3(static_cast<double>(left_out) * voxel_) + " in " +
              std::to_string(others) +
              (others == 1 ? " other is left out" : " others are left out");
      if (kept.regions.size() == found) {
        text +=
            ", each of fewer than " + std::to_string(kFewestVoxels) + " voxels";
      } else if (!options_.pieces_of) {
        text += "; {pieces}=all makes a mesh of each";
      }
    }
    Note(entry_.name, text);
  }

  LabelMesh MeshOf(const LabelRegion& region, const std::string& name) {
    LabelSurface surface = SurfaceOfRegion(
        Where(name),
        region,
        image_.grid,
        options_.edge_length > 0 ? options_.edge_length
                                 : kEdgesOfVoxel * std::cbrt(voxel_));
    if (region.cavity_voxels > 0) {
      Note(name,
           "has cavities of " +
               Cm3(static_cast<double>(region.cavity_voxels) * voxel_) +
               ", which are filled");
    }
    LabelMesh mesh;
    mesh.label = entry_.label;
    mesh.name = name;
    mesh.is_bone = entry_.is_bone.value_or(false);
    mesh.entry = entry_;
    mesh.mesh = std::move(surface.mesh);
    mesh.voxel_volume = static_cast<double>(region.voxels) * voxel_;
    mesh.volume = surface.volume;
    mesh.delivered_volume = mesh.voxel_volume;
    if (IsLossWorthANote(surface.lost_volume, mesh.voxel_volume)) {
      Note(name,
           "loses " + Cm3(surface.lost_volume) +
               ": parts that are so thin, or hang on the rest by so little, "
               "that the smoothed surface does not hold them");
    }
    return mesh;
  }

  const LabelImage& image_;
  const LabelEntry& entry_;
  const LabelMeshOptions& options_;
  const double voxel_;  // mm^3
  std::vector<std::string>* notes_;
};

constexpr char kLeaveOut[] =
    "leave them out by {labels}=TABLE, a table of the other labels (lines such "
    "as 3,femur,bone), or remove them from the image";

// Throws InputError that names all labels that are too small for a surface.
void CheckAreLargeEnough(const LabelImage& image,
                         const Boxes& boxes,
                         const std::vector<LabelEntry>& entries) {
  std::vector<LabelEntry> small;
  std::int64_t voxels = 0;
  for (const LabelEntry& entry : entries) {
    const LabelMeshOptions options;
    std::vector<std::string> notes;
    const std::int64_t largest = MeshesOfLabel(image, entry, options, &notes)
                                     .LargestPiece(boxes.at(entry.label));
    if (largest >= kFewestVoxels) continue;
    small.push_back(entry);
    voxels = std::max(voxels, largest);
  }
  if (small.empty()) return;
  const bool is_one = small.size() == 1;
  throw InputError(image.path,
                   LabelsText(small, "label") +
                       (is_one ? " has " : ": none has more than ") +
                       std::to_string(voxels) +
                       " voxels in one piece; allowed: at least " +
                       std::to_string(kFewestVoxels),
                   kLeaveOut);
}

// Adds a note about the segments of the file (.seg.nrrd) without voxels.
void NoteEmptySegments(const LabelImage& image,
                       const Boxes& boxes,
                       std::vector<std::string>* notes) {
  std::vector<LabelEntry> empty;
  for (const auto& [label, name] : image.grid.names) {
    if (label > 0 && !boxes.count(label)) {
      LabelEntry entry;
      entry.label = label;
      entry.name = name;
      empty.push_back(entry);
    }
  }
  if (empty.empty()) return;
  notes->push_back("named in " + image.path +
                   ", but without voxels: " + LabelsText(empty, "segment"));
}

// Throws InputError for the labels for which no surface could be made.
void ThrowRefused(const LabelImage& image,
                  const std::vector<InputError>& refused) {
  if (refused.empty()) return;
  if (refused.size() == 1) throw refused[0];
  std::vector<std::string> texts;
  for (const InputError& error : refused) {
    std::string where = error.where();
    if (where.rfind(image.path + ": ", 0) == 0) {
      where = where.substr(image.path.size() + 2);
    }
    texts.push_back(where + " " + error.problem());
  }
  throw InputError(image.path,
                   std::to_string(refused.size()) +
                       " labels become no surfaces: " + ShortList(texts),
                   kLeaveOut);
}

}  // namespace

LabelMeshes ReadLabelMeshes(const std::string& path,
                            const LabelMeshOptions& options) {
  return MeshesOfLabels(ReadLabelImage(path, options.mm_per_unit), options);
}

LabelMeshes MeshesOfLabels(const LabelImage& image,
                           const LabelMeshOptions& options) {
  const Boxes boxes = BoxesOfLabels(image);
  if (boxes.empty()) {
    throw InputError(
        image.path, "has no label above 0", "export the label map again");
  }
  LabelMeshes result;
  result.frame = image.grid.is_oriented ? "LPS" : "of the file";
  result.notes = image.notes;
  const std::vector<LabelEntry> entries =
      options.table.empty()
          ? EntriesOf(image, boxes)
          : EntriesInBoth(image, boxes, options, &result.notes);
  if (options.table.empty()) NoteEmptySegments(image, boxes, &result.notes);
  CheckAreLargeEnough(image, boxes, entries);
  std::vector<InputError> refused;
  for (const LabelEntry& entry : entries) {
    try {
      for (LabelMesh& mesh : MeshesOfLabel(image, entry, options, &result.notes)
                                 .Make(boxes.at(entry.label))) {
        result.meshes.push_back(std::move(mesh));
      }
    } catch (const InputError& error) {
      refused.push_back(error);
    }
  }
  ThrowRefused(image, refused);
  return result;
}
#else
LabelMeshes ReadLabelMeshes(const std::string& path, const LabelMeshOptions&) {
  CheckLabelImagesAreRead(path);
  return {};
}

LabelMeshes MeshesOfLabels(const LabelImage& image, const LabelMeshOptions&) {
  CheckLabelImagesAreRead(image.path);
  return {};
}
#endif

}  // namespace musclewarp
