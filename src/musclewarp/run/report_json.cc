// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/report_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "musclewarp/base/memory.h"
#include "musclewarp/build_info/build_info.h"
#include "musclewarp/figures/figures_json.h"
#include "musclewarp/frames/fibre_measures.h"
#include "musclewarp/run/kept_model.h"
#include "musclewarp/run/machine.h"
#include "musclewarp/run/paths_in_json.h"
#include "musclewarp/run/pose_name.h"
#include "musclewarp/run/shape_warnings.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

// How a muscle was made anew; null if it was not.
OrderedJson ReconstructionJson(const SurfaceReconstruction& reconstruction) {
  return reconstruction.is_done ? JsonOf(reconstruction) : OrderedJson();
}

// The pieces of a mesh that its repair left out.
OrderedJson DroppedPiecesJson(const MeshPreparation& mesh) {
  OrderedJson list = OrderedJson::array();
  for (const DroppedPiece& piece : mesh.repairs.dropped_pieces) {
    const Eigen::RowVector3d& place = piece.place;
    list.push_back({{"reason", ToString(piece.reason)},
                    {"triangles", piece.triangles},
                    {"area_mm2", piece.area},
                    {"share", piece.share},
                    {"volume_mm3", piece.volume},
                    {"cavity_mm3", piece.cavity},
                    {"place_mm", {place.x(), place.y(), place.z()}}});
  }
  return list;
}

// The attachment areas of a muscle. `is_found`: on the meshes, not in the
// scene.
OrderedJson AttachmentsJson(const PreparedMuscle& muscle, bool is_found) {
  const MuscleModel& model = muscle.model;
  const std::vector<double> areas = AttachedAreas(model.attachments,
                                                  muscle.attached,
                                                  model.fine_rest,
                                                  model.fine_triangles);
  OrderedJson list = OrderedJson::array();
  for (size_t a = 0; a < areas.size(); ++a) {
    const auto on_bones = muscle.area_on_bones.find(model.attachments[a].body);
    const bool has_bones = on_bones != muscle.area_on_bones.end();
    list.push_back({{"body", NameOfCarrier(model.attachments[a])},
                    {"area_mm2", areas[a]},
                    {"area_on_bones_mm2", has_bones ? on_bones->second : 0},
                    {"found", is_found}});
  }
  return list;
}

OrderedJson LineEndsJson(const std::vector<LineEnd>& ends) {
  OrderedJson list = OrderedJson::array();
  for (const LineEnd& end : ends) {
    list.push_back({{"body", end.body}, {"distance_mm", end.distance}});
  }
  return list;
}

OrderedJson BareTendonsJson(const std::vector<BareTendon>& tendons) {
  OrderedJson list = OrderedJson::array();
  for (const BareTendon& tendon : tendons) {
    list.push_back({{"end", tendon.is_at_origin ? "origin" : "insertion"},
                    {"body", tendon.body},
                    {"bone", tendon.bone},
                    {"landmark", tendon.landmark},
                    {"length_mm", tendon.length},
                    {"evidence", ToString(tendon.evidence)}});
  }
  return list;
}

FibreSpread SpreadAtRest(const PreparedMuscle& muscle) {
  return SpreadOf(LinesAt(muscle.fibres, muscle.model.coarse_rest));
}

OrderedJson PrepareJson(const PreparedScene& scene) {
  OrderedJson muscles = OrderedJson::array();
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    const PreparedMuscle& muscle = scene.muscles[i];
    const FibreSpread fibres = SpreadAtRest(muscle);
    const bool has_named = !scene.scene.muscles[i].attachments.empty();
    muscles.push_back(
        {{"name", muscle.model.name},
         {"mesh", muscle.mesh.path},
         {"fine_vertices", muscle.model.fine_rest.rows()},
         {"coarse_vertices", muscle.model.coarse_rest.rows()},
         {"hull_encloses", muscle.hull_encloses},
         {"volume_mm3", muscle.model.rest_volume},
         {"delivered_volume_mm3", muscle.mesh.delivered_volume},
         {"skeleton_samples", muscle.model.samples.size()},
         {"lines", muscle.model.lines.size()},
         {"line_ends", LineEndsJson(muscle.line_ends)},
         {"bare_tendons", BareTendonsJson(muscle.bare_tendons)},
         {"fibres", muscle.fibres.num_lines()},
         {"fibres_ms", muscle.fibres_ms},
         {"shortest_fibre_mm", fibres.shortest},
         {"fibre_origins_spread_mm", fibres.at_origin},
         {"fibre_insertions_spread_mm", fibres.at_insertion},
         {"attachment_rows", muscle.model.attachment_of.size()},
         {"attachments", AttachmentsJson(muscle, !has_named)},
         {"dropped_pieces", DroppedPiecesJson(muscle.mesh)},
         {"defects", DefectsJson(muscle.mesh.defects)},
         {"repairs", RepairsJson(muscle.mesh)},
         {"remade", ReconstructionJson(muscle.mesh.reconstruction)}});
  }
  OrderedJson bones = OrderedJson::array();
  for (const PreparedBone& bone : scene.bones) {
    bones.push_back(
        {{"name", bone.mesh.name},
         {"mesh", bone.mesh.path},
         {"vertices", bone.rest.points.rows()},
         {"pieces", bone.mesh.repairs.pieces},
         {"dropped_pieces", DroppedPiecesJson(bone.mesh)},
         {"delivered_triangles_changed", bone.delivered_only.triangles.rows()},
         {"defects", DefectsJson(bone.mesh.defects)},
         {"repairs", RepairsJson(bone.mesh)}});
  }
  OrderedJson crossings = OrderedJson::array();
  for (const BoneCrossing& crossing : scene.bone_crossings) {
    const Eigen::RowVector3d& place = crossing.place;
    crossings.push_back({{"a", crossing.a},
                         {"b", crossing.b},
                         {"triangle_pairs", crossing.triangle_pairs},
                         {"place_mm", {place.x(), place.y(), place.z()}}});
  }
  OrderedJson json = {{"wall_ms", scene.wall_ms},
                      {"cached", scene.is_cached},
                      {"memory_needed_gib", scene.memory_needed / kBytesPerGib},
                      {"notes", scene.scene.notes},
                      {"warnings", scene.warnings},
                      {"muscles", muscles},
                      {"bones", bones},
                      {"bone_crossings", crossings}};
  if (!scene.stages.empty()) json["stages"] = JsonOf(scene.stages);
  return json;
}

// Where the poses come from, and in which unit each coordinate is.
// Null without contact.
OrderedJson ContactOptionsJson(const ContactReport& contact) {
  switch (contact.kind) {
    case ContactKind::kCertified:
      return {{"gap_mm", contact.gap}};
    case ContactKind::kPaper:
      return {{"level", contact.level}, {"seed", contact.seed}};
    case ContactKind::kNone:
      break;
  }
  return nullptr;
}

OrderedJson RowsJson(const Eigen::Matrix4d& matrix) {
  OrderedJson rows = OrderedJson::array();
  for (int i = 0; i < 4; ++i) {
    rows.push_back({matrix(i, 0), matrix(i, 1), matrix(i, 2), matrix(i, 3)});
  }
  return rows;
}

// How the meshes lie on the model at rest.
OrderedJson RestJson(const ModelPoses& poses) {
  OrderedJson bodies = OrderedJson::object();
  for (const int body : poses.bodies) {
    bodies[poses.model.bodies[body].name] =
        RowsJson(poses.body_from_rest[body]);
  }
  return {{"scene_from_ground", RowsJson(poses.scene_from_ground)},
          {"body_from_rest", bodies}};
}

OrderedJson MotionJson(const Scene& scene, bool keeps_model) {
  if (!scene.model) return nullptr;
  const Model& model = scene.model->model;
  OrderedJson coordinates = OrderedJson::array();
  for (const int index : scene.model->given_coordinates) {
    const auto& moving = scene.model->moving_coordinates;
    const CoordinateKind kind = model.coordinates[index].kind;
    coordinates.push_back(
        {{"name", model.coordinates[index].name},
         {"unit", UnitInReports(kind)},
         {"moves", std::count(moving.begin(), moving.end(), index) > 0}});
  }
  OrderedJson json = {{"model", model.path}};
  if (keeps_model) json["kept_model"] = kKeptModel;
  json["file"] = scene.motion_path;
  if (!scene.design.empty()) json["design"] = scene.design;
  json["coordinates"] = coordinates;
  json["rest"] = RestJson(*scene.model);
  return json;
}

}  // namespace

nlohmann::ordered_json RepairsJson(const MeshPreparation& mesh) {
  const RepairReport& repairs = mesh.repairs;
  const DroppedTotals dropped = TotalsOf(repairs.dropped_pieces);
  return {{"merged_points", repairs.point_merges.merged},
          {"longest_merge_mm", repairs.point_merges.longest},
          {"degenerate_triangles_removed", repairs.degenerate_triangles},
          {"duplicate_triangles_removed", repairs.duplicate_triangles},
          {"flipped_triangles", repairs.flipped_triangles},
          {"non_manifold_edges_separated", repairs.separation.edges},
          {"non_manifold_vertices_separated", repairs.separated_vertices},
          {"stitched_points",
           repairs.stitches.merged_points + repairs.stitches.inserted_points},
          {"longest_stitch_mm", repairs.stitches.longest},
          {"holes_filled", repairs.fillings.holes},
          {"missing_faces_filled", repairs.fillings.missing_faces},
          {"filled_area_mm2", repairs.fillings.area},
          {"longest_hole_mm", repairs.fillings.longest},
          {"dropped_components", repairs.dropped_pieces.size()},
          {"dropped_triangles", dropped.triangles},
          {"dropped_area_mm2", dropped.area},
          {"largest_dropped_area_mm2", dropped.largest_area},
          {"pulled_points", repairs.pulls.points},
          {"longest_pull_mm", repairs.pulls.longest},
          {"dropped_points", repairs.dropped_points},
          {"self_crossing_pairs_before", mesh.self_crossings.pairs_before},
          {"self_crossing_pairs_after", mesh.self_crossings.pairs_after},
          {"self_crossing_new_vertices", mesh.self_crossings.new_vertices},
          {"sliver_edges_collapsed", mesh.slivers.collapsed_edges},
          {"sliver_edges_flipped", mesh.slivers.flipped_edges},
          {"slivers_left", mesh.slivers.slivers_left},
          {"sliver_deviation_mm", mesh.slivers.largest_deviation},
          {"drawn_out_triangles_removed", mesh.drawn_out_triangles}};
}

nlohmann::ordered_json DefectsJson(const MeshDefects& defects) {
  return {{"duplicate_points", defects.duplicate_points},
          {"unreferenced_points", defects.unreferenced_points},
          {"degenerate_triangles", defects.degenerate_triangles},
          {"duplicate_triangles", defects.duplicate_triangles},
          {"border_edges", defects.border_edges},
          {"border_length_mm", defects.border_length},
          {"non_manifold_edges", defects.non_manifold_edges},
          {"non_manifold_vertices", defects.non_manifold_vertices},
          {"misoriented_edges", defects.misoriented_edges},
          {"components", defects.components},
          {"is_inside_out", defects.is_inside_out}};
}

RunFigures TotalsOf(const RunRecord& run) {
  return FiguresOf(run.frames, run.frames_planned, run.finished, run.stopped);
}

nlohmann::ordered_json MachineJson() {
  const Machine machine = ThisMachine();
  return {{"processor", machine.processor},
          {"cores", machine.cores},
          {"threads", machine.threads}};
}

nlohmann::ordered_json ReportJson(const RunRecord& run) {
  OrderedJson prepare = PrepareJson(*run.scene);
  OrderedJson rest = {{"intersections", JsonOf(run.rest)}};
  if (run.contact.rest) {
    prepare["contact_ms"] = run.contact.prepare_ms;
    for (const std::string& warning : run.contact.warnings) {
      prepare["warnings"].push_back(warning);
    }
    rest["after_initial_fix"] = JsonOf(*run.contact.rest);
  }
  OrderedJson json = {
      {"scene", run.scene->scene.name},
      {"axes", run.scene->scene.axes},
      {"side", run.scene->scene.side},
      {"body_size", run.scene->scene.body_size},
      {"solver", run.solver},
      {"contact", ToString(run.contact.kind)},
      {"contact_options", ContactOptionsJson(run.contact)},
      {"machine", MachineJson()},
      {"version", kVersion},
      {"code", CodeKey()},
      {"command", run.command},
      {"options", run.options},
      {"inputs_hash", run.inputs_hash},
      {"motion", MotionJson(run.scene->scene, IsModelKept(run.dir))},
      {"prepare", prepare},
      {"rest", rest},
      {"frames", JsonOf(run.frames)},
      {"warnings", ShapeWarnings(run.frames, run.scene->scene.body_size)},
      {"summary", JsonOf(TotalsOf(run))}};
  if (!run.dir.empty()) AdaptTexts(run.dir, &json);
  return json;
}

}  // namespace musclewarp
