// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/base/described.h"
#include "musclewarp/label_images/label_meshes.h"
#include "musclewarp/scene/length_unit.h"

namespace musclewarp {

// The setting of the unit of files that do not state their own.
struct UnitSettings {
  std::string units = "mm";

  // Returns the length of the unit. Precondition (CHECKed): `units` is one of
  // kLengthUnits.
  double MmPerUnit() const;
};

constexpr auto FieldsOf(Described<UnitSettings>) {
  return std::make_tuple(
      Field(&UnitSettings::units, "units")
          .Text("unit of the mesh files, and of a label image that does not "
                "state its own; results are in mm")
          .OneOf(kLengthUnits));
}

// The settings of the meshes of a label image and of the mesh files beside it.
struct LabelSettings : UnitSettings {
  std::string labels;
  double edge = LabelMeshOptions().edge_length;
  std::string pieces = "largest";
  std::string bone;
};

constexpr auto FieldsOf(Described<LabelSettings>) {
  using S = LabelSettings;
  return std::make_tuple(
      Field(&S::labels, "labels")
          .Text("table of the labels of an image: label,name,kind and, for "
                "joints, bone,side,body,origin,insertion, or that of 3D Slicer "
                "or ITK-SNAP; labels that are not in it are left out")
          .Path(),
      Field(&S::edge, "edge", "mm")
          .Text("length of the edges of the surfaces of labels; 0: twice the "
                "edge of a voxel")
          .Within(0, 100),
      Field(&S::pieces, "pieces")
          .Text("what becomes of a mesh file with several closed surfaces, and "
                "of a label whose voxels are not all connected by their faces: "
                "largest (the largest piece; the others are lost) or all (a "
                "mesh of each piece)")
          .OneOf("largest, all"),
      Inherited<UnitSettings>(),
      Field(&S::bone, "bone")
          .Text("names of labels that are bones beside those of which the "
                "table says so; for a separation also mesh files, as bones do "
                "not move; commas"));
}

// Returns the options that the settings mean. Throws InputError, naming the
// setting, for a value that is not allowed.
LabelMeshOptions OptionsOf(const LabelSettings& settings);

}  // namespace musclewarp
