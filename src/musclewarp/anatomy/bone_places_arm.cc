// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <iterator>

#include "musclewarp/anatomy/bone_place_rows.h"

namespace musclewarp {
namespace {

constexpr PlaceRow kPlacesOfArm[] = {
    // Trunk. Of several vertebrae or ribs the one in the middle stands for all.
    {"occiput", "skull", 0.5, 1, "posterior"},
    {"upper_cervical_vertebrae", "vertebrae_C3", 0, 1, "lateral"},
    {"upper_cervical_vertebrae", "vertebrae_C2", 0, 1, "lateral"},
    {"upper_cervical_vertebrae", "vertebrae", 0, 0.1, "lateral"},
    {"vertebra_prominens", "vertebrae_C7", 0, 1, "posterior"},
    {"vertebra_prominens", "vertebrae_T1", 0, 1, "posterior"},
    {"vertebra_prominens", "vertebrae", 0.15, 0.25, "posterior"},
    {"upper_thoracic_vertebrae", "vertebrae_T3", 0, 1, "posterior"},
    {"upper_thoracic_vertebrae", "vertebrae_T4", 0, 1, "posterior"},
    {"upper_thoracic_vertebrae", "vertebrae", 0.2, 0.4, "posterior"},
    {"middle_thoracic_vertebrae", "vertebrae_T8", 0, 1, "posterior"},
    {"middle_thoracic_vertebrae", "vertebrae_T7", 0, 1, "posterior"},
    {"middle_thoracic_vertebrae", "vertebrae", 0.3, 0.7, "posterior"},
    {"lower_thoracic_vertebrae", "vertebrae_T10", 0, 1, "posterior"},
    {"lower_thoracic_vertebrae", "vertebrae_T9", 0, 1, "posterior"},
    {"lower_thoracic_vertebrae", "vertebrae", 0.45, 0.75, "posterior"},
    {"lumbar_spines", "vertebrae_L3", 0, 1, "posterior"},
    {"lumbar_spines", "vertebrae", 0.7, 1, "posterior"},
    {"front_of_sternum", "sternum", 0, 1, "anterior"},
    {"first_rib", "rib_1", 0.7, 1, "anterior"},
    {"third_to_fifth_ribs", "rib_4", 0.6, 1, "anterior"},
    {"third_to_fifth_ribs", "rib_3", 0.6, 1, "anterior"},
    {"third_to_fifth_ribs", "rib_5", 0.6, 1, "anterior"},
    {"side_of_ribs", "rib_5", 0.3, 0.8, "lateral"},
    {"side_of_ribs", "rib_4", 0.3, 0.8, "lateral"},
    {"side_of_ribs", "rib_6", 0.3, 0.8, "lateral"},
    // Clavicle, whose length is from the sternum to the acromion.
    {"medial_clavicle", "clavicle", 0, 0.5, "anterior"},
    {"lateral_clavicle", "clavicle", 0.67, 1, "anterior"},
    {"back_of_lateral_clavicle", "clavicle", 0.67, 1, "posterior superior"},
    {"underside_of_clavicle", "clavicle", 0.33, 0.7, "inferior"},
    // Scapula, whose length is from its top to the inferior angle.
    {"acromion", "scapula", 0, 0.25, "lateral posterior superior"},
    {"spine_of_scapula", "scapula", 0.08, 0.35, "posterior"},
    {"root_of_spine", "scapula", 0.2, 0.38, "posterior medial"},
    {"supraspinous_fossa", "scapula", 0, 0.28, "posterior superior"},
    {"infraspinous_fossa", "scapula", 0.28, 0.85, "posterior"},
    {"subscapular_fossa", "scapula", 0.1, 0.95, "anterior medial"},
    {"lateral_border", "scapula", 0.3, 0.8, "lateral lateral posterior"},
    {"inferior_angle", "scapula", 0.7, 1, "lateral posterior"},
    {"coracoid_process", "scapula", 0, 0.25, "anterior lateral"},
    {"supraglenoid_tubercle", "scapula", 0.1, 0.3, "lateral superior"},
    {"infraglenoid_tubercle", "scapula", 0.33, 0.52, "lateral"},
    {"superior_angle", "scapula", 0, 0.25, "medial"},
    {"upper_medial_border", "scapula", 0.2, 0.38, "medial"},
    {"lower_medial_border", "scapula", 0.35, 1, "medial"},
    {"front_of_medial_border", "scapula", 0.05, 1, "medial anterior"},
    // Humerus.
    {"top_of_greater_tubercle", "humerus", 0, 0.07, "lateral superior"},
    {"back_of_greater_tubercle", "humerus", 0.01, 0.09, "lateral posterior"},
    {"low_greater_tubercle", "humerus", 0.04, 0.14, "posterior lateral"},
    {"lesser_tubercle", "humerus", 0.03, 0.13, "anterior medial"},
    {"crest_of_greater_tubercle", "humerus", 0.12, 0.33, "anterior lateral"},
    {"crest_of_lesser_tubercle",
     "humerus",
     0.13,
     0.33,
     "medial medial anterior"},
    {"bicipital_groove", "humerus", 0.1, 0.28, "anterior"},
    {"deltoid_tuberosity", "humerus", 0.33, 0.55, "lateral"},
    {"middle_inside_of_humerus", "humerus", 0.4, 0.62, "medial"},
    {"lower_front_of_humerus", "humerus", 0.45, 0.92, "anterior"},
    {"upper_back_of_humerus", "humerus", 0.12, 0.5, "posterior lateral"},
    {"lower_back_of_humerus", "humerus", 0.3, 0.92, "posterior medial"},
    {"lateral_ridge", "humerus", 0.65, 0.85, "lateral"},
    {"lower_lateral_ridge", "humerus", 0.8, 0.93, "lateral"},
    {"lateral_epicondyle", "humerus", 0.9, 0.98, "lateral"},
    {"back_of_lateral_epicondyle", "humerus", 0.9, 0.98, "lateral posterior"},
    {"medial_epicondyle", "humerus", 0.88, 0.97, "medial"},
    // Ulna and radius.
    {"olecranon", "ulna", 0, 0.08, "posterior superior"},
    {"side_of_olecranon", "ulna", 0, 0.28, "lateral posterior"},
    {"tuberosity_of_ulna", "ulna", 0.08, 0.22, "anterior"},
    {"coronoid_process", "ulna", 0.06, 0.17, "anterior medial"},
    {"supinator_crest", "ulna", 0.1, 0.28, "lateral"},
    {"upper_back_of_ulna", "ulna", 0.02, 0.67, "posterior medial"},
    {"front_of_ulna", "ulna", 0.1, 0.75, "anterior medial"},
    {"middle_back_of_ulna", "ulna", 0.25, 0.65, "posterior lateral"},
    {"lower_back_of_ulna", "ulna", 0.55, 0.85, "posterior lateral"},
    {"low_front_of_ulna", "ulna", 0.75, 0.96, "anterior"},
    {"tuberosity_of_radius", "radius", 0.08, 0.2, "medial posterior"},
    {"upper_side_of_radius", "radius", 0.08, 0.38, "lateral"},
    {"oblique_line_of_radius", "radius", 0.15, 0.45, "anterior"},
    {"front_of_radius", "radius", 0.2, 0.75, "anterior"},
    {"middle_side_of_radius", "radius", 0.38, 0.58, "lateral"},
    {"middle_back_of_radius", "radius", 0.33, 0.65, "posterior"},
    {"lower_back_of_radius", "radius", 0.5, 0.75, "posterior"},
    {"low_front_of_radius", "radius", 0.75, 0.96, "anterior"},
    {"styloid_of_radius", "radius", 0.9, 1, "lateral"},
    // Hand.
    {"pisiform", "carpals", 0, 0.7, "palmar medial"},
    {"pisiform", "metacarpal_5", 0, 0.2, "palmar"},
    {"palmar_aponeurosis", "hand", 0.1, 0.5, "palmar"},
    {"palmar_aponeurosis", "metacarpals", 0, 0.8, "palmar"},
    {"palmar_aponeurosis", "metacarpal_3", 0, 0.8, "palmar"},
    {"side_of_metacarpal_1", "metacarpal_1", 0, 0.25, "lateral"},
    {"palm_of_metacarpal_2", "metacarpal_2", 0, 0.2, "palmar"},
    {"back_of_metacarpal_2", "metacarpal_2", 0, 0.2, "posterior lateral"},
    {"back_of_metacarpal_3", "metacarpal_3", 0, 0.2, "posterior lateral"},
    {"side_of_metacarpal_5", "metacarpal_5", 0, 0.2, "medial posterior"},
    {"palm_of_thumb", "finger_1_distal", 0, 0.4, "palmar"},
    {"back_of_thumb", "finger_1_distal", 0, 0.4, "posterior"},
    {"back_of_thumb_base", "finger_1_proximal", 0, 0.3, "posterior"},
    {"palm_of_middle_phalanx_2", "finger_2_middle", 0.2, 0.8, "palmar"},
    {"palm_of_middle_phalanx_3", "finger_3_middle", 0.2, 0.8, "palmar"},
    {"palm_of_middle_phalanx_4", "finger_4_middle", 0.2, 0.8, "palmar"},
    {"palm_of_middle_phalanx_5", "finger_5_middle", 0.2, 0.8, "palmar"},
    {"palm_of_finger_2", "finger_2_distal", 0, 0.4, "palmar"},
    {"palm_of_finger_3", "finger_3_distal", 0, 0.4, "palmar"},
    {"palm_of_finger_4", "finger_4_distal", 0, 0.4, "palmar"},
    {"palm_of_finger_5", "finger_5_distal", 0, 0.4, "palmar"},
    {"back_of_finger_2", "finger_2_middle", 0, 0.3, "posterior"},
    {"back_of_finger_2", "finger_2_distal", 0, 0.4, "posterior"},
    {"back_of_finger_3", "finger_3_middle", 0, 0.3, "posterior"},
    {"back_of_finger_3", "finger_3_distal", 0, 0.4, "posterior"},
    {"back_of_finger_4", "finger_4_middle", 0, 0.3, "posterior"},
    {"back_of_finger_4", "finger_4_distal", 0, 0.4, "posterior"},
    {"back_of_finger_5", "finger_5_middle", 0, 0.3, "posterior"},
    {"back_of_finger_5", "finger_5_distal", 0, 0.4, "posterior"},
    {"back_of_proximal_phalanx_2", "finger_2_proximal", 0.1, 0.9, "posterior"},
    {"back_of_proximal_phalanx_5", "finger_5_proximal", 0.1, 0.9, "posterior"},
};

// Shares of the hand's length from the wrist to the tips of the fingers are
// rough: the hands of scenes are in many poses.
constexpr WholeRow kWholesOfArm[] = {
    {"rib_1", "ribs", 0, 0.1, ""},
    {"rib_4", "ribs", 0.2, 0.45, ""},
    {"rib_5", "ribs", 0.25, 0.5, ""},
    {"carpals", "hand", 0, 0.2, ""},
    {"metacarpal_1", "metacarpals", 0, 0.7, "lateral"},
    {"metacarpal_1", "hand", 0.12, 0.38, "lateral"},
    {"metacarpal_2", "metacarpals", 0, 1, "lateral"},
    {"metacarpal_2", "hand", 0.18, 0.52, "lateral"},
    {"metacarpal_3", "metacarpals", 0, 1, ""},
    {"metacarpal_3", "hand", 0.18, 0.52, ""},
    {"metacarpal_5", "metacarpals", 0, 0.9, "medial"},
    {"metacarpal_5", "hand", 0.18, 0.46, "medial"},
    {"finger_1_distal", "hand", 0.5, 0.64, "lateral"},
    {"finger_1_proximal", "hand", 0.36, 0.5, "lateral"},
    {"finger_2_proximal", "hand", 0.5, 0.72, "lateral"},
    {"finger_2_middle", "hand", 0.72, 0.86, "lateral"},
    {"finger_2_distal", "hand", 0.86, 0.96, "lateral"},
    {"finger_3_middle", "hand", 0.75, 0.9, ""},
    {"finger_3_distal", "hand", 0.9, 1, ""},
    {"finger_4_middle", "hand", 0.72, 0.87, ""},
    {"finger_4_distal", "hand", 0.87, 0.97, ""},
    {"finger_5_proximal", "hand", 0.46, 0.64, "medial"},
    {"finger_5_middle", "hand", 0.64, 0.74, "medial"},
    {"finger_5_distal", "hand", 0.74, 0.83, "medial"},
};

}  // namespace

std::vector<PlaceRow> PlaceRowsOfArm() {
  return {std::begin(kPlacesOfArm), std::end(kPlacesOfArm)};
}

std::vector<WholeRow> WholeRowsOfArm() {
  return {std::begin(kWholesOfArm), std::end(kWholesOfArm)};
}

}  // namespace musclewarp
