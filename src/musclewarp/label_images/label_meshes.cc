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
#include "musclewarp/label_images/label_image.h"
#include "musclewarp/label_images/label_regions.h"
#include "musclewarp/label_images/label_surface.h"
#include "musclewarp/scene/scene_names.h"
#endif

namespace musclewarp {

#ifdef MUSCLEWARP_WITH_VTK
namespace {

// More without a table is no segmentation, but an image.
constexpr std::size_t kMostLabels = 1000;

// The edges of triangles, in edges of a cube with the volume of a voxel.
constexpr double kEdgesOfVoxel = 2;

// A smaller share of a label that is lost is not worth a note.
constexpr double kLostWorthANote = 0.02;

using Boxes = std::map<int, LabelBox>;

// Returns a row for every label of the image, for want of a table.
std::vector<LabelEntry> EntriesOf(const LabelImage& image, const Boxes& boxes) {
  if (boxes.size() > kMostLabels) {
    throw InputError(
        image.path,
        "has " + std::to_string(boxes.size()) +
            " different values above 0; allowed: at most 1000 labels",
        "export the segmentation as a label map, or name the labels that are "
        "meant by --labels");
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
          "name the labels by --labels");
    }
    entries.push_back(entry);
  }
  return entries;
}

// Returns the rows of the table whose labels the image has, by label. What one
// of them has and the other has not goes to `notes`.
std::vector<LabelEntry> EntriesInBoth(const LabelImage& image,
                                      const Boxes& boxes,
                                      const std::string& table,
                                      std::vector<std::string>* notes) {
  std::vector<LabelEntry> entries;
  std::set<int> named;
  for (const LabelEntry& entry : ReadLabelTable(table)) {
    named.insert(entry.label);
    if (boxes.count(entry.label)) {
      entries.push_back(entry);
    } else {
      notes->push_back("label " + std::to_string(entry.label) + " (" +
                       entry.name + ") of " + table + " is not in the image");
    }
  }
  std::string unnamed;
  for (const auto& [label, box] : boxes) {
    if (named.count(label)) continue;
    unnamed += (unnamed.empty() ? "" : ", ") + std::to_string(label);
  }
  if (entries.empty()) {
    throw InputError(table,
                     "has none of the labels of " + image.path + " (" +
                         unnamed.substr(0, 60) + ")",
                     "check that the table belongs to the image");
  }
  if (!unnamed.empty()) {
    notes->push_back("labels of the image that are not in " + table +
                     " are left out: " + unnamed);
  }
  std::sort(entries.begin(),
            entries.end(),
            [](const LabelEntry& a, const LabelEntry& b) {
              return a.label < b.label;
            });
  return entries;
}

// "label 3 (femur): 2 pieces of 0.120 cm3 besides the largest are left out".
void NoteWhatWasLeftOut(const LabelEntry& entry,
                        const LabelRegion& region,
                        const LabelSurface& surface,
                        double voxel,
                        std::vector<std::string>* notes) {
  const auto note = [&](double volume, const std::string& what) {
    std::ostringstream text;
    text << entry.name << " (label " << entry.label << "): " << volume / 1000
         << " cm3 " << what;
    notes->push_back(text.str());
  };
  if (region.other_pieces > 0) {
    note(static_cast<double>(region.other_voxels) * voxel,
         "in " + std::to_string(region.other_pieces) +
             (region.other_pieces == 1 ? " piece" : " pieces") +
             " besides the largest are left out");
  }
  if (region.cavity_voxels > 0) {
    note(static_cast<double>(region.cavity_voxels) * voxel,
         "of cavities are filled");
  }
  if (surface.lost_volume >
      kLostWorthANote * static_cast<double>(region.voxels) * voxel) {
    note(surface.lost_volume,
         "are left out, in parts that are thinner than a voxel");
  }
}

LabelMesh MeshOfLabel(const LabelImage& image,
                      const LabelEntry& entry,
                      const LabelBox& box,
                      double edge_length,
                      std::vector<std::string>* notes) {
  const double voxel = image.grid.VoxelVolume();
  const LabelRegion region = RegionOfLabel(image, entry.label, box);
  LabelSurface surface = SurfaceOfRegion(
      image.path + ": label " + std::to_string(entry.label) + " (" +
          entry.name + ")",
      region,
      image.grid,
      edge_length > 0 ? edge_length : kEdgesOfVoxel * std::cbrt(voxel));
  NoteWhatWasLeftOut(entry, region, surface, voxel, notes);
  LabelMesh mesh;
  mesh.label = entry.label;
  mesh.name = entry.name;
  mesh.is_bone = entry.is_bone.value_or(false);
  mesh.mesh = std::move(surface.mesh);
  mesh.voxel_volume = static_cast<double>(region.voxels) * voxel;
  mesh.volume = surface.volume;
  return mesh;
}

}  // namespace

LabelMeshes ReadLabelMeshes(const std::string& path,
                            const LabelMeshOptions& options) {
  const LabelImage image = ReadLabelImage(path);
  const Boxes boxes = BoxesOfLabels(image);
  if (boxes.empty()) {
    throw InputError(
        path, "has no label above 0", "export the label map again");
  }
  LabelMeshes result;
  result.frame = image.grid.is_oriented ? "LPS" : "of the file";
  result.notes = image.notes;
  const std::vector<LabelEntry> entries =
      options.table.empty()
          ? EntriesOf(image, boxes)
          : EntriesInBoth(image, boxes, options.table, &result.notes);
  for (const LabelEntry& entry : entries) {
    result.meshes.push_back(MeshOfLabel(image,
                                        entry,
                                        boxes.at(entry.label),
                                        options.edge_length,
                                        &result.notes));
  }
  return result;
}
#else
LabelMeshes ReadLabelMeshes(const std::string& path, const LabelMeshOptions&) {
  CheckLabelImagesAreRead(path);
  return {};
}
#endif

}  // namespace musclewarp
