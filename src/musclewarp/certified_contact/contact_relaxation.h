// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "musclewarp/certified_contact/contact_mesh.h"
#include "musclewarp/certified_contact/separation.h"
#include "musclewarp/geometry/triangle_bvh.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

struct ContactRelaxationOptions {
  // Kept between two surfaces, mm.
  double gap = 0.1;
  // How fast an offset dies away from where contact asks for it, mm.
  double smoothing_length = 8;
  // How far a vertex may go in one step from where it is carried to without
  // being pushed, mm. What is nearer than most of that is looked at.
  double reach = 1;
  // Sweeps over all vertices; after defects were found.
  int sweeps = 24;
  int repair_sweeps = 10;
  // Of the volume, relative.
  double volume_tolerance = 1e-8;
  // Of the triangles of a muscle; more are unfolded.
  double max_folded_share = 5e-4;

  bool IsValid(std::string* error) const;
};

// Where muscles and bones are, and where the muscles would be without what
// contact does to single vertices: where their coarse meshes have them.
struct ContactState {
  std::vector<Points> points;   // of the muscles, #V x 3, mm
  std::vector<Points> targets;  // #V x 3, mm
  std::vector<Eigen::Matrix4d> bones_from_rest;
};

// What is wrong with a state.
struct StateDefects {
  int crossing_pairs = 0;  // of triangles of two meshes
  // Of triangles of one muscle, if it has more than at rest: those that are
  // apart in the state before or in the targets, so that planes can part them.
  int self_pairs = 0;
  // Triangles turned over against their targets, if a muscle has too many.
  int folded = 0;
};

// One step of contact: from a clean state, in which no triangles cross, to
// another one nearby, where bones and targets are elsewhere.
//
// A plane that parts two triangles now is a side for each of them to stay on:
// a triangle lies beyond a plane if its corners do. So contact becomes a few
// half-spaces for each vertex by itself. Planes against bones move as the bone
// does. In the frame of the bone the plane stands still and, half-spaces being
// convex, the straight way of a vertex from here to there stays in it: no
// muscle passes through a bone between the two states. Planes between two
// muscles (or two sheets of one) turn with them and lie where both want to go
// equally far beyond them.
//
// In their half-spaces the vertices take the places p = target + offset that
// minimise
//
//   1/2 sum_edges w |o_i - o_j|^2 + 1/2 sum_vertices area / length^2 |o_i|^2,
//
// by projected Gauss-Seidel sweeps: an obstacle problem, whose solution is as
// small and smooth as contact lets it be, and zero where there is none.
//
// Muscles are treated alike: nothing depends on their order but rounding.
class ContactRelaxation {
 public:
  // Keeps references to the meshes. `clean` and `next` have the same muscles
  // and bones; the points of `next` are not used. Precondition (CHECKed): the
  // options are valid.
  ContactRelaxation(const ContactRelaxationOptions& options,
                    const std::vector<ContactMesh>& muscles,
                    const std::vector<const TriangleBvh*>& rest_bones,
                    const ContactState& clean,
                    const ContactState& next);

  void Sweep(int sweeps);

  // Of those of the vertices that are near planes, each with the one of these
  // on the wrong side of which its target is farthest, or that it is nearest
  // to.
  std::vector<VertexHalfSpace> TightestPlanes(
      int muscle, const std::vector<int>& vertices) const;

  // From now on offsets are those from `targets` (#V x 3 each).
  void SetTargets(std::vector<Points> targets) {
    targets_ = std::move(targets);
  }

  // Moves vertices that no plane holds along their normals, until volumes are
  // as they should be (paper section 3.3: what is in contact takes no part).
  // Returns the largest relative error left.
  double RestoreVolumes();

  // Looks for triangles that cross all the same, by an exact test, or are
  // folded, and adds planes for them: the next Sweep() will set them right.
  // Those of one muscle move more as one piece from then on.
  StateDefects AddDefects();

  // By how much a vertex is on the wrong side of a plane against another mesh,
  // at most, mm.
  double WorstViolation() const;

  const std::vector<Points>& points() const { return points_; }

 private:
  // A plane between two muscles, or within one: a is above it, b below. In a
  // triangle that must not fold a is a corner and b the edge opposite to it.
  struct Plane {
    int muscle_a, muscle_b;
    Eigen::RowVector3i a, b;  // vertices
    Eigen::RowVector3d normal;
    double half_gap;
    double distance;  // before, mm
    int corner = -1;  // a vertex that stays on it
    double level = 0;
    double bias = 0;

    bool IsWithinOne() const { return muscle_a == muscle_b; }
  };
  // A side for a vertex to stay on: sign * normal . p >= level. That of a
  // plane of planes_ has its normal and level.
  struct Side {
    int vertex;
    int plane;  // -1: a bone's
    double sign;
    HalfSpace space;
    double distance = 0;  // of the triangles before, mm
  };

  int num_muscles() const { return static_cast<int>(muscles_.size()); }
  void FindBonePlanes(int bone);
  void AddBonePlane(int muscle, int triangle, int bone, const HalfSpace& space);
  void FindMusclePlanes(int a, int b);
  Plane PlaneOf(int a, int b, const PartedPair& pair) const;
  bool AddSheetPlane(int muscle, int f, int g);
  void AddPlane(const Plane& plane);
  // A normal between triangle f of muscle a and g of b, as they turn.
  Eigen::RowVector3d Turned(
      int a, int f, int b, int g, const Eigen::RowVector3d& before) const;
  void Stiffen(int muscle, const std::vector<int>& triangles);
  int AddSelfCrossings(int muscle);
  int AddMuscleCrossings(int a, int b);
  int AddBoneCrossings(int bone);
  int AddFolded(int muscle);
  void SortSides();
  void SetLevels(bool is_first);
  void SweepMuscle(int muscle, bool is_full);
  double RestoreVolume(int muscle);
  double Level(const Side& side) const;
  void FindNearSides(int muscle, int vertex, const Eigen::RowVector3d& point);
  // The nearest point on the right side of the near ones.
  Eigen::RowVector3d Projected(int muscle,
                               int vertex,
                               const Eigen::RowVector3d& point) const;

  const ContactRelaxationOptions options_;
  const std::vector<ContactMesh>& muscles_;
  const std::vector<const TriangleBvh*>& rest_bones_;
  const std::vector<Eigen::Matrix4d> bones_before_, bones_;
  std::vector<Points> clean_, carried_, targets_, points_, wishes_;
  // By muscle, by triangle: from clean_ to carried_, for row vectors.
  std::vector<std::vector<Eigen::Matrix3d>> turns_;
  std::vector<Eigen::VectorXd> stiffness_;  // by muscle, by vertex
  std::vector<std::unique_ptr<TriangleBvh>> clean_trees_, trees_;
  std::vector<Plane> planes_;
  std::vector<std::vector<Side>> sides_;       // by muscle, by vertex
  std::vector<std::vector<int>> first_sides_;  // of a vertex
  // Of the sides of a vertex those that it may meet next; the first
  // num_near_sides_ from first_sides_ on.
  std::vector<std::vector<int>> near_sides_, num_near_sides_;
};

}  // namespace musclewarp
