// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/nifti_pair.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "musclewarp/base/input_error.h"
#include "musclewarp/label_images/unpacked_file.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// The format is named in the last four of the 348 header bytes of NIfTI-1, and
// after the header size in NIfTI-2.
constexpr std::size_t kNiftiBytes = 348, kName1 = 344, kName2 = 4;

struct PairName {
  std::string stem;  // without extensions
  std::string
      ending;  // ".img" or ".hdr" in the case of the file; empty: neither
};

PairName PairNameOf(const std::string& path) {
  fs::path name(path);
  if (LowerCase(name.extension().string()) == ".gz") name.replace_extension();
  const std::string ending = name.extension().string();
  const std::string lower = LowerCase(ending);
  if (lower != ".img" && lower != ".hdr") return {};
  return {name.replace_extension().string(), ending};
}

// Returns the file of a pair with this ending, in lower or upper case like the
// ending of the given file.
std::string FileWithEnding(const std::string& path,
                           const PairName& name,
                           const std::string& lower,
                           const std::string& upper) {
  const bool is_upper = name.ending[1] < 'a';
  const std::string plain = name.stem + (is_upper ? upper : lower);
  for (const std::string& file : {plain, plain + ".gz", plain + ".GZ"}) {
    std::error_code error;
    if (fs::is_regular_file(file, error)) return file;
  }
  throw InputError(path,
                   "is one of a pair of files, and there is no " + plain +
                       " or " + plain + ".gz",
                   "put both files into one folder");
}

// Returns the integer of so many bytes at a place, first byte last or first.
std::int64_t IntegerAt(const std::string& bytes,
                       std::size_t at,
                       std::size_t count,
                       bool is_little) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = is_little ? count - 1 - i : i;
    value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  }
  return static_cast<std::int64_t>(value);
}

void CheckDimensions(const std::string& header, std::int64_t dimensions) {
  constexpr std::int64_t kMostDimensions = 7;
  if (dimensions >= 1 && dimensions <= kMostDimensions) return;
  throw InputError(header,
                   "says that it has " + std::to_string(dimensions) +
                       " dimensions; allowed: 1 to 7",
                   "copy or export the file again");
}

void CheckVoxelType(const std::string& header, std::int64_t type) {
  // Whole numbers of 1 to 8 bytes with and without sign, and real numbers of 4
  // and 8 bytes; complex numbers and colours, which are refused elsewhere.
  constexpr std::int64_t kTypes[] = {
      2, 4, 8, 16, 32, 64, 128, 256, 512, 768, 1024, 1280, 1792, 2304};
  if (std::find(std::begin(kTypes), std::end(kTypes), type) !=
      std::end(kTypes)) {
    return;
  }
  throw InputError(header,
                   "says that its voxels are of type " + std::to_string(type) +
                       ", which is not read",
                   "save the labels as whole numbers of 1, 2 or 4 bytes");
}

}  // namespace

bool IsNiftiPairFile(const std::string& path) {
  return !PairNameOf(path).ending.empty();
}

std::string CheckedNiftiHeader(const std::string& path) {
  const PairName name = PairNameOf(path);
  FileWithEnding(path, name, ".img", ".IMG");
  const std::string header = FileWithEnding(path, name, ".hdr", ".HDR");
  const std::string bytes = ReadUnpacked(header, kNiftiBytes);
  const auto has = [&](std::size_t at, const char* text) {
    return bytes.size() == kNiftiBytes && bytes.compare(at, 3, text) == 0;
  };
  if (has(kName1, "ni1") || has(kName1, "n+1") || has(kName2, "ni2") ||
      has(kName2, "n+2")) {
    return header;
  }
  throw InputError(header,
                   "is no header of NIfTI; ANALYZE 7.5, which looks the same, "
                   "does not say where left and right are",
                   "save the image as .nii.gz with the program that made it");
}

void CheckNiftiFields(const std::string& header) {
  constexpr std::int64_t kNifti2Bytes = 540;
  const std::string bytes = ReadUnpacked(header, kNiftiBytes);
  if (bytes.size() < kNiftiBytes) {
    throw InputError(header,
                     "cannot be read: it ends after " +
                         std::to_string(bytes.size()) +
                         " bytes, within the header of NIfTI",
                     "copy or export the file again");
  }
  for (const bool is_little : {true, false}) {
    const std::int64_t size = IntegerAt(bytes, 0, 4, is_little);
    if (size != kNiftiBytes && size != kNifti2Bytes) continue;
    const bool is_second = size == kNifti2Bytes;
    CheckDimensions(header,
                    is_second ? IntegerAt(bytes, 16, 8, is_little)
                              : IntegerAt(bytes, 40, 2, is_little));
    CheckVoxelType(header, IntegerAt(bytes, is_second ? 12 : 70, 2, is_little));
    return;
  }
  throw InputError(header,
                   "does not begin with the size of a header of NIfTI",
                   "copy or export the file again");
}

}  // namespace musclewarp
