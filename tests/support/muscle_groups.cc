// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "support/muscle_groups.h"

#include <optional>
#include <string>
#include <utility>

#include "musclewarp/mesh/measures.h"
#include "support/meshes.h"
#include "support/muscles.h"

namespace musclewarp {
namespace {

TriangleSoup MovedAlongX(TriangleSoup soup, double x) {
  soup.points.col(0).array() += x;
  return soup;
}

MuscleModel SpindleAt(double x) {
  SceneMuscle muscle = SpindleMuscle();
  muscle.name += std::to_string(x);
  for (ActionLine& line : muscle.lines) line.rest.col(0).array() += x;
  return PrepareMuscle(muscle,
                       MovedAlongX(Spindle(12, 60, 3), x),
                       MovedAlongX(Spindle(13, 62, 2), x),
                       {},
                       NoAttachmentRows());
}

PaperContact ContactOf(const std::vector<std::unique_ptr<ContactShape>>& shapes,
                       const ContactShape& bone,
                       const PaperContactOptions& options) {
  std::vector<ContactBody> muscles;
  for (const auto& shape : shapes) {
    muscles.push_back(ContactBody::Deformable(*shape, options.seed));
  }
  std::vector<ContactBody> bones;
  bones.push_back(ContactBody::Obstacle(bone, Eigen::Matrix4d::Identity()));
  return PaperContact(options, std::move(muscles), std::move(bones));
}

}  // namespace

TouchingSpindles::TouchingSpindles(ContactLevel level, double gap) {
  options.level = level;
  models.push_back(SpindleAt(0));
  models.push_back(SpindleAt(24 + gap));
  bone = MovedAlongX(Icosphere(8, 2), 2 * 24 + gap - 12 + 8 + gap / 2);
  for (const MuscleModel& model : models) {
    coarse_shapes.push_back(std::make_unique<ContactShape>(
        model.name,
        TriangleSoup{model.coarse_rest, model.coarse_triangles},
        options.paper.seed));
    fine_shapes.push_back(std::make_unique<ContactShape>(
        model.name,
        TriangleSoup{model.fine_rest, model.fine_triangles},
        options.paper.seed));
  }
  bone_shape = std::make_unique<ContactShape>("bone", bone, options.paper.seed);
}

GroupContact TouchingSpindles::Contact() const {
  PaperContact fine = ContactOf(fine_shapes, *bone_shape, options.paper);
  if (options.level == ContactLevel::kFine) {
    return GroupContact(options, Models(), std::move(fine), std::nullopt);
  }
  return GroupContact(options,
                      Models(),
                      ContactOf(coarse_shapes, *bone_shape, options.paper),
                      std::move(fine));
}

std::vector<const MuscleModel*> TouchingSpindles::Models() const {
  std::vector<const MuscleModel*> all;
  for (const MuscleModel& model : models) all.push_back(&model);
  return all;
}

std::vector<MuscleTarget> TouchingSpindles::Targets() const {
  std::vector<MuscleTarget> targets;
  for (const MuscleModel& model : models) {
    targets.push_back(TargetOf(model, ScenePose(), {}));
  }
  return targets;
}

std::vector<MuscleState> TouchingSpindles::RestStates() const {
  std::vector<MuscleState> states;
  for (const MuscleModel& model : models) {
    states.push_back({model.coarse_rest, {}});
  }
  return states;
}

int TouchingSpindles::VerticesInside(
    const std::vector<MuscleState>& states) const {
  std::vector<TriangleSoup> meshes = {bone};
  for (size_t i = 0; i < models.size(); ++i) {
    meshes.push_back(
        {FinePoints(models[i], states[i]), models[i].fine_triangles});
  }
  int inside = 0;
  for (size_t a = 0; a < meshes.size(); ++a) {
    for (size_t b = a + 1; b < meshes.size(); ++b) {
      const MeshIntersection found = IntersectMeshes(meshes[a], meshes[b]);
      inside +=
          static_cast<int>(found.a_inside_b.size() + found.b_inside_a.size());
    }
  }
  return inside;
}

double TouchingSpindles::VolumeRatio(int muscle,
                                     const MuscleState& state) const {
  return SignedVolume(FinePoints(models[muscle], state),
                      models[muscle].fine_triangles) /
         models[muscle].rest_volume;
}

}  // namespace musclewarp
