// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "musclewarp/base/stage_times.h"
#include "musclewarp/certificate/bone_overlaps.h"
#include "musclewarp/certificate/delivered_crossings.h"
#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/frames/shape_measures.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/preparation/attachments.h"
#include "musclewarp/solver/solver_summary.h"

namespace musclewarp {

// A muscle in one pose.
struct MuscleFrame {
  std::string name;
  Points points;  // of the fine mesh, n x 3, mm
  SolverSummary solver;

  // The volume of the fine mesh against that of the mesh as it was delivered
  // (MeshPreparation::delivered_volume).
  double volume_ratio = 0;

  // How far the volume is off the one that the solver keeps, that of the mesh
  // at rest, as a share of it: an error of the solver. What the preparation
  // took is in the ratio.
  double volume_error = 0;
  int folded_triangles = 0;
  double max_displacement = 0;  // of a fine vertex from rest, mm

  // The smallest distance of a vertex to another mesh, mm, negative inside one;
  // at most kGapLimit. And the distance of each vertex, n, if it was asked for
  // (MeasureOptions).
  double min_gap = 0;
  Eigen::VectorXd gaps;
  int self_pairs = 0;  // of triangles that cross each other

  // With certified contact: how far contact moved a fine vertex, at most and on
  // average, and how deep the muscle is in another mesh, or another in it,
  // without contact, mm.
  double max_contact_displacement = 0;
  double mean_contact_displacement = 0;
  double depth_without_contact = 0;

  // The largest patch of its surface that contact has torn.
  SurfacePatch torn_patch;

  // The muscles that push this one, which comes last, and the depths of all
  // overlaps along that chain without contact, mm: what its displacement is
  // judged by.
  std::vector<std::string> pushed_by;
  double push_depth = 0;

  // How far each attachment area has left its body.
  std::vector<AttachmentDrift> attachments;

  // What the pose does to its shape.
  ShapeMeasures shape;

  // The action lines, sampled, and the fibres, as the muscle carries them; #P x
  // 3 each, mm.
  std::vector<Points> lines;
  std::vector<Points> fibres;

  // The length of each action line straight through its path points, mm.
  std::vector<double> path_lengths;

  // -dl/dq of each line and fibre by coordinate, mm/rad (or mm/m). There are
  // none without a model, nor with the paper's contact, which ends in no
  // minimum that could be differentiated.
  std::map<std::string, std::vector<double>> line_moment_arms;
  std::map<std::string, std::vector<double>> fibre_moment_arms;
};

// Gaps to other meshes are measured up to this distance, mm.
constexpr double kGapLimit = 5;

// A whole scene in one pose, with everything that is known about it. Muscles
// and bones are in the order of the scene.
//
//   const Frame frame = deformer.MoveTo(pose);
//   if (!frame.IsUsable()) LOG(WARNING) << frame.FullReport();
//   for (const MuscleFrame& muscle : frame.muscles) {
//     Show(muscle.name, muscle.points);
//   }
struct Frame {
  int index = -1;  // of the pose in its scene, or -1
  std::string name;
  double time = 0;                            // s
  std::map<std::string, double> coordinates;  // of the model, rad or m
  std::vector<MuscleFrame> muscles;
  std::vector<Points> bones;  // #V x 3 each, mm

  // The rigid motions of the bones from rest, 4 x 4, translation in mm: `bones`
  // are the points at rest, Transformed() by them.
  std::vector<Eigen::Matrix4d> bones_from_rest;

  // -dl/dq of the straight lines, by line and coordinate, mm/rad (or mm/m).
  std::map<std::string, std::map<std::string, double>> path_moment_arms;

  // False if the shape of a muscle could not be differentiated, which happens
  // where it is no minimum.
  bool moment_arms_converged = true;

  // What crosses, counted by exact tests on these very points, and the proved
  // gaps between meshes.
  SceneIntersections intersections;

  // What muscles have in common with triangles of bones as they were delivered
  // that the repaired bones do not have; empty if there is nothing.
  std::vector<DeliveredCrossing> delivered_crossings;
  int pose_steps = 1;  // on the way from the frame before

  // With certified contact, the bones of different bodies that lie in each
  // other. Looked for only if the frame is not usable or a muscle leaves a bone
  // that it is attached to, as they may be why.
  std::vector<BoneOverlap> bone_overlaps;

  // What a certified frame has to hold and this one does not, a sentence each
  // (certificate/shortcomings.h). None of a frame without certified contact.
  std::vector<std::string> shortcomings;

  double wall_ms = 0;         // for moving the scene to the pose
  double solve_ms = 0;        // of that, in the solver
  double certify_ms = 0;      // for intersections, gaps and folded triangles
  double moment_arms_ms = 0;  // for all moment arms

  // Where that time went, if DeformerOptions::record_stages asked for it. Short
  // work between the stages is in none of them.
  std::vector<StageTime> stages;

  // True if every solve converged and there are no shortcomings.
  bool IsUsable() const;

  // Solver iterations of all muscles together.
  int iterations() const;

  // "converged", or the reason and the muscle whose solve did not converge.
  std::string stop_reason() const;

  // The largest |volume ratio - 1| of a muscle.
  double WorstVolumeError() const;

  // One line: the name of the pose, whether the frame is usable, and how many
  // triangles cross.
  std::string BriefReport() const;

  // The brief report, a line for each muscle, and all shortcomings.
  std::string FullReport() const;
};

}  // namespace musclewarp
