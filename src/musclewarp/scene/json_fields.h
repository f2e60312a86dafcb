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

// A value of a JSON file together with the file and the path to it
// ("muscles[2].mesh"), so that every complaint says where. The readers throw
// InputError when the value is missing or of another type.
class JsonField {
 public:
  // Parses a file. Throws InputError if it is missing or not JSON.
  static JsonField ParseFile(const std::string& file);

  const Json& value() const { return value_; }
  const std::string& file() const { return file_; }
  // "scene.json: muscles[2].mesh"
  std::string where() const;

  bool Has(const std::string& key) const;
  // A member of an object; InputError if it is missing.
  JsonField At(const std::string& key) const;
  JsonField At(size_t index) const;
  // Number of elements; InputError if it is not an array.
  size_t ArraySize() const;
  // InputError if this is not an object or has a key that is not allowed.
  void CheckKeys(std::initializer_list<std::string> allowed) const;
  void CheckObject() const;

  std::string AsString() const;  // not empty
  double AsNumber() const;       // finite
  bool AsBool() const;
  std::vector<std::string> AsStrings() const;  // ["...", ...]
  Points AsPoints() const;                     // [[x, y, z], ...]
  // [[4 numbers] x 4], row major, a rigid motion.
  Eigen::Matrix4d AsRigidTransform() const;

  // Throws InputError at this field.
  [[noreturn]] void Fail(const std::string& problem,
                         const std::string& advice) const;

 private:
  JsonField(Json value, std::string file, std::string field)
      : value_(std::move(value)),
        file_(std::move(file)),
        field_(std::move(field)) {}

  Json value_;
  std::string file_;
  std::string field_;
};

}  // namespace musclewarp
