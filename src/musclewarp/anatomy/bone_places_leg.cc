// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <iterator>

#include "musclewarp/anatomy/bone_place_rows.h"

namespace musclewarp {
namespace {

constexpr PlaceRow kPlacesOfLeg[] = {
    // Trunk and hip bone, whose length is from the iliac crest to the ischium.
    // Where a scene has no lumbar vertebrae, the pelvis carries the psoas, as
    // it does in gait2392.
    {"lumbar_vertebrae", "vertebrae_L3", 0, 1, "anterior lateral"},
    {"lumbar_vertebrae", "vertebrae_L2", 0, 1, "anterior lateral"},
    {"lumbar_vertebrae", "vertebrae_L4", 0, 1, "anterior lateral"},
    {"lumbar_vertebrae", "vertebrae_L1", 0, 1, "anterior lateral"},
    {"lumbar_vertebrae", "vertebrae_L5", 0, 1, "anterior lateral"},
    {"lumbar_vertebrae", "vertebrae", 0.6, 1, "anterior lateral"},
    {"lumbar_vertebrae", "sacrum", 0, 0.15, "anterior lateral"},
    {"back_of_sacrum", "sacrum", 0.4, 1, "posterior"},
    {"front_of_sacrum", "sacrum", 0.3, 0.8, "anterior lateral"},
    {"posterior_iliac_crest", "hip_bone", 0.02, 0.2, "posterior"},
    {"posterior_ilium", "hip_bone", 0.1, 0.4, "posterior lateral"},
    {"gluteal_surface", "hip_bone", 0.05, 0.4, "lateral posterior"},
    {"lower_gluteal_surface", "hip_bone", 0.3, 0.55, "lateral"},
    {"iliac_fossa", "hip_bone", 0.05, 0.45, "medial anterior"},
    {"asis", "hip_bone", 0.2, 0.46, "anterior lateral"},
    {"aiis", "hip_bone", 0.48, 0.62, "anterior lateral"},
    {"pecten_pubis", "hip_bone", 0.65, 0.88, "anterior medial superior"},
    {"body_of_pubis", "hip_bone", 0.72, 0.95, "anterior medial"},
    {"ischiopubic_ramus", "hip_bone", 0.82, 1, "inferior medial"},
    {"outer_obturator_margin", "hip_bone", 0.72, 0.95, "anterior medial"},
    {"inner_obturator_margin", "hip_bone", 0.55, 0.95, "medial"},
    {"brim_of_pelvis", "hip_bone", 0.55, 0.72, "anterior"},
    {"lesser_sciatic_notch", "hip_bone", 0.74, 0.84, "posterior"},
    {"ischial_spine", "hip_bone", 0.62, 0.78, "posterior medial"},
    {"ischial_tuberosity", "hip_bone", 0.82, 1, "posterior inferior"},
    {"side_of_ischial_tuberosity", "hip_bone", 0.82, 0.97, "lateral"},
    // Femur.
    {"greater_trochanter", "femur", 0.02, 0.12, "lateral"},
    {"front_of_greater_trochanter",
     "femur",
     0.03,
     0.12,
     "lateral lateral anterior"},
    {"top_of_greater_trochanter", "femur", 0.01, 0.06, "lateral superior"},
    {"inside_of_greater_trochanter", "femur", 0.03, 0.09, "posterior lateral"},
    {"trochanteric_fossa", "femur", 0.04, 0.1, "posterior lateral"},
    {"intertrochanteric_crest", "femur", 0.08, 0.17, "posterior lateral"},
    {"lesser_trochanter", "femur", 0.14, 0.22, "medial posterior"},
    {"gluteal_tuberosity", "femur", 0.15, 0.36, "posterior lateral"},
    {"pectineal_line", "femur", 0.18, 0.33, "posterior medial"},
    {"upper_linea_aspera", "femur", 0.2, 0.42, "posterior medial"},
    {"middle_linea_aspera", "femur", 0.35, 0.62, "posterior medial"},
    {"linea_aspera", "femur", 0.15, 0.75, "posterior medial"},
    {"lateral_linea_aspera",
     "femur",
     0.35,
     0.75,
     "posterior posterior lateral"},
    {"adductor_tubercle", "femur", 0.88, 0.96, "medial"},
    {"side_of_femur", "femur", 0.1, 0.55, "lateral posterior"},
    {"inside_of_femur", "femur", 0.12, 0.75, "medial posterior"},
    {"front_of_femur", "femur", 0.15, 0.7, "anterior lateral"},
    {"above_medial_condyle", "femur", 0.88, 0.97, "posterior medial"},
    {"above_lateral_condyle", "femur", 0.88, 0.97, "posterior lateral"},
    {"lateral_supracondylar_line", "femur", 0.84, 0.94, "posterior lateral"},
    {"lateral_femoral_condyle", "femur", 0.92, 0.99, "lateral"},
    // Patella, tibia, fibula. Without a patella the patellar ligament ends
    // on the tuberosity of the tibia.
    {"base_of_patella", "patella", 0, 0.3, "superior anterior"},
    {"base_of_patella", "tibia", 0.06, 0.17, "anterior"},
    {"iliotibial_tubercle", "tibia", 0.02, 0.08, "lateral anterior"},
    {"lateral_tibial_condyle", "tibia", 0.01, 0.07, "lateral anterior"},
    {"back_of_medial_condyle", "tibia", 0.02, 0.09, "medial posterior"},
    {"pes_anserinus", "tibia", 0.06, 0.2, "medial medial anterior"},
    {"above_soleal_line", "tibia", 0.05, 0.3, "posterior posterior medial"},
    {"soleal_line", "tibia", 0.15, 0.5, "posterior medial"},
    {"side_of_tibia", "tibia", 0.05, 0.6, "lateral anterior"},
    {"back_of_tibia", "tibia", 0.2, 0.75, "posterior medial"},
    {"lateral_back_of_tibia", "tibia", 0.15, 0.65, "posterior lateral"},
    {"head_of_fibula", "fibula", 0, 0.08, "lateral"},
    {"upper_back_of_fibula", "fibula", 0, 0.35, "posterior"},
    {"front_of_fibula", "fibula", 0.02, 0.75, "anterior"},
    {"middle_front_of_fibula", "fibula", 0.25, 0.75, "anterior medial"},
    {"lower_front_of_fibula", "fibula", 0.65, 0.95, "anterior"},
    {"upper_side_of_fibula", "fibula", 0, 0.67, "lateral"},
    {"lower_side_of_fibula", "fibula", 0.33, 0.88, "lateral"},
    {"inside_of_fibula", "fibula", 0.08, 0.67, "medial posterior"},
    {"lower_back_of_fibula", "fibula", 0.33, 0.92, "posterior"},
    // Foot, whose lengths are from the heel to the toes.
    {"calcaneal_tuberosity", "calcaneus", 0, 0.2, "posterior"},
    {"first_ray_medial", "metatarsal_1", 0, 0.18, "medial medial plantar"},
    {"first_ray_medial", "cuneiform_medial", 0.4, 1, "medial medial plantar"},
    {"first_ray_lateral", "metatarsal_1", 0, 0.18, "plantar lateral"},
    {"first_ray_lateral", "cuneiform_medial", 0.4, 1, "plantar lateral"},
    {"tuberosity_of_metatarsal_5", "metatarsal_5", 0, 0.18, "lateral"},
    {"top_of_metatarsal_5", "metatarsal_5", 0, 0.3, "superior"},
    {"tuberosity_of_navicular", "navicular", 0, 1, "medial plantar"},
    {"tuberosity_of_navicular", "cuneiform_medial", 0, 0.7, "medial plantar"},
    // Where tendons are held: below the retinacula and in the grooves.
    {"front_of_ankle", "tibia", 0.88, 0.96, "anterior"},
    {"top_of_navicular", "navicular", 0, 1, "superior"},
    {"top_of_navicular", "cuneiform_medial", 0, 0.7, "superior"},
    {"inside_of_navicular", "navicular", 0, 1, "superior superior medial"},
    {"inside_of_navicular",
     "cuneiform_medial",
     0,
     0.7,
     "superior superior medial"},
    {"inside_of_talus", "talus", 0.15, 0.5, "medial"},
    {"top_of_lateral_cuneiform", "cuneiform_lateral", 0, 1, "superior"},
    {"top_of_lateral_cuneiform", "cuboid", 0, 1, "superior"},
    {"top_of_metatarsal_1", "metatarsal_1", 0.7, 1, "superior"},
    {"behind_lateral_malleolus", "fibula", 0.9, 0.98, "posterior"},
    {"side_of_calcaneus", "calcaneus", 0.55, 0.85, "lateral"},
    {"groove_of_cuboid", "cuboid", 0, 1, "lateral plantar"},
    {"behind_medial_malleolus", "tibia", 0.93, 1, "posterior medial"},
    {"side_of_sustentaculum", "calcaneus", 0.5, 0.85, "medial"},
    {"back_of_talus", "talus", 0, 0.3, "posterior medial"},
    {"sole_of_metatarsal_1", "metatarsal_1", 0.7, 1, "plantar"},
    {"sole_of_metatarsals", "metatarsal_3", 0.5, 1, "plantar"},
    {"top_of_toe_1", "toe_1_distal", 0, 0.4, "superior"},
    {"top_of_toe_2", "toe_2_distal", 0, 0.5, "superior"},
    {"top_of_toe_2", "toe_2_middle", 0, 0.5, "superior"},
    {"top_of_toe_3", "toe_3_distal", 0, 0.5, "superior"},
    {"top_of_toe_3", "toe_3_middle", 0, 0.5, "superior"},
    {"top_of_toe_4", "toe_4_distal", 0, 0.5, "superior"},
    {"top_of_toe_4", "toe_4_middle", 0, 0.5, "superior"},
    {"top_of_toe_5", "toe_5_distal", 0, 0.5, "superior"},
    {"top_of_toe_5", "toe_5_middle", 0, 0.5, "superior"},
    {"sole_of_toe_1", "toe_1_distal", 0, 0.4, "plantar"},
    {"sole_of_toe_2", "toe_2_distal", 0, 0.5, "plantar"},
    {"sole_of_toe_3", "toe_3_distal", 0, 0.5, "plantar"},
    {"sole_of_toe_4", "toe_4_distal", 0, 0.5, "plantar"},
    {"sole_of_toe_5", "toe_5_distal", 0, 0.5, "plantar"},
};

// Shares of the foot's length measured on the right foot of BodyParts3D. A mesh
// called tibia may have the fibula in it; without one, the side of the tibia
// stands in.
constexpr WholeRow kWholesOfLeg[] = {
    {"hip_bone", "pelvis", 0, 1, ""},
    {"sacrum", "pelvis", 0.2, 0.7, "posterior"},
    {"fibula", "tibia", 0.03, 1, "lateral"},
    {"calcaneus", "tarsals", 0, 0.61, ""},
    {"calcaneus", "foot", 0, 0.33, ""},
    {"talus", "tarsals", 0.1, 0.6, "superior"},
    {"cuboid", "tarsals", 0.6, 0.95, "lateral"},
    {"cuboid", "foot", 0.33, 0.5, "lateral"},
    {"cuneiform_lateral", "tarsals", 0.72, 1, "superior"},
    {"cuneiform_lateral", "foot", 0.39, 0.52, "superior"},
    {"metatarsal_3", "metatarsals", 0.2, 0.95, ""},
    {"metatarsal_3", "foot", 0.46, 0.78, ""},
    {"navicular", "tarsals", 0.61, 0.81, "medial"},
    {"navicular", "foot", 0.33, 0.44, "medial"},
    {"metatarsal_1", "metatarsals", 0.35, 1, "medial"},
    {"metatarsal_1", "foot", 0.49, 0.77, "medial"},
    {"cuneiform_medial", "tarsals", 0.74, 1, "medial"},
    {"metatarsal_5", "metatarsals", 0, 0.74, "lateral"},
    {"metatarsal_5", "foot", 0.34, 0.66, "lateral"},
    {"toe_1_distal", "toes", 0.64, 0.97, "medial"},
    {"toe_1_distal", "foot", 0.87, 0.99, "medial"},
    {"toe_2_distal", "toes", 0.83, 1, ""},
    {"toe_2_distal", "foot", 0.94, 1, ""},
    {"toe_3_distal", "toes", 0.78, 0.92, ""},
    {"toe_3_distal", "foot", 0.92, 0.97, ""},
    {"toe_4_distal", "toes", 0.58, 0.72, "lateral"},
    {"toe_4_distal", "foot", 0.85, 0.9, "lateral"},
    {"toe_5_distal", "toes", 0.36, 0.5, "lateral"},
    {"toe_5_distal", "foot", 0.77, 0.82, "lateral"},
};

}  // namespace

std::vector<PlaceRow> PlaceRowsOfLeg() {
  return {std::begin(kPlacesOfLeg), std::end(kPlacesOfLeg)};
}

std::vector<WholeRow> WholeRowsOfLeg() {
  return {std::begin(kWholesOfLeg), std::end(kWholesOfLeg)};
}

}  // namespace musclewarp
