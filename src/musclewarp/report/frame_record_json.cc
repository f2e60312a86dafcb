// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
// How a record becomes an entry in report.json, and back.
#include "musclewarp/report/frame_record.h"

#include <optional>

namespace musclewarp {

using OrderedJson = nlohmann::ordered_json;

namespace {

OrderedJson ToJson(const Eigen::RowVector3d& place) {
  return {place.x(), place.y(), place.z()};
}

Eigen::RowVector3d PlaceFromJson(const OrderedJson& json) {
  return {json.at(0).get<double>(),
          json.at(1).get<double>(),
          json.at(2).get<double>()};
}

OrderedJson ToJson(const std::vector<AttachmentDrift>& drifts) {
  OrderedJson list = OrderedJson::array();
  for (const AttachmentDrift& drift : drifts) {
    list.push_back({{"body", drift.body},
                    {"vertices", drift.vertices},
                    {"mean_drift_mm", drift.mean},
                    {"max_drift_mm", drift.max},
                    {"place_mm", ToJson(drift.place)}});
  }
  return list;
}

std::vector<AttachmentDrift> DriftsFromJson(const OrderedJson& json) {
  std::vector<AttachmentDrift> drifts;
  for (const OrderedJson& item : json) {
    AttachmentDrift& drift = drifts.emplace_back();
    item.at("body").get_to(drift.body);
    item.at("vertices").get_to(drift.vertices);
    item.at("mean_drift_mm").get_to(drift.mean);
    item.at("max_drift_mm").get_to(drift.max);
    drift.place = PlaceFromJson(item.at("place_mm"));
  }
  return drifts;
}

OrderedJson ToJson(const std::vector<BoneOverlap>& overlaps) {
  OrderedJson list = OrderedJson::array();
  for (const BoneOverlap& overlap : overlaps) {
    list.push_back({{"a", overlap.a},
                    {"b", overlap.b},
                    {"depth_mm", overlap.depth_mm},
                    {"place_mm", ToJson(overlap.place)}});
  }
  return list;
}

std::vector<BoneOverlap> OverlapsFromJson(const OrderedJson& json) {
  std::vector<BoneOverlap> overlaps;
  for (const OrderedJson& item : json) {
    BoneOverlap& overlap = overlaps.emplace_back();
    item.at("a").get_to(overlap.a);
    item.at("b").get_to(overlap.b);
    item.at("depth_mm").get_to(overlap.depth_mm);
    overlap.place = PlaceFromJson(item.at("place_mm"));
  }
  return overlaps;
}

OrderedJson ToJson(const std::vector<DeliveredCrossing>& crossings) {
  OrderedJson list = OrderedJson::array();
  for (const DeliveredCrossing& crossing : crossings) {
    list.push_back({{"muscle", crossing.muscle},
                    {"bone", crossing.bone},
                    {"triangle_pairs", crossing.triangle_pairs},
                    {"pieces_inside", crossing.pieces_inside},
                    {"place_mm", ToJson(crossing.place)}});
  }
  return list;
}

std::vector<DeliveredCrossing> DeliveredFromJson(const OrderedJson& json) {
  std::vector<DeliveredCrossing> crossings;
  for (const OrderedJson& item : json) {
    DeliveredCrossing& crossing = crossings.emplace_back();
    item.at("muscle").get_to(crossing.muscle);
    item.at("bone").get_to(crossing.bone);
    item.at("triangle_pairs").get_to(crossing.triangle_pairs);
    item.at("pieces_inside").get_to(crossing.pieces_inside);
    crossing.place = PlaceFromJson(item.at("place_mm"));
  }
  return crossings;
}

OrderedJson ToJson(const StretchMeasures& stretch) {
  return {{"mean", stretch.mean},
          {"quantile_99", stretch.quantile_99},
          {"quantile_999", stretch.quantile_999},
          {"largest", stretch.largest},
          {"largest_place_mm", ToJson(stretch.largest_place)},
          {"area_beyond_1_6_mm2", stretch.area_beyond_anatomy},
          {"area_beyond_2_mm2", stretch.area_of_patches},
          {"largest_patch_mm2", stretch.largest_patch},
          {"patch_place_mm", ToJson(stretch.patch_place)}};
}

StretchMeasures StretchFromJson(const OrderedJson& json) {
  StretchMeasures stretch;
  json.at("mean").get_to(stretch.mean);
  json.at("quantile_99").get_to(stretch.quantile_99);
  json.at("quantile_999").get_to(stretch.quantile_999);
  json.at("largest").get_to(stretch.largest);
  stretch.largest_place = PlaceFromJson(json.at("largest_place_mm"));
  json.at("area_beyond_1_6_mm2").get_to(stretch.area_beyond_anatomy);
  json.at("area_beyond_2_mm2").get_to(stretch.area_of_patches);
  json.at("largest_patch_mm2").get_to(stretch.largest_patch);
  stretch.patch_place = PlaceFromJson(json.at("patch_place_mm"));
  return stretch;
}

OrderedJson ToJson(const ShapeMeasures& shape) {
  return {{"max_stretch", shape.max_stretch},
          {"max_stretch_along", shape.max_stretch_along},
          {"max_stretch_across", shape.max_stretch_across},
          {"stretch_place_mm", ToJson(shape.stretch_place)},
          {"min_area_ratio", shape.min_area_ratio},
          {"max_area_ratio", shape.max_area_ratio},
          {"max_bend_deg", shape.max_bend},
          {"bend_place_mm", ToJson(shape.bend_place)},
          {"max_change_mm", shape.max_change},
          {"change_place_mm", ToJson(shape.change_place)},
          {"triangle_stretch", ToJson(shape.triangles)}};
}

ShapeMeasures ShapeFromJson(const OrderedJson& json) {
  ShapeMeasures shape;
  json.at("max_stretch").get_to(shape.max_stretch);
  json.at("max_stretch_along").get_to(shape.max_stretch_along);
  json.at("max_stretch_across").get_to(shape.max_stretch_across);
  shape.stretch_place = PlaceFromJson(json.at("stretch_place_mm"));
  json.at("min_area_ratio").get_to(shape.min_area_ratio);
  json.at("max_area_ratio").get_to(shape.max_area_ratio);
  json.at("max_bend_deg").get_to(shape.max_bend);
  shape.bend_place = PlaceFromJson(json.at("bend_place_mm"));
  json.at("max_change_mm").get_to(shape.max_change);
  shape.change_place = PlaceFromJson(json.at("change_place_mm"));
  // Earlier reports have no stretches of triangles.
  if (json.contains("triangle_stretch")) {
    shape.triangles = StretchFromJson(json.at("triangle_stretch"));
  }
  return shape;
}

OrderedJson ToJson(const MuscleRecord& record) {
  return {{"name", record.name},
          {"volume_mm3", record.volume_mm3},
          {"volume_ratio", record.volume_ratio},
          {"volume_error", record.volume_error},
          {"max_step_mm", record.max_step_mm},
          {"max_displacement_mm", record.max_displacement_mm},
          {"min_gap_mm", record.min_gap_mm},
          {"folded_triangles", record.folded_triangles},
          {"self_pairs", record.self_pairs},
          {"max_contact_displacement_mm", record.max_contact_displacement_mm},
          {"mean_contact_displacement_mm", record.mean_contact_displacement_mm},
          {"depth_without_contact_mm", record.depth_without_contact_mm},
          {"torn_patch_mm2", record.torn_patch.area},
          {"torn_patch_place_mm", ToJson(record.torn_patch.place)},
          {"push_depth_mm", record.push_depth_mm},
          {"pushed_by", record.pushed_by},
          {"attachments", ToJson(record.attachments)},
          {"shape", ToJson(record.shape)},
          {"iterations", record.iterations},
          {"solve_ms", record.solve_ms},
          {"initial_energy_mm2", record.initial_energy_mm2},
          {"final_energy_mm2", record.final_energy_mm2},
          {"stop_reason", record.stop_reason},
          {"line_lengths_mm", record.line_lengths_mm},
          {"path_lengths_mm", record.path_lengths_mm},
          {"fibre_lengths_mm", record.fibre_lengths_mm},
          {"fibre_stretch_by_fifths", record.fibre_stretch_by_fifths},
          {"line_moment_arms_mm", record.line_moment_arms_mm},
          {"fibre_moment_arms_mm", record.fibre_moment_arms_mm}};
}

MuscleRecord MuscleRecordFromJson(const OrderedJson& json) {
  MuscleRecord record;
  json.at("name").get_to(record.name);
  json.at("volume_mm3").get_to(record.volume_mm3);
  json.at("volume_ratio").get_to(record.volume_ratio);
  // Earlier reports had no other volume to compare with.
  record.volume_error = json.value("volume_error", record.volume_ratio - 1);
  json.at("max_step_mm").get_to(record.max_step_mm);
  json.at("max_displacement_mm").get_to(record.max_displacement_mm);
  json.at("min_gap_mm").get_to(record.min_gap_mm);
  json.at("folded_triangles").get_to(record.folded_triangles);
  json.at("self_pairs").get_to(record.self_pairs);
  json.at("max_contact_displacement_mm")
      .get_to(record.max_contact_displacement_mm);
  json.at("mean_contact_displacement_mm")
      .get_to(record.mean_contact_displacement_mm);
  json.at("depth_without_contact_mm").get_to(record.depth_without_contact_mm);
  // Reports of older versions lack them.
  if (json.contains("torn_patch_mm2")) {
    record.torn_patch = {json.at("torn_patch_mm2").get<double>(),
                         PlaceFromJson(json.at("torn_patch_place_mm"))};
  }
  record.push_depth_mm = json.value("push_depth_mm", 0.0);
  record.pushed_by = json.value("pushed_by", std::vector<std::string>());
  record.attachments =
      DriftsFromJson(json.value("attachments", OrderedJson::array()));
  if (json.contains("shape")) record.shape = ShapeFromJson(json.at("shape"));
  json.at("iterations").get_to(record.iterations);
  json.at("solve_ms").get_to(record.solve_ms);
  json.at("initial_energy_mm2").get_to(record.initial_energy_mm2);
  json.at("final_energy_mm2").get_to(record.final_energy_mm2);
  json.at("stop_reason").get_to(record.stop_reason);
  json.at("line_lengths_mm").get_to(record.line_lengths_mm);
  json.at("path_lengths_mm").get_to(record.path_lengths_mm);
  json.at("fibre_lengths_mm").get_to(record.fibre_lengths_mm);
  record.fibre_stretch_by_fifths =
      json.value("fibre_stretch_by_fifths", record.fibre_stretch_by_fifths);
  record.line_moment_arms_mm =
      json.value("line_moment_arms_mm", record.line_moment_arms_mm);
  record.fibre_moment_arms_mm =
      json.value("fibre_moment_arms_mm", record.fibre_moment_arms_mm);
  return record;
}

OrderedJson ToJson(const std::vector<MeshGap>& gaps) {
  OrderedJson list = OrderedJson::array();
  for (const MeshGap& gap : gaps) {
    list.push_back({{"a", gap.a},
                    {"b", gap.b},
                    {"at_least_mm", gap.at_least_mm},
                    {"at_most_mm", gap.at_most_mm},
                    {"place_mm", {gap.place[0], gap.place[1], gap.place[2]}}});
  }
  return list;
}

std::vector<MeshGap> GapsFromJson(const OrderedJson& json) {
  std::vector<MeshGap> gaps;
  for (const OrderedJson& item : json) {
    MeshGap gap;
    item.at("a").get_to(gap.a);
    item.at("b").get_to(gap.b);
    item.at("at_least_mm").get_to(gap.at_least_mm);
    item.at("at_most_mm").get_to(gap.at_most_mm);
    for (int k = 0; k < 3; ++k) item.at("place_mm").at(k).get_to(gap.place[k]);
    gaps.push_back(gap);
  }
  return gaps;
}

std::vector<StageTime> StagesFromJson(const OrderedJson& json) {
  std::vector<StageTime> stages;
  for (const OrderedJson& item : json) {
    stages.push_back({item.at("name").get<std::string>(),
                      item.at("ms").get<double>(),
                      item.at("visits").get<int>()});
  }
  return stages;
}

SceneIntersections IntersectionsFromJson(const OrderedJson& json) {
  SceneIntersections intersections;
  json.at("triangle_pairs").get_to(intersections.triangle_pairs);
  json.at("vertices_inside").get_to(intersections.vertices_inside);
  json.at("max_depth_mm").get_to(intersections.max_depth_mm);
  json.at("self_pairs").get_to(intersections.self_pairs);
  json.at("exempt_pairs").get_to(intersections.exempt_pairs);
  for (const OrderedJson& item : json.at("pairs")) {
    PairIntersection pair;
    item.at("a").get_to(pair.a);
    item.at("b").get_to(pair.b);
    item.at("triangle_pairs").get_to(pair.triangle_pairs);
    item.at("vertices_inside").get_to(pair.vertices_inside);
    item.at("max_depth_mm").get_to(pair.max_depth_mm);
    item.at("exempt_pairs").get_to(pair.exempt_pairs);
    intersections.pairs.push_back(pair);
  }
  return intersections;
}

}  // namespace

OrderedJson ToJson(const std::vector<StageTime>& stages) {
  OrderedJson json = OrderedJson::array();
  for (const StageTime& stage : stages) {
    json.push_back(
        {{"name", stage.name}, {"ms", stage.ms}, {"visits", stage.visits}});
  }
  return json;
}

OrderedJson ToJson(const SceneIntersections& intersections) {
  OrderedJson pairs = OrderedJson::array();
  for (const PairIntersection& pair : intersections.pairs) {
    pairs.push_back({{"a", pair.a},
                     {"b", pair.b},
                     {"triangle_pairs", pair.triangle_pairs},
                     {"vertices_inside", pair.vertices_inside},
                     {"max_depth_mm", pair.max_depth_mm},
                     {"exempt_pairs", pair.exempt_pairs}});
  }
  return {{"triangle_pairs", intersections.triangle_pairs},
          {"vertices_inside", intersections.vertices_inside},
          {"max_depth_mm", intersections.max_depth_mm},
          {"self_pairs", intersections.self_pairs},
          {"exempt_pairs", intersections.exempt_pairs},
          {"pairs", pairs}};
}

OrderedJson ToJson(const FrameRecord& record) {
  OrderedJson muscles = OrderedJson::array();
  for (const MuscleRecord& muscle : record.muscles) {
    muscles.push_back(ToJson(muscle));
  }
  const std::optional<double> gap = record.intersections.SmallestGap();
  OrderedJson json = {
      {"index", record.index},
      {"name", record.name},
      {"time", record.time},
      {"coordinates", record.coordinates},
      {"wall_ms", record.wall_ms},
      {"solve_ms", record.solve_ms},
      {"certify_ms", record.certify_ms},
      {"moment_arms_ms", record.moment_arms_ms},
      {"pose_steps", record.pose_steps},
      {"iterations", record.iterations},
      {"stop_reason", record.stop_reason},
      {"usable", record.usable},
      {"shortcomings", record.shortcomings},
      {"bone_overlaps", ToJson(record.bone_overlaps)},
      {"delivered_crossings", ToJson(record.delivered_crossings)},
      {"muscles", muscles},
      {"path_moment_arms_mm", record.path_moment_arms_mm},
      {"moment_arms_converged", record.moment_arms_converged},
      {"intersections", ToJson(record.intersections)},
      {"gaps", ToJson(record.intersections.gaps)},
      {"smallest_gap_mm", gap ? OrderedJson(*gap) : OrderedJson()}};
  if (!record.stages.empty()) json["stages"] = ToJson(record.stages);
  return json;
}

FrameRecord FrameRecordFromJson(const OrderedJson& json) {
  FrameRecord record;
  json.at("index").get_to(record.index);
  json.at("name").get_to(record.name);
  json.at("time").get_to(record.time);
  json.at("coordinates").get_to(record.coordinates);
  json.at("wall_ms").get_to(record.wall_ms);
  json.at("solve_ms").get_to(record.solve_ms);
  json.at("certify_ms").get_to(record.certify_ms);
  record.moment_arms_ms = json.value("moment_arms_ms", 0.0);
  record.stages = StagesFromJson(json.value("stages", OrderedJson::array()));
  json.at("pose_steps").get_to(record.pose_steps);
  json.at("iterations").get_to(record.iterations);
  json.at("stop_reason").get_to(record.stop_reason);
  json.at("usable").get_to(record.usable);
  json.at("shortcomings").get_to(record.shortcomings);
  record.bone_overlaps =
      OverlapsFromJson(json.value("bone_overlaps", OrderedJson::array()));
  record.delivered_crossings = DeliveredFromJson(
      json.value("delivered_crossings", OrderedJson::array()));
  for (const OrderedJson& muscle : json.at("muscles")) {
    record.muscles.push_back(MuscleRecordFromJson(muscle));
  }
  json.at("path_moment_arms_mm").get_to(record.path_moment_arms_mm);
  record.moment_arms_converged = json.value("moment_arms_converged", true);
  record.intersections = IntersectionsFromJson(json.at("intersections"));
  // Reports that were written before gaps were measured can still be read.
  if (json.contains("gaps")) {
    record.intersections.gaps = GapsFromJson(json.at("gaps"));
  }
  return record;
}

}  // namespace musclewarp
