// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace musclewarp {

// Bad input from the user: a file, a field of a scene, a flag. The tools print
// what() and exit with code 2; nothing has been written by then.
//
//   throw InputError("muscle.ply", "face 12 names vertex 900, the file has
//   800",
//                    "export the mesh again");
//
// prints "muscle.ply: face 12 names vertex 900, the file has 800; export the
// mesh again".
class InputError : public std::runtime_error {
 public:
  // where: file, or file and field ("scene.json: muscles[2].mesh").
  // problem: the value seen and the value allowed.
  // advice: what the user can do.
  InputError(const std::string& where,
             const std::string& problem,
             const std::string& advice);
};

}  // namespace musclewarp
