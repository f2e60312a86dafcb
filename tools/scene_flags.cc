// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/scene_flags.h"

#include <gflags/gflags.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "musclewarp/base/portable_path.h"
#include "tools/deformer_settings.h"
#include "tools/flag_values.h"
#include "tools/program.h"
#include "tools/split.h"

DEFINE_string(scene, "", "scene file (JSON)");
DEFINE_string(data_root,
              "",
              "folder that the paths in the scene are relative to; without it "
              "the folder of the scene file");
DEFINE_string(frames,
              "all",
              "poses to compute: all, last, N, FIRST:LAST or FIRST:LAST:STEP "
              "(last included); FIRST and LAST may be times: 0.1s:0.35s");
DEFINE_string(
    motion,
    "",
    "OpenSim motion (.mot, .sto) in place of the one the scene names");
DEFINE_string(motion_in_degrees,
              "",
              "whether angles of the motion are in degrees, for files whose "
              "header does not say so: yes or no");
DEFINE_string(geometry,
              "",
              "folders with meshes of the model, with commas, beside its own "
              "and the folder Geometry there");
DEFINE_string(contact_level,
              "coarse",
              "what meets with --contact=paper: coarse (hulls) or fine (the "
              "meshes)");
DEFINE_int32(max_iterations, 500, "of a solver, before it gives up");
DEFINE_uint32(seed, 1, "of the rays that tell inside from outside");
DEFINE_int32(threads, 0, "threads; 0: one a core");
DEFINE_double(max_hole,
              musclewarp::DeformerSettings().max_hole,
              "holes whose border is at most this long are filled when a mesh "
              "is repaired, mm; a longer one is filled only if it is a slit: "
              "if the area of its filling is at most 0.006 times the square of "
              "the length of its border");
DEFINE_int32(coarse_vertices, 200, "vertices of the hull of a muscle, about");
DEFINE_int32(bone_coarse_vertices,
             1000,
             "vertices of the hull of a bone, about (--contact_level=coarse)");
DEFINE_string(laplacian,
              "area",
              "how the rows that keep a shape weigh: area (the shape does not "
              "depend on the size of the hull) or paper (divided by the sums "
              "of their weights, as Kellnhofer and Kohout have them)");
DEFINE_double(laplacian_length,
              0,
              "with --laplacian=area, the length scale of the stiffness of a "
              "shape, mm: the larger, the stiffer; 0: by the area of the "
              "muscle");
DEFINE_string(
    lines,
    musclewarp::DeformerSettings().lines,
    "how a muscle follows its lines where they get longer or "
    "shorter: tendon (it slides along them, and thin parts keep their "
    "length), slide (all of it is stretched evenly) or fixed (each "
    "place stays in its segment, as Kellnhofer and Kohout have it)");
DEFINE_double(sample_spacing, 10, "distance of samples along a line, mm");
DEFINE_double(skeleton_weight,
              1,
              "how strongly a muscle follows its lines, against its shape");
DEFINE_double(attachment_weight,
              8,
              "how strongly coarse meshes follow the attachment areas; 0: not");
DEFINE_double(bending_weight,
              musclewarp::DeformerSettings().bending_weight,
              "how strongly fibres keep the curvature that they have at rest, "
              "against the shape of the surface; 0: not");
DEFINE_string(attachments,
              "auto",
              "which areas of muscles follow their bones: auto (those of the "
              "scene; for a muscle without any, they are found on the meshes), "
              "scene or none");
DEFINE_int32(auto_lines,
             3,
             "lines made for a muscle that has none; 1: a centre line");
DEFINE_double(gap,
              musclewarp::DeformerSettings().gap,
              "distance that certified contact keeps between surfaces, mm; at "
              "most 0.5; the default follows the size of the body");
DEFINE_int32(max_rounds,
             6,
             "rounds in which a step of certified contact resolves what still "
             "crosses, before it is given up for a shorter one");
DEFINE_double(frame_timeout_s,
              -1,
              "a frame of certified contact that takes longer than this is "
              "given up, s; 0: none is ever given up; -1: those that make no "
              "progress are, however fast and busy the machine is");
DEFINE_string(remake,
              "auto",
              "what certified contact does with muscles that cannot be "
              "separated from bones and each other by moving their vertices: "
              "auto (their meshes are made anew) or never (the scene is "
              "refused)");
DEFINE_double(max_torn_patch,
              musclewarp::DeformerSettings().max_torn_patch,
              "with --contact=certified: a frame is not usable if contact "
              "stretches a patch of a muscle larger than this, mm2, beyond "
              "twice its length at rest; 0: none is forbidden");
DEFINE_double(
    max_loss,
    musclewarp::DeformerSettings().max_loss,
    "share of the volume of a muscle, as it was delivered, that may be "
    "lost: pieces that are left out, and what goes where its mesh is "
    "made anew; with more frames are not usable");
DEFINE_double(
    max_lost_area,
    musclewarp::DeformerSettings().max_lost_area,
    "area of the surface of a muscle, mm2, that may be gone where it is made "
    "anew: "
    "farther than 3 mm, and twice its depth in others, from the new surface; "
    "with more frames are not usable");
DEFINE_double(max_lost_extent,
              musclewarp::DeformerSettings().max_lost_extent,
              "length at an end of a muscle, mm, beyond twice its depth in "
              "others, that may "
              "be gone where it is made anew; with more frames are not usable");
DEFINE_double(max_step_turn,
              20,
              "largest turn of a body in one step of certified contact, "
              "degrees; steps are shorter where contact pushes muscles far");
DEFINE_double(max_step_move,
              80,
              "largest move of a point of a line in one step of certified "
              "contact, mm");
DEFINE_bool(body_twist,
            true,
            "muscles turn about their lines as the bones at the ends do");

namespace musclewarp {
namespace {

// Returns a text as one word for a shell.
std::string ShellQuoted(const std::string& text) {
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) || std::strchr("_-+=./:,@%", c) != nullptr;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) {
    return text;
  }
  std::string quoted = "'";
  for (const char c : text)
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

DeformerSettings ChoicesFromFlags() {
  DeformerSettings choices;
  choices.contact_level = FLAGS_contact_level;
  choices.attachments = FLAGS_attachments;
  choices.remake = FLAGS_remake;
  choices.max_loss = FLAGS_max_loss;
  choices.max_lost_area = FLAGS_max_lost_area;
  choices.max_lost_extent = FLAGS_max_lost_extent;
  choices.max_torn_patch = FLAGS_max_torn_patch;
  choices.max_iterations = FLAGS_max_iterations;
  choices.seed = FLAGS_seed;
  choices.max_hole = FLAGS_max_hole;
  choices.coarse_vertices = FLAGS_coarse_vertices;
  choices.bone_coarse_vertices = FLAGS_bone_coarse_vertices;
  choices.laplacian = FLAGS_laplacian;
  choices.laplacian_length = FLAGS_laplacian_length;
  choices.lines = FLAGS_lines;
  choices.sample_spacing = FLAGS_sample_spacing;
  choices.skeleton_weight = FLAGS_skeleton_weight;
  choices.attachment_weight = FLAGS_attachment_weight;
  choices.bending_weight = FLAGS_bending_weight;
  choices.auto_lines = FLAGS_auto_lines;
  choices.gap = FLAGS_gap;
  choices.max_rounds = FLAGS_max_rounds;
  choices.frame_timeout_s = FLAGS_frame_timeout_s;
  choices.max_step_turn = FLAGS_max_step_turn;
  choices.max_step_move = FLAGS_max_step_move;
  choices.body_twist = FLAGS_body_twist;
  choices.lengths_in_mm = LengthsGiven();
  return choices;
}

// Returns the flags of these programs, without those of the libraries.
std::vector<gflags::CommandLineFlagInfo> OwnFlags() {
  std::vector<gflags::CommandLineFlagInfo> all, own;
  gflags::GetAllFlags(&all);
  for (const auto& flag : all) {
    if (flag.filename.find("tools/") != std::string::npos) own.push_back(flag);
  }
  return own;
}

// The flags that were set, but those in `without`.
std::string SetFlags(
    const std::set<std::string>& without,
    const std::function<std::string(const std::string& name,
                                    const std::string& value)>& value_of) {
  std::string text;
  for (const auto& flag : OwnFlags()) {
    if (flag.is_default || without.count(flag.name)) continue;
    text += " --" + flag.name + "=" +
            ShellQuoted(value_of(flag.name, flag.current_value));
  }
  return text;
}

std::string AsGiven(const std::string& /*name*/, const std::string& value) {
  return value;
}

std::string AbsolutePath(const std::string& path) {
  auto absolute = std::filesystem::absolute(path).lexically_normal();
  if (!absolute.has_filename()) absolute = absolute.parent_path();
  return absolute.string();
}

// Returns the value of a flag as reports have it. Paths do not depend on the
// working folder, so that the report can have them lead from its own folder
// (run/paths_in_json.h).
std::string AsRecorded(const std::string& name, const std::string& value) {
  static const std::set<std::string> kPaths = {
      "scene", "data_root", "out", "record_steps"};
  const bool is_cache = name == "cache" && !CacheFolderOf(value).empty();
  if (value.empty()) return value;
  if (kPaths.count(name) > 0 || is_cache) return AbsolutePath(value);
  if (name == "geometry") {
    std::string folders;
    for (const std::string& folder : Split(value, ',')) {
      folders += (folders.empty() ? "" : ",") + AbsolutePath(folder);
    }
    return folders;
  }
  if (name != "motion") return value;
  // It leads from the folder of the data.
  const std::string root =
      FLAGS_data_root.empty()
          ? std::filesystem::absolute(FLAGS_scene).parent_path().string()
          : FLAGS_data_root;
  return std::filesystem::path(value).is_absolute() ? PathFrom(root, value)
                                                    : value;
}

}  // namespace

std::string SceneFlagFile() {
  std::string text;
  for (const auto& flag : OwnFlags()) {
    const bool is_of_scene =
        flag.filename.find("tools/scene_flags.cc") != std::string::npos;
    if (!is_of_scene || flag.is_default || flag.name == "frames") continue;
    const bool is_path = flag.name == "scene" || flag.name == "data_root";
    text += "--" + flag.name + "=" +
            (is_path ? std::filesystem::absolute(flag.current_value).string()
                     : flag.current_value) +
            "\n";
  }
  return text;
}

ModelSources ModelSourcesFromFlags() {
  ModelSources sources;
  sources.motion = FLAGS_motion;
  sources.geometry = ParseFolders("--geometry", FLAGS_geometry);
  if (!FLAGS_motion_in_degrees.empty()) {
    sources.motion_in_degrees =
        ParseYesNo("--motion_in_degrees", FLAGS_motion_in_degrees);
  }
  return sources;
}

DeformOptions SceneOptionsFromFlags() {
  DeformOptions options;
  options.scene = FLAGS_scene;
  options.data_root = FLAGS_data_root;
  options.model = ModelSourcesFromFlags();
  options.frames = FLAGS_frames;
  options.threads = FLAGS_threads;
  options.deformer = OptionsOf(ChoicesFromFlags());
  // Programs show no gaps of vertices, but for files that DeformCommand writes.
  options.deformer.frames.measures.vertex_gaps = false;
  options.command = std::string(gflags::ProgramInvocationShortName()) +
                    SetFlags({"resume", "overwrite"}, AsRecorded);
  // Files count by their contents; threads and timing make no difference.
  std::set<std::string> other_flags = {"resume",
                                       "overwrite",
                                       "html",
                                       "profile",
                                       "cache",
                                       "record_steps",
                                       "out",
                                       "threads",
                                       "scene",
                                       "demo",
                                       "data_root",
                                       "geometry",
                                       "motion"};
  options.result_flags = SetFlags(other_flags, AsGiven);
  other_flags.insert({"frames", "format", "bones"});
  options.deformer.cache.options_key =
      "flags:" + SetFlags(other_flags, AsGiven);
  for (const auto& flag : OwnFlags()) {
    options.all_flags[flag.name] = AsRecorded(flag.name, flag.current_value);
  }
  return options;
}

void SetIterationLimit(SolverConfiguration* configuration) {
  SetIterationLimit(FLAGS_max_iterations, configuration);
}

}  // namespace musclewarp
