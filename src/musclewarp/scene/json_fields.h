// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

using Json = nlohmann::json;

// Returns a value as text for a message: in JSON syntax, with control
// characters escaped and long texts cut off with "...". Arrays and objects are
// only described.
std::string Shortened(const Json& value);

// The same of a value that is this text.
std::string ShortenedText(const std::string& text);

// A value of a JSON file together with the name of the file and the path to the
// value, so that every message names the place of the error:
//
//   const JsonField scene = JsonField::ParseFile("scene.json");
//   const JsonField muscle = scene.At("muscles").At(2);
//   muscle.CheckKeys({"name", "mesh"});
//   const std::string mesh = muscle.At("mesh").AsString();
//
// prints "scene.json: muscles[2].mesh: is 5; give a text in quotes, not empty"
// if the mesh is a number. All readers throw InputError if the value is
// missing, has another type or is not allowed.
class JsonField {
 public:
  // Parses a file. Throws InputError if it cannot be read, is not JSON,
  // contains a duplicate key in an object, or a number beyond the range of
  // double.
  static JsonField ParseFile(const std::string& file);

  // Parses a text, which messages call `name`, in the same way.
  static JsonField Parse(const std::string& text, const std::string& name);

  const Json& value() const { return *value_; }
  const std::string& file() const { return file_; }

  // Returns the file and the path: "scene.json: muscles[2].mesh".
  std::string where() const;

  bool IsArray() const;
  bool IsNull() const;
  bool IsNumber() const;
  bool IsObject() const;
  bool IsString() const;

  // Returns the value as text for a message, as Shortened() does.
  std::string AsText() const;

  // Returns the keys of an object in alphabetical order; of another value none.
  std::vector<std::string> Keys() const;

  // Returns true if this is an object that has the key.
  bool Has(const std::string& key) const;

  // Returns the member of an object. Throws InputError if there is none.
  JsonField At(const std::string& key) const;

  // Returns an element of an array. Precondition: index < ArraySize().
  JsonField At(size_t index) const;

  // Returns the number of elements. Throws InputError if this is not an array.
  size_t ArraySize() const;

  // Throws InputError if this is not an object, or has a key that is not
  // allowed: a misspelt key would otherwise be ignored without notice.
  void CheckKeys(std::initializer_list<std::string> allowed) const;

  // Throws InputError if this is not an object.
  void CheckObject() const;

  // Returns the same field with the length unit that its key "units" states
  // ("mm", "cm" or "m"). The readers below convert lengths in it from this unit
  // to mm. Throws InputError for another unit.
  JsonField InItsUnits() const;
  double mm_per_unit() const { return mm_per_unit_; }

  // Return the value if it has the required type and range.
  std::string AsString() const;  // not empty
  double AsNumber() const;       // finite
  double AsCoordinate() const;   // mm, within kLargestCoordinate
  double AsLength() const;       // mm, above 0
  bool AsBool() const;
  std::vector<std::string> AsStrings() const;  // of ["...", ...]

  // Returns the points (#P x 3, mm) in [[x, y, z], ...], which may be empty.
  Points AsPoints() const;

  // Returns the rigid motion (4 x 4, translation in mm) in four rows of four
  // numbers. The rotation may be rounded to three digits.
  Eigen::Matrix4d AsRigidTransform() const;

  // Throws InputError for this field; see InputError for the two texts.
  [[noreturn]] void Fail(const std::string& problem,
                         const std::string& advice) const;

 private:
  JsonField(std::shared_ptr<const Json> value,
            std::string file,
            std::string field,
            double mm_per_unit = 1)
      : value_(std::move(value)),
        file_(std::move(file)),
        field_(std::move(field)),
        mm_per_unit_(mm_per_unit) {}

  // Returns a pointer to a part of this value, which keeps all of the file.
  std::shared_ptr<const Json> Part(const Json& part) const;

  std::shared_ptr<const Json> value_;
  std::string file_;
  std::string field_;  // path from the root; empty for the root itself
  double mm_per_unit_ = 1;
};

}  // namespace musclewarp
