// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The named parts of a mesh file: the objects of an .obj, its groups if it has
// no objects, or the solids of an ASCII .stl. Empty for other files.
struct MeshParts {
  // What the format calls a part: "object", "group" or "solid"; empty if there
  // are none.
  std::string kind;

  // The names of the parts that have triangles, in the order of the file.
  // Objects and solids may share a name.
  std::vector<std::string> names;

  // The names of those without triangles.
  std::vector<std::string> empty;

  // By triangle, its part as an index into `names`.
  std::vector<int> part_of;
};

// Returns a name as parts have it: without blanks at its ends, and with one
// blank where there are several.
std::string PartName(std::string_view text);

// Keeps track of parts while the faces of a file are read in order.
class PartCollector {
 public:
  // How a name that comes again is understood.
  enum class Again {
    kContinues,  // as the part that it was
    kStarts,     // as another part of that name
  };

  // `first` is the name of faces before the first part.
  PartCollector(Again again, const char* first);

  // The faces from here on belong to the part `name`.
  void Start(const std::string& name);
  void AddFace() { part_of_face_.push_back(current_); }
  bool HasParts() const { return has_parts_; }

  // Returns the parts, given the face of each triangle, counted from 0.
  MeshParts Parts(const char* kind,
                  const std::vector<int>& face_of_triangle) const;

 private:
  Again again_;
  bool has_parts_ = false;
  int current_ = 0;
  std::vector<std::string> names_;
  std::vector<int> part_of_face_;
};

// Returns the mesh of one part; its points are those in use, in order.
TriangleSoup MeshOfPart(const TriangleSoup& soup,
                        const MeshParts& parts,
                        int part);

// Leaves of a mesh and its parts those called `name`, and the points in use.
// Throws InputError, which lists the names, if there is none. `file` is for
// messages.
void KeepPart(const std::string& file,
              const std::string& name,
              TriangleSoup* soup,
              MeshParts* parts);

}  // namespace musclewarp
