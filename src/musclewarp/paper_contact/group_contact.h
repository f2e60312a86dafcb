// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "musclewarp/paper_contact/paper_contact.h"
#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_state.h"

namespace musclewarp {

// Which surfaces meet.
enum class ContactLevel {
  kCoarse,  // the hulls, as in the paper: quick, keeps hulls apart
  kFine,    // the meshes themselves: lets them touch
};

// "coarse" or "fine": the text of flags and reports.
std::string ToString(ContactLevel level);

struct GroupContactOptions {
  ContactLevel level = ContactLevel::kCoarse;
  PaperContactOptions paper;

  // A vertex takes no part in the volume correction for so many iterations
  // after it was found inside another body. The paper has 1; but as two muscles
  // give way by 0.6 each, vertices in contact are found inside in every second
  // iteration only, and the volume correction would swing between them and the
  // others.
  int mask_memory = 5;

  // Rounds of the final check and fix of the fine meshes; 0 leaves it out.
  int max_final_rounds = 40;

  bool IsValid(std::string* error) const;
};

// The contact policy of a group of muscles, for whatever solver moves them:
//
//   GroupContact contact(...);
//   contact.Start(&states);
//   for (...) {
//     ... states[i].coarse += alpha * h ...
//     contact.AfterStep(alpha, &states);
//   }
//   contact.Finish(&states);
//
// At the coarse level the points in contact are X and what is rolled back is X
// itself. At the fine level they are W X + offset and what is rolled back is
// the offset of single vertices, which otherwise dies away by alpha in each
// step: a vertex set free then goes back to W X as a coarse one goes to X*.
class GroupContact {
 public:
  // Keeps pointers to the models. The muscles of `contact` are those of the
  // models, at the level of the options. `fine_contact` is for the final check
  // on the fine meshes; without it there is none at the coarse level.
  // Precondition (CHECKed): the options are valid.
  GroupContact(const GroupContactOptions& options,
               std::vector<const MuscleModel*> models,
               PaperContact contact,
               std::optional<PaperContact> fine_contact);

  // Before Start: the states follow on those of a pose before, in which nothing
  // was inside anything that could be helped. Start then has no initial fix to
  // make but takes back, as after any step, what the way from there carried
  // into other bodies: the side of every contact is known. `now_from_before`:
  // the motion of the bones since then.
  void FollowOn(const std::vector<MuscleState>& before,
                std::vector<Eigen::Matrix4d> now_from_before);

  // The initial fix, before the first iteration. True if it changed the states.
  bool Start(std::vector<MuscleState>* states);

  // After X <- X + alpha h of all muscles: rollback and masking.
  void AfterStep(double alpha, std::vector<MuscleState>* states);

  // The volume of the coarse mesh does not see what this moves.
  bool moves_fine_vertices() const {
    return options_.level == ContactLevel::kFine;
  }

  // The largest move of a vertex in contact level of a muscle in the last step,
  // rollback included, mm.
  double max_move(int muscle) const { return max_move_[muscle]; }

  // Of a muscle after the last call, at the level of contact, mm.
  const Points& points(int muscle) const { return before_[muscle]; }

  // Vertices found inside another body by the last AfterStep.
  int found_inside(int muscle) const;

  // The final check and fix on the fine meshes: what is still inside another
  // body is pushed out (contact/final_fix.h) and the volume restored with those
  // vertices held, until nothing is inside or max_final_rounds have passed.
  // True if nothing is inside.
  bool Finish(std::vector<MuscleState>* states);

 private:
  Points ContactPoints(int muscle, const MuscleState& state) const;
  // Moves the bodies to the states, and the states to where the bodies went.
  void MoveBodies(const std::vector<MuscleState>& states);
  void MoveStates(std::vector<MuscleState>* states);

  GroupContactOptions options_;
  std::vector<const MuscleModel*> models_;
  PaperContact contact_;
  std::optional<PaperContact> fine_contact_;
  std::vector<Points> before_;  // points in contact after the last call
  bool follows_on_ = false;
  std::vector<Eigen::Matrix4d> now_from_before_;  // of the bones
  std::vector<Points> stepped_;  // the same before the bodies were moved
  std::vector<double> max_move_;
  // Steps since a vertex was last found inside another body.
  std::vector<std::vector<int>> steps_free_;
};

}  // namespace musclewarp
