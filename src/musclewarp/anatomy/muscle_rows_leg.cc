// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <iterator>

#include "musclewarp/anatomy/muscle_rows.h"

namespace musclewarp {
namespace {

// A section of H. Gray, Anatomy of the Human Body, 1918, IV (Myology).
constexpr char kLeg[] = "Gray 1918, IV 8c";

constexpr MuscleRow kMusclesOfLeg[] = {
    {"tibialis_anterior",
     "FMA22532",
     kLeg,
     "side_of_tibia",
     "first_ray_medial",
     "tib ant, tibialis anticus"},
    {"extensor_digitorum_longus",
     "FMA22534",
     kLeg,
     "front_of_fibula lateral_tibial_condyle",
     "top_of_toe_3 top_of_toe_2 top_of_toe_4 top_of_toe_5",
     "edl, ext dig, extensor digitorum longus of foot"},
    {"extensor_hallucis_longus",
     "FMA22533",
     kLeg,
     "middle_front_of_fibula",
     "top_of_toe_1",
     "ehl, ext hal"},
    {"fibularis_tertius",
     "FMA22538",
     kLeg,
     "lower_front_of_fibula",
     "top_of_metatarsal_5",
     "per tert"},
    {"fibularis_longus",
     "FMA22539",
     kLeg,
     "upper_side_of_fibula",
     "first_ray_lateral",
     "per long"},
    {"fibularis_brevis",
     "FMA22540",
     kLeg,
     "lower_side_of_fibula",
     "tuberosity_of_metatarsal_5",
     "per brev"},
    {"gastrocnemius",
     "FMA22541",
     kLeg,
     "above_medial_condyle above_lateral_condyle",
     "calcaneal_tuberosity",
     "gastroc"},
    {"gastrocnemius_medial_head",
     "FMA45956",
     kLeg,
     "above_medial_condyle",
     "calcaneal_tuberosity",
     "medial gastrocnemius, gastrocnemius mediale, gastrocnemius medialis, "
     "mediale gastrocnemii, med gas, gas med"},
    {"gastrocnemius_lateral_head",
     "FMA45959",
     kLeg,
     "above_lateral_condyle",
     "calcaneal_tuberosity",
     "lateral gastrocnemius, gastrocnemius laterale, gastrocnemius lateralis, "
     "laterale gastrocnemii, lat gas, gas lat"},
    {"soleus",
     "FMA22542",
     kLeg,
     "upper_back_of_fibula soleal_line",
     "calcaneal_tuberosity",
     ""},
    {"triceps_surae",
     "FMA51062",
     kLeg,
     "above_medial_condyle above_lateral_condyle upper_back_of_fibula "
     "soleal_line",
     "calcaneal_tuberosity",
     ""},
    {"plantaris",
     "FMA22543",
     kLeg,
     "lateral_supracondylar_line",
     "calcaneal_tuberosity",
     ""},
    {"popliteus",
     "FMA22590",
     kLeg,
     "lateral_femoral_condyle",
     "above_soleal_line",
     ""},
    {"tibialis_posterior",
     "FMA51099",
     kLeg,
     "lateral_back_of_tibia inside_of_fibula",
     "tuberosity_of_navicular",
     "tib post, tibialis posticus"},
    {"flexor_digitorum_longus",
     "FMA51071",
     kLeg,
     "back_of_tibia",
     "sole_of_toe_3 sole_of_toe_2 sole_of_toe_4 sole_of_toe_5",
     "fdl, flex dig, flexor digitorum longus of foot"},
    {"flexor_hallucis_longus",
     "FMA22593",
     kLeg,
     "lower_back_of_fibula",
     "sole_of_toe_1",
     "fhl, flex hal"},
    {"leg_anterior_compartment",
     "FMA45163",
     kLeg,
     "side_of_tibia front_of_fibula",
     "first_ray_medial top_of_toe_1 top_of_toe_3 top_of_toe_2 top_of_toe_4 "
     "top_of_toe_5 top_of_metatarsal_5",
     "anterior compartment of leg, anterior leg compartment"},
    {"leg_lateral_compartment",
     "",
     kLeg,
     "upper_side_of_fibula lower_side_of_fibula",
     "first_ray_lateral tuberosity_of_metatarsal_5",
     "lateral compartment of leg, lateral compartment, lateral leg "
     "compartment"},
    {"leg_deep_posterior_compartment",
     "",
     kLeg,
     "lateral_back_of_tibia back_of_tibia lower_back_of_fibula",
     "tuberosity_of_navicular sole_of_toe_1 sole_of_toe_3 sole_of_toe_2 "
     "sole_of_toe_4 sole_of_toe_5",
     "deep posterior compartment of leg, deep posterior compartment, deep "
     "posterior leg compartment"},
};

}  // namespace

std::vector<MuscleRow> MuscleRowsOfLeg() {
  return {std::begin(kMusclesOfLeg), std::end(kMusclesOfLeg)};
}

}  // namespace musclewarp
