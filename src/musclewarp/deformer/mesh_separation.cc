// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/deformer/mesh_separation.h"

#include <utility>
#include <vector>

#include "musclewarp/deformer/body_size.h"
#include "musclewarp/deformer/length_options.h"
#include "musclewarp/deformer/solver_configuration.h"
#include "musclewarp/figures/scaled_figures.h"
#include "musclewarp/frame_solvers/certified_frame.h"
#include "musclewarp/frames/frame_measures.h"
#include "musclewarp/frames/scaled_frame.h"
#include "musclewarp/preparation/scaled_preparation.h"
#include "musclewarp/scene/scene_checks.h"

namespace musclewarp {

RestSeparationOptions MeshSeparationOptions() {
  RestSeparationOptions options;
  // docs/results.md compares separation with and without the coarse solve.
  options.contact.coarse_weight = 0;
  // No motion follows in which the meshes would settle.
  options.contact.max_rest_steps += options.contact.max_settling_steps;
  // A mesh moves farther than it is deep if a part has to leave a pocket.
  options.requirements.displacement_allowance = 5;
  options.requirements.least_displacement = 0;
  options.reconstruction.reconstructs_displaced = false;
  options.prepare.makes_lines = false;
  options.prepare.attachments = AttachmentKind::kNone;
  options.prepare.remove_self_crossings = true;
  options.prepare.remove_slivers = true;
  return options;
}

namespace {

// Returns the result in units of the body's size, of a scene in these units.
MeshSeparation SeparateSized(const Scene& scene,
                             const RestSeparationOptions& options,
                             const ProgressCallback& on_progress) {
  MeshSeparation result;
  result.scene = PrepareScene(scene, options.prepare, on_progress);
  result.rest = SeparateRest(options,
                             SolversOf(SolverConfiguration()).single,
                             on_progress,
                             &result.scene);
  SceneMeshes meshes(result.scene);
  result.before = result.scene.as_delivered
                      ? *result.scene.as_delivered
                      : IntersectAsPrepared(result.scene, &meshes);
  const CertifiedScene certified =
      RestoreCertifiedScene(result.scene, options.contact, result.rest.state);
  result.frame = CertifiedFrame(
      result.scene,
      certified,
      options.requirements,
      result.rest.state,
      /*before=*/{},
      std::vector<SolverSummary>(scene.muscles.size(), NothingToSolve()),
      &meshes);
  result.frame.index = 0;
  return result;
}

}  // namespace

MeshSeparation SeparateMeshes(const Scene& scene,
                              const RestSeparationOptions& options,
                              const ProgressCallback& on_progress,
                              const std::set<std::string>& lengths_in_mm) {
  CheckScene(scene);
  const Scene sized = InBodyUnits(scene);
  RestSeparationOptions sized_options = options;
  AskInMillimetres(lengths_in_mm,
                   sized.body_size,
                   &sized_options.prepare,
                   &sized_options.contact,
                   &sized_options.requirements);
  MeshSeparation result = SeparateSized(sized, sized_options, on_progress);
  result.gap = sized_options.contact.step.gap * sized.body_size;
  if (sized.body_size == 1) return result;
  ScaleLengths(sized.body_size, &result.scene);
  ScaleFigures(sized.body_size, &result.rest.intersections);
  ScaleFigures(sized.body_size, &result.before);
  ScaleLengths(sized.body_size, &result.frame);
  return result;
}

}  // namespace musclewarp
