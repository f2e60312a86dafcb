// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/scaled_preparation.h"

#include <cmath>

#include "musclewarp/figures/scaled_figures.h"
#include "musclewarp/scene/scaled_scene.h"

namespace musclewarp {
namespace {

void ScaleLengths(double factor, RepairReport* repairs) {
  repairs->point_merges.longest *= factor;
  repairs->stitches.longest *= factor;
  repairs->fillings.area *= factor * factor;
  repairs->fillings.longest *= factor;
  for (DroppedPiece& piece : repairs->dropped_pieces) {
    piece.area *= factor * factor;
    piece.volume *= std::pow(factor, 3);
    piece.cavity *= std::pow(factor, 3);
    piece.place *= factor;
  }
  repairs->pulls.longest *= factor;
}

void ScaleLengths(double factor, MeshPreparation* mesh) {
  mesh->defects.border_length *= factor;
  ScaleLengths(factor, &mesh->repairs);
  mesh->self_crossings.place *= factor;
  mesh->self_crossings.farthest *= factor;
  mesh->slivers.largest_deviation *= factor;
  ScaleFigures(factor, &mesh->reconstruction);
  mesh->delivered_volume *= std::pow(factor, 3);
}

void ScaleLengths(double factor, Guides* guides) {
  for (ActionLine& line : guides->lines) ScaleLengths(factor, &line);
  for (GuidePath& path : guides->paths) path.rest_length *= factor;
}

void ScaleLengths(double factor, MuscleModel* model) {
  for (ActionLine& line : model->lines) ScaleLengths(factor, &line);
  ScaleLengths(factor, &model->guides);
  for (Attachment& area : model->attachments) ScaleLengths(factor, &area);
  model->fine_rest *= factor;
  model->coarse_rest *= factor;
  model->rest_volume *= std::pow(factor, 3);
  model->coarse_rest_volume *= std::pow(factor, 3);
  model->rest_area *= factor * factor;
}

void ScaleLengths(double factor, PreparedMuscle* muscle) {
  ScaleLengths(factor, &muscle->mesh);
  ScaleLengths(factor, &muscle->model);
  for (auto& [body, area] : muscle->area_on_bones) area *= factor * factor;
  for (LineEnd& end : muscle->line_ends) end.distance *= factor;
  for (BareTendon& tendon : muscle->bare_tendons) tendon.length *= factor;
}

void ScaleLengths(double factor, PreparedBone* bone) {
  ScaleLengths(factor, &bone->mesh);
  bone->rest.points *= factor;
  bone->delivered_only.points *= factor;
}

}  // namespace

void ScaleLengths(double factor, PreparedScene* scene) {
  ScaleLengths(factor, &scene->scene);
  for (PreparedMuscle& muscle : scene->muscles) ScaleLengths(factor, &muscle);
  for (PreparedBone& bone : scene->bones) ScaleLengths(factor, &bone);
  for (BoneCrossing& crossing : scene->bone_crossings) crossing.place *= factor;
  if (scene->as_delivered) ScaleFigures(factor, &*scene->as_delivered);
}

}  // namespace musclewarp
