// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/articulated_scene.h"

#include <glog/logging.h>

#include <algorithm>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/near_name.h"
#include "musclewarp/base/short_list.h"
#include "musclewarp/scene/scene_names.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

double SweptValue(const CoordinateSweep& sweep, int frame, int frames) {
  if (frames < 2) return sweep.from;
  const double part = static_cast<double>(frame) / (frames - 1);
  return sweep.from + part * (sweep.to - sweep.from);
}

// The body that a name stands for: its own, or that of a bone.
std::string BodyNamed(const Articulation& articulation,
                      const std::string& muscle,
                      const std::string& name) {
  std::vector<std::string> names = articulation.bodies;
  for (const std::string& body : articulation.bodies) {
    if (body == name) return body;
  }
  for (const Bone& bone : articulation.bones) {
    if (bone.name == name) return bone.body;
    names.push_back(bone.name);
  }
  throw InputError(
      muscle,
      "ends on " + QuotedName(name) + ", which is neither a body nor a bone",
      DidYouMean(name, names) + "allowed: " + ShortList(names));
}

OrderedJson MuscleJson(const Articulation& articulation,
                       const SceneMeshFile& muscle) {
  OrderedJson json = {{"name", muscle.name}, {"mesh", muscle.file}};
  if (muscle.delivered_volume > 0) {
    json["delivered_volume_mm3"] = muscle.delivered_volume;
  }
  const std::vector<std::string> ends =
      EndBodiesOf(articulation, muscle.name, muscle.origin, muscle.insertion);
  if (!ends.empty()) json["end_bodies"] = ends;
  return json;
}

}  // namespace

std::vector<std::string> EndBodiesOf(const Articulation& articulation,
                                     const std::string& muscle,
                                     const std::string& origin,
                                     const std::string& insertion) {
  if (origin.empty() && insertion.empty()) return {};
  if (origin.empty() || insertion.empty()) {
    throw InputError(muscle,
                     origin.empty() ? "has an insertion and no origin"
                                    : "has an origin and no insertion",
                     "name the bodies of both ends, or of none");
  }
  return {BodyNamed(articulation, muscle, origin),
          BodyNamed(articulation, muscle, insertion)};
}

std::vector<std::string> CoordinateNames(const Articulation& articulation) {
  std::vector<std::string> names;
  for (const FoundJoint& joint : articulation.joints) {
    if (!joint.IsFound() || !joint.coupling.coordinate.empty()) continue;
    for (const JointCoordinate& entry : CoordinatesOf(joint.kind, joint.side)) {
      names.push_back(entry.name);
    }
  }
  return names;
}

void CheckCoordinates(const JointMotion& motion,
                      const Articulation& articulation,
                      const std::string& where) {
  const std::vector<std::string> names = CoordinateNames(articulation);
  for (const CoordinateSweep& sweep : motion.sweeps) {
    if (std::count(names.begin(), names.end(), sweep.coordinate) > 0) continue;
    std::string known;
    for (const std::string& name : names) {
      known += (known.empty() ? "" : ", ") + name;
    }
    throw InputError(where,
                     "has " + QuotedName(sweep.coordinate) +
                         ", which no joint that was found has",
                     DidYouMean(sweep.coordinate, names) + "allowed: " + known);
  }
}

std::vector<JointMotion> MotionsOfRanges(const Articulation& articulation) {
  std::vector<JointMotion> motions;
  for (const FoundJoint& joint : articulation.joints) {
    if (!joint.IsFound() || !joint.coupling.coordinate.empty()) continue;
    for (const JointCoordinate& entry : CoordinatesOf(joint.kind, joint.side)) {
      JointMotion motion;
      motion.name = entry.name;
      motion.sweeps = {{entry.name, entry.lowest, entry.highest}};
      motions.push_back(std::move(motion));
    }
  }
  return motions;
}

JointMotion FirstMotion(const Articulation& articulation) {
  constexpr double kWay = 30;  // degrees
  JointMotion motion;
  motion.frames = 7;
  for (const FoundJoint& joint : articulation.joints) {
    if (!joint.IsFound() || !joint.coupling.coordinate.empty()) continue;
    const JointCoordinate entry = CoordinatesOf(joint.kind, joint.side)[0];
    const double scan = DegreesOf(ScanCoordinates(joint)[0]);
    motion.name = entry.name;
    motion.sweeps = {{entry.name, scan, scan + kWay}};
    break;
  }
  return motion;
}

StorageTable MotionTable(const JointMotion& motion) {
  StorageTable table;
  table.name = motion.name;
  table.in_degrees = true;
  table.values.resize(motion.frames, motion.sweeps.size());
  for (const CoordinateSweep& sweep : motion.sweeps) {
    table.labels.push_back(sweep.coordinate);
  }
  for (int frame = 0; frame < motion.frames; ++frame) {
    table.times.push_back(motion.frames > 1
                              ? static_cast<double>(frame) / (motion.frames - 1)
                              : 0);
    for (size_t i = 0; i < motion.sweeps.size(); ++i) {
      table.values(frame, i) =
          SweptValue(motion.sweeps[i], frame, motion.frames);
    }
  }
  return table;
}

OrderedJson ArticulatedSceneJson(const Articulation& articulation,
                                 const ArticulatedSceneParts& parts,
                                 const JointMotion& motion) {
  OrderedJson scene = {{"name", parts.name}, {"units", parts.units}};
  if (!parts.axes.empty()) scene["axes"] = parts.axes;
  for (const FoundJoint& joint : articulation.joints) {
    scene["side"] = ToString(joint.side);
    break;
  }
  OrderedJson muscles = OrderedJson::array(), bones = OrderedJson::array();
  for (const SceneMeshFile& muscle : parts.muscles) {
    muscles.push_back(MuscleJson(articulation, muscle));
  }
  for (const Bone& bone : articulation.bones) {
    const auto file = std::find_if(
        parts.bones.begin(), parts.bones.end(), [&](const auto& entry) {
          return entry.name == bone.name;
        });
    CHECK(file != parts.bones.end()) << bone.name;
    bones.push_back(
        {{"name", bone.name}, {"mesh", file->file}, {"body", bone.body}});
  }
  scene["muscles"] = muscles;
  scene["bones"] = bones;
  scene["model"] = parts.model;
  OrderedJson coordinates;
  for (const CoordinateSweep& sweep : motion.sweeps) {
    coordinates[sweep.coordinate] = motion.frames > 1
                                        ? OrderedJson{sweep.from, sweep.to}
                                        : OrderedJson{sweep.from};
  }
  scene["motion"] = {{"frames", motion.frames}, {"coordinates", coordinates}};
  scene["model_rest"] = {{"coordinates", OrderedJson::object()},
                         {"in_degrees", true}};
  return scene;
}

}  // namespace musclewarp
