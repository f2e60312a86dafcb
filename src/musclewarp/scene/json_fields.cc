// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/json_fields.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/scene/coordinate_limits.h"
#include "musclewarp/scene/length_unit.h"
#include "musclewarp/scene/rigid_motion.h"

namespace musclewarp {
namespace {

// Returns the largest length up to `length` at which a text ends with a
// complete UTF-8 character.
size_t CutLength(const std::string& text, size_t length) {
  const auto goes_on = [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
  };
  while (length > 0 && goes_on(text[length])) --length;
  return length;
}

// Parses a text and refuses duplicate keys, of which the parser would keep only
// the last without notice.
Json ParseText(const std::string& text, const std::string& file) {
  std::vector<std::vector<std::string>> open_objects;
  const Json::parser_callback_t refuse_duplicates =
      [&](int, Json::parse_event_t event, Json& parsed) {
        if (event == Json::parse_event_t::object_start) {
          open_objects.emplace_back();
        } else if (event == Json::parse_event_t::object_end) {
          open_objects.pop_back();
        } else if (event == Json::parse_event_t::key) {
          const auto key = parsed.get<std::string>();
          auto& keys = open_objects.back();
          if (std::find(keys.begin(), keys.end(), key) != keys.end()) {
            throw InputError(
                file,
                "the key " + Shortened(key) + " stands twice in an object",
                "remove one");
          }
          keys.push_back(key);
        }
        return true;
      };
  try {
    return Json::parse(text, refuse_duplicates);
  } catch (const Json::out_of_range&) {
    throw InputError(file,
                     "has a number that is too large for a double",
                     "allowed: up to 1.7e308 in size, and less where the scene "
                     "says so");
  } catch (const Json::parse_error& error) {
    const auto offset = std::min<size_t>(error.byte, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + offset, '\n');
    throw InputError(file,
                     "is not JSON: error near line " + std::to_string(line),
                     "look for a missing comma, quote or bracket there");
  }
}

}  // namespace

std::string Shortened(const Json& value) {
  // Arrays and objects may be as large and as deep as their file.
  if (value.is_array()) {
    return "an array of " + std::to_string(value.size()) + " elements";
  }
  if (value.is_object()) return "an object";
  // Invalid UTF-8 is replaced, because the message must be printable.
  std::string text;
  for (const char c :
       value.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == 0x7f) {
      text += "\\u007f";
    } else {
      text += c;
    }
  }
  return text.size() <= 40 ? text : text.substr(0, CutLength(text, 37)) + "...";
}

JsonField JsonField::ParseFile(const std::string& file) {
  return Parse(ReadFile(file), file);
}

JsonField JsonField::Parse(const std::string& text, const std::string& name) {
  return JsonField(ParseText(text, name), name, "");
}

std::string JsonField::where() const {
  return field_.empty() ? file_ : file_ + ": " + field_;
}

void JsonField::Fail(const std::string& problem,
                     const std::string& advice) const {
  throw InputError(where(), problem, advice);
}

void JsonField::CheckObject() const {
  if (!value_.is_object()) {
    Fail("is " + Shortened(value_), "give an object { ... }");
  }
}

bool JsonField::Has(const std::string& key) const {
  return value_.is_object() && value_.contains(key);
}

JsonField JsonField::At(const std::string& key) const {
  CheckObject();
  const std::string field = field_.empty() ? key : field_ + "." + key;
  if (!value_.contains(key)) {
    throw InputError(file_ + ": " + field, "is missing", "add it");
  }
  return JsonField(value_.at(key), file_, field, mm_per_unit_);
}

JsonField JsonField::At(size_t index) const {
  return JsonField(value_.at(index),
                   file_,
                   field_ + "[" + std::to_string(index) + "]",
                   mm_per_unit_);
}

size_t JsonField::ArraySize() const {
  if (!value_.is_array()) {
    Fail("is " + Shortened(value_), "give an array [ ... ]");
  }
  return value_.size();
}

void JsonField::CheckKeys(std::initializer_list<std::string> allowed) const {
  CheckObject();
  for (const auto& item : value_.items()) {
    if (std::find(allowed.begin(), allowed.end(), item.key()) !=
        allowed.end()) {
      continue;
    }
    std::string list;
    for (const auto& key : allowed) list += (list.empty() ? "" : ", ") + key;
    Fail("has the unknown key " + Shortened(item.key()), "allowed: " + list);
  }
}

std::string JsonField::AsString() const {
  if (!value_.is_string() || value_.get<std::string>().empty()) {
    Fail("is " + Shortened(value_), "give a text in quotes, not empty");
  }
  return value_.get<std::string>();
}

double JsonField::AsNumber() const {
  if (!value_.is_number() || !std::isfinite(value_.get<double>())) {
    Fail("is " + Shortened(value_), "give a finite number");
  }
  return value_.get<double>();
}

double JsonField::AsCoordinate() const {
  const double value = mm_per_unit_ * AsNumber();
  if (std::abs(value) > kLargestCoordinate) {
    Fail("is " + Shortened(value_), AllowedCoordinates());
  }
  return value;
}

double JsonField::AsLength() const {
  const double value = AsCoordinate();
  if (value <= 0) Fail("is not above 0", "give a length above 0");
  return value;
}

JsonField JsonField::InItsUnits() const {
  const JsonField units = At("units");
  const std::optional<double> mm_per_unit = MillimetresPer(units.AsString());
  if (!mm_per_unit) {
    units.Fail("is " + Shortened(units.value()),
               std::string("allowed: ") + kLengthUnits);
  }
  JsonField field = *this;
  field.mm_per_unit_ = *mm_per_unit;
  return field;
}

bool JsonField::AsBool() const {
  if (!value_.is_boolean()) {
    Fail("is " + Shortened(value_), "give true or false");
  }
  return value_.get<bool>();
}

std::vector<std::string> JsonField::AsStrings() const {
  std::vector<std::string> strings(ArraySize());
  for (size_t i = 0; i < strings.size(); ++i) strings[i] = At(i).AsString();
  return strings;
}

Points JsonField::AsPoints() const {
  Points points(ArraySize(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const JsonField point = At(i);
    if (point.ArraySize() != 3) {
      point.Fail("has " + std::to_string(point.ArraySize()) + " entries",
                 "give a point as [x, y, z]");
    }
    for (int k = 0; k < 3; ++k) points(i, k) = point.At(k).AsCoordinate();
  }
  return points;
}

Eigen::Matrix4d JsonField::AsRigidTransform() const {
  const std::string advice =
      "give 4 rows of 4 numbers, row major, rotation and translation";
  Eigen::Matrix4d transform;
  if (ArraySize() != 4) {
    Fail("has " + std::to_string(ArraySize()) + " rows", advice);
  }
  for (int i = 0; i < 4; ++i) {
    const JsonField row = At(i);
    if (row.ArraySize() != 4) {
      row.Fail("has " + std::to_string(row.ArraySize()) + " numbers", advice);
    }
    for (int k = 0; k < 4; ++k) {
      const bool is_length = i < 3 && k == 3;
      transform(i, k) =
          is_length ? row.At(k).AsCoordinate() : row.At(k).AsNumber();
    }
  }
  const std::string fault = RigidMotionFault(transform);
  if (!fault.empty()) Fail(fault, advice);
  return transform;
}

}  // namespace musclewarp
