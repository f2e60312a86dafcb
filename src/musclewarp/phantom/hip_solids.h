// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "musclewarp/phantom/field.h"

namespace musclewarp::phantom {

// The solids of the scene "hip": a right hip that is nobody's, drawn by hand
// from textbook proportions. The axes are x lateral (to the right), y anterior,
// z up; the origin is the centre of the femoral head; lengths are in mm.

// The radii of the head of the femur and of the socket around it; the gap
// between them is where the cartilage would be.
constexpr double kHeadRadius = 24;
constexpr double kSocketRadius = 27;

// Returns the x of the lateral (gluteal) face of the iliac wing at (y, z).
double WingLateralX(double y, double z);

// Half a pelvis: iliac wing with its crest, socket, ischium and pubis.
Field PelvisField();

// The upper half of a femur: head, neck, trochanters and a cut shaft.
Field FemurField();

// How deep the muscles reach into bones and into each other at rest, mm, as
// muscles segmented one by one do. Muscles are cut along their neighbours at
// these depths; bumps, facets, and fields that grow by less than one per
// millimetre add up to a millimetre.
constexpr double kAttachmentDepth = 2.5;
constexpr double kSheetOverlap = 1.5;

// The deep fan: from the lower wing to the front of the greater trochanter.
// `bones` is the union of all bones.
Field GluteusMinimusField(const Field& bones);

// The large fan over it: from below the crest to the side of the trochanter.
Field GluteusMediusField(const Field& bones, const Field& gluteus_minimus);

// A long round strap that bends over the pelvic rim in front of the joint down
// to the lesser trochanter.
Field PsoasField(const Field& bones);

}  // namespace musclewarp::phantom
