// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/anatomy/bone_places.h"

namespace musclewarp {

// One end of a muscle, or one of several ends on its side.
struct AnatomicalEnd {
  // "calcaneal_tuberosity", one of LandmarkNames().
  std::string landmark;

  // Where it is, in the order in which bones of a scene are to be tried: the
  // first that the scene has is to be taken. Not empty.
  std::vector<BonePlace> places;

  // What says so, such as "Gray 1918, IV 8c".
  std::string source;
};

// Where a muscle begins and ends.
struct MuscleFacts {
  // As anatomy has it, without side: "tibialis_anterior".
  std::string name;

  // Its concept in the Foundational Model of Anatomy, as in the list of parts
  // of BodyParts3D; empty for groups that have none there.
  std::string fma_id;

  // The bones on which it begins and ends, each once, the main one first: the
  // first place of each end below.
  std::vector<std::string> origins;
  std::vector<std::string> insertions;

  // The same with landmarks. What ends in a fascia has the bone that the fascia
  // goes to; the membranes and septa between bones are left out.
  std::vector<AnatomicalEnd> origin_ends;
  std::vector<AnatomicalEnd> insertion_ends;

  // What keeps the tendon to the insertion near the bones, from the muscle on:
  // grooves, and what lies below retinacula.
  std::vector<AnatomicalEnd> pulleys;

  // Other names; that they are found in other spellings, too, is said at
  // MuscleKey().
  std::vector<std::string> aliases;
};

// Returns all muscles and groups of muscles that are known.
const std::vector<MuscleFacts>& AllMuscleFacts();

// Returns the muscle, or the group of muscles, of a name, or nullptr for a name
// that is not known. Known are the names of TotalSegmentator
// ("gluteus_maximus_left"), MuscleMap, BodyParts3D ("long head of right biceps
// femoris"), OpenSim's models ("bflh_r", "tib_ant_r") and Latin ("m. soleus"),
// of either side and in any spelling that MuscleKey() takes for the same. The
// whole name has to be known: "tibialis" is no muscle, and "soleus_fascia" not
// the soleus.
const MuscleFacts* FindMuscleFacts(const std::string& name);

}  // namespace musclewarp
