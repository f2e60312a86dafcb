// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/report/report_json.h"

#include <algorithm>
#include <cmath>

#include "musclewarp/report/machine.h"

namespace musclewarp {
namespace {

using Json = nlohmann::ordered_json;

Json ToJson(const RepairReport& repairs) {
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
          {"filled_area_mm2", repairs.fillings.area},
          {"longest_hole_mm", repairs.fillings.longest},
          {"dropped_components", repairs.dropped_components},
          {"dropped_triangles", repairs.dropped_triangles},
          {"dropped_area_mm2", repairs.dropped_area},
          {"largest_dropped_area_mm2", repairs.largest_dropped_area},
          {"pulled_points", repairs.pulls.points},
          {"longest_pull_mm", repairs.pulls.longest},
          {"dropped_points", repairs.dropped_points}};
}

Json ToJson(const SceneIntersections& intersections) {
  Json pairs = Json::array();
  for (const PairIntersection& pair : intersections.pairs) {
    pairs.push_back({{"a", pair.a},
                     {"b", pair.b},
                     {"triangle_pairs", pair.triangle_pairs},
                     {"vertices_inside", pair.vertices_inside},
                     {"max_depth_mm", pair.max_depth_mm}});
  }
  return {{"triangle_pairs", intersections.triangle_pairs},
          {"vertices_inside", intersections.vertices_inside},
          {"max_depth_mm", intersections.max_depth_mm},
          {"self_pairs", intersections.self_pairs},
          {"pairs", pairs}};
}

Json PrepareJson(const PreparedScene& scene) {
  Json muscles = Json::array();
  for (const PreparedMuscle& muscle : scene.muscles) {
    muscles.push_back({{"name", muscle.model.name},
                       {"mesh", muscle.mesh.path},
                       {"fine_vertices", muscle.model.fine_rest.rows()},
                       {"coarse_vertices", muscle.model.coarse_rest.rows()},
                       {"hull_encloses", muscle.hull_encloses},
                       {"volume_mm3", muscle.model.rest_volume},
                       {"skeleton_samples", muscle.model.samples.size()},
                       {"attachment_rows", muscle.model.attachment_of.size()},
                       {"defects", DefectsJson(muscle.mesh.defects)},
                       {"repairs", ToJson(muscle.mesh.repairs)}});
  }
  Json bones = Json::array();
  for (const PreparedBone& bone : scene.bones) {
    bones.push_back({{"name", bone.mesh.name},
                     {"mesh", bone.mesh.path},
                     {"vertices", bone.rest.points.rows()},
                     {"defects", DefectsJson(bone.mesh.defects)},
                     {"repairs", ToJson(bone.mesh.repairs)}});
  }
  return {{"wall_ms", scene.wall_ms},
          {"cached", false},
          {"warnings", scene.warnings},
          {"muscles", muscles},
          {"bones", bones}};
}

Json ToJson(const MuscleFrame& frame, const std::string& name) {
  return {{"name", name},
          {"volume_ratio", frame.volume_ratio},
          {"max_step_mm", frame.solver.max_step},
          {"max_displacement_mm", frame.max_displacement},
          {"folded_triangles", frame.folded_triangles},
          {"iterations", frame.solver.iterations},
          {"solve_ms", frame.solver.wall_ms},
          {"initial_energy_mm2", frame.solver.initial_energy},
          {"final_energy_mm2", frame.solver.final_energy},
          {"stop_reason", ToString(frame.solver.stop_reason)},
          {"line_lengths_mm", frame.line_lengths}};
}

Json ToJson(const Frame& frame, const PreparedScene& scene) {
  Json muscles = Json::array();
  for (size_t i = 0; i < frame.muscles.size(); ++i) {
    muscles.push_back(ToJson(frame.muscles[i], scene.muscles[i].model.name));
  }
  return {{"index", frame.index},
          {"name", frame.pose->name},
          {"time", frame.pose->time},
          {"coordinates", frame.pose->coordinates},
          {"wall_ms", frame.wall_ms},
          {"solve_ms", frame.solve_ms},
          {"certify_ms", frame.certify_ms},
          {"iterations", frame.iterations()},
          {"stop_reason", frame.stop_reason(scene)},
          {"muscles", muscles},
          {"intersections", ToJson(frame.intersections)}};
}

}  // namespace

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

RunTotals TotalsOf(const RunRecord& run) {
  RunTotals totals;
  totals.frames = static_cast<int>(run.frames.size());
  totals.usable = !run.frames.empty();
  std::vector<double> wall_ms;
  for (const Frame& frame : run.frames) {
    totals.frames_clean += frame.intersections.IsClean();
    totals.usable = totals.usable && frame.IsUsable();
    wall_ms.push_back(frame.wall_ms);
    for (const MuscleFrame& muscle : frame.muscles) {
      totals.worst_volume_error = std::max(totals.worst_volume_error,
                                           std::abs(muscle.volume_ratio - 1));
      totals.worst_folded_triangles =
          std::max(totals.worst_folded_triangles, muscle.folded_triangles);
    }
  }
  if (!wall_ms.empty()) {
    const auto middle = wall_ms.begin() + wall_ms.size() / 2;
    std::nth_element(wall_ms.begin(), middle, wall_ms.end());
    totals.wall_ms_per_frame_median = *middle;
  }
  return totals;
}

nlohmann::ordered_json MachineJson() {
  const Machine machine = ThisMachine();
  return {{"processor", machine.processor},
          {"cores", machine.cores},
          {"threads", machine.threads}};
}

nlohmann::ordered_json ReportJson(const RunRecord& run) {
  Json prepare = PrepareJson(*run.scene);
  Json rest = {{"intersections", ToJson(run.rest)}};
  Json contact_options = nullptr;
  if (run.contact) {
    prepare["contact_ms"] = run.contact->wall_ms;
    for (const std::string& warning : run.contact->warnings) {
      prepare["warnings"].push_back(warning);
    }
    rest["after_initial_fix"] = ToJson(run.rest_after_fix);
    const GroupContactOptions& options = run.contact->options.group;
    contact_options = {{"level", ToString(options.level)},
                       {"seed", options.paper.seed}};
  }
  const RunTotals totals = TotalsOf(run);
  Json frames = Json::array();
  for (const Frame& frame : run.frames) {
    frames.push_back(ToJson(frame, *run.scene));
  }
  return {{"scene", run.scene->scene.name},
          {"solver", run.solver},
          {"contact", run.contact ? "paper" : "none"},
          {"contact_options", contact_options},
          {"machine", MachineJson()},
          {"version", MUSCLEWARP_VERSION},
          {"prepare", prepare},
          {"rest", rest},
          {"frames", frames},
          {"summary",
           {{"frames", totals.frames},
            {"frames_clean", totals.frames_clean},
            {"worst_volume_error", totals.worst_volume_error},
            {"worst_folded_triangles", totals.worst_folded_triangles},
            {"wall_ms_per_frame_median", totals.wall_ms_per_frame_median},
            {"usable", totals.usable}}}};
}

}  // namespace musclewarp
