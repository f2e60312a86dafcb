// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/paper_contact/contact_body.h"
#include "musclewarp/paper_contact/paper_contact_options.h"

namespace musclewarp {

// The contact of Kellnhofer and Kohout between muscles and with bones: what
// happens to positions, whoever moves them. Pairs are handled one after the
// other, A x B, then A' x C, then B' x C' (paper section 3.3), muscles first;
// the result depends on their order.
class PaperContact {
 public:
  // Precondition (CHECKed): the options are valid; muscles deformable, bones
  // not.
  PaperContact(const PaperContactOptions& options,
               std::vector<ContactBody> muscles,
               std::vector<ContactBody> bones);

  const ContactBody& muscle(int index) const { return muscles_[index]; }
  int num_muscles() const { return static_cast<int>(muscles_.size()); }
  void MoveMuscle(int index, Points points);

  // Section 3.2, before the first iteration. True if anything was inside.
  bool FixInitial();

  // Section 3.3, after a step of all muscles from `before` (a muscle each).
  void RollBack(const std::vector<Points>& before);

  // The same after a step in which the bones moved as well: seen from a bone, a
  // muscle came from `before` moved along with the bone. `now_from_before`, a
  // bone each; none: they stayed.
  void RollBack(const std::vector<Points>& before,
                const std::vector<Eigen::Matrix4d>& now_from_before);

  // What is left at the end (final_fix.h). True if anything was inside.
  bool FixRemaining();

  // By muscle, #V: the vertices that the last RollBack found inside another
  // body.
  const std::vector<std::vector<char>>& found_inside() const {
    return found_inside_;
  }

 private:
  // Calls visit(a, b, index of a, index of b among muscles or bones) for the
  // pairs whose capsules overlap.
  template <typename Visit>
  void ForEachPair(const Visit& visit);

  PaperContactOptions options_;
  std::vector<ContactBody> muscles_;
  std::vector<ContactBody> bones_;
  std::vector<std::vector<char>> found_inside_;
};

}  // namespace musclewarp
