// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace musclewarp {

// A row of a table of labels.
struct LabelEntry {
  int label = 0;  // above 0
  std::string name;
  std::optional<bool> is_bone;  // none: the table does not say

  // For musclewarp-articulate, empty if the table does not say: what a bone is
  // and on which side, if its name does not tell, and the body to which it
  // belongs; the bodies on which a muscle ends.
  std::string bone = {}, side = {}, body = {};
  std::string origin = {}, insertion = {};
};

// Reads a table that names labels, one a line, in any of these forms:
//
//   label,name,kind          commas, semicolons or tabs between the columns;
//   1,gluteus_medius,muscle  the first line may name them. "kind" (muscle or
//   2,femur,bone             bone) may be empty or missing
//   1 femur 128 174 128 255  colour table of 3D Slicer (.ctbl)
//   1 255 0 0 1 1 1 "femur"  label descriptions of ITK-SNAP
//   1 femur bone             words between blanks
//
// In the line that names the columns, "label", "labelvalue", "value", "index",
// "idx" and "id" are the label, "name", "labelname" and "structure" the name,
// "kind" and "type" the kind, and "bone", "side", "body", "origin" and
// "insertion" what LabelEntry has under these names; case, blanks and
// underscores do not matter. Further columns are passed over.
// Empty lines and rows and those that begin with # are passed over, and so is
// label 0, the background. Rows come in the order of the file. The table may be
// as spreadsheets save it: UTF-8 with a mark at its beginning, UTF-16 with one,
// a first line "sep=;", quotes around cells, and labels such as 1.0.
//
// Throws InputError that names the file and the line, for a line of another
// form, a label that is not a whole number from 0 to 2147483647, a name that
// cannot be the name of a file (CheckFileName), a kind other than muscle and
// bone, and labels and names that occur twice; also if the table has no row.
std::vector<LabelEntry> ReadLabelTable(const std::string& path);

}  // namespace musclewarp
