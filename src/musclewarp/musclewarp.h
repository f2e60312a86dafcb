// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Everything that a program needs to deform muscles with musclewarp:
//
//   #include <musclewarp/musclewarp.h>
//   namespace mw = musclewarp;
//
//   mw::Scene scene;  // or mw::ReadScene("hip.json", data_root)
//   scene.muscles.push_back({"psoas", psoas_points, psoas_triangles, lines});
//   scene.bones.push_back({"femur_r", femur_points, femur_triangles});
//   mw::Deformer deformer(scene, mw::DeformerOptions());
//   for (const mw::ScenePose& pose : poses) {
//     const mw::Frame frame = deformer.MoveTo(pose);
//     if (!frame.IsUsable()) LOG(WARNING) << frame.FullReport();
//     Show(frame.muscles[0].points);
//   }
//
// and to give a skeleton joints that move it (docs/joints.md):
//
//   const mw::Articulation leg = mw::Articulate(
//       {mw::BoneOfName("femur_r", femur), mw::BoneOfName("hip_right", hip)},
//       {});
//   mw::WriteArticulatedModel(leg, "leg", "leg/model.osim");
//
// and to read the labels of an image, with what users choose
// (docs/settings.md):
//
//   mw::SubjectInput input;
//   input.use = mw::SubjectUse::kJoints;
//   input.files = {"segmentation.nii.gz"};
//   input.labels = mw::OptionsOf(mw::LabelSettings());
//   const mw::Subject subject = mw::ReadSubject(input);
//   const mw::Articulation leg = mw::Articulate(mw::BonesOf(subject), {});
//
// Lengths are in millimetres, angles in radians. Bad input throws InputError.

#include "musclewarp/anatomy/bone_names.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/deformer/deformer.h"
#include "musclewarp/frames/frame.h"
#include "musclewarp/joints/articulated_model.h"
#include "musclewarp/joints/articulated_scene.h"
#include "musclewarp/joints/articulation.h"
#include "musclewarp/joints/joints_file.h"
#include "musclewarp/run/frame_files.h"
#include "musclewarp/scene/scene.h"
#include "musclewarp/settings/articulation_settings.h"
#include "musclewarp/settings/deformer_settings.h"
#include "musclewarp/settings/file_settings.h"
#include "musclewarp/settings/label_settings.h"
#include "musclewarp/settings/scene_settings.h"
#include "musclewarp/settings/separation_settings.h"
#include "musclewarp/subject/line_muscles.h"
#include "musclewarp/subject/subject.h"
