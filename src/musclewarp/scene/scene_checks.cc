// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/scene_checks.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/near_name.h"
#include "musclewarp/scene/coordinate_limits.h"
#include "musclewarp/scene/rigid_motion.h"
#include "musclewarp/scene/scene_names.h"

namespace musclewarp {
namespace {

// A scene that was built in memory has no file.
std::string Where(const Scene& scene) {
  return scene.path.empty() ? "the scene" : scene.path;
}

// Names of meshes are file names: the meshes of a frame are written as
// <name>.<ext>.
void CheckMeshName(const Scene& scene,
                   const std::string& what,
                   const std::string& name,
                   std::set<std::string>* seen) {
  CheckFileName(Where(scene), what, name);
  if (!seen->insert(name).second) {
    throw InputError(Where(scene),
                     "the name " + QuotedName(name) + " is given twice",
                     "muscles and bones need names of their own");
  }
}

std::string Listed(const std::set<std::string>& names) {
  std::string list;
  for (const std::string& name : names) {
    list += (list.empty() ? "" : ", ") + name;
  }
  return list;
}

// Checks that the motion of a body that a line or an attachment follows is
// known. `where` begins with the file.
void CheckFollowedBody(const std::string& where,
                       const std::string& body,
                       const std::set<std::string>& known) {
  if (known.count(body)) return;
  throw InputError(
      where,
      "names the body " + QuotedName(body) + ", which no bone and no pose has",
      known.empty() ? "add a bone with that body, or move it in a pose"
                    : DidYouMean(body, {known.begin(), known.end()}) +
                          "known bodies: " + Listed(known));
}

// Checks that the scene uses a body that a pose moves: otherwise its name is
// probably misspelt.
void CheckMovedBody(const std::string& where,
                    const std::string& body,
                    const std::set<std::string>& in_use) {
  if (in_use.count(body)) return;
  throw InputError(where,
                   "names the body " + QuotedName(body) +
                       ", which no bone, line or attachment has",
                   in_use.empty()
                       ? "leave it out"
                       : DidYouMean(body, {in_use.begin(), in_use.end()}) +
                             "bodies in use: " + Listed(in_use));
}

void CheckLine(const std::string& where,
               const ActionLine& line,
               const std::set<std::string>& bodies) {
  if (line.rest.rows() < 2) {
    throw InputError(
        where,
        "has " + std::to_string(line.rest.rows()) + " points in \"rest\"",
        "give at least 2");
  }
  CheckCoordinates(where, line.rest);
  for (Eigen::Index i = 0; i + 1 < line.rest.rows(); ++i) {
    if (line.rest.row(i) == line.rest.row(i + 1)) {
      throw InputError(where,
                       "repeats point " + std::to_string(i) + " as point " +
                           std::to_string(i + 1),
                       "remove one of them");
    }
  }
  if (!line.bodies.empty() &&
      static_cast<Eigen::Index>(line.bodies.size()) != line.rest.rows()) {
    throw InputError(where,
                     "has " + std::to_string(line.bodies.size()) +
                         " bodies for " + std::to_string(line.rest.rows()) +
                         " points",
                     "give one body a point, or none");
  }
  for (const auto& body : line.bodies) CheckFollowedBody(where, body, bodies);
}

void CheckTargets(const Scene& scene,
                  const ScenePose& pose,
                  const std::map<std::string, const ActionLine*>& lines) {
  for (const auto& [name, target] : pose.lines) {
    const std::string where = Where(scene) + ": target of line " +
                              QuotedName(name) + " in pose " +
                              QuotedName(pose.name);
    const auto line = lines.find(name);
    if (line == lines.end()) {
      throw InputError(where, "no muscle has such a line", "check the name");
    }
    if (target.rows() != line->second->rest.rows()) {
      throw InputError(where,
                       "has " + std::to_string(target.rows()) +
                           " points, the rest line has " +
                           std::to_string(line->second->rest.rows()),
                       "give the same number of points");
    }
    CheckCoordinates(where, target);
  }
}

// Returns the bodies whose motion is known: those of bones, of poses and of the
// model.
std::set<std::string> KnownBodies(const Scene& scene) {
  std::set<std::string> bodies;
  for (const SceneBone& bone : scene.bones) bodies.insert(bone.body);
  for (const ScenePose& pose : scene.poses) {
    for (const auto& [body, transform] : pose.bodies) bodies.insert(body);
  }
  if (scene.model) {
    for (const int body : scene.model->bodies) {
      bodies.insert(scene.model->model.bodies[body].name);
    }
  }
  return bodies;
}

void CheckEndBodies(const Scene& scene, const SceneMuscle& muscle) {
  if (muscle.end_bodies.empty()) return;
  const std::string where =
      Where(scene) + ": \"end_bodies\" of muscle " + muscle.name;
  if (muscle.end_bodies.size() != 2) {
    throw InputError(where,
                     "has " + std::to_string(muscle.end_bodies.size()) +
                         " bodies; allowed: two",
                     "name the body of the origin and that of the insertion");
  }
  for (const std::string& body : muscle.end_bodies) {
    const bool has_bones = std::any_of(
        scene.bones.begin(), scene.bones.end(), [&](const SceneBone& bone) {
          return bone.body == body;
        });
    if (has_bones) continue;
    std::vector<std::string> known;
    for (const SceneBone& bone : scene.bones) known.push_back(bone.body);
    throw InputError(
        where,
        "names " + QuotedName(body) +
            ", which is the body of no bone of the scene",
        DidYouMean(body, known) +
            "name bodies of bones, or leave it out to have them found "
            "on the meshes");
  }
}

void CheckEndsOn(const Scene& scene, const SceneMuscle& muscle) {
  if (!muscle.ends_on) return;
  for (const std::string& name : *muscle.ends_on) {
    const bool is_other =
        name != muscle.name && std::any_of(scene.muscles.begin(),
                                           scene.muscles.end(),
                                           [&](const SceneMuscle& other) {
                                             return other.name == name;
                                           });
    if (is_other) continue;
    std::vector<std::string> others;
    for (const SceneMuscle& other : scene.muscles) {
      if (other.name != muscle.name) others.push_back(other.name);
    }
    throw InputError(
        Where(scene) + ": \"ends_on\" of muscle " + muscle.name,
        "names " + QuotedName(name) + ", which is no other muscle of the scene",
        DidYouMean(name, others) +
            "name muscles, leave it out to have them found on the "
            "meshes, or give [] if it ends on bones");
  }
}

void CheckMuscle(const Scene& scene,
                 const SceneMuscle& muscle,
                 const std::set<std::string>& bodies,
                 std::map<std::string, const ActionLine*>* lines) {
  for (const ActionLine& line : muscle.lines) {
    CheckColumnName(Where(scene), "line of muscle " + muscle.name, line.name);
    CheckLine(Where(scene) + ": line " + QuotedName(line.name) + " of muscle " +
                  muscle.name,
              line,
              bodies);
    if (!lines->emplace(line.name, &line).second) {
      throw InputError(Where(scene),
                       "the line " + QuotedName(line.name) + " is given twice",
                       "lines need names of their own");
    }
  }
  for (const Attachment& attachment : muscle.attachments) {
    const std::string where =
        Where(scene) + ": an attachment of muscle " + muscle.name;
    CheckFollowedBody(where, attachment.body, bodies);
    CheckCoordinates(where, attachment.points);
  }
  CheckEndsOn(scene, muscle);
  CheckEndBodies(scene, muscle);
}

void CheckOnePose(const Scene& scene,
                  const ScenePose& pose,
                  const std::set<std::string>& in_use,
                  const std::map<std::string, const ActionLine*>& lines) {
  CheckPrintable(Where(scene), "pose", pose.name);
  const std::string where = Where(scene) + ": pose " + QuotedName(pose.name);
  for (const auto& [body, transform] : pose.bodies) {
    CheckMovedBody(where, body, in_use);
    CheckCoordinates(where + ": body " + QuotedName(body), transform);
    const std::string fault = RigidMotionFault(transform);
    if (fault.empty()) continue;
    throw InputError(where + ": body " + QuotedName(body),
                     fault,
                     "give the motion from rest as 4 x 4 numbers, rotation and "
                     "translation in mm");
  }
  CheckTargets(scene, pose, lines);
}

// Adds a column of a table of the run. `what` says what it would be of, such as
// the line "a".
void AddColumn(const Scene& scene,
               const std::string& column,
               const std::string& what,
               std::map<std::string, std::string>* columns) {
  const auto [entry, is_new] = columns->emplace(ColumnName(column), what);
  if (is_new) return;
  throw InputError(Where(scene),
                   "tables would have the column " + QuotedName(entry->first) +
                       " twice: of " + entry->second + " and of " + what,
                   "choose another name");
}

// Checks that no two columns of a table of the run have one name (lengths.sto
// also has the lengths of paths of models, volumes.sto those of muscles).
void CheckColumns(const Scene& scene) {
  std::map<std::string, std::string> of_lines = {{"time", "the time"}};
  std::map<std::string, std::string> of_muscles = of_lines;
  for (const SceneMuscle& muscle : scene.muscles) {
    const std::string name = QuotedName(muscle.name);
    AddColumn(scene, muscle.name, "the muscle " + name, &of_muscles);
    for (const ActionLine& line : muscle.lines) {
      const std::string of_line = "the line " + QuotedName(line.name);
      AddColumn(scene, line.name, of_line, &of_lines);
      AddColumn(
          scene, line.name + "_path", "the path of " + of_line, &of_lines);
    }
  }
}

std::set<std::string> SetOfBodiesInUse(const Scene& scene) {
  const std::vector<std::string> bodies = BodiesInUse(scene);
  return {bodies.begin(), bodies.end()};
}

void CheckPoses(const Scene& scene,
                const std::map<std::string, const ActionLine*>& lines) {
  const std::set<std::string> in_use = SetOfBodiesInUse(scene);
  std::set<std::string> names;
  for (const ScenePose& pose : scene.poses) {
    if (!names.insert(pose.name).second) {
      throw InputError(Where(scene),
                       "the pose " + QuotedName(pose.name) + " is given twice",
                       "poses need names of their own");
    }
    CheckOnePose(scene, pose, in_use, lines);
  }
}

std::map<std::string, const ActionLine*> LinesByName(const Scene& scene) {
  std::map<std::string, const ActionLine*> lines;
  for (const SceneMuscle& muscle : scene.muscles) {
    for (const ActionLine& line : muscle.lines) lines.emplace(line.name, &line);
  }
  return lines;
}

}  // namespace

void CheckScene(const Scene& scene) {
  CheckPrintable(Where(scene), "scene", scene.name);
  std::set<std::string> mesh_names;
  for (const SceneBone& bone : scene.bones) {
    CheckMeshName(scene, "bone", bone.name, &mesh_names);
  }
  for (const SceneMuscle& muscle : scene.muscles) {
    CheckMeshName(scene, "muscle", muscle.name, &mesh_names);
  }
  const std::set<std::string> bodies = KnownBodies(scene);
  std::map<std::string, const ActionLine*> lines;
  for (const SceneMuscle& muscle : scene.muscles) {
    CheckMuscle(scene, muscle, bodies, &lines);
  }
  CheckColumns(scene);
  CheckPoses(scene, lines);
}

void CheckPose(const Scene& scene, const ScenePose& pose) {
  CheckOnePose(scene, pose, SetOfBodiesInUse(scene), LinesByName(scene));
}

}  // namespace musclewarp
