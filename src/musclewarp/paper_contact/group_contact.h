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

// The surfaces that are tested against each other during the iterations.
enum class ContactLevel {
  kCoarse,  // the hulls, as in the paper: fast, but keeps the hulls apart
  kFine,    // the fine meshes: slower, lets the muscles touch
};

// Returns "coarse" or "fine", the text of flags and reports.
std::string ToString(ContactLevel level);

struct GroupContactOptions {
  ContactLevel level = ContactLevel::kCoarse;
  PaperContactOptions paper;

  // For this many iterations after it was found inside another body, a vertex
  // takes no part in the volume correction ("masking"). The paper has 1. But
  // two muscles that give way by 0.6 each are inside each other in every second
  // iteration only, and the volume correction would swing between the vertices
  // in contact and the others.
  int mask_memory = 5;

  // Largest number of rounds of the final check on the fine meshes; 0 leaves
  // it out.
  int max_final_rounds = 40;

  // Returns false and names the field, its value and the rule if a field, one
  // of `paper` included, is out of range.
  bool IsValid(std::string* error) const;
};

// Applies the contact of PaperContact to the states of a group of muscles,
// whichever solver moves them:
//
//   GroupContact contact(...);
//   contact.Start(&states);
//   for (...) {
//     ... states[i].coarse += alpha * h ...
//     contact.AfterStep(alpha, &states);
//   }
//   contact.Finish(&states);
//
// At the coarse level the points in contact are X, and rolling back changes X
// itself. At the fine level they are W X + offset, and rolling back changes the
// offset of single vertices. The offset decays by the factor 1 - alpha in each
// step, so that a fine vertex that is set free returns to W X as a coarse one
// returns to X*.
class GroupContact {
 public:
  // `contact` has the muscles of `models`, in the same order, with hulls or
  // fine meshes according to the level of the options. `fine_contact` has their
  // fine meshes and serves the final check at the coarse level; without it that
  // check is left out. Keeps pointers to the models.
  // Precondition (CHECKed): the options are valid.
  GroupContact(const GroupContactOptions& options,
               std::vector<const MuscleModel*> models,
               PaperContact contact,
               std::optional<PaperContact> fine_contact);

  // To be called before Start if the states continue those of an earlier pose,
  // `before`, in which nothing was inside anything else that could be helped.
  // Start then makes no initial fix. Instead it treats the whole way from there
  // as one step and rolls back what that carried into other bodies, so that the
  // side of every contact is known. `now_from_before` are the rigid motions of
  // the bones since then, one per bone, translations in mm.
  void FollowOn(const std::vector<MuscleState>& before,
                std::vector<Eigen::Matrix4d> now_from_before);

  // Makes the initial fix, before the first iteration (paper section 3.2).
  // Returns true if it changed the states.
  bool Start(std::vector<MuscleState>* states);

  // Rolls back and masks vertices after the step X <- X + alpha h of all
  // muscles (paper section 3.3).
  void AfterStep(double alpha, std::vector<MuscleState>* states);

  // Makes the final check on the fine meshes: vertices that are still inside
  // another body are pushed out (PushOut) and the volume is restored with these
  // vertices held, in rounds, until nothing is inside or max_final_rounds have
  // passed. Returns true if nothing is inside, or if there is no check to make.
  // The volume is restored in any case.
  bool Finish(std::vector<MuscleState>* states);

  // Whether contact moves fine vertices. The volume of the coarse mesh does not
  // reflect such moves.
  bool moves_fine_vertices() const {
    return options_.level == ContactLevel::kFine;
  }

  // The largest move of a vertex of a muscle, at the level of contact, in the
  // last step with its rollback, mm.
  double max_move(int muscle) const { return max_move_[muscle]; }

  // The points of a muscle after the last call, at the level of contact, mm.
  const Points& points(int muscle) const { return before_[muscle]; }

  // The number of vertices of a muscle that the last rollback found inside
  // another body.
  int found_inside(int muscle) const;

 private:
  Points ContactPoints(int muscle, const MuscleState& state) const;
  // Moves the bodies to where the states are, and the states to where the
  // bodies went.
  void MoveBodies(const std::vector<MuscleState>& states);
  void MoveStates(std::vector<MuscleState>* states);

  GroupContactOptions options_;
  std::vector<const MuscleModel*> models_;
  PaperContact contact_;
  std::optional<PaperContact> fine_contact_;
  std::vector<Points> before_;   // points in contact after the last call
  std::vector<Points> stepped_;  // the same before contact moved them
  bool follows_on_ = false;
  std::vector<Eigen::Matrix4d> now_from_before_;  // one per bone
  std::vector<double> max_move_;                  // one per muscle, mm
  // Per muscle and vertex: steps since it was last found inside another body.
  std::vector<std::vector<int>> steps_free_;
};

}  // namespace musclewarp
