// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
//
// What a hundred fibres of a muscle cost: to find, to express in the hull, and
// to move with a frame.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "musclewarp/fibres/fibres.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/solver/embedded_lines.h"

namespace musclewarp {
namespace {

void Register(const PreparedScene& scene,
              const std::vector<BodySurface>& bodies) {
  for (const PreparedMuscle& muscle : scene.muscles) {
    const MuscleModel& model = muscle.model;
    const TriangleSoup fine = {model.fine_rest, model.fine_triangles};
    const auto add = [&](const std::string& what, auto run) {
      benchmark::RegisterBenchmark((model.name + "/" + what).c_str(), run)
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime();
    };
    const auto fibres = MakeFibres(fine, bodies, {}, FibreOptions());
    const EmbeddedLines carried =
        EmbedLines(fibres, model.coarse_rest, model.coarse_triangles);
    add("find", [fine, &bodies](auto& state) {
      for (auto _ : state) {
        benchmark::DoNotOptimize(MakeFibres(fine, bodies, {}, FibreOptions()));
      }
    });
    add("coordinates", [fibres, &model](auto& state) {
      for (auto _ : state) {
        benchmark::DoNotOptimize(
            EmbedLines(fibres, model.coarse_rest, model.coarse_triangles));
      }
    });
    add("move", [carried, &model](auto& state) {
      for (auto _ : state) {
        benchmark::DoNotOptimize(LinesAt(carried, model.coarse_rest));
      }
    });
  }
}

}  // namespace
}  // namespace musclewarp

int main(int argc, char** argv) {
  using musclewarp::BodySurface;
  using musclewarp::TriangleBvh;
  const char* root = std::getenv("MUSCLEWARP_DATA_ROOT");
  const std::string data = MUSCLEWARP_DATA_DIR;
  const musclewarp::PreparedScene scene = musclewarp::PrepareScene(
      root ? musclewarp::ReadScene(data + "/scenes/lhdl_hip.json", root)
           : musclewarp::ReadScene(data + "/phantom/scene.json", ""),
      {});
  std::vector<std::unique_ptr<TriangleBvh>> trees;
  std::vector<BodySurface> bodies;
  for (const auto& bone : scene.bones) {
    trees.push_back(
        std::make_unique<TriangleBvh>(bone.rest.points, bone.rest.triangles));
    bodies.push_back({bone.mesh.name, {trees.back().get()}});
  }
  benchmark::Initialize(&argc, argv);
  musclewarp::Register(scene, bodies);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
