// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gflags/gflags.h>
#include <unistd.h>

#include <iostream>

#include "tools/flag_values.h"
#include "tools/program.h"
#include "tools/separate_command.h"
#include "tools/separate_input.h"
#include "tools/split.h"

DEFINE_string(out, "", "folder for the separated meshes");
DEFINE_string(bone,
              "",
              "files of meshes and names of labels that must not move; commas");
DEFINE_string(
    units,
    "mm",
    "unit of the mesh files, and of a label image that does not state "
    "its own: mm, cm, m; results are in mm");
DEFINE_string(labels,
              "",
              "table of the labels of an image: label,name,kind, or that of 3D "
              "Slicer or ITK-SNAP; labels that are not in it are left out");
DEFINE_double(edge,
              0,
              "edges of the triangles of labels, mm; 0: twice a voxel");
DEFINE_string(
    pieces,
    "largest",
    "what becomes of a mesh file of several closed surfaces, and of a label "
    "whose voxels do not all hang together by their faces: largest (the "
    "largest piece, the others are lost) or all (a mesh of each piece)");
DEFINE_double(max_loss,
              musclewarp::SeparateOptions().max_loss,
              "share of the volume of a mesh or label, as it was delivered, "
              "that may be lost; with more the exit code is 1");
DEFINE_double(
    max_lost_area,
    musclewarp::SeparateOptions().max_lost_area,
    "area of the surface of a mesh, mm2, that may be gone where it is made "
    "anew: "
    "farther than 3 mm, and twice its depth in others, from the new surface; "
    "with more the exit code is 1");
DEFINE_double(max_lost_extent,
              musclewarp::SeparateOptions().max_lost_extent,
              "length at an end of a mesh, mm, beyond twice its depth in "
              "others, that may "
              "be gone where it is made anew; with more the exit code is 1");
DEFINE_double(max_move,
              musclewarp::SeparateOptions().max_move,
              "how far a vertex may move beyond twice the depth of its mesh in "
              "others and what those that push it add, mm; with more the exit "
              "code is 1");
DEFINE_double(max_hole,
              musclewarp::SeparateOptions().max_hole,
              "holes whose border is at most this long are filled when a mesh "
              "file is repaired, mm; slits and missing faces are whatever "
              "their length");
DEFINE_double(gap,
              musclewarp::SeparateOptions().gap,
              "distance that is kept between meshes, mm; at most 0.5; the "
              "default follows the size of the body");
DEFINE_string(format, "ply", "mesh files to write: ply, obj, vtp; commas");
DEFINE_string(remake,
              "auto",
              "what happens to meshes that cannot be separated by moving their "
              "vertices: auto (they are made anew) or never (the input is "
              "refused)");
DEFINE_bool(json, false, "also write DIR/separation.json, with all figures");
DEFINE_int32(threads, 0, "threads; 0: one a core");

int main(int argc, char** argv) {
  return musclewarp::RunProgram(
      argc,
      argv,
      "musclewarp-separate --out=DIR [--bone=FILE,...] FILE... [flags]\n"
      "       musclewarp-separate --out=DIR [--labels=TABLE] [--bone=NAME,...] "
      "IMAGE [flags]\n\n"
      "Moves the vertices of surface meshes as little as it takes for no two "
      "meshes to\ncross, while each keeps its volume. The meshes of --bone do "
      "not move. Reads .ply,\n.obj, .off, .stl, .vtk, and with VTK .vtp; "
      "repairs the meshes; writes all of\nthem to DIR/<name>.ply. "
      "FILE#NAME is an object of an .obj or a solid of an ASCII\n.stl.\n\n"
      "With VTK also takes one label image (.nii, .nii.gz, .img, .nrrd, .nhdr, "
      ".mha, "
      ".mhd,\n.mgz): each label becomes a closed surface with the volume of "
      "its "
      "voxels, in "
      "mm, in LPS (+x left,\n+y back, +z head), named by TABLE, a line a "
      "label: 3,femur,bone. Without a table\nall labels are taken, as "
      "label_3.\n\n"
      "Exit code: 0 separated, 1 not (the summary says why), 2 bad input.",
      [](const std::vector<std::string>& files) {
        musclewarp::SeparateOptions options;
        options.out = FLAGS_out;
        options.bones = musclewarp::Split(FLAGS_bone, ',');
        options.mm_per_unit = musclewarp::ParseUnits(FLAGS_units);
        options.labels = FLAGS_labels;
        options.edge = FLAGS_edge;
        options.pieces = musclewarp::ParsePieces(FLAGS_pieces);
        options.max_loss = FLAGS_max_loss;
        options.max_lost_area = FLAGS_max_lost_area;
        options.max_lost_extent = FLAGS_max_lost_extent;
        options.max_move = FLAGS_max_move;
        options.max_hole = FLAGS_max_hole;
        options.gap = FLAGS_gap;
        options.lengths_in_mm = musclewarp::LengthsGiven();
        options.remake = musclewarp::ParseRemake(FLAGS_remake);
        options.formats = musclewarp::ParseFormats(FLAGS_format);
        options.json = FLAGS_json;
        options.threads = FLAGS_threads;
        options.is_terminal = isatty(STDOUT_FILENO);
        return musclewarp::SeparateCommand(files, options, std::cout);
      });
}
