// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "python/src/pickling.h"

#include <cstdint>
#include <utility>

#include "musclewarp/base/archived_bytes.h"
#include "musclewarp/deformer/scene_archive.h"
#include "musclewarp/figures/figures_json.h"

namespace musclewarp {

// Reports have only a part of it.
MUSCLEWARP_ARCHIVE_WITHOUT(SolverSummary,
                           (history),
                           stop_reason,
                           message,
                           iterations,
                           initial_energy,
                           final_energy,
                           volume_ratio,
                           max_step,
                           wall_ms)

// Copies all figures but those of muscles.
void CopyFiguresOfPose(const FrameFigures& figures, Frame* frame) {
  frame->index = figures.index;
  frame->reached_from = figures.reached_from;
  frame->name = figures.name;
  frame->time = figures.time;
  frame->coordinates = figures.coordinates;
  frame->wall_ms = figures.wall_ms;
  frame->solve_ms = figures.solve_ms;
  frame->certify_ms = figures.certify_ms;
  frame->moment_arms_ms = figures.moment_arms_ms;
  frame->stages = figures.stages;
  frame->pose_steps = figures.pose_steps;
  frame->shortcomings = figures.shortcomings;
  frame->bone_overlaps = figures.bone_overlaps;
  frame->delivered_crossings = figures.delivered_crossings;
  frame->path_moment_arms = figures.path_moment_arms;
  frame->moment_arms_converged = figures.moment_arms_converged;
  frame->intersections = figures.intersections;
}

// The figures as report.json has them, and the shapes.
template <class Archive>
void save(Archive& archive, const Frame& frame) {
  archive(nlohmann::ordered_json::to_cbor(JsonOf(FiguresOf(frame))));
  for (const MuscleFrame& muscle : frame.muscles) {
    archive(muscle.solver,
            muscle.points,
            muscle.gaps,
            muscle.lines,
            muscle.fibres,
            muscle.bare_tendons);
  }
  archive(frame.bones, frame.bones_from_rest);
}

template <class Archive>
void load(Archive& archive, Frame& frame) {
  std::vector<std::uint8_t> cbor;
  archive(cbor);
  FrameFigures figures;
  ReadJson(nlohmann::json::from_cbor(cbor), {}, &figures);
  CopyFiguresOfPose(figures, &frame);
  for (MuscleFigures& muscle : figures.muscles) {
    static_cast<MuscleFigures&>(frame.muscles.emplace_back()) =
        std::move(muscle);
  }
  for (MuscleFrame& muscle : frame.muscles) {
    archive(muscle.solver,
            muscle.points,
            muscle.gaps,
            muscle.lines,
            muscle.fibres,
            muscle.bare_tendons);
  }
  archive(frame.bones, frame.bones_from_rest);
}

namespace python {

MUSCLEWARP_ARCHIVE(ScenePart, name, triangles, lines)
MUSCLEWARP_ARCHIVE(SceneParts, muscles, bones, key)
MUSCLEWARP_ARCHIVE(FrameOfScene, frame, parts)

// The parts are those of the run, so that its frames share them.
template <class Archive>
void save(Archive& archive, const RunOfDeformer& run) {
  const RunBasis& basis = *run.basis;
  archive(basis.solver,
          basis.keywords,
          basis.parts,
          basis.scene->scene,
          *basis.scene,
          basis.scene->wall_ms,
          basis.contact,
          basis.rest,
          run.frames.size());
  for (const SharedFrame& frame : run.frames) archive(frame->frame);
}

template <class Archive>
void load(Archive& archive, RunOfDeformer& run) {
  const auto basis = std::make_shared<RunBasis>();
  const auto scene = std::make_shared<PreparedScene>();
  size_t count = 0;
  archive(basis->solver,
          basis->keywords,
          basis->parts,
          scene->scene,
          *scene,
          scene->wall_ms,
          basis->contact,
          basis->rest,
          count);
  basis->scene = scene;
  for (size_t i = 0; i < count; ++i) {
    const auto frame = std::make_shared<FrameOfScene>();
    archive(frame->frame);
    frame->parts = basis->parts;
    run.frames.push_back(frame);
  }
  run.basis = basis;
}

}  // namespace python
}  // namespace musclewarp

namespace musclewarp::python {

std::string KeyOf(const PreparedScene& scene,
                  const std::map<std::string, std::string>& keywords) {
  ContentHash key;
  for (const auto& [name, value] : keywords) {
    if (name != "cache") key.Add(name + "=" + value);
  }
  for (const PreparedMuscle& muscle : scene.muscles) {
    const MuscleModel& model = muscle.model;
    key.Add(ArchivedBytes(model.name,
                          model.lines,
                          model.attachments,
                          model.fine_rest,
                          model.fine_triangles));
  }
  for (const PreparedBone& bone : scene.bones) {
    key.Add(ArchivedBytes(bone.mesh.name, bone.body, bone.rest));
  }
  return key.Hex();
}

template <typename T>
pybind11::bytes StateForPickle(const T& object) {
  return pybind11::bytes(ArchivedBytes(object));
}

template <typename T>
std::shared_ptr<T> FromStateForPickle(const pybind11::bytes& state) {
  const auto object = std::make_shared<T>();
  RestoreArchived(std::string(state), "the pickle", object.get());
  return object;
}

#define MUSCLEWARP_PICKLE(T)                         \
  template pybind11::bytes StateForPickle(const T&); \
  template std::shared_ptr<T> FromStateForPickle<T>(const pybind11::bytes&);

MUSCLEWARP_PICKLE(TriangleSoup)
MUSCLEWARP_PICKLE(ActionLine)
MUSCLEWARP_PICKLE(Attachment)
MUSCLEWARP_PICKLE(SceneMuscle)
MUSCLEWARP_PICKLE(SceneBone)
MUSCLEWARP_PICKLE(ScenePose)
MUSCLEWARP_PICKLE(Scene)
MUSCLEWARP_PICKLE(FrameOfScene)
MUSCLEWARP_PICKLE(RunOfDeformer)

}  // namespace musclewarp::python
