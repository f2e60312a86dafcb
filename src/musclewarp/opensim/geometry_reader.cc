// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/geometry_reader.h"

#include <algorithm>
#include <utility>

namespace musclewarp {
namespace {

// Models that were made on Windows have backslashes in file names.
std::string ForwardSlashes(std::string path) {
  std::replace(path.begin(), path.end(), '\\', '/');
  return path;
}

// Reads the six numbers of a <transform>, three rotations and a translation.
Eigen::Matrix4d TransformOf(const OsimXml& xml, pugi::xml_node node) {
  const auto t = xml.Numbers(node, "transform", 6, {0, 0, 0, 0, 0, 0});
  return OffsetTransform({t[3], t[4], t[5]}, {t[0], t[1], t[2]});
}

Eigen::Vector3d ScaleOf(const OsimXml& xml, pugi::xml_node node) {
  return xml.Vector(node, "scale_factors", Eigen::Vector3d::Ones());
}

// Adds the meshes of a frame of OpenSim 4, <attached_geometry><Mesh>.
void AddMeshes(const OsimXml& xml,
               pugi::xml_node frame,
               const Eigen::Matrix4d& body_from_frame,
               std::vector<ModelGeometry>* geometry) {
  for (const auto mesh : frame.child("attached_geometry").children("Mesh")) {
    geometry->push_back({ForwardSlashes(xml.Text(xml.Child(mesh, "mesh_file"))),
                         ScaleOf(xml, mesh),
                         body_from_frame});
  }
}

}  // namespace

std::vector<ModelGeometry> ReadBodyGeometry(const OsimXml& xml,
                                            pugi::xml_node body) {
  std::vector<ModelGeometry> geometry;
  const pugi::xml_node visible = body.child("VisibleObject");
  for (const auto node : ObjectsOf(visible, "GeometrySet")) {
    const std::string file = xml.Text(node.child("geometry_file"));
    if (file.empty()) continue;
    geometry.push_back({ForwardSlashes(file),
                        ScaleOf(xml, visible).cwiseProduct(ScaleOf(xml, node)),
                        TransformOf(xml, visible) * TransformOf(xml, node)});
  }
  AddMeshes(xml, body, Eigen::Matrix4d::Identity(), &geometry);
  return geometry;
}

void AddOffsetGeometry(const OsimXml& xml,
                       const OffsetFrames& frames,
                       Model* model) {
  for (const pugi::xml_node node : frames.nodes()) {
    if (!node.child("attached_geometry").child("Mesh")) continue;
    const FrameOnBody frame = frames.Place(node);
    if (frame.body < 0) continue;
    AddMeshes(
        xml, node, frame.body_from_frame, &model->bodies[frame.body].geometry);
  }
}

}  // namespace musclewarp
