// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/group_contact.h"

#include <glog/logging.h>

#include <algorithm>
#include <utility>

#include "musclewarp/base/invalid_option.h"
#include "musclewarp/solver/volume_restoration.h"

namespace musclewarp {
namespace {

// Adds the moves of vertices from `followed` to `points` to their offsets.
// Differences keep the offsets of unmoved vertices exact; offsets computed anew
// would change by rounding.
void AddMoves(const Points& followed, const Points& points, Points* offset) {
  if (offset->rows() == 0) offset->setZero(points.rows(), 3);
  *offset += points - followed;
}

}  // namespace

std::string ToString(ContactLevel level) {
  return level == ContactLevel::kFine ? "fine" : "coarse";
}

bool GroupContactOptions::IsValid(std::string* error) const {
  const auto fail = [error](
                        const std::string& field, auto value, auto allowed) {
    return InvalidOption(
        "GroupContactOptions::" + field, value, allowed, error);
  };
  if (mask_memory < 1) return fail("mask_memory", mask_memory, "above 0");
  if (max_final_rounds < 0) {
    return fail("max_final_rounds", max_final_rounds, "0 or above");
  }
  return paper.IsValid(error);
}

GroupContact::GroupContact(const GroupContactOptions& options,
                           std::vector<const MuscleModel*> models,
                           PaperContact contact,
                           std::optional<PaperContact> fine_contact)
    : options_(options),
      models_(std::move(models)),
      contact_(std::move(contact)),
      fine_contact_(std::move(fine_contact)),
      before_(models_.size()),
      stepped_(models_.size()),
      max_move_(models_.size(), 0) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  CHECK_EQ(models_.size(), static_cast<size_t>(contact_.num_muscles()));
  for (int i = 0; i < contact_.num_muscles(); ++i) {
    steps_free_.emplace_back(contact_.muscle(i).points().rows(),
                             options.mask_memory);
  }
}

void GroupContact::FollowOn(const std::vector<MuscleState>& before,
                            std::vector<Eigen::Matrix4d> now_from_before) {
  follows_on_ = true;
  now_from_before_ = std::move(now_from_before);
  for (size_t i = 0; i < models_.size(); ++i) {
    before_[i] = ContactPoints(static_cast<int>(i), before[i]);
  }
}

bool GroupContact::Start(std::vector<MuscleState>* states) {
  MoveBodies(*states);
  bool was_inside = false;
  if (follows_on_) {
    contact_.RollBack(std::vector<Points>(before_), now_from_before_);
    for (size_t i = 0; i < models_.size(); ++i) {
      was_inside |= found_inside(static_cast<int>(i)) > 0;
    }
  } else {
    was_inside = contact_.FixInitial();
  }
  MoveStates(states);
  return was_inside;
}

void GroupContact::AfterStep(double alpha, std::vector<MuscleState>* states) {
  for (MuscleState& state : *states) state.corrections.fine_offset *= 1 - alpha;
  MoveBodies(*states);
  const std::vector<Points> before = before_;
  contact_.RollBack(before);
  MoveStates(states);
  for (size_t i = 0; i < models_.size(); ++i) {
    VertexCorrections& corrections = (*states)[i].corrections;
    auto& held =
        moves_fine_vertices() ? corrections.held_fine : corrections.held_coarse;
    std::vector<int>& steps_free = steps_free_[i];
    std::vector<char> is_held(steps_free.size());
    for (size_t v = 0; v < steps_free.size(); ++v) {
      steps_free[v] = contact_.found_inside()[i][v] ? 0 : steps_free[v] + 1;
      is_held[v] = steps_free[v] < options_.mask_memory;
    }
    held = HeldVertices::Of(before_[i], is_held);
    max_move_[i] = (before_[i] - before[i]).rowwise().norm().maxCoeff();
  }
}

int GroupContact::found_inside(int muscle) const {
  const auto& found = contact_.found_inside()[muscle];
  return static_cast<int>(std::count(found.begin(), found.end(), 1));
}

bool GroupContact::Finish(std::vector<MuscleState>* states) {
  PaperContact* fine = moves_fine_vertices() ? &contact_
                       : fine_contact_       ? &*fine_contact_
                                             : nullptr;
  const int count = static_cast<int>(models_.size());
  std::vector<std::vector<char>> is_held(count);
  std::vector<Points> before(count);
#pragma omp parallel for schedule(dynamic)
  for (int i = 0; i < count; ++i) {
    MuscleState& state = (*states)[i];
    state.corrections.held_coarse = HeldVertices();
    state.corrections.held_fine = HeldVertices();
    RestoreVolume(*models_[i], &state);
    is_held[i].assign(models_[i]->fine_rest.rows(), 0);
  }
  if (fine == nullptr) return true;
  for (int round = 0; round < options_.max_final_rounds; ++round) {
#pragma omp parallel for schedule(dynamic)
    for (int i = 0; i < count; ++i) {
      before[i] = FinePoints(*models_[i], (*states)[i]);
      fine->MoveMuscle(i, before[i]);
    }
    if (!fine->FixRemaining()) return true;
#pragma omp parallel for schedule(dynamic)
    for (int i = 0; i < count; ++i) {
      const Points& points = fine->muscle(i).points();
      for (Eigen::Index v = 0; v < points.rows(); ++v) {
        if (points.row(v) != before[i].row(v)) is_held[i][v] = 1;
      }
      VertexCorrections& corrections = (*states)[i].corrections;
      AddMoves(before[i], points, &corrections.fine_offset);
      corrections.held_fine = HeldVertices::Of(points, is_held[i]);
      RestoreVolume(*models_[i], &(*states)[i]);
    }
  }
  return false;
}

Points GroupContact::ContactPoints(int muscle, const MuscleState& state) const {
  return moves_fine_vertices() ? FinePoints(*models_[muscle], state)
                               : state.coarse;
}

void GroupContact::MoveBodies(const std::vector<MuscleState>& states) {
  for (size_t i = 0; i < models_.size(); ++i) {
    stepped_[i] = ContactPoints(static_cast<int>(i), states[i]);
    contact_.MoveMuscle(static_cast<int>(i), stepped_[i]);
  }
}

void GroupContact::MoveStates(std::vector<MuscleState>* states) {
  for (size_t i = 0; i < models_.size(); ++i) {
    before_[i] = contact_.muscle(static_cast<int>(i)).points();
    MuscleState& state = (*states)[i];
    if (moves_fine_vertices()) {
      AddMoves(stepped_[i], before_[i], &state.corrections.fine_offset);
    } else {
      state.coarse = before_[i];
    }
  }
}

}  // namespace musclewarp
