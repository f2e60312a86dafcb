// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace musclewarp {

// The header of an NRRD file as text (teem.sourceforge.net/nrrd/format.html).
struct NrrdText {
  std::map<std::string, std::string> fields;  // "sizes: 5 6 7", in lower case
  std::map<std::string, std::string> values;  // "Segment0_Name:=femur"

  // The data files, as the header names them; none if the data follow the
  // header, starting at byte `data_from`.
  std::vector<std::string> data_files;
  std::uint64_t data_from = 0;

  // Returns a field, whose words may be joined in the file: "data file" or
  // "datafile". Empty if it is missing.
  std::string Find(const std::string& name) const;
};

// Reads the header of a file, including the names of the data files: one name,
// LIST followed by lines with names, or a pattern such as "slice%03d.raw 1 60
// 1". Throws InputError for a file that is not NRRD, a header without an end,
// and invalid patterns.
NrrdText ReadNrrdText(const std::string& path);

}  // namespace musclewarp
