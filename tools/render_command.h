// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace musclewarp {

// What musclewarp-render is asked for; the fields are its flags.
struct RenderRequest {
  // A folder written by musclewarp-deform, or any folder of meshes.
  std::string in;
  // Mesh files, instead of `in`.
  std::vector<std::string> files;
  // The picture, .png.
  std::string out;
  // Frames of `in` from left to right: numbers or "last", with commas.
  std::string frames = "0";
  // Texts below the frames, with commas; "auto" takes the names of the frames
  // from report.json if there is more than one frame, "" is none.
  std::string captions = "auto";
  // See ParseView in musclewarp/geometry/view.h.
  std::string view = "anterior";
  std::string axes;  // empty: as the run says, else LPS
  std::string side;  // the same, else right
  // Width x height of the whole picture, pixels.
  std::string size = "1200x1000";
  // Names with commas: what is a bone if there is no report.json; what is left
  // out; what the picture is made to hold (empty: all).
  std::string bones;
  std::string hide;
  std::string fit;
  // name:opacity with commas.
  std::string fade;
  // What the colours of muscles tell: "muscle", which it is, or "stretch", how
  // far each triangle is stretched; that needs a run, which has them at rest.
  std::string color = "muscle";
  // Names the muscles below the picture, or what the colours tell.
  bool legend = true;
  bool outlines = true;
};

// Draws the picture and says on `log` what was written. Throws InputError that
// names the flag or the file; nothing is written then.
void Render(const RenderRequest& request, std::ostream& log);

}  // namespace musclewarp
