// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "musclewarp/frames/frame.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/run/lines_file.h"

namespace musclewarp {

// Returns the name of the folder of a frame, such as "frame_0007".
std::string FrameFolder(int index);

// Returns 12 for "frame_0012" and "frame_12", and -1 for names of another form.
int FrameNumber(const std::string& name);

// Returns the frame folders of a run by number.
std::map<int, std::string> FrameFoldersIn(const std::string& dir);

// The folder of the meshes as they were delivered and repaired.
constexpr char kRestFolder[] = "rest";

// Which folders of a run have the meshes of its bones: those of all frames, or
// the rest folder only. Bones are rigid, and most of what a frame holds.
enum class BoneFiles { kEvery, kOnce };

// Returns "every" or "once".
const char* ToString(BoneFiles bones);

// The files of a frame.
struct FrameFileOptions {
  // Extensions of the meshes without dot. All formats keep double precision
  // (.stl does not and is not offered by the programs).
  std::vector<std::string> formats = {"ply"};

  // With kOnce, "vtp" has bones in every frame all the same, because ParaView
  // plays these files as they are.
  BoneFiles bones = BoneFiles::kEvery;

  bool HasFormat(const std::string& format) const;

  // Returns true if frames have the meshes of bones in the format.
  bool HasBonesInFrames(const std::string& format) const;
};

// Returns the lines and fibres of a frame, as lines.json has them.
std::vector<MuscleLines> LinesOf(const PreparedScene& scene,
                                 const Frame& frame);

// Writes all meshes of a frame to DIR/frame_0000/<name>.<format> (DIR/rest/...
// of the rest frame) and lines and fibres to lines.json beside them; the folder
// appears complete or not at all. With BoneFiles::kOnce the motions of the
// bones from rest are written to bones.json (bones_file.h), and the rest frame
// has to be written, too. With "vtp" muscles carry point data: displacement
// from rest (mm), area_stretch (area of the triangles around a vertex to that
// at rest), gap to the nearest other mesh (mm, negative inside, at most
// kGapLimit) and contact (1 where the gap is at most kContactGap), and each
// muscle has its lines in lines/<name>.vtp and its fibres, if any, in
// fibres/<name>.vtp.
void WriteFrame(const PreparedScene& scene,
                const Frame& frame,
                const FrameFileOptions& options,
                const std::string& dir);

// Reads the meshes of a written frame back, bones that are written once by
// their motions. Returns the files, within `dir`, that do not hold the frame's
// points and triangles to the last bit. If there are none, the certificate of
// the frame is one of its files.
std::vector<std::string> FilesThatDiffer(const PreparedScene& scene,
                                         const Frame& frame,
                                         const FrameFileOptions& options,
                                         const std::string& dir);

// A vertex with a smaller gap than this counts as touching another mesh, mm.
constexpr double kContactGap = 0.5;

// Writes DIR/motion.pvd, the collection by which ParaView plays the .vtp files
// of `frames`, at the times of the poses if they rise, else at the indices.
void WritePvd(const PreparedScene& scene,
              const std::vector<int>& frames,
              const std::string& dir);

// Returns for each vertex the ratio of the area of the triangles around it to
// that at rest, #V; 1 where they have no area.
Eigen::VectorXd AreaStretch(const Points& rest,
                            const Points& points,
                            const Triangles& triangles);

}  // namespace musclewarp
