// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/scaled_scene.h"

#include <cmath>
#include <memory>

namespace musclewarp {
namespace {

void ScaleMesh(double factor, SceneMuscle* muscle) {
  muscle->points *= factor;
  muscle->mm_per_unit *= factor;
}

void ScaleMesh(double factor, SceneBone* bone) {
  if (bone->mesh_path.empty() && bone->rest_from_file.isIdentity(0)) {
    bone->points *= factor;
  } else {
    bone->rest_from_file.topRows<3>() *= factor;
  }
}

}  // namespace

void ScaleTranslation(double factor, Eigen::Matrix4d* motion) {
  motion->topRightCorner<3, 1>() *= factor;
}

void ScaleLengths(double factor, ActionLine* line) {
  line->rest *= factor;
  line->bare_begin *= factor;
  line->bare_end *= factor;
  if (line->supports) ScaleLengths(factor, &*line->supports);
}

void ScaleLengths(double factor, Attachment* attachment) {
  attachment->points *= factor;
  attachment->radius *= factor;
}

void ScaleLengths(double factor, ScenePose* pose) {
  pose->taut_lines = {};
  pose->pushes.clear();
  for (auto& [body, motion] : pose->bodies) ScaleTranslation(factor, &motion);
  for (auto& [line, points] : pose->lines) points *= factor;
  for (auto& [line, length] : pose->path_lengths) length *= factor;
}

void ScaleLengths(double factor, Scene* scene) {
  for (SceneMuscle& muscle : scene->muscles) {
    ScaleMesh(factor, &muscle);
    for (ActionLine& line : muscle.lines) ScaleLengths(factor, &line);
    for (Attachment& area : muscle.attachments) ScaleLengths(factor, &area);
    muscle.delivered_volume *= std::pow(factor, 3);
  }
  for (SceneBone& bone : scene->bones) ScaleMesh(factor, &bone);
  for (ScenePose& pose : scene->poses) ScaleLengths(factor, &pose);
  if (!scene->model) return;
  auto model = std::make_shared<ModelPoses>(*scene->model);
  model->body_size /= factor;
  scene->model = std::move(model);
}

}  // namespace musclewarp
