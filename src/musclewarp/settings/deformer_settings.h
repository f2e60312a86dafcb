// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/base/angles.h"
#include "musclewarp/deformer/deformer.h"
#include "musclewarp/settings/rest_settings.h"

namespace musclewarp {

// The settings of a Deformer: flags of musclewarp-deform and keywords of
// Python.
struct DeformerSettings : RestSettings {
  std::string contact = "certified";
  std::string solver = "ceres";
  std::string attachments = "auto";
  int auto_lines = PrepareOptions().auto_lines;
  std::string made_lines = "taut";
  int fibres = PrepareOptions().fibres.fibres;
  double max_torn_patch = FrameRequirements().max_torn_patch;
  int coarse_vertices = OuterHullOptions().coarse_vertices;
  std::string laplacian = "area";
  double laplacian_length = CotangentLaplacianOptions().length_scale;
  std::string lines = "tendon";
  double sample_spacing = MuscleModelOptions().sample_spacing;
  double skeleton_weight = MuscleModelOptions().skeleton_weight;
  double attachment_weight = MuscleModelOptions().attachment_weight;
  double bending_weight = MuscleModelOptions().bending_weight;
  bool body_twist = PreRotationOptions().use_body_twist;
  bool bone_push = DeformerOptions().bone_push.enabled;
  int max_rounds = StepOptions().max_rounds;
  double max_step_turn = DegreesOf(CertifiedContactOptions().limits.max_turn);
  double max_step_move = CertifiedContactOptions().limits.max_move;
  double frame_timeout_s = CertifiedContactOptions().frame_timeout_s;
  int max_iterations = GaussNewtonOptions().max_iterations;
  std::string contact_level = "coarse";
  int bone_coarse_vertices = PaperSceneOptions().bone_hull.coarse_vertices;
  unsigned seed = PaperContactOptions().seed;
  std::string cache = "none";
  double max_memory_gib = 0;
};

constexpr auto FieldsOf(Described<DeformerSettings>) {
  using S = DeformerSettings;
  constexpr double kLargestWeight = 1e6;
  return std::make_tuple(
      Field(&S::contact, "contact")
          .Text("certified (no triangles of muscles cross each other or "
                "bones), paper (muscles keep out of each other and of bones as "
                "in Kellnhofer and Kohout) or none (every muscle deforms on "
                "its own)")
          .OneOf("certified, paper, none"),
      Inherited<RestSettings>(),
      Field(&S::max_torn_patch, "max_torn_patch", "mm2")
          .Text("with {contact}=certified, largest patch of a muscle that "
                "contact may stretch beyond twice its length at rest; with a "
                "larger one the frame is not usable; 0: no limit")
          .AtLeast(0),
      Field(&S::solver, "solver")
          .Text("ceres, or reference (Gauss-Newton with a Lagrange multiplier, "
                "as in the paper)")
          .OneOf("ceres, reference"),
      Field(&S::attachments, "attachments")
          .Text("areas of muscles that follow their bones: auto (those of the "
                "scene, and for a muscle without any those found on the "
                "meshes), scene or none")
          .OneOf("auto, scene, none"),
      Field(&S::auto_lines, "auto_lines")
          .Text("number of action lines that are made for a muscle without "
                "any; 1: a centre line")
          .AtLeast(1),
      Field(&S::made_lines, "made_lines")
          .Text("course of lines that are made, and of those that slide: taut "
                "(as short as what supports them at rest allows) or guided "
                "(each point moves with the nearest body)")
          .OneOf("taut, guided"),
      Field(&S::fibres, "fibres")
          .Text("number of fibres of each muscle, written with vtp and as "
                "tables")
          .AtLeast(0),
      Field(&S::coarse_vertices, "coarse_vertices")
          .Text("approximate number of vertices of the hull of a muscle")
          .Within(20, 5000),
      Field(&S::laplacian, "laplacian")
          .Text("weights of the rows that keep a shape: area (the shape does "
                "not depend on the size of the hull) or paper (divided by the "
                "sums of their weights, as in Kellnhofer and Kohout)")
          .OneOf("area, paper"),
      Field(&S::laplacian_length, "laplacian_length", "mm")
          .Text("with {laplacian}=area, length scale of the stiffness of a "
                "shape: the larger, the stiffer; 0: by the area of the muscle")
          .AtLeast(0),
      Field(&S::lines, "lines")
          .Text("how a muscle follows its lines as their lengths change: "
                "tendon (it slides along them, and thin parts keep their "
                "length), slide (it is stretched evenly) or fixed (each place "
                "stays in its segment, as in Kellnhofer and Kohout)")
          .OneOf("tendon, slide, fixed"),
      Field(&S::sample_spacing, "sample_spacing", "mm")
          .Text("distance of samples along a line")
          .AtLeast(0.01),
      Field(&S::skeleton_weight, "skeleton_weight")
          .Text("weight with which a muscle follows its lines, against its "
                "shape")
          .Above(0, kLargestWeight),
      Field(&S::attachment_weight, "attachment_weight")
          .Text("weight with which coarse meshes follow the attachment areas; "
                "0: not at all")
          .Within(0, kLargestWeight),
      Field(&S::bending_weight, "bending_weight")
          .Text("weight with which fibres keep their curvature at rest, "
                "against the shape of the surface; 0: not at all")
          .Within(0, kLargestWeight),
      Field(&S::body_twist, "body_twist")
          .Text("turn muscles about their lines as the bones at their ends "
                "turn"),
      Field(&S::bone_push, "bone_push")
          .Text("bones push muscles aside before contact does; never with "
                "{contact}=paper"),
      Field(&S::max_rounds, "max_rounds")
          .Text("rounds in which a step of certified contact resolves what "
                "still crosses, before a shorter step replaces it")
          .AtLeast(1),
      Field(&S::max_step_turn, "max_step_turn", "degrees")
          .Text("largest turn of a body in one step of certified contact; "
                "steps are shorter where contact pushes muscles far")
          .Above(0),
      Field(&S::max_step_move, "max_step_move", "mm")
          .Text("largest move of a point of a line in one step of certified "
                "contact")
          .Above(0),
      Field(&S::frame_timeout_s, "frame_timeout_s", "s")
          .Text("time after which a frame of certified contact is given up; 0: "
                "none ever is; -1: frames without progress are, however fast "
                "and busy the machine is")
          .AtLeast(0)
          .Or(CertifiedContactOptions::kNoClock),
      Field(&S::max_iterations, "max_iterations")
          .Text("largest number of iterations of a solver")
          .AtLeast(1),
      Field(&S::contact_level, "contact_level")
          .Text("with {contact}=paper, the surfaces that must not cross: "
                "coarse (the hulls) or fine (the meshes)")
          .OneOf("coarse, fine"),
      Field(&S::bone_coarse_vertices, "bone_coarse_vertices")
          .Text("with {contact}=paper and {contact_level}=coarse, approximate "
                "number of vertices of the hull of a bone")
          .Within(20, 5000),
      Field(&S::seed, "seed")
          .Text("with {contact}=paper, seed of the random rays of the inside "
                "test"),
      Field(&S::cache, "cache")
          .Text("folder in which the preparation of the scene is kept for "
                "later runs; none: every run prepares it anew")
          .Path()
          .Changes(Effect::kNothing),
      Field(&S::max_memory_gib, "max_memory_gib", "GiB")
          .Text(
              "memory that a run may take; a scene that needs more is refused "
              "before it is prepared; 0: 80 % of what the machine has left")
          .AtLeast(0)
          .Changes(Effect::kNothing));
}

// Returns the options that the settings mean. Throws InputError, naming the
// setting, for a value that is not allowed.
DeformerOptions OptionsOf(const DeformerSettings& settings);

// Sets the iteration limits of all solvers of a configuration.
void SetIterationLimit(int max_iterations, SolverConfiguration* configuration);

}  // namespace musclewarp
