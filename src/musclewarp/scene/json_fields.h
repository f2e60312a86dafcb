// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

using Json = nlohmann::json;

// A value for a message: as JSON has it, control characters escaped and long
// texts cut off with "..."; of arrays and objects only what they are.
std::string Shortened(const Json& value);

// A value of a JSON file together with the file and the path to it, so that
// every complaint says where it belongs:
//
//   const JsonField scene = JsonField::ParseFile("scene.json");
//   const JsonField muscle = scene.At("muscles").At(2);
//   muscle.CheckKeys({"name", "mesh"});
//   const std::string mesh = muscle.At("mesh").AsString();
//
// prints, if the mesh is a number, "scene.json: muscles[2].mesh: is 5; give a
// text in quotes, not empty". All readers throw InputError when the value is
// missing, of another type or not allowed.
class JsonField {
 public:
  // Parses a file. Throws InputError if it cannot be read, is not JSON, has a
  // key twice in one object, or a number that no double can hold.
  static JsonField ParseFile(const std::string& file);

  // The same for a text, which messages call `name`.
  static JsonField Parse(const std::string& text, const std::string& name);

  const Json& value() const { return value_; }
  const std::string& file() const { return file_; }

  // The file and the path: "scene.json: muscles[2].mesh".
  std::string where() const;

  // True if this is an object that has the key.
  bool Has(const std::string& key) const;

  // The member of an object, which must be there.
  JsonField At(const std::string& key) const;

  // The element of an array. Precondition: index < ArraySize().
  JsonField At(size_t index) const;

  // The number of elements; throws InputError if this is not an array.
  size_t ArraySize() const;

  // Throws InputError if this is not an object, or has a key that is not
  // allowed: a misspelt key would be passed over in silence.
  void CheckKeys(std::initializer_list<std::string> allowed) const;

  // Throws InputError if this is not an object.
  void CheckObject() const;

  // Returns the same field with the unit that its key "units" states ("mm",
  // "cm" or "m"): the lengths in it are read in that unit, and are mm in all
  // that the functions below return. Throws InputError for another unit.
  JsonField InItsUnits() const;
  double mm_per_unit() const { return mm_per_unit_; }

  // The value as what it should be.
  std::string AsString() const;  // not empty
  double AsNumber() const;       // finite
  double AsCoordinate() const;   // mm, within kLargestCoordinate
  double AsLength() const;       // mm, above 0
  bool AsBool() const;
  std::vector<std::string> AsStrings() const;  // of ["...", ...]

  // Points (#P x 3, mm) of [[x, y, z], ...]; there may be none.
  Points AsPoints() const;

  // A rigid motion (translation in mm) of four rows of four numbers. The
  // rotation may be rounded to three digits.
  Eigen::Matrix4d AsRigidTransform() const;

  // Throws InputError at this field, see InputError for the two texts.
  [[noreturn]] void Fail(const std::string& problem,
                         const std::string& advice) const;

 private:
  JsonField(Json value,
            std::string file,
            std::string field,
            double mm_per_unit = 1)
      : value_(std::move(value)),
        file_(std::move(file)),
        field_(std::move(field)),
        mm_per_unit_(mm_per_unit) {}

  Json value_;
  std::string file_;
  std::string field_;  // path from the root; empty for the root itself
  double mm_per_unit_ = 1;
};

}  // namespace musclewarp
