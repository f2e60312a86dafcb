// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/shortcomings.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "musclewarp/base/option_check.h"
#include "musclewarp/base/text.h"

namespace musclewarp {
namespace {

template <typename... Words>
std::string Sentence(const Words&... words) {
  std::ostringstream text;
  text.precision(3);
  (text << ... << words);
  return text.str();
}

// " around (x, y, z)", or nothing where no triangles cross.
std::string PlaceOf(const PairFigures& pair, double body_size) {
  if (pair.triangle_pairs == 0) return "";
  return " around " + PlaceText(pair.place, body_size);
}

// Areas and volumes in the units that sentences have.
double SquareCentimetres(double area, double body_size) {
  return area * std::pow(body_size, 2) / 100;
}
double CubicCentimetres(double volume, double body_size) {
  return volume * std::pow(body_size, 3) / 1000;
}

// Returns a number with two digits, or with as many more as show that it is
// below `limit`.
std::string BelowText(double value, double limit) {
  std::string text;
  for (int digits = 2; digits <= 17; ++digits) {
    text = NumberText(value, digits);
    if (std::stod(text) < limit) break;
  }
  return text;
}

void AddNarrowGaps(const std::vector<MeshGap>& gaps,
                   const FrameRequirements& requirements,
                   std::vector<std::string>* shortcomings) {
  const double required = requirements.gap;
  const double body_size = requirements.body_size;
  for (const MeshGap& gap : gaps) {
    // Meshes that intersect are named for that.
    if (gap.at_most_mm == 0 || gap.at_least_mm >= required) continue;
    shortcomings->push_back(
        Sentence(gap.a,
                 " and ",
                 gap.b,
                 " are ",
                 BelowText(gap.at_least_mm * body_size, required * body_size),
                 " mm apart, less than the gap of ",
                 required * body_size,
                 " mm, near ",
                 PlaceText(gap.place, body_size)));
  }
}

void AddShortcomingsOfShape(const JudgedMuscle& judged,
                            const FrameRequirements& requirements,
                            std::vector<std::string>* shortcomings) {
  const MuscleFigures& muscle = judged.figures;
  const double error = std::abs(muscle.volume_error);
  if (!(error <= requirements.max_volume_error)) {
    shortcomings->push_back(Sentence(muscle.name,
                                     ": volume off by ",
                                     error,
                                     ", allowed ",
                                     requirements.max_volume_error));
  }
  const double loss = 1 - muscle.volume_ratio;
  if (!(loss <= requirements.max_volume_loss)) {
    shortcomings->push_back(Sentence(
        muscle.name,
        ": ",
        100 * loss,
        " % of its volume of ",
        CubicCentimetres(judged.delivered_volume, requirements.body_size),
        " cm3 is lost, allowed ",
        100 * requirements.max_volume_loss,
        " %"));
  }
  if (!(muscle.shape.max_stretch <= requirements.max_stretch)) {
    shortcomings->push_back(Sentence(muscle.name,
                                     ": stretched to ",
                                     muscle.shape.max_stretch,
                                     " times its length, allowed ",
                                     requirements.max_stretch));
  }
  shortcomings->insert(shortcomings->end(),
                       judged.missed_bones.begin(),
                       judged.missed_bones.end());
}

void AddLosses(const JudgedMuscle& judged,
               const FrameRequirements& requirements,
               std::vector<std::string>* shortcomings) {
  const std::string& name = judged.figures.name;
  const SurfaceReconstruction& reconstruction = judged.reconstruction;
  if (reconstruction.gone_area > requirements.max_lost_area) {
    shortcomings->push_back(Sentence(
        name,
        ": ",
        SquareCentimetres(reconstruction.gone_area, requirements.body_size),
        " cm2 of the muscle are gone, the farthest "
        "point ",
        reconstruction.farthest * requirements.body_size,
        " mm away, allowed ",
        SquareCentimetres(requirements.max_lost_area, requirements.body_size),
        " cm2"));
  }
  if (reconstruction.lost_extent > requirements.max_lost_extent) {
    shortcomings->push_back(
        Sentence(name,
                 ": ends ",
                 reconstruction.lost_extent * requirements.body_size,
                 " mm short of where the delivered mesh "
                 "ends, allowed ",
                 requirements.max_lost_extent * requirements.body_size,
                 " mm"));
  }
  for (const std::string& carrier : reconstruction.lost_attachments) {
    shortcomings->push_back(
        Sentence(name, ": is not attached to ", carrier, " any more"));
  }
}

void AddShortcomingsOf(const JudgedMuscle& judged,
                       const FrameRequirements& requirements,
                       std::vector<std::string>* shortcomings) {
  const MuscleFigures& muscle = judged.figures;
  AddShortcomingsOfShape(judged, requirements, shortcomings);
  AddLosses(judged, requirements, shortcomings);
  if (muscle.self_pairs > 0) {
    shortcomings->push_back(Sentence(muscle.name,
                                     ": ",
                                     muscle.self_pairs,
                                     " self-intersecting triangle pairs"));
  }
  if (requirements.max_torn_patch > 0 &&
      muscle.torn_patch.area > requirements.max_torn_patch) {
    shortcomings->push_back(Sentence(
        muscle.name,
        ": ",
        SquareCentimetres(muscle.torn_patch.area, requirements.body_size),
        " cm2 torn by contact near ",
        PlaceText(muscle.torn_patch.place, requirements.body_size),
        ", allowed ",
        SquareCentimetres(requirements.max_torn_patch, requirements.body_size),
        " cm2"));
  }
  const auto most_folded =
      static_cast<int>(requirements.max_folded_fraction *
                       static_cast<double>(judged.num_triangles));
  if (muscle.folded_triangles > most_folded) {
    shortcomings->push_back(Sentence(muscle.name,
                                     ": ",
                                     muscle.folded_triangles,
                                     " folded triangles, allowed ",
                                     most_folded));
  }
  const double body_size = requirements.body_size;
  const double depth = muscle.depth_without_contact;
  const double farthest = AllowedDisplacement(requirements, muscle);
  if (!(muscle.max_contact_displacement <= farthest)) {
    std::ostringstream chain;
    if (muscle.pushed_by.size() > 1) {
      chain << ", " << muscle.push_depth * body_size << " mm along the chain";
      for (const std::string& name : muscle.pushed_by) {
        chain << (&name == &muscle.pushed_by.front() ? " " : ", ") << name;
      }
    }
    shortcomings->push_back(
        Sentence(muscle.name,
                 ": moved by ",
                 muscle.max_contact_displacement * body_size,
                 " mm by contact, allowed ",
                 farthest * body_size,
                 " (",
                 depth * body_size,
                 " mm deep without",
                 chain.str(),
                 ")"));
  }
}

}  // namespace

bool FrameRequirements::IsValid(std::string* error) const {
  return OptionCheck("FrameRequirements", error)
      .IsAtLeast("max_volume_error", max_volume_error, 0)
      .IsWithin("max_volume_loss", max_volume_loss, 0, 1)
      .IsAtLeast("max_lost_area", max_lost_area, 0)
      .IsAtLeast("max_lost_extent", max_lost_extent, 0)
      .IsAtLeast("max_stretch", max_stretch, 1)
      .IsAtLeast("max_torn_patch", max_torn_patch, 0)
      .IsWithin("max_folded_fraction", max_folded_fraction, 0, 1)
      .IsAtLeast("displacement_per_depth", displacement_per_depth, 0)
      .IsAtLeast("displacement_allowance", displacement_allowance, 0)
      .IsAtLeast("least_displacement", least_displacement, 0)
      .IsWithin("touching_distance", touching_distance, 0, kMeshGapLimit)
      .IsWithin("gap", gap, 0, kMeshGapLimit)
      .is_valid();
}

double LargestDisplacement(const FrameRequirements& requirements,
                           const MuscleFigures& muscle) {
  const double depth = muscle.depth_without_contact;
  return requirements.displacement_per_depth * depth +
         std::max(0.0, muscle.push_depth - depth) +
         requirements.displacement_allowance;
}

double AllowedDisplacement(const FrameRequirements& requirements,
                           const MuscleFigures& muscle) {
  return std::max(LargestDisplacement(requirements, muscle),
                  requirements.least_displacement);
}

std::vector<std::string> ShapeShortcomings(
    const FrameRequirements& requirements,
    const std::vector<JudgedMuscle>& muscles) {
  std::string error;
  CHECK(requirements.IsValid(&error)) << error;
  std::vector<std::string> shortcomings;
  for (const JudgedMuscle& muscle : muscles) {
    AddShortcomingsOfShape(muscle, requirements, &shortcomings);
  }
  return shortcomings;
}

std::vector<std::string> Shortcomings(
    const FrameRequirements& requirements,
    const SceneIntersections& intersections,
    const std::vector<JudgedMuscle>& muscles) {
  std::string error;
  CHECK(requirements.IsValid(&error)) << error;
  std::vector<std::string> shortcomings;
  for (const PairFigures& pair : intersections.pairs) {
    if (pair.triangle_pairs + pair.vertices_inside == 0) continue;  // exempt
    shortcomings.push_back(Sentence(pair.a,
                                    " x ",
                                    pair.b,
                                    ": ",
                                    pair.triangle_pairs,
                                    " crossing triangle pairs",
                                    PlaceOf(pair, requirements.body_size),
                                    ", ",
                                    pair.vertices_inside,
                                    " vertices inside, ",
                                    pair.max_depth_mm * requirements.body_size,
                                    " mm deep"));
  }
  AddNarrowGaps(intersections.gaps, requirements, &shortcomings);
  for (const JudgedMuscle& muscle : muscles) {
    AddShortcomingsOf(muscle, requirements, &shortcomings);
  }
  return shortcomings;
}

std::vector<std::string> DeliveredShortcomings(
    const std::vector<DeliveredCrossing>& crossings, double body_size) {
  std::vector<std::string> shortcomings;
  for (const DeliveredCrossing& crossing : crossings) {
    shortcomings.push_back(
        Sentence(crossing.muscle,
                 " x ",
                 crossing.bone,
                 " as it was delivered: ",
                 crossing.triangle_pairs,
                 " crossing triangle pairs and ",
                 crossing.pieces_inside,
                 crossing.pieces_inside == 1 ? " piece" : " pieces",
                 " of the bone inside, around ",
                 PlaceText(crossing.place, body_size),
                 ", where the repair of the bone has left out or moved "
                 "triangles: mend the bone there, or remove those triangles"));
  }
  return shortcomings;
}

}  // namespace musclewarp
