// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/pieces_field.h"

#include <string>

namespace musclewarp {

void CheckPieces(const JsonField& field) {
  const std::string choice = field.AsString();
  if (choice == "largest") return;
  if (choice == "all") {
    field.Fail("is \"all\"; a muscle is one closed surface",
               "make a mesh of each piece (separation with {pieces}=all), and "
               "give each a muscle of its own in the scene");
  }
  field.Fail("is \"" + choice + "\"", "allowed: \"largest\"");
}

}  // namespace musclewarp
