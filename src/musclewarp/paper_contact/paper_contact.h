// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/paper_contact/contact_body.h"
#include "musclewarp/paper_contact/paper_contact_options.h"

namespace musclewarp {

// The contact of Kellnhofer and Kohout (section 3) among muscles and between
// muscles and bones. It works on positions alone and does not know what moves
// them; GroupContact connects it with the states of a solver.
//
// Pairs of bodies are handled one after the other, A x B, then A' x C, then
// B' x C' (section 3.3), for each muscle its pairs with later muscles first and
// then those with bones. The result depends on that order, as in the paper.
// Pairs whose bounding capsules do not overlap are skipped.
class PaperContact {
 public:
  // Preconditions (CHECKed): the options are valid, muscles are deformable and
  // bones are not.
  PaperContact(const PaperContactOptions& options,
               std::vector<ContactBody> muscles,
               std::vector<ContactBody> bones);

  const ContactBody& muscle(int index) const { return muscles_[index]; }
  int num_muscles() const { return static_cast<int>(muscles_.size()); }

  // Replaces the points of a muscle (#V x 3, mm), after a step.
  void MoveMuscle(int index, Points points);

  // Removes the overlap at the start, before the first iteration (section 3.2,
  // initial_fix.h). Returns true if anything was inside.
  bool FixInitial();

  // Takes back what the last step carried into other bodies (section 3.3,
  // step_rollback.h). `before` are the points of each muscle before the step
  // (#V x 3, mm).
  void RollBack(const std::vector<Points>& before);

  // The same for a step in which the bones moved as well. Seen from a bone, a
  // muscle came from `before`, moved along with the bone. `now_from_before` are
  // the rigid motions of the bones, one per bone; if empty, no bone moved.
  void RollBack(const std::vector<Points>& before,
                const std::vector<Eigen::Matrix4d>& now_from_before);

  // Reduces the overlap that is left after the iterations (final_fix.h).
  // Returns true if anything was inside.
  bool FixRemaining();

  // For each muscle and vertex, whether the last RollBack found the vertex
  // inside another body.
  const std::vector<std::vector<char>>& found_inside() const {
    return found_inside_;
  }

 private:
  // Calls visit(a, b, index of a, index of b) for the pairs whose capsules
  // overlap. a is a muscle; the index of b is one among muscles or bones.
  template <typename Visit>
  void ForEachPair(const Visit& visit);

  PaperContactOptions options_;
  std::vector<ContactBody> muscles_;
  std::vector<ContactBody> bones_;
  std::vector<std::vector<char>> found_inside_;
};

}  // namespace musclewarp
