// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/articulate_command.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <utility>

#include "musclewarp/anatomy/bone_names.h"
#include "musclewarp/base/angles.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/base/portable_path.h"
#include "musclewarp/base/setting_names.h"
#include "musclewarp/base/short_list.h"
#include "musclewarp/base/text.h"
#include "musclewarp/geometry/view.h"
#include "musclewarp/joints/articulated_model.h"
#include "musclewarp/joints/articulated_scene.h"
#include "musclewarp/joints/joints_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/mesh_files/mesh_path.h"
#include "musclewarp/page/joints_page.h"
#include "musclewarp/program/program.h"
#include "musclewarp/run/output_folder.h"
#include "musclewarp/run/output_lock.h"
#include "musclewarp/run/paths_in_json.h"
#include "musclewarp/scene/scene_names.h"
#include "musclewarp/settings/checked_settings.h"
#include "musclewarp/subject/line_muscles.h"
#include "musclewarp/subject/subject.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

double ParseDouble(const std::string& flag, const std::string& text) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end || !std::isfinite(number)) {
    throw InputError(
        flag, "has " + QuotedName(text) + ", which is no number", "correct it");
  }
  return number;
}

// Returns an angle in degrees.
double ParseAngle(const std::string& flag, const std::string& text) {
  constexpr double kFullTurn = 360;
  const double angle = ParseDouble(flag, text);
  if (std::abs(angle) <= kFullTurn) return angle;
  throw InputError(
      flag, "has " + QuotedName(text) + " degrees", "allowed: -360 to 360");
}

// Returns the motion of entries such as "hip_flexion_r:-10:60:15", one for each
// coordinate. At least one of them has the number of frames.
JointMotion ParseMotion(const std::vector<std::string>& entries) {
  JointMotion motion;
  bool has_frames = false;
  for (const std::string& entry : entries) {
    const std::string flag = "--motion=" + entry;
    const std::vector<std::string> parts = Split(entry, ':');
    if (parts.size() < 3 || parts.size() > 4) {
      throw InputError(flag,
                       "is no motion",
                       "give COORDINATE:FROM:TO:FRAMES in degrees, such as "
                       "hip_flexion_r:-10:60:15");
    }
    for (const CoordinateSweep& other : motion.sweeps) {
      if (other.coordinate != parts[0]) continue;
      throw InputError(flag,
                       "has " + QuotedName(parts[0]) + " a second time",
                       "give each coordinate once");
    }
    motion.sweeps.push_back(
        {parts[0], ParseAngle(flag, parts[1]), ParseAngle(flag, parts[2])});
    motion.name += (motion.name.empty() ? "" : "+") + parts[0];
    if (parts.size() < 4) continue;
    const double frames = ParseDouble(flag, parts[3]);
    if (frames != std::floor(frames) || frames < 1 ||
        frames > kMostMotionFrames) {
      throw InputError(flag,
                       "has " + QuotedName(parts[3]) + " frames",
                       "allowed: 1 to 100000");
    }
    if (has_frames && frames != motion.frames) {
      throw InputError(flag,
                       "has another number of frames than the one before",
                       "coordinates move together; give one number");
    }
    motion.frames = static_cast<int>(frames);
    has_frames = true;
  }
  for (const CoordinateSweep& sweep : motion.sweeps) {
    if (motion.frames > 1 || sweep.from == sweep.to) continue;
    throw InputError("--motion",
                     "moves " + QuotedName(sweep.coordinate) + " in one frame",
                     "give two frames or more, or one value twice");
  }
  return motion;
}

class ArticulateRun {
 public:
  ArticulateRun(const std::vector<std::string>& files,
                const ArticulateOptions& options,
                std::ostream& screen)
      : files_(files), options_(options), screen_(screen) {}

  int Execute() {
    CheckWritable(options_.out);
    CheckSettings<ThreadSettings>(options_);
    if (files_.empty()) {
      throw InputError("files",
                       "none given",
                       "name the meshes of the bones, or a label image");
    }
    CheckSettings<LabelSettings>(options_);
    std::vector<std::string> results;  // the meshes of the model
    for (const std::string& file : files_) {
      results.push_back("Geometry/" + MeshNameOf(file) + ".obj");
    }
    CheckInputsStay(files_, options_.out, results);
    ArticulationOptions joints =
        OptionsOf(PartOf<ArticulationSettings>(options_));
    const JointMotion motion = ParseMotion(Split(options_.motion, ','));
    UseThreads(options_);
    const OutputLock lock(options_.out);
    subject_ = ReadSubject(Input());
    CheckOneUnit();
    // The axes of a label image are those of its file.
    if (!subject_.image.empty())
      joints.axes = subject_.IsOriented() ? "LPS" : "";
    PrintNotes(subject_.notes);
    articulation_ = Articulate(BonesOf(subject_), joints);
    PrintNotes(articulation_.notes);
    articulation_.notes.insert(articulation_.notes.begin(),
                               subject_.notes.begin(),
                               subject_.notes.end());
    ChooseMotions(motion);
    PrintJoints();
    MakeLineMuscles();
    Write(joints.axes);
    return AllJointsWereFound() ? kExitUsable : kExitNotUsable;
  }

 private:
  SubjectInput Input() const {
    SubjectInput input;
    input.use = SubjectUse::kJoints;
    input.files = files_;
    input.muscle_files = Split(options_.muscles, ',');
    input.bones = Split(options_.bone, ',');
    input.labels = OptionsOf(PartOf<LabelSettings>(options_));
    return input;
  }

  // Throws InputError for mesh files in another unit than mm beside a label
  // image: the scene has one unit, and meshes of labels are in mm.
  void CheckOneUnit() const {
    if (subject_.image.empty() || options_.units == "mm") return;
    for (const auto* meshes : {&subject_.bones, &subject_.muscles}) {
      for (const SubjectMesh& mesh : *meshes) {
        if (mesh.file.empty()) continue;
        throw InputError("--units=" + options_.units,
                         "is that of " + mesh.file +
                             ", and the surfaces of labels are in mm",
                         "convert the mesh files to mm");
      }
    }
  }

  void ChooseMotions(const JointMotion& asked) {
    CheckCoordinates(asked, articulation_, "--motion");
    const bool is_asked = !asked.sweeps.empty();
    motions_ = is_asked ? std::vector<JointMotion>{asked}
                        : MotionsOfRanges(articulation_);
    of_scene_ = is_asked ? asked : FirstMotion(articulation_);
  }

  void PrintNotes(const std::vector<std::string>& notes) {
    for (const std::string& note : notes) screen_ << WithFlags(note) << "\n";
  }

  void PrintJoints() {
    screen_ << std::fixed << std::setprecision(1);
    for (const FoundJoint& joint : articulation_.joints) {
      screen_ << std::left << std::setw(12) << joint.name() << std::setw(8)
              << (joint.is_given ? "given" : ToString(joint.verdict.quality));
      if (joint.IsFound()) {
        screen_ << joint.parent << " - " << joint.child << ", at "
                << PlaceText(joint.center.transpose());
      }
      screen_ << "\n";
      for (const FittedShape& shape : joint.shapes) PrintShape(shape);
      for (const std::string& reason : joint.verdict.reasons) {
        screen_ << "    " << WithFlags(reason) << "\n";
      }
    }
  }

  void PrintShape(const FittedShape& shape) {
    screen_ << "    " << shape.what << ": radius "
            << RoundedText(shape.radius, 1, articulation_.size)
            << " mm, spread "
            << RoundedText(shape.spread, 2, articulation_.size)
            << " mm, covers ";
    if (shape.kind == FittedShape::Kind::kSphere) {
      screen_ << 100 * shape.coverage << " % of its sphere\n";
    } else {
      screen_ << DegreesOf(shape.angle) << " degrees\n";
    }
  }

  // Makes the lines of the muscles. A model without muscles still moves the
  // bones, so that it is written if there are no lines.
  void MakeLineMuscles() {
    LineMuscles made =
        LineMusclesOf(subject_, articulation_, options_.MmPerUnit());
    if (!made.why_none.empty()) {
      screen_ << "warning: model.osim has no muscles, as no lines can be made "
                 "for them: "
              << WithFlags(made.why_none) << "\n";
    }
    for (const std::string& warning : made.warnings) {
      screen_ << "warning: " << WithFlags(warning) << "\n";
    }
    muscles_ = std::move(made.muscles);
    if (muscles_.empty()) return;
    screen_ << "model.osim has " << muscles_.size()
            << " muscles, one for each line; their forces and the lengths of "
               "their fibres and tendons are estimates\n";
    std::vector<std::string> refused;
    for (const LineMuscle& muscle : muscles_) {
      const std::string& name = muscle.line.name;
      if (name.find_first_of(kNotInOpenSimNames) == std::string::npos) continue;
      refused.push_back(QuotedName(name));
    }
    if (refused.empty()) return;
    screen_ << "warning: OpenSim 4 takes no blanks and none of \\ / * + in "
               "names, so that it will refuse "
            << ShortList(refused) << "; rename their meshes or labels\n";
  }

  void Write(const std::string& axes) {
    const fs::path out = options_.out;
    MakeFolder(options_.out);
    RemovePartialOutput(options_.out);
    MakeFolder((out / "Geometry").string());
    MakeFolder((out / "motions").string());
    for (const JointMotion& motion : motions_) {
      WriteTextAtomically((out / "motions" / (motion.name + ".mot")).string(),
                          StorageText(MotionTable(motion)));
    }
    WriteLabels(out);
    const std::string name = NameOfRun();
    WriteArticulatedModel(
        articulation_, name, (out / "model.osim").string(), muscles_);
    nlohmann::ordered_json joints = JointsJson(articulation_, axes);
    AdaptTexts(options_.out, &joints);
    WriteJson("joints.json", joints);
    if (options_.html) WritePage(name, axes);
    if (of_scene_.sweeps.empty()) return;
    WriteJson(
        "scene.json",
        ArticulatedSceneJson(articulation_, SceneParts(name, axes), of_scene_));
    if (subject_.muscles.empty()) {
      screen_ << "the scene has no muscles to move; --muscles names their "
                 "meshes\n";
      return;
    }
    screen_ << "next: musclewarp-deform --scene="
            << (out / "scene.json").string() << " --out=DIR\n";
  }

  void WritePage(const std::string& name, const std::string& axes) {
    JointsPageOptions page;
    page.name = name;
    page.axes = axes;
    const std::string file = (fs::path(options_.out) / "joints.html").string();
    WriteTextAtomically(file, JointsPageHtml(articulation_, page));
    screen_ << "wrote " << file << "\n";
  }

  // Writes the meshes of labels, which have no files that the scene could name.
  void WriteLabels(const fs::path& out) {
    if (subject_.image.empty()) return;
    MakeFolder((out / "meshes").string());
    for (const Bone& bone : articulation_.bones) {
      const bool is_label = std::any_of(
          subject_.bones.begin(), subject_.bones.end(), [&](auto& mesh) {
            return mesh.name == bone.name && mesh.file.empty();
          });
      if (!is_label) continue;
      WriteTriangleSoup((out / MeshOfLabel(bone.name)).string(), bone.mesh);
    }
    for (const SubjectMesh& muscle : subject_.muscles) {
      if (!muscle.file.empty()) continue;
      WriteTriangleSoup((out / MeshOfLabel(muscle.name)).string(), muscle.mesh);
    }
  }

  void WriteJson(const std::string& file, const nlohmann::ordered_json& json) {
    WriteTextAtomically(
        (fs::path(options_.out) / file).string(),
        json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) +
            "\n");
  }

  std::string NameOfRun() const {
    const fs::path out = fs::absolute(options_.out).lexically_normal();
    const fs::path last =
        out.filename().empty() ? out.parent_path().filename() : out.filename();
    return last.empty() ? "model" : last.string();
  }

  ArticulatedSceneParts SceneParts(const std::string& name,
                                   const std::string& axes) const {
    ArticulatedSceneParts parts;
    parts.name = name;
    parts.units = subject_.image.empty() ? options_.units : "mm";
    parts.axes = axes;
    for (const SubjectMesh& mesh : subject_.bones) {
      parts.bones.push_back({mesh.name, SceneFile(mesh)});
    }
    for (const SubjectMesh& mesh : subject_.muscles) {
      parts.muscles.push_back({mesh.name,
                               SceneFile(mesh),
                               mesh.origin,
                               mesh.insertion,
                               mesh.delivered_volume});
    }
    return parts;
  }

  // Returns the path of a mesh as the scene names it.
  std::string SceneFile(const SubjectMesh& mesh) const {
    if (mesh.file.empty()) return MeshOfLabel(mesh.name).generic_string();
    return MeshPathFrom(options_.out, mesh.file);
  }

  // Returns the path of the mesh of a label, relative to the output folder.
  static fs::path MeshOfLabel(const std::string& name) {
    return fs::path("meshes") / (name + ".ply");
  }

  bool AllJointsWereFound() const {
    return std::all_of(articulation_.joints.begin(),
                       articulation_.joints.end(),
                       [](const FoundJoint& joint) { return joint.IsFound(); });
  }

  const std::vector<std::string>& files_;
  const ArticulateOptions& options_;
  std::ostream& screen_;
  Subject subject_;
  Articulation articulation_;
  std::vector<LineMuscle> muscles_;
  std::vector<JointMotion> motions_;
  JointMotion of_scene_;
};

}  // namespace

int ArticulateCommand(const std::vector<std::string>& files,
                      const ArticulateOptions& options,
                      std::ostream& screen) {
  return ArticulateRun(files, options, screen).Execute();
}

}  // namespace musclewarp
