// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/json_fields.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/near_name.h"
#include "musclewarp/base/nesting.h"
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

// Parses a text and refuses what is nested too deep, and duplicate keys, of
// which the parser would keep only the last without notice.
Json ParseText(const std::string& text, const std::string& file) {
  std::vector<std::vector<std::string>> open_objects;
  const Json::parser_callback_t refuse_duplicates =
      [&](int depth, Json::parse_event_t event, Json& parsed) {
        CheckNesting(file, depth);
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

std::string ShortenedText(const std::string& text) {
  return Shortened(Json(text));
}

JsonField JsonField::ParseFile(const std::string& file) {
  return Parse(ReadFile(file), file);
}

JsonField JsonField::Parse(const std::string& text, const std::string& name) {
  return JsonField(
      std::make_shared<const Json>(ParseText(text, name)), name, "");
}

std::shared_ptr<const Json> JsonField::Part(const Json& part) const {
  return {value_, &part};
}

std::string JsonField::where() const {
  return field_.empty() ? file_ : file_ + ": " + field_;
}

void JsonField::Fail(const std::string& problem,
                     const std::string& advice) const {
  throw InputError(where(), problem, advice);
}

void JsonField::CheckObject() const {
  if (!IsObject()) {
    Fail("is " + AsText(), "give an object { ... }");
  }
}

bool JsonField::IsArray() const { return value().is_array(); }
bool JsonField::IsNull() const { return value().is_null(); }
bool JsonField::IsNumber() const { return value().is_number(); }
bool JsonField::IsObject() const { return value().is_object(); }
bool JsonField::IsString() const { return value().is_string(); }

std::string JsonField::AsText() const { return Shortened(value()); }

std::vector<std::string> JsonField::Keys() const {
  std::vector<std::string> keys;
  if (!IsObject()) return keys;
  for (const auto& item : value().items()) keys.push_back(item.key());
  return keys;
}

bool JsonField::Has(const std::string& key) const {
  return IsObject() && value().contains(key);
}

JsonField JsonField::At(const std::string& key) const {
  CheckObject();
  const std::string field = field_.empty() ? key : field_ + "." + key;
  if (!value().contains(key)) {
    throw InputError(file_ + ": " + field, "is missing", "add it");
  }
  return JsonField(Part(value().at(key)), file_, field, mm_per_unit_);
}

JsonField JsonField::At(size_t index) const {
  return JsonField(Part(value().at(index)),
                   file_,
                   field_ + "[" + std::to_string(index) + "]",
                   mm_per_unit_);
}

size_t JsonField::ArraySize() const {
  if (!IsArray()) {
    Fail("is " + AsText(), "give an array [ ... ]");
  }
  return value().size();
}

void JsonField::CheckKeys(std::initializer_list<std::string> allowed) const {
  CheckObject();
  for (const auto& item : value().items()) {
    if (std::find(allowed.begin(), allowed.end(), item.key()) !=
        allowed.end()) {
      continue;
    }
    std::string list;
    for (const auto& key : allowed) list += (list.empty() ? "" : ", ") + key;
    Fail("has the unknown key " + Shortened(item.key()),
         DidYouMean(item.key(), allowed) + "allowed: " + list);
  }
}

std::string JsonField::AsString() const {
  if (!IsString() || value().get<std::string>().empty()) {
    Fail("is " + AsText(), "give a text in quotes, not empty");
  }
  return value().get<std::string>();
}

double JsonField::AsNumber() const {
  if (!IsNumber() || !std::isfinite(value().get<double>())) {
    Fail("is " + AsText(), "give a finite number");
  }
  return value().get<double>();
}

double JsonField::AsCoordinate() const {
  const double value = mm_per_unit_ * AsNumber();
  if (std::abs(value) > kLargestCoordinate) {
    Fail("is " + AsText(), AllowedCoordinates());
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
  if (!value().is_boolean()) {
    Fail("is " + AsText(), "give true or false");
  }
  return value().get<bool>();
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
