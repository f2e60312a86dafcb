// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

namespace musclewarp {

// Reports bad input: a file, a field of a scene, or a setting. The programs
// print the message and exit with code 2; no output has been written by then.
//
//   throw InputError("muscle.ply",
//                    "face 12 names vertex 900, the file has 800 vertices",
//                    "export the mesh again");
//
// has the text "muscle.ply: face 12 names vertex 900, the file has 800
// vertices; export the mesh again".
class InputError : public std::runtime_error {
 public:
  // `where` names the file, or the file and the field in it
  // ("scene.json: muscles[2].mesh"); `problem` states the value that was seen
  // and the values that are allowed; `advice` tells the user what to do.
  InputError(const std::string& where,
             const std::string& problem,
             const std::string& advice);

  // The parts of the message. They name settings in braces
  // (base/setting_names.h), which what() does as the fields of C++.
  const std::string& where() const { return *where_; }
  const std::string& problem() const { return *problem_; }
  const std::string& advice() const { return *advice_; }

  // Returns the whole message with settings named as flags.
  std::string WithFlags() const;

 private:
  // Shared, as an exception must not throw while it is copied.
  std::shared_ptr<const std::string> where_, problem_, advice_;
};

}  // namespace musclewarp
