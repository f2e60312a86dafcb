// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/nrrd_text.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/export_advice.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

constexpr int kMostDataFiles = 100000;

std::string Trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

// A "%03d" or "%d" in the name of a file.
struct NumberInName {
  std::size_t begin = std::string::npos, end = 0;
  std::size_t digits = 0;
  bool has_zeros = false;
};

NumberInName FindNumber(const std::string& name) {
  NumberInName number;
  number.begin = name.find('%');
  if (number.begin == std::string::npos) return number;
  std::size_t at = number.begin + 1;
  number.has_zeros = at < name.size() && name[at] == '0';
  while (at < name.size() && name[at] >= '0' && name[at] <= '9') {
    number.digits = std::min<std::size_t>(
        10 * number.digits + static_cast<std::size_t>(name[at] - '0'), 20);
    ++at;
  }
  if (at == name.size() || (name[at] != 'd' && name[at] != 'u')) return {};
  number.end = at + 1;
  return number;
}

// Returns the names for a pattern "slice%03d.raw MIN MAX STEP", which a
// dimension may follow, or no names if the text is not a pattern.
std::vector<std::string> NamesOfPattern(const std::string& path,
                                        const std::string& text) {
  std::istringstream words(text);
  std::string name, rest;
  int from = 0, to = 0, step = 0;
  words >> name >> from >> to >> step;
  const NumberInName number = FindNumber(name);
  if (!words || number.begin == std::string::npos) return {};
  if (step == 0 || (to - from) / step < 0 ||
      (to - from) / step >= kMostDataFiles || from < 0 || to < 0) {
    throw InputError(path + ": data file",
                     "is " + Quoted(text) +
                         "; allowed: a pattern, and from, to and step, which "
                         "lead from one to the other",
                     "save the image as one .nrrd file");
  }
  std::vector<std::string> names;
  for (int i = from; step > 0 ? i <= to : i >= to; i += step) {
    std::string digits = std::to_string(i);
    if (digits.size() < number.digits) {
      digits.insert(
          0, number.digits - digits.size(), number.has_zeros ? '0' : ' ');
    }
    names.push_back(name.substr(0, number.begin) + digits +
                    name.substr(number.end));
  }
  return names;
}

void CheckMagic(const std::string& path, std::ifstream* file) {
  char magic[4] = {};
  file->read(magic, 4);
  if (*file && std::string_view(magic, 4) == "NRRD") return;
  throw InputError(path,
                   "is not an NRRD file: it starts with " +
                       Quoted(std::string_view(magic, file->gcount())),
                   "name the file by what it holds");
}

bool IsList(const std::string& text) {
  return text.substr(0, text.find(' ')) == "LIST";
}

// Sets the names of the data files, unless they are a list.
void TakeDataFiles(const std::string& path, NrrdText* text) {
  const std::string files = text->Find("data file");
  if (files.empty() || IsList(files)) return;
  text->data_files = NamesOfPattern(path, files);
  if (text->data_files.empty()) text->data_files = {files};
}

}  // namespace

std::string NrrdText::Find(const std::string& name) const {
  auto found = fields.find(name);
  if (found == fields.end()) {
    std::string together = name;
    together.erase(std::remove(together.begin(), together.end(), ' '),
                   together.end());
    found = fields.find(together);
  }
  return found == fields.end() ? "" : found->second;
}

// A header ends with an empty line, or with the file if the data are in others.
NrrdText ReadNrrdText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  CheckMagic(path, &file);
  NrrdText text;
  std::string line;
  std::getline(file, line);
  bool is_list = false;
  while (std::getline(file, line)) {
    line = Trimmed(line);
    if (line.empty()) {
      text.data_from = static_cast<std::uint64_t>(file.tellg());
      break;
    }
    if (line[0] == '#') continue;
    if (is_list) {
      text.data_files.push_back(line);
      continue;
    }
    const std::size_t value = line.find(":="), field = line.find(": ");
    if (value < field) {
      text.values[line.substr(0, value)] = Trimmed(line.substr(value + 2));
    } else if (field != std::string::npos) {
      text.fields[LowerCase(line.substr(0, field))] =
          Trimmed(line.substr(field + 2));
      is_list = IsList(text.Find("data file"));
    }
  }
  TakeDataFiles(path, &text);
  const bool has_end = text.data_from > 0 || !text.data_files.empty();
  if (has_end) return text;
  throw InputError(path, "is truncated: its header has no end", kCopyAgain);
}

}  // namespace musclewarp
