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

  // For musclewarp-articulate; empty if the table does not state them: the kind
  // and side of a bone, if its name does not tell, and the body to which it
  // belongs; the bodies on which a muscle ends.
  std::string bone = {}, side = {}, body = {};
  std::string origin = {}, insertion = {};
};

// Reads a table that names labels, one per line, in any of these forms:
//
//   label,name,kind          commas, semicolons or tabs between the columns;
//   1,gluteus_medius,muscle  the first line may name them. "kind" (muscle or
//   2,femur,bone             bone) may be empty or missing
//   1 femur 128 174 128 255  colour table of 3D Slicer (.ctbl)
//   1 255 0 0 1 1 1 "femur"  label descriptions of ITK-SNAP
//   1 femur bone             words between blanks
//
// In a header line, "label", "labelvalue", "value", "index", "idx" and "id"
// name the label, "name", "labelname" and "structure" the name, "kind" and
// "type" the kind, and "bone", "side", "body", "origin" and "insertion" the
// fields of LabelEntry with these names, regardless of case, blanks and
// underscores. Further columns, empty lines and rows, lines that begin with #,
// and label 0, the background, are ignored. Rows are returned in the order of
// the file. Files saved by spreadsheets are supported: UTF-8 or UTF-16 with a
// byte order mark, a first line "sep=;", quotes around cells, and labels such
// as 1.0.
//
// Throws InputError that names the file and the line, for a line of another
// form, a label that is not an integer from 0 to 2147483647, a name that cannot
// be a file name (CheckFileName), a kind other than muscle and bone, and
// duplicate labels and names; also if the table has no row.
std::vector<LabelEntry> ReadLabelTable(const std::string& path);

}  // namespace musclewarp
