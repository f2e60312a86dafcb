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

  // The files of the data, as the header names them; none if the data follow
  // the header, from byte `data_from` on.
  std::vector<std::string> data_files;
  std::uint64_t data_from = 0;

  // Returns a field, of which the words may be written together: "data file" or
  // "datafile". Empty if it is not there.
  std::string Find(const std::string& name) const;
};

// Reads the header of a file, and the names that it has for the files of the
// data: one name, LIST with the names below it, or a pattern such as
// "slice%03d.raw 1 60 1". Throws InputError for a file that is not NRRD, a
// header without an end, and patterns that are none.
NrrdText ReadNrrdText(const std::string& path);

}  // namespace musclewarp
