// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/frame_solver.h"

#include <glog/logging.h>

#include <utility>

#include "musclewarp/frame_solvers/certified_frame_solver.h"
#include "musclewarp/frame_solvers/free_frame_solver.h"
#include "musclewarp/frame_solvers/paper_frame_solver.h"
#include "musclewarp/frames/frame_measures.h"

namespace musclewarp {

std::string ToString(ContactKind kind) {
  switch (kind) {
    case ContactKind::kNone:
      return "none";
    case ContactKind::kPaper:
      return "paper";
    case ContactKind::kCertified:
      return "certified";
  }
  LOG(FATAL) << "no such kind of contact";
}

bool FrameSolverOptions::IsValid(std::string* error) const {
  return paper.IsValid(error) && paper_limits.IsValid(error) &&
         certified.IsValid(error) && requirements.IsValid(error);
}

FrameSolver::FrameSolver(const PreparedScene& scene,
                         const FrameSolverOptions& options,
                         std::shared_ptr<SceneMeshes> meshes)
    : scene_(scene), options_(options), meshes_(std::move(meshes)) {
  contact_.kind = options_.contact;
  contact_.name = ToString(options_.contact);
}

const Frame& FrameSolver::RestFrame() {
  if (!rest_frame_) {
    rest_frame_ =
        musclewarp::RestFrame(scene_, meshes_.get(), options_.measures);
  }
  return *rest_frame_;
}

std::unique_ptr<FrameSolver> MakeFrameSolver(
    const PreparedScene& scene,
    const FrameSolverOptions& options,
    std::shared_ptr<SceneMeshes> meshes,
    std::optional<RestResult> rest) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  switch (options.contact) {
    case ContactKind::kNone:
      return std::make_unique<FreeFrameSolver>(
          scene, options, std::move(meshes));
    case ContactKind::kPaper:
      return std::make_unique<PaperFrameSolver>(
          scene, options, std::move(meshes));
    case ContactKind::kCertified:
      CHECK(rest) << "certified contact starts from a separated rest pose";
      return std::make_unique<CertifiedFrameSolver>(
          scene, options, std::move(meshes), std::move(*rest));
  }
  LOG(FATAL) << "no such kind of contact";
}

}  // namespace musclewarp
