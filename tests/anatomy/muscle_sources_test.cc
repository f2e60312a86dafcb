// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "musclewarp/anatomy/muscle_facts.h"

namespace musclewarp {
namespace {

// A name of a source, and the muscle that it means.
using SourceNames = std::vector<std::pair<std::string, std::string>>;

void ExpectFound(const SourceNames& names) {
  for (const auto& [name, muscle] : names) {
    const MuscleFacts* facts = FindMuscleFacts(name);
    ASSERT_NE(facts, nullptr) << name;
    EXPECT_EQ(facts->name, muscle) << name;
  }
}

// Names that are those of this library but for side and spelling.
void ExpectFoundAsNamed(const std::vector<std::string>& names,
                        const std::string& after = "") {
  for (std::string name : names) {
    const std::string spelled = name + after;
    for (char& letter : name) {
      if (letter == ' ') letter = '_';
    }
    ExpectFound({{spelled, name}});
  }
}

TEST(NamesOfTotalSegmentator, AreFound) {
  ExpectFoundAsNamed({"gluteus_maximus",
                      "gluteus_medius",
                      "gluteus_minimus",
                      "iliopsoas",
                      "quadriceps_femoris",
                      "thigh_medial_compartment",
                      "thigh_posterior_compartment",
                      "sartorius"},
                     "_left");
  ExpectFoundAsNamed({"deltoid",
                      "supraspinatus",
                      "infraspinatus",
                      "subscapularis",
                      "trapezius",
                      "pectoralis_minor",
                      "serratus_anterior",
                      "teres_major",
                      "triceps_brachii"});
  ExpectFound({{"coracobrachial", "coracobrachialis"},
               {"levator_scapulae_left", "levator_scapulae"}});
}

TEST(NamesOfMuscleMap, AreFound) {
  ExpectFoundAsNamed({"levator scapulae",
                      "trapezius",
                      "supraspinatus",
                      "subscapularis",
                      "infraspinatus",
                      "deltoid",
                      "psoas major",
                      "latissimus dorsi",
                      "gluteus minimus",
                      "gluteus medius",
                      "gluteus maximus",
                      "tensor fasciae latae",
                      "iliacus",
                      "piriformis",
                      "pectineus",
                      "obturator internus",
                      "obturator externus",
                      "gemelli and quadratus femoris",
                      "vastus lateralis",
                      "vastus intermedius",
                      "vastus medialis",
                      "rectus femoris",
                      "sartorius",
                      "gracilis",
                      "semimembranosus",
                      "semitendinosus",
                      "biceps femoris long head",
                      "biceps femoris short head",
                      "adductor magnus",
                      "adductor longus",
                      "adductor brevis",
                      "soleus",
                      "gastrocnemius"},
                     " right");
  ExpectFound(
      {{"rhomboid", "rhomboids"},
       {"lattisimus dorsi", "latissimus_dorsi"},
       {"tensor fascia latae", "tensor_fasciae_latae"},
       {"leg anterior compartment left", "leg_anterior_compartment"},
       {"deep posterior compartment left", "leg_deep_posterior_compartment"},
       {"lateral compartment right", "leg_lateral_compartment"}});
}

TEST(NamesOfBodyParts3D, AreFound) {
  ExpectFound(
      {{"long head of right biceps femoris", "biceps_femoris_long_head"},
       {"short_head_of_left_biceps_femoris", "biceps_femoris_short_head"},
       {"biceps_femoris_long", "biceps_femoris_long_head"},
       {"medial head of gastrocnemius", "gastrocnemius_medial_head"},
       {"lateral head of left gastrocnemius", "gastrocnemius_lateral_head"},
       {"gastrocnemius_medial", "gastrocnemius_medial_head"},
       {"anterior compartment of leg", "leg_anterior_compartment"},
       {"medial compartment of thigh", "thigh_medial_compartment"},
       {"posterior compartment of thigh", "thigh_posterior_compartment"},
       {"clavicular part of right deltoid", "deltoid_clavicular_part"},
       {"acromial part of deltoid", "deltoid_acromial_part"},
       {"spinal part of deltoid", "deltoid_spinal_part"},
       {"deltoid_spinal", "deltoid_spinal_part"},
       {"clavicular part of pectoralis major",
        "pectoralis_major_clavicular_part"},
       {"sternocostal part of pectoralis major",
        "pectoralis_major_sternocostal_part"},
       {"descending part of trapezius", "trapezius_descending_part"},
       {"transverse part of trapezius", "trapezius_transverse_part"},
       {"ascending part of trapezius", "trapezius_ascending_part"},
       {"infraspinatus muscle", "infraspinatus"},
       {"long head of biceps brachii", "biceps_brachii_long_head"},
       {"short head of right biceps brachii", "biceps_brachii_short_head"},
       {"long head of triceps brachii", "triceps_brachii_long_head"},
       {"lateral head of triceps brachii", "triceps_brachii_lateral_head"},
       {"medial head of triceps brachii", "triceps_brachii_medial_head"},
       {"humeral head of pronator teres", "pronator_teres"},
       {"humeral head of flexor carpi ulnaris",
        "flexor_carpi_ulnaris_humeral_head"},
       {"ulnar head of flexor carpi ulnaris",
        "flexor_carpi_ulnaris_ulnar_head"},
       {"humero-ulnar head of flexor digitorum superficialis",
        "flexor_digitorum_superficialis_humero_ulnar_head"},
       {"radial head of right flexor digitorum superficialis",
        "flexor_digitorum_superficialis_radial_head"},
       {"ulnar head of extensor carpi ulnaris",
        "extensor_carpi_ulnaris_ulnar_head"}});
}

TEST(NamesOfBodyParts3D, AreFoundWhereTheyAreOurs) {
  ExpectFoundAsNamed({"adductor minimus",
                      "fibularis tertius",
                      "fibularis longus",
                      "fibularis brevis",
                      "triceps surae",
                      "plantaris",
                      "popliteus",
                      "tibialis anterior",
                      "tibialis posterior",
                      "extensor digitorum longus",
                      "extensor hallucis longus",
                      "flexor digitorum longus",
                      "flexor hallucis longus",
                      "gemellus superior",
                      "gemellus inferior",
                      "quadratus femoris",
                      "rhomboid major",
                      "rhomboid minor",
                      "pectoralis major",
                      "subclavius",
                      "teres minor",
                      "brachialis",
                      "anconeus",
                      "flexor carpi radialis",
                      "palmaris longus",
                      "flexor digitorum profundus",
                      "flexor pollicis longus",
                      "pronator quadratus",
                      "brachioradialis",
                      "extensor carpi radialis longus",
                      "extensor carpi radialis brevis",
                      "extensor digitorum",
                      "extensor digiti minimi",
                      "supinator",
                      "abductor pollicis longus",
                      "extensor pollicis brevis",
                      "extensor pollicis longus",
                      "extensor indicis"});
}

// Rajagopal 2016 and the models of Lai and Uhlrich that follow it.
TEST(NamesOfRajagopalsModel, AreFound) {
  ExpectFound({{"addbrev_r", "adductor_brevis"},
               {"addlong_r", "adductor_longus"},
               {"addmagDist_r", "adductor_magnus"},
               {"addmagIsch_r", "adductor_magnus"},
               {"addmagMid_l", "adductor_magnus"},
               {"addmagProx_l", "adductor_magnus"},
               {"bflh_r", "biceps_femoris_long_head"},
               {"bfsh_r", "biceps_femoris_short_head"},
               {"edl_r", "extensor_digitorum_longus"},
               {"ehl_r", "extensor_hallucis_longus"},
               {"fdl_r", "flexor_digitorum_longus"},
               {"fhl_r", "flexor_hallucis_longus"},
               {"gaslat_r", "gastrocnemius_lateral_head"},
               {"gasmed_r", "gastrocnemius_medial_head"},
               {"glmax1_r", "gluteus_maximus"},
               {"glmed2_l", "gluteus_medius"},
               {"glmin3_r", "gluteus_minimus"},
               {"grac_r", "gracilis"},
               {"iliacus_r", "iliacus"},
               {"perbrev_r", "fibularis_brevis"},
               {"perlong_r", "fibularis_longus"},
               {"piri_r", "piriformis"},
               {"psoas_r", "psoas_major"},
               {"recfem_r", "rectus_femoris"},
               {"sart_r", "sartorius"},
               {"semimem_r", "semimembranosus"},
               {"semiten_r", "semitendinosus"},
               {"soleus_r", "soleus"},
               {"tfl_r", "tensor_fasciae_latae"},
               {"tibant_r", "tibialis_anterior"},
               {"tibpost_r", "tibialis_posterior"},
               {"vasint_r", "vastus_intermedius"},
               {"vaslat_r", "vastus_lateralis"},
               {"vasmed_r", "vastus_medialis"}});
}

TEST(NamesOfGait2392, AreFound) {
  ExpectFound({{"glut_med1_r", "gluteus_medius"},
               {"glut_min3_l", "gluteus_minimus"},
               {"glut_max2_r", "gluteus_maximus"},
               {"semimem_r", "semimembranosus"},
               {"semiten_r", "semitendinosus"},
               {"bifemlh_r", "biceps_femoris_long_head"},
               {"bifemsh_r", "biceps_femoris_short_head"},
               {"sar_r", "sartorius"},
               {"add_long_r", "adductor_longus"},
               {"add_brev_r", "adductor_brevis"},
               {"add_mag1_r", "adductor_magnus"},
               {"tfl_r", "tensor_fasciae_latae"},
               {"pect_r", "pectineus"},
               {"grac_r", "gracilis"},
               {"iliacus_r", "iliacus"},
               {"psoas_r", "psoas_major"},
               {"quad_fem_r", "quadratus_femoris"},
               {"gem_r", "gemelli"},
               {"peri_r", "piriformis"},
               {"rect_fem_r", "rectus_femoris"},
               {"vas_med_r", "vastus_medialis"},
               {"vas_int_r", "vastus_intermedius"},
               {"vas_lat_r", "vastus_lateralis"},
               {"med_gas_r", "gastrocnemius_medial_head"},
               {"lat_gas_r", "gastrocnemius_lateral_head"},
               {"soleus_r", "soleus"},
               {"tib_post_r", "tibialis_posterior"},
               {"flex_dig_r", "flexor_digitorum_longus"},
               {"flex_hal_r", "flexor_hallucis_longus"},
               {"tib_ant_r", "tibialis_anterior"},
               {"per_brev_r", "fibularis_brevis"},
               {"per_long_r", "fibularis_longus"},
               {"per_tert_r", "fibularis_tertius"},
               {"ext_dig_r", "extensor_digitorum_longus"},
               {"ext_hal_r", "extensor_hallucis_longus"}});
}

TEST(NamesOfSmallModels, AreFound) {
  // gait10dof18musc
  ExpectFound({{"hamstrings_r", "thigh_posterior_compartment"},
               {"bifemsh_r", "biceps_femoris_short_head"},
               {"glut_max_r", "gluteus_maximus"},
               {"iliopsoas_r", "iliopsoas"},
               {"rect_fem_r", "rectus_femoris"},
               {"vasti_r", "vasti"},
               {"gastroc_r", "gastrocnemius"}});
  // arm26
  ExpectFound({{"TRIlong", "triceps_brachii_long_head"},
               {"TRIlat", "triceps_brachii_lateral_head"},
               {"TRImed", "triceps_brachii_medial_head"},
               {"BIClong", "biceps_brachii_long_head"},
               {"BICshort", "biceps_brachii_short_head"},
               {"BRA", "brachialis"}});
}

TEST(LatinNames, AreFound) {
  ExpectFound(
      {{"Musculus tibialis anterior", "tibialis_anterior"},
       {"m. soleus", "soleus"},
       {"M. fibularis longus", "fibularis_longus"},
       {"m. peroneus longus", "fibularis_longus"},
       {"musculus gastrocnemius caput mediale", "gastrocnemius_medial_head"},
       {"caput laterale musculi gastrocnemii", "gastrocnemius_lateral_head"},
       {"m. biceps femoris, caput longum", "biceps_femoris_long_head"},
       {"caput breve musculi bicipitis femoris", "biceps_femoris_short_head"},
       {"M. biceps brachii caput breve", "biceps_brachii_short_head"},
       {"caput longum musculi tricipitis brachii", "triceps_brachii_long_head"},
       {"musculus deltoideus pars clavicularis", "deltoid_clavicular_part"},
       {"mm. rhomboidei", "rhomboids"},
       {"m. glutaeus maximus", "gluteus_maximus"},
       {"musculus obturatorius internus", "obturator_internus"}});
}

}  // namespace
}  // namespace musclewarp
