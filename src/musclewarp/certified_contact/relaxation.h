// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/certified_contact/contact_step.h"
#include "musclewarp/certified_contact/plane_set.h"
#include "musclewarp/certified_contact/step_options.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The iterate of Relax(): the vertices of all muscles, before and after
// projection into their half-spaces.
struct RelaxedPoints {
  std::vector<Points> points;       // #V x 3, mm, in their half-spaces
  std::vector<Points> unprojected;  // before the projection
};

// Returns the predicted vertices, the start of the relaxation.
RelaxedPoints StartOf(const ContactStep& step);

// The stiffness of each vertex, #V: a factor on the weights of its edges.
using Stiffness = std::vector<Eigen::VectorXd>;

// Returns a stiffness of one for every vertex.
Stiffness UniformStiffness(const ContactScene& scene);

// Moves the vertices towards the positions p = target + offset that minimise
//
//     1/2 sum_edges w |o_i - o_j|^2 (1 + h/2 |o_i - o_j|^2 / e^2)
//   + 1/2 sum_edges r w max(0, |p_i - p_j| - s)^2
//   + 1/2 sum_vertices area / l^2 |o_i|^2
//
// subject to the half-spaces of the vertices, by `sweeps` projected
// Gauss-Seidel sweeps: an obstacle problem, whose offsets are as small and
// smooth as contact permits, and zero without contact. l is the smoothing
// length, w the weight of an edge times the larger stiffness of its ends, e its
// length at rest, h the strain hardening. In the second sum edges pull as taut
// ropes do: r is the rope factor, s the stretch limit times e or, if longer,
// the length of the edge between the targets. All three sums are convex.
// A pressure makes up for volume that contact takes
// (RelaxationOptions::pressure_gain), also where the muscle is in contact, so
// that it pushes those muscles back that press it. Without a lack of volume
// there is none.
//
// Attached vertices move to their attached positions instead, as far as the
// half-spaces permit.
//
// `targets`: #V x 3 each, mm. The levels of planes between muscles are updated
// before every sweep. The order of the muscles affects rounding only.
RelaxedPoints Relax(const StepOptions& options,
                    const ContactStep& step,
                    const std::vector<Points>& targets,
                    const Stiffness& stiffness,
                    int sweeps,
                    PlaneSet* planes,
                    RelaxedPoints start);

}  // namespace musclewarp
