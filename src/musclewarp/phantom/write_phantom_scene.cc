// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/phantom/phantom_scene.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson JsonOf(
    const Eigen::Ref<
        const Eigen::
            Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>&
        rows) {
  OrderedJson json = OrderedJson::array();
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    OrderedJson row = OrderedJson::array();
    for (Eigen::Index j = 0; j < rows.cols(); ++j) row.push_back(rows(i, j));
    json.push_back(row);
  }
  return json;
}

OrderedJson JsonOf(const SceneMuscle& muscle) {
  OrderedJson json;
  json["name"] = muscle.name;
  json["mesh"] = muscle.mesh_path;
  for (const ActionLine& line : muscle.lines) {
    OrderedJson of_line = {{"name", line.name},
                           {"rest", JsonOf(line.rest)},
                           {"bodies", line.bodies}};
    if (line.slides) of_line["slides"] = true;
    json["lines"].push_back(of_line);
  }
  for (const Attachment& attachment : muscle.attachments) {
    json["attachments"].push_back({{"body", attachment.body},
                                   {"points", JsonOf(attachment.points)},
                                   {"radius", attachment.radius}});
  }
  return json;
}

OrderedJson JsonOf(const ScenePose& pose) {
  OrderedJson json;
  json["name"] = pose.name;
  json["time"] = pose.time;
  for (const auto& [body, matrix] : pose.bodies) {
    json["bodies"][body] = JsonOf(matrix);
  }
  for (const auto& [line, points] : pose.lines) {
    json["lines"][line] = JsonOf(points);
  }
  return json;
}

OrderedJson JsonOf(const Scene& scene) {
  OrderedJson json;
  json["name"] = scene.name;
  json["units"] = "mm";
  json["axes"] = scene.axes;
  json["side"] = scene.side;
  for (const SceneMuscle& muscle : scene.muscles) {
    json["muscles"].push_back(JsonOf(muscle));
  }
  for (const SceneBone& bone : scene.bones) {
    json["bones"].push_back(
        {{"name", bone.name}, {"mesh", bone.mesh_path}, {"body", bone.body}});
  }
  for (const ScenePose& pose : scene.poses) {
    json["poses"].push_back(JsonOf(pose));
  }
  return json;
}

// Returns the scene with its poses and lines taken from an OpenSim model and
// motion.
OrderedJson MotionJsonOf(const Scene& scene) {
  OrderedJson json = JsonOf(scene);
  json.erase("poses");
  json["name"] = scene.name + "_motion";
  for (OrderedJson& muscle : json["muscles"]) {
    for (OrderedJson& line : muscle["lines"]) line = OrderedJson(line["name"]);
  }
  json["model"] = scene.name + ".osim";
  json["motion"] = scene.name + ".mot";
  return json;
}

// Writes JSON like dump(), but keeps a list of plain values on one line, so
// that each point has a line.
void Print(const OrderedJson& json,
           const std::string& indent,
           std::string* text) {
  bool is_plain = true;
  for (const OrderedJson& child : json) is_plain &= child.is_primitive();
  if (json.is_primitive() || (json.is_array() && is_plain)) {
    *text += json.dump();
    return;
  }
  const std::string inner = indent + "  ";
  std::string separator = "\n";
  *text += json.is_array() ? "[" : "{";
  for (const auto& item : json.items()) {
    *text += separator + inner;
    if (json.is_object()) *text += OrderedJson(item.key()).dump() + ": ";
    Print(item.value(), inner, text);
    separator = ",\n";
  }
  *text += "\n" + indent + (json.is_array() ? "]" : "}");
}

}  // namespace

void WritePhantomScene(const PhantomScene& scene, const std::string& dir) {
  std::error_code error;
  std::filesystem::create_directories(dir, error);
  if (error) {
    throw InputError(dir,
                     "cannot be made a folder (" + error.message() + ")",
                     "choose a folder that can be written");
  }
  for (const PhantomMesh& mesh : scene.meshes) {
    WriteTriangleSoup(dir + "/" + mesh.name + ".ply", mesh.delivered);
  }
  std::string text;
  Print(JsonOf(scene.scene), "", &text);
  WriteTextAtomically(dir + "/scene.json", text + "\n");
  if (scene.model_text.empty()) return;
  const std::string stem = dir + "/" + scene.scene.name;
  WriteTextAtomically(stem + ".osim", scene.model_text);
  WriteTextAtomically(stem + ".mot", scene.motion_text);
  text.clear();
  Print(MotionJsonOf(scene.scene), "", &text);
  WriteTextAtomically(dir + "/motion.json", text + "\n");
}

}  // namespace musclewarp
