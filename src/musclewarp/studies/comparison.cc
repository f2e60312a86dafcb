// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/studies/comparison.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "musclewarp/base/csv_field.h"
#include "musclewarp/build_info/build_info.h"
#include "musclewarp/run/report_json.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

double CostOf(const Frame& frame) {
  double cost = 0;
  for (const MuscleFrame& muscle : frame.muscles) {
    cost += muscle.solver.final_energy;
  }
  return cost;
}

double LargestDistance(const Frame& frame, const Frame& reference) {
  double distance = 0;
  for (size_t i = 0; i < frame.muscles.size(); ++i) {
    distance = std::max(distance,
                        (frame.muscles[i].points - reference.muscles[i].points)
                            .rowwise()
                            .norm()
                            .maxCoeff());
  }
  return distance;
}

double MeanDistance(const Frame& frame, const Frame& reference) {
  double sum = 0, count = 0;
  for (size_t i = 0; i < frame.muscles.size(); ++i) {
    const Points& points = frame.muscles[i].points;
    sum += (points - reference.muscles[i].points).rowwise().norm().sum();
    count += static_cast<double>(points.rows());
  }
  return sum / count;
}

size_t Widest(const std::vector<ComparisonRow>& rows,
              std::string ComparisonRow::*text,
              size_t at_least) {
  for (const ComparisonRow& row : rows) {
    at_least = std::max(at_least, (row.*text).size());
  }
  return at_least;
}

OrderedJson ToJson(const ComparisonRow& row, const PreparedScene& scene) {
  OrderedJson json = {{"frame", row.frame},
                      {"pose", row.pose},
                      {"configuration", row.configuration},
                      {"contact", row.contact},
                      {"stop_reason", row.stop_reason},
                      {"was_run", row.was_run}};
  if (!row.was_run) return json;
  OrderedJson muscles = OrderedJson::array();
  for (size_t i = 0; i < row.muscles.size(); ++i) {
    const SolverSummary& solver = row.muscles[i];
    OrderedJson history = OrderedJson::array();
    for (const SolverIteration& iteration : solver.history) {
      history.push_back({{"max_step_mm", iteration.max_step},
                         {"volume_error", iteration.volume_error},
                         {"alpha", iteration.alpha},
                         {"fine_volume", iteration.is_fine_volume}});
    }
    muscles.push_back({{"name", scene.muscles[i].model.name},
                       {"iterations", solver.iterations},
                       {"ms", solver.wall_ms},
                       {"initial_cost_mm2", solver.initial_energy},
                       {"final_cost_mm2", solver.final_energy},
                       {"volume_ratio", solver.volume_ratio},
                       {"stop_reason", ToString(solver.stop_reason)},
                       {"history", history}});
  }
  json.update({{"iterations", row.iterations},
               {"ms", row.ms},
               {"ms_per_iteration", row.ms_per_iteration},
               {"time_ratio", row.time_ratio},
               {"final_cost_mm2", row.final_cost},
               {"cost_ratio", row.cost_ratio},
               {"volume_ratio", row.volume_ratio},
               {"distance_to_reference_mm", row.distance},
               {"largest_contact_move_mm", row.largest_contact_move},
               {"mean_contact_move_mm", row.mean_contact_move},
               {"folded_triangles", row.folded_triangles},
               {"self_pairs", row.intersections.self_pairs},
               {"triangle_pairs", row.intersections.triangle_pairs},
               {"vertices_inside", row.intersections.vertices_inside},
               {"max_depth_mm", row.intersections.max_depth_mm},
               {"muscles", muscles}});
  return json;
}

}  // namespace

ComparisonRow RowOf(const Frame& frame,
                    const Frame* reference,
                    const Frame* without_contact,
                    bool counts_together) {
  ComparisonRow row;
  row.frame = frame.index;
  row.pose = frame.name;
  row.was_run = true;
  row.stop_reason = frame.stop_reason();
  row.iterations =
      counts_together ? frame.muscles[0].solver.iterations : frame.iterations();
  row.ms = frame.solve_ms;
  row.ms_per_iteration = row.ms / std::max(1, row.iterations);
  row.final_cost = CostOf(frame);
  row.volume_ratio = 1;
  for (const MuscleFrame& muscle : frame.muscles) {
    if (std::abs(muscle.volume_error) > std::abs(row.volume_ratio - 1)) {
      row.volume_ratio = 1 + muscle.volume_error;
    }
    row.folded_triangles += muscle.folded_triangles;
    row.muscles.push_back(muscle.solver);
  }
  row.intersections = frame.intersections;
  if (without_contact) {
    row.largest_contact_move = LargestDistance(frame, *without_contact);
    row.mean_contact_move = MeanDistance(frame, *without_contact);
  }
  if (reference) {
    row.time_ratio = row.ms / reference->solve_ms;
    // In the rest pose both costs are rounding errors.
    const double cost = CostOf(*reference);
    row.cost_ratio =
        std::max(row.final_cost, cost) < 1e-9 ? 1 : row.final_cost / cost;
    row.distance = LargestDistance(frame, *reference);
  }
  return row;
}

void PrintComparison(const std::vector<ComparisonRow>& rows,
                     std::ostream& out) {
  const size_t pose = Widest(rows, &ComparisonRow::pose, 4);
  const size_t name = Widest(rows, &ComparisonRow::configuration, 13);
  const size_t contact = Widest(rows, &ComparisonRow::contact, 7);
  const auto text = [&](const std::string& value, size_t width) {
    out << std::left << std::setw(static_cast<int>(width)) << value
        << std::right << "  ";
  };
  out << "\n";
  text("pose", pose);
  text("configuration", name);
  text("contact", contact);
  out << "iterations        ms  ms/iter  x time    cost mm^2    x cost"
         "  volume ratio    dist mm  folded    self   pairs  inside  depth mm"
         "   moved    mean  stop\n";
  for (const ComparisonRow& row : rows) {
    text(row.pose, pose);
    text(row.configuration, name);
    text(row.contact, contact);
    if (row.was_run) {
      out << std::fixed << std::setw(10) << row.iterations << std::setw(10)
          << std::setprecision(1) << row.ms << std::setw(9)
          << std::setprecision(2) << row.ms_per_iteration << std::setw(8)
          << row.time_ratio << std::setw(13) << std::setprecision(4)
          << row.final_cost << std::setw(10) << std::setprecision(5)
          << row.cost_ratio << std::setw(14) << std::setprecision(9)
          << row.volume_ratio << std::scientific << std::setw(11)
          << std::setprecision(1) << row.distance << std::fixed << std::setw(8)
          << row.folded_triangles << std::setw(8)
          << row.intersections.self_pairs << std::setw(8)
          << row.intersections.triangle_pairs << std::setw(8)
          << row.intersections.vertices_inside << std::setw(10)
          << std::setprecision(2) << row.intersections.max_depth_mm
          << std::setw(8) << row.largest_contact_move << std::setw(8)
          << std::setprecision(3) << row.mean_contact_move << "  ";
    }
    out << row.stop_reason << "\n";
  }
}

std::string ComparisonCsv(const std::vector<ComparisonRow>& rows) {
  std::ostringstream csv;
  csv << std::setprecision(12)
      << "frame,pose,configuration,contact,iterations,ms,ms_per_iteration,"
         "time_ratio,final_cost_mm2,cost_ratio,volume_ratio,"
         "distance_to_reference_mm,folded_triangles,self_pairs,"
         "triangle_pairs,vertices_inside,max_depth_mm,"
         "largest_contact_move_mm,mean_contact_move_mm,stop_reason\n";
  for (const ComparisonRow& row : rows) {
    csv << row.frame << "," << CsvField(row.pose) << "," << row.configuration
        << "," << row.contact << ",";
    if (row.was_run) {
      csv << row.iterations << "," << row.ms << "," << row.ms_per_iteration
          << "," << row.time_ratio << "," << row.final_cost << ","
          << row.cost_ratio << "," << row.volume_ratio << "," << row.distance
          << "," << row.folded_triangles << "," << row.intersections.self_pairs
          << "," << row.intersections.triangle_pairs << ","
          << row.intersections.vertices_inside << ","
          << row.intersections.max_depth_mm << "," << row.largest_contact_move
          << "," << row.mean_contact_move << ",";
    } else {
      csv << std::string(15, ',');
    }
    csv << CsvField(row.stop_reason) << "\n";
  }
  return csv.str();
}

std::string HistoryCsv(const std::vector<ComparisonRow>& rows,
                       const PreparedScene& scene) {
  std::ostringstream csv;
  csv << std::setprecision(12)
      << "frame,pose,configuration,contact,muscle,iteration,max_step_mm,"
         "volume_error,alpha,volume_of\n";
  for (const ComparisonRow& row : rows) {
    for (size_t i = 0; i < row.muscles.size(); ++i) {
      const auto& history = row.muscles[i].history;
      for (size_t k = 0; k < history.size(); ++k) {
        csv << row.frame << "," << CsvField(row.pose) << ","
            << row.configuration << "," << row.contact << ","
            << CsvField(scene.muscles[i].model.name) << "," << k + 1 << ","
            << history[k].max_step << "," << history[k].volume_error << ","
            << history[k].alpha << ","
            << (history[k].is_fine_volume ? "fine" : "coarse") << "\n";
      }
    }
  }
  return csv.str();
}

OrderedJson ComparisonJson(const std::vector<ComparisonRow>& rows,
                           const PreparedScene& scene) {
  OrderedJson json_rows = OrderedJson::array();
  for (const ComparisonRow& row : rows) {
    json_rows.push_back(ToJson(row, scene));
  }
  return {{"scene", scene.scene.name},
          {"machine", MachineJson()},
          {"version", kVersion},
          {"rows", json_rows}};
}

}  // namespace musclewarp
