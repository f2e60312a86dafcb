// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
//
// What one pose of one muscle costs, preparation apart: the reference solver,
// Ceres, and CGAL's as-rigid-as-possible deformation of the same fine mesh with
// the ends of the lines as handles. The last pose of the LHDL hip if
// MUSCLEWARP_DATA_ROOT names the data, else of the embedded scene.

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <map>

#include "arap.h"
#include "musclewarp/geometry/fine_map.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/scene/line_targets.h"
#include "musclewarp/solver/gauss_newton.h"
#include "problems/single_muscle/single_muscle_solver.h"

namespace musclewarp {
namespace {

// Handles are the vertices this near to an end of a line, mm: about the size of
// an attachment area.
constexpr double kHandleRadius = 12;

std::vector<Arap::Handle> Handles(const MuscleModel& model,
                                  const ScenePose& pose) {
  std::map<int, Arap::Handle> handles;
  for (const ActionLine& line : model.lines) {
    for (const Eigen::Index end : {Eigen::Index{0}, line.rest.rows() - 1}) {
      const Eigen::Matrix4d transform = BodyTransform(pose, line.bodies[end]);
      for (Eigen::Index v = 0; v < model.fine_rest.rows(); ++v) {
        const double distance =
            (model.fine_rest.row(v) - line.rest.row(end)).norm();
        if (distance > kHandleRadius) continue;
        const Points target = Transformed(model.fine_rest.row(v), transform);
        handles[v] = {static_cast<int>(v), target.row(0)};
      }
    }
  }
  std::vector<Arap::Handle> list;
  for (const auto& entry : handles) list.push_back(entry.second);
  return list;
}

void SetLabel(const MuscleModel& model, double ratio, benchmark::State* state) {
  state->counters["fine"] = model.fine_rest.rows();
  state->counters["coarse"] = model.coarse_rest.rows();
  state->counters["volume_ratio"] = ratio;
}

void Reference(benchmark::State& state,
               const MuscleModel& model,
               const ScenePose& pose) {
  SolverSummary summary;
  for (auto _ : state) {
    Points coarse = model.coarse_rest;
    SolveGaussNewton(model, TargetOf(model, pose, {}), {}, &coarse, &summary);
    // The result is the fine mesh.
    benchmark::DoNotOptimize(Product(model.fine_from_coarse, coarse));
  }
  SetLabel(model, summary.volume_ratio, &state);
  state.counters["iterations"] = summary.iterations;
}

void Ceres(benchmark::State& state,
           const MuscleModel& model,
           const ScenePose& pose) {
  SolverSummary summary;
  for (auto _ : state) {
    Points coarse = model.coarse_rest;
    SolveSingleMuscle(model, TargetOf(model, pose, {}), {}, &coarse, &summary);
    benchmark::DoNotOptimize(Product(model.fine_from_coarse, coarse));
  }
  SetLabel(model, summary.volume_ratio, &state);
  state.counters["iterations"] = summary.iterations;
}

void ArapIterations(benchmark::State& state,
                    const MuscleModel& model,
                    const ScenePose& pose) {
  const TriangleSoup fine = {model.fine_rest, model.fine_triangles};
  Arap arap(fine, Handles(model, pose));
  Points points;
  for (auto _ : state) points = arap.Deform(10);
  SetLabel(model,
           SignedVolume(points, model.fine_triangles) / model.rest_volume,
           &state);
  state.counters["iterations"] = 10;
}

void ArapPreparation(benchmark::State& state,
                     const MuscleModel& model,
                     const ScenePose& pose) {
  const TriangleSoup fine = {model.fine_rest, model.fine_triangles};
  const std::vector<Arap::Handle> handles = Handles(model, pose);
  for (auto _ : state) Arap arap(fine, handles);
}

void Coordinates(benchmark::State& state, const MuscleModel& model) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(MeanValueCoordinates(
        model.fine_rest, model.coarse_rest, model.coarse_triangles));
  }
}

void Register(const PreparedScene& scene) {
  const ScenePose& pose = scene.scene.poses.back();
  for (const PreparedMuscle& muscle : scene.muscles) {
    const MuscleModel& model = muscle.model;
    const auto add = [&](const std::string& what, auto run) {
      benchmark::RegisterBenchmark((model.name + "/" + what).c_str(), run)
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime();
    };
    add("reference", [&](auto& state) { Reference(state, model, pose); });
    add("ceres", [&](auto& state) { Ceres(state, model, pose); });
    add("arap_10", [&](auto& state) { ArapIterations(state, model, pose); });
    add("prepare_arap",
        [&](auto& state) { ArapPreparation(state, model, pose); });
    add("prepare_coordinates", [&](auto& state) { Coordinates(state, model); });
  }
}

}  // namespace
}  // namespace musclewarp

int main(int argc, char** argv) {
  const char* root = std::getenv("MUSCLEWARP_DATA_ROOT");
  const std::string data = MUSCLEWARP_DATA_DIR;
  const musclewarp::PreparedScene scene = musclewarp::PrepareScene(
      root ? musclewarp::ReadScene(data + "/scenes/lhdl_hip.json", root)
           : musclewarp::ReadScene(data + "/phantom/scene.json", ""),
      {});
  benchmark::Initialize(&argc, argv);
  musclewarp::Register(scene);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
