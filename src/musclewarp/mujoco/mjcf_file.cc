// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mujoco/mjcf_file.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <pugixml.hpp>
#include <sstream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/text.h"

namespace musclewarp {
namespace {

constexpr int kDigits = 12;

template <typename Vector>
std::string NumbersText(const Vector& numbers) {
  std::string text;
  for (const double number : numbers) {
    text += (text.empty() ? "" : " ") + NumberText(number, kDigits);
  }
  return text;
}

// w, x, y, z, as MuJoCo has it.
std::string TurnText(const Eigen::Matrix4d& transform) {
  const Eigen::Quaterniond q(Eigen::Matrix3d(transform.topLeftCorner<3, 3>()));
  return NumbersText(std::array<double, 4>{q.w(), q.x(), q.y(), q.z()});
}

pugi::xml_node Add(pugi::xml_node parent, const char* element) {
  return parent.append_child(element);
}

void Set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name) = value.c_str();
}

// Returns true if these moments of inertia are positive in all directions:
// MuJoCo refuses others. Those that only miss the triangle inequality, as
// rounded ones do, it balances itself ("balanceinertia").
bool ArePositive(const std::array<double, 6>& moments) {
  Eigen::Matrix3d inertia;
  inertia << moments[0], moments[3], moments[4],  //
      moments[3], moments[1], moments[5],         //
      moments[4], moments[5], moments[2];
  return inertia.llt().info() == Eigen::Success;
}

// A body without a mass, or with moments that no body has, is a small ball.
void AddInertia(const BodyMass& body, pugi::xml_node node) {
  pugi::xml_node inertial = Add(node, "inertial");
  if (!(body.mass > kLeastMass) || !ArePositive(body.inertia)) {
    constexpr double kRadius = 0.05;  // m
    const double mass = std::max(body.mass, kLeastMass);
    Set(inertial,
        "pos",
        NumbersText(Eigen::Vector3d(kMetresPerMillimetre * body.centre)));
    Set(inertial, "mass", NumberText(mass, kDigits));
    const double moment = mass * kRadius * kRadius;
    Set(inertial,
        "diaginertia",
        NumbersText(std::array<double, 3>{moment, moment, moment}));
    return;
  }
  Set(inertial,
      "pos",
      NumbersText(Eigen::Vector3d(kMetresPerMillimetre * body.centre)));
  Set(inertial, "mass", NumberText(body.mass, kDigits));
  Set(inertial, "fullinertia", NumbersText(body.inertia));
}

class MjcfWriter {
 public:
  MjcfWriter(const MjcfModel& mjcf, const Model& model)
      : mjcf_(mjcf), model_(model) {}

  std::string Write() {
    pugi::xml_node root = document_.append_child("mujoco");
    Set(root, "model", mjcf_.name);
    AddSettings(root);
    AddAssets(root);
    world_ = Add(root, "worldbody");
    AddBodies();
    AddSkins(root);
    AddTendons(root);
    AddCouplings(root);
    AddActuators(root);
    AddKeyframe(root);
    std::ostringstream text;
    document_.save(text, "  ");
    return text.str();
  }

 private:
  static void AddSettings(pugi::xml_node root) {
    pugi::xml_node compiler = Add(root, "compiler");
    Set(compiler, "angle", "radian");
    Set(compiler, "autolimits", "true");
    Set(compiler, "balanceinertia", "true");
    Set(compiler, "assetdir", "assets");
    pugi::xml_node option = Add(root, "option");
    Set(option, "gravity", "0 -9.80665 0");
    Set(option, "integrator", "implicitfast");
    // Joints have a little inertia of their own: bodies that follow others,
    // such as the patella, have little of theirs.
    pugi::xml_node defaults = Add(root, "default");
    pugi::xml_node joint = Add(defaults, "joint");
    Set(joint, "armature", "0.001");
    Set(joint, "damping", "0.1");
    pugi::xml_node geom = Add(defaults, "geom");
    Set(geom, "type", "mesh");
    Set(geom, "contype", "0");
    Set(geom, "conaffinity", "0");
    Set(geom, "group", "1");
    Set(geom, "mass", "0");
    Set(geom, "rgba", "0.89 0.85 0.76 1");
    Set(Add(defaults, "site"), "size", "0.002");
    Set(Add(defaults, "tendon"), "width", "0.002");
  }

  void AddAssets(pugi::xml_node root) {
    pugi::xml_node asset = Add(root, "asset");
    for (const MjcfBone& bone : mjcf_.bones) {
      pugi::xml_node mesh = Add(asset, "mesh");
      Set(mesh, "name", bone.name);
      Set(mesh, "file", bone.name + ".obj");
      // The shell suffices for a mesh without mass, closed or not.
      Set(mesh, "inertia", "shell");
    }
  }

  pugi::xml_node NodeOf(int place) {
    return place < 0 ? world_ : nodes_[place];
  }

  void AddBodies() {
    std::vector<pugi::xml_node> of_model(model_.bodies.size());
    of_model[0] = world_;
    for (const MjcfBody& body : mjcf_.tree.bodies) {
      pugi::xml_node node = Add(NodeOf(body.parent), "body");
      nodes_.push_back(node);
      Set(node, "name", body.name);
      Set(node,
          "pos",
          NumbersText(
              Eigen::Vector3d(body.parent_from_body.topRightCorner<3, 1>())));
      Set(node, "quat", TurnText(body.parent_from_body));
      // What has nothing but joints weighs nothing either.
      if (body.model_body < 0) Set(node, "gravcomp", "1");
      AddInertia(MassOf(body), node);
      for (const MjcfJoint& joint : body.joints) AddJoint(joint, node);
      if (body.model_body >= 0) of_model[body.model_body] = node;
    }
    for (const MjcfBone& bone : mjcf_.bones) {
      pugi::xml_node geom = Add(of_model[bone.body], "geom");
      Set(geom, "name", bone.name);
      Set(geom, "mesh", bone.name);
    }
    for (const MjcfMuscle& muscle : mjcf_.muscles) {
      for (size_t i = 0; i < muscle.path.sites.size(); ++i) {
        pugi::xml_node site = Add(of_model[muscle.path.sites[i].body], "site");
        Set(site, "name", SiteName(muscle, i));
        Set(site,
            "pos",
            NumbersText(Eigen::Vector3d(kMetresPerMillimetre *
                                        muscle.path.sites[i].place)));
      }
    }
  }

  BodyMass MassOf(const MjcfBody& body) const {
    const auto mass = mjcf_.masses.find(body.name);
    return mass == mjcf_.masses.end() ? BodyMass() : mass->second;
  }

  static void AddJoint(const MjcfJoint& joint, pugi::xml_node body) {
    pugi::xml_node node = Add(body, "joint");
    Set(node, "name", joint.name);
    Set(node, "type", joint.is_hinge ? "hinge" : "slide");
    Set(node, "axis", NumbersText(joint.axis));
    Set(node, "pos", NumbersText(joint.anchor));
    if (joint.range) Set(node, "range", NumbersText(*joint.range));
  }

  static std::string SiteName(const MjcfMuscle& muscle, size_t i) {
    return muscle.name + "_site_" + std::to_string(i + 1);
  }

  void AddSkins(pugi::xml_node root) {
    if (mjcf_.skins.empty()) return;
    pugi::xml_node deformable = Add(root, "deformable");
    for (const MjcfSkin& skin : mjcf_.skins) {
      pugi::xml_node node = Add(deformable, "skin");
      Set(node, "name", skin.name);
      Set(node, "file", skin.name + ".skn");
      Set(node, "rgba", "0.72 0.27 0.24 1");
    }
  }

  void AddTendons(pugi::xml_node root) {
    pugi::xml_node tendons = Add(root, "tendon");
    for (const MjcfMuscle& muscle : mjcf_.muscles) {
      pugi::xml_node spatial = Add(tendons, "spatial");
      Set(spatial, "name", muscle.name);
      for (size_t i = 0; i < muscle.path.sites.size(); ++i) {
        Set(Add(spatial, "site"), "site", SiteName(muscle, i));
      }
    }
  }

  void AddCouplings(pugi::xml_node root) {
    if (mjcf_.tree.couplings.empty()) return;
    pugi::xml_node equality = Add(root, "equality");
    for (const MjcfCoupling& coupling : mjcf_.tree.couplings) {
      pugi::xml_node joint = Add(equality, "joint");
      Set(joint, "joint1", coupling.joint);
      if (!coupling.of.empty()) Set(joint, "joint2", coupling.of);
      Set(joint, "polycoef", NumbersText(coupling.coefficients));
    }
  }

  void AddActuators(pugi::xml_node root) {
    pugi::xml_node actuators = Add(root, "actuator");
    for (const MjcfMuscle& muscle : mjcf_.muscles) {
      pugi::xml_node node = Add(actuators, "muscle");
      Set(node, "name", muscle.name);
      Set(node, "tendon", muscle.name);
      Set(node,
          "lengthrange",
          NumbersText(std::array<double, 2>{
              kMetresPerMillimetre * muscle.length_range[0],
              kMetresPerMillimetre * muscle.length_range[1]}));
      if (muscle.force > 0) Set(node, "force", NumberText(muscle.force));
    }
  }

  // The default pose of the OpenSim model.
  void AddKeyframe(pugi::xml_node root) {
    std::string values;
    for (const size_t place : InOrderOfMujoco()) {
      for (const MjcfJoint& joint : mjcf_.tree.bodies[place].joints) {
        values += (values.empty() ? "" : " ") +
                  NumberText(joint.default_value, kDigits);
      }
    }
    pugi::xml_node key = Add(Add(root, "keyframe"), "key");
    Set(key, "name", "default");
    Set(key, "qpos", values);
  }

  // MuJoCo numbers bodies depth first, as the document has them.
  std::vector<size_t> InOrderOfMujoco() const {
    std::vector<size_t> order;
    const auto add = [&](int parent, const auto& self) -> void {
      for (size_t i = 0; i < mjcf_.tree.bodies.size(); ++i) {
        if (mjcf_.tree.bodies[i].parent != parent) continue;
        order.push_back(i);
        self(static_cast<int>(i), self);
      }
    };
    add(-1, add);
    return order;
  }

  const MjcfModel& mjcf_;
  const Model& model_;
  pugi::xml_document document_;
  pugi::xml_node world_;
  std::vector<pugi::xml_node> nodes_;  // by place in the tree
};

// Numbers of a .skn file: little-endian, as MuJoCo reads them.
class SknWriter {
 public:
  void Add(std::int32_t number) { AddBytes(&number, sizeof number); }
  void Add(float number) { AddBytes(&number, sizeof number); }
  void AddName(const std::string& name) {
    char bytes[kNameSize] = {};
    std::memcpy(bytes, name.data(), name.size());
    AddBytes(bytes, sizeof bytes);
  }
  const std::string& bytes() const { return bytes_; }

  static constexpr size_t kNameSize = 40;  // with a 0 at the end

 private:
  void AddBytes(const void* data, size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
  }
  std::string bytes_;
};

}  // namespace

std::string MjcfText(const MjcfModel& mjcf, const Model& model) {
  return MjcfWriter(mjcf, model).Write();
}

std::string SknBytes(const MjcfSkin& skin) {
  SknWriter writer;
  const Eigen::Index count = skin.skin.places.rows();
  writer.Add(static_cast<std::int32_t>(count));
  writer.Add(std::int32_t{0});  // texture coordinates
  writer.Add(static_cast<std::int32_t>(skin.triangles.rows()));
  writer.Add(static_cast<std::int32_t>(skin.bones.size()));
  for (Eigen::Index v = 0; v < count; ++v) {
    for (int k = 0; k < 3; ++k) {
      writer.Add(
          static_cast<float>(kMetresPerMillimetre * skin.skin.places(v, k)));
    }
  }
  for (Eigen::Index f = 0; f < skin.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      writer.Add(static_cast<std::int32_t>(skin.triangles(f, k)));
    }
  }
  for (size_t b = 0; b < skin.bones.size(); ++b) {
    const std::string& name = skin.bones[b].body;
    if (name.size() >= SknWriter::kNameSize) {
      throw InputError(
          "the body \"" + name + "\"",
          "has a name of " + std::to_string(name.size()) + " bytes",
          "skins of MuJoCo have at most 39; rename the body");
    }
    writer.AddName(name);
    const Eigen::Matrix4d& place = skin.bones[b].rest_from_body;
    for (int k = 0; k < 3; ++k) {
      writer.Add(static_cast<float>(kMetresPerMillimetre * place(k, 3)));
    }
    const Eigen::Quaterniond q(Eigen::Matrix3d(place.topLeftCorner<3, 3>()));
    for (const double part : {q.w(), q.x(), q.y(), q.z()}) {
      writer.Add(static_cast<float>(part));
    }
    std::vector<Eigen::Index> vertices;
    for (Eigen::Index v = 0; v < count; ++v) {
      if (skin.skin.weights(v, b) != 0) vertices.push_back(v);
    }
    writer.Add(static_cast<std::int32_t>(vertices.size()));
    for (const Eigen::Index v : vertices) {
      writer.Add(static_cast<std::int32_t>(v));
    }
    for (const Eigen::Index v : vertices) {
      writer.Add(static_cast<float>(skin.skin.weights(v, b)));
    }
  }
  return writer.bytes();
}

std::string MeshText(const TriangleSoup& mesh) {
  std::string text;
  for (const Eigen::RowVector3d point : mesh.points.rowwise()) {
    text +=
        "v " +
        NumbersText(Eigen::Vector3d(kMetresPerMillimetre * point.transpose())) +
        "\n";
  }
  for (const Eigen::RowVector3i triangle : mesh.triangles.rowwise()) {
    text += "f";
    for (const int vertex : triangle) text += " " + std::to_string(vertex + 1);
    text += "\n";
  }
  return text;
}

}  // namespace musclewarp
