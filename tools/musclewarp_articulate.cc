// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gflags/gflags.h>

#include <iostream>

#include "tools/articulate_command.h"
#include "tools/program.h"
#include "tools/split.h"

DEFINE_string(out, "", "folder for the model, the scene and the report");
DEFINE_string(muscles, "", "meshes of muscles for the scene; commas");
DEFINE_string(bone,
              "",
              "labels that are bones although neither the table nor their "
              "names say so; commas");
DEFINE_string(labels,
              "",
              "table of the labels of an image: label,name,kind,bone,side,body "
              "(docs/joints.md); labels that are not in it are left out");
DEFINE_double(edge,
              0,
              "edges of the triangles of labels, mm; 0: twice a voxel");
DEFINE_string(side,
              "both",
              "right, left or both: where joints are found; one of them is "
              "also the side of bones of which nothing else tells it");
DEFINE_string(joints,
              "",
              "hip, knee, patella, ankle, subtalar, shoulder, elbow, forearm; "
              "commas; without it all for which there are bones");
DEFINE_string(given,
              "",
              "file of joints to take as they are, in the form of joints.json");
DEFINE_string(motion,
              "",
              "coordinates that move together, in degrees: "
              "hip_flexion_r:-10:60:15 goes from -10 to 60 in 15 frames; "
              "commas; without it a motion of each coordinate is written");
DEFINE_string(zero,
              "anatomy",
              "where coordinates are 0: anatomy (frames of both bones "
              "parallel) or scan (the pose of the scan)");
DEFINE_string(axes,
              musclewarp::ArticulateOptions().axes,
              "where +x, +y and +z of the files point, such as LPS or ASR; "
              "none if that is not known");
DEFINE_string(units,
              "mm",
              "unit of the mesh files, and of a label image that does not "
              "state its own: mm, cm, m");
DEFINE_bool(html,
            false,
            "also write joints.html, the bones and joints as one page to look "
            "at");
DEFINE_int32(threads, 0, "threads; 0: one a core");

int main(int argc, char** argv) {
  return musclewarp::RunProgram(
      argc,
      argv,
      "musclewarp-articulate --out=DIR [--muscles=FILE,...] FILE... "
      "[flags]\n"
      "       musclewarp-articulate --out=DIR [--labels=TABLE] IMAGE "
      "[flags]\n\n"
      "Finds the joints of a skeleton on the shapes of its bones, of which the "
      "names of\nfiles or labels tell what they are (femur_r, hip_left, "
      "tibia). "
      "Writes to DIR an OpenSim\nmodel, motions, a report of the joints "
      "(joints.json) and a scene, so that\n\n"
      "    musclewarp-deform --scene=DIR/scene.json --out=...\n\n"
      "moves the muscles. A joint is good, weak (used, with the reason) or "
      "failed (its\nbone stays fixed).\n\n"
      "Exit code: 0 all joints good or weak, 1 one failed, 2 bad input.",
      [](const std::vector<std::string>& files) {
        musclewarp::ArticulateOptions options;
        options.out = FLAGS_out;
        options.muscles = musclewarp::Split(FLAGS_muscles, ',');
        options.bones = musclewarp::Split(FLAGS_bone, ',');
        options.labels = FLAGS_labels;
        options.edge = FLAGS_edge;
        options.side = FLAGS_side;
        options.joints = musclewarp::Split(FLAGS_joints, ',');
        options.given = FLAGS_given;
        options.motion = musclewarp::Split(FLAGS_motion, ',');
        options.zero = FLAGS_zero;
        options.axes = FLAGS_axes;
        options.units = FLAGS_units;
        options.threads = FLAGS_threads;
        options.html = FLAGS_html;
        return musclewarp::ArticulateCommand(files, options, std::cout);
      });
}
