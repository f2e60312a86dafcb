// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/motion_columns.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/near_name.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

// Returns true for columns of a states file that are not coordinates.
bool IsOtherState(const std::string& label) {
  for (const char* end : {"/speed",
                          "_u",
                          "/activation",
                          ".activation",
                          "/fiber_length",
                          ".fiber_length"}) {
    if (EndsWith(label, end)) return true;
  }
  return false;
}

std::vector<std::string> SplitAt(const std::string& text, char separator) {
  std::vector<std::string> parts;
  size_t begin = 0;
  for (size_t end = 0; end != std::string::npos; begin = end + 1) {
    end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
  }
  return parts;
}

// Returns the name of the coordinate that a label stands for, in this model or
// in another one, after that of its joint if the label has it. A path is one of
// a coordinate if it ends with "value", or if a joint is the owner of what it
// leads to: that of an actuator may end with the name of a coordinate, too.
std::optional<std::string> CoordinateNameIn(const std::string& label,
                                            const Model& model) {
  std::vector<std::string> parts = SplitAt(label, '/');
  if (parts.size() == 1) return label;
  const bool is_value = parts.back() == "value";
  if (is_value) parts.pop_back();
  if (parts.size() == 1) return parts[0];
  const std::string owner = parts[parts.size() - 2];
  const std::string name = owner + "/" + parts.back();
  if (is_value) return name;
  const bool is_of_joint = std::any_of(
      model.joints.begin(), model.joints.end(), [&](const Joint& joint) {
        return joint.name == owner;
      });
  const bool is_in_jointset =
      parts.size() >= 3 && parts[parts.size() - 3] == "jointset";
  if (!is_of_joint && !is_in_jointset) return std::nullopt;
  return name;
}

// Returns true for parts of names that tell coordinates of one kind apart: the
// side, the axis, or a number.
bool IsDistinguishing(const std::string& part) {
  return part.size() <= 2 || part == "left" || part == "right" ||
         std::any_of(part.begin(), part.end(), [](unsigned char c) {
           return std::isdigit(c) != 0;
         });
}

bool DifferInDistinguishingParts(const std::string& a, const std::string& b) {
  const auto parts_a = SplitAt(a, '_');
  const auto parts_b = SplitAt(b, '_');
  if (a == b || parts_a.size() != parts_b.size()) return false;
  for (size_t i = 0; i < parts_a.size(); ++i) {
    if (parts_a[i] == parts_b[i]) continue;
    if (!IsDistinguishing(parts_a[i]) || !IsDistinguishing(parts_b[i])) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool IsNearlyNamed(const std::string& name, const std::string& coordinate) {
  const std::string a = LowerCase(name);
  const std::string b = LowerCase(coordinate);
  if (DifferInDistinguishingParts(a, b)) return false;
  const int letters = static_cast<int>(std::max(a.size(), b.size()));
  return EditDistance(a, b) <= std::max(1, letters / 6);
}

MotionColumns MatchColumns(const Model& model,
                           const StorageTable& table,
                           const std::string& path) {
  MotionColumns columns;
  std::vector<char> has_column(model.coordinates.size(), 0);
  for (const std::string& label : table.labels) {
    const auto name = CoordinateNameIn(label, model);
    const int coordinate = name ? model.FindCoordinate(*name) : -1;
    columns.coordinates.push_back(coordinate);
    if (coordinate < 0) continue;
    if (has_column[coordinate]) {
      throw InputError(path + ": column \"" + label + "\"",
                       "is the second one for the coordinate " +
                           model.coordinates[coordinate].name,
                       "remove one of the two");
    }
    has_column[coordinate] = 1;
  }
  for (size_t i = 0; i < table.labels.size(); ++i) {
    const std::string& label = table.labels[i];
    if (columns.coordinates[i] >= 0 || IsOtherState(label)) continue;
    const auto name = CoordinateNameIn(label, model);
    if (name && !model.CoordinatesCalled(*name).empty()) {
      columns.ambiguous.push_back(static_cast<int>(i));
      continue;
    }
    columns.others.push_back(label);
    if (!name || table.values.col(i).isZero(0)) continue;
    const std::string last_name = SplitAt(*name, '/').back();
    for (size_t k = 0; k < model.coordinates.size(); ++k) {
      const std::string& coordinate = model.coordinates[k].name;
      if (has_column[k] || !IsNearlyNamed(last_name, coordinate)) continue;
      throw InputError(path + ": column \"" + label + "\"",
                       "is no coordinate of " + model.path +
                           ", but is nearly named as \"" + coordinate +
                           "\", which has no column",
                       "rename the column, or remove it");
    }
  }
  return columns;
}

}  // namespace musclewarp
