// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/paper_contact.h"

#include <glog/logging.h>

#include <string>
#include <utility>

#include "musclewarp/mesh/transformed.h"
#include "musclewarp/paper_contact/final_fix.h"
#include "musclewarp/paper_contact/initial_fix.h"
#include "musclewarp/paper_contact/step_rollback.h"

namespace musclewarp {

PaperContact::PaperContact(const PaperContactOptions& options,
                           std::vector<ContactBody> muscles,
                           std::vector<ContactBody> bones)
    : options_(options),
      muscles_(std::move(muscles)),
      bones_(std::move(bones)) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  for (const ContactBody& muscle : muscles_) {
    CHECK(muscle.is_deformable()) << muscle.shape().name;
    found_inside_.emplace_back(muscle.points().rows(), 0);
  }
  for (const ContactBody& bone : bones_) {
    CHECK(!bone.is_deformable()) << bone.shape().name;
  }
}

void PaperContact::MoveMuscle(int index, Points points) {
  muscles_[index].MoveTo(std::move(points));
}

bool PaperContact::FixInitial() {
  bool was_inside = false;
  ForEachPair([&](ContactBody* a, ContactBody* b, int, int) {
    was_inside |= FixInitialIntersections(options_, a, b);
  });
  return was_inside;
}

bool PaperContact::FixRemaining() {
  bool was_inside = false;
  ForEachPair([&](ContactBody* a, ContactBody* b, int, int) {
    was_inside |= PushOut(options_, a, b);
  });
  return was_inside;
}

void PaperContact::RollBack(const std::vector<Points>& before) {
  RollBack(before, {});
}

void PaperContact::RollBack(
    const std::vector<Points>& before,
    const std::vector<Eigen::Matrix4d>& now_from_before) {
  CHECK_EQ(before.size(), muscles_.size());
  CHECK(now_from_before.empty() || now_from_before.size() == bones_.size());
  for (auto& found : found_inside_) found.assign(found.size(), 0);
  const Points none;
  ForEachPair([&](ContactBody* a, ContactBody* b, int a_idx, int b_idx) {
    const bool is_bone = !b->is_deformable();
    const bool bone_moved = is_bone && !now_from_before.empty();
    RollBackStep(options_,
                 bone_moved ? Transformed(before[a_idx], now_from_before[b_idx])
                            : before[a_idx],
                 is_bone ? none : before[b_idx],
                 a,
                 b,
                 &found_inside_[a_idx],
                 is_bone ? nullptr : &found_inside_[b_idx]);
  });
}

template <typename Visit>
void PaperContact::ForEachPair(const Visit& visit) {
  const auto visit_if_near =
      [&](ContactBody* a, ContactBody* b, int a_idx, int b_idx) {
        if (Overlap(a->capsule(), b->capsule())) visit(a, b, a_idx, b_idx);
      };
  for (int i = 0; i < num_muscles(); ++i) {
    for (int j = i + 1; j < num_muscles(); ++j) {
      visit_if_near(&muscles_[i], &muscles_[j], i, j);
    }
    for (size_t j = 0; j < bones_.size(); ++j) {
      visit_if_near(&muscles_[i], &bones_[j], i, static_cast<int>(j));
    }
  }
}

}  // namespace musclewarp
