// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/frame_files.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iomanip>
#include <sstream>

#include "musclewarp/base/output_file.h"
#include "musclewarp/base/xml_text.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/mesh/triangle_difference.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/mesh_files/vtp_writer.h"
#include "musclewarp/run/bones_file.h"
#include "musclewarp/run/lines_file.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// Folders of a frame, so that no name of a mesh is taken.
constexpr char kLines[] = "lines/";
constexpr char kFibres[] = "fibres/";

#ifdef MUSCLEWARP_WITH_VTK
void WriteMuscleVtp(const PreparedMuscle& muscle,
                    const MuscleFrame& frame,
                    double body_size,
                    const fs::path& folder) {
  const MuscleModel& model = muscle.model;
  const Eigen::VectorXd contact =
      (frame.gaps.array() <= kContactGap * body_size).cast<double>();
  const std::vector<NamedField> fields = {
      {"displacement", frame.points - model.fine_rest},
      {"area_stretch",
       AreaStretch(model.fine_rest, frame.points, model.fine_triangles)},
      {"gap", frame.gaps},
      {"contact", contact}};
  WriteTextAtomically((folder / (model.name + ".vtp")).string(),
                      VtpOfMesh({frame.points, model.fine_triangles}, fields));
}

void WriteLinesVtp(const std::vector<Points>& lines, const fs::path& path) {
  fs::create_directories(path.parent_path());
  Eigen::VectorXd numbers(lines.size());
  Eigen::VectorXd lengths(lines.size());
  for (size_t i = 0; i < lines.size(); ++i) {
    numbers[i] = static_cast<double>(i + 1);
    lengths[i] = PolylineLength(lines[i]);
  }
  WriteTextAtomically(
      path.string(),
      VtpOfLines(lines, {{"number", numbers}, {"length_mm", lengths}}));
}
#else
void WriteMuscleVtp(const PreparedMuscle&,
                    const MuscleFrame&,
                    double,
                    const fs::path&) {
  LOG(FATAL) << "this build cannot write .vtp";
}
void WriteLinesVtp(const std::vector<Points>&, const fs::path&) {}
#endif

BoneMotions NamedMotions(const PreparedScene& scene, const Frame& frame) {
  BoneMotions motions;
  for (size_t i = 0; i < scene.bones.size(); ++i) {
    motions[scene.bones[i].mesh.name] = frame.bones_from_rest[i];
  }
  return motions;
}

void WriteMuscles(const PreparedScene& scene,
                  const Frame& frame,
                  const std::string& format,
                  const fs::path& folder) {
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    const PreparedMuscle& muscle = scene.muscles[i];
    const MuscleFrame& moved = frame.muscles[i];
    CHECK(moved.points.allFinite()) << muscle.model.name;  // KeepFinite
    const std::string file = muscle.model.name + "." + format;
    if (format != "vtp") {
      WriteTriangleSoup((folder / file).string(),
                        {moved.points, muscle.model.fine_triangles});
      continue;
    }
    WriteMuscleVtp(muscle, moved, scene.scene.body_size, folder);
    WriteLinesVtp(moved.lines, folder / (kLines + file));
    if (moved.fibres.empty()) continue;
    WriteLinesVtp(moved.fibres, folder / (kFibres + file));
  }
}

void WriteBones(const PreparedScene& scene,
                const Frame& frame,
                const std::string& format,
                const fs::path& folder) {
  for (size_t i = 0; i < scene.bones.size(); ++i) {
    const PreparedBone& bone = scene.bones[i];
    WriteTriangleSoup((folder / (bone.mesh.name + "." + format)).string(),
                      {frame.bones[i], bone.rest.triangles});
  }
}

}  // namespace

const char* ToString(BoneFiles bones) {
  return bones == BoneFiles::kOnce ? "once" : "every";
}

bool FrameFileOptions::HasFormat(const std::string& format) const {
  return std::count(formats.begin(), formats.end(), format) > 0;
}

bool FrameFileOptions::HasBonesInFrames(const std::string& format) const {
  return bones == BoneFiles::kEvery || format == "vtp";
}

std::string FrameFolder(int index) {
  std::ostringstream name;
  name << "frame_" << std::setw(4) << std::setfill('0') << index;
  return name.str();
}

int FrameNumber(const std::string& name) {
  constexpr char kFramePrefix[] = "frame_";
  const std::size_t length = sizeof(kFramePrefix) - 1;
  const std::string digits = name.substr(std::min(length, name.size()));
  if (name.compare(0, length, kFramePrefix) != 0 || digits.empty() ||
      digits.size() > 9 ||
      !std::all_of(digits.begin(), digits.end(), [](unsigned char c) {
        return std::isdigit(c);
      })) {
    return -1;
  }
  return std::stoi(digits);
}

std::map<int, std::string> FrameFoldersIn(const std::string& dir) {
  std::map<int, std::string> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(dir)) {
    const std::string name = entry.path().filename().string();
    const int number = FrameNumber(name);
    if (FrameFolder(number) == name && entry.is_directory()) {
      folders[number] = entry.path().string();
    }
  }
  return folders;
}

Eigen::VectorXd AreaStretch(const Points& rest,
                            const Points& points,
                            const Triangles& triangles) {
  const auto areas_around = [&](const Points& at) {
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(at.rows());
    for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
      const Eigen::RowVector3d a = at.row(triangles(f, 0));
      const Eigen::RowVector3d ab = at.row(triangles(f, 1)) - a;
      const Eigen::RowVector3d ac = at.row(triangles(f, 2)) - a;
      const double area = ab.cross(ac).norm() / 2;
      for (int corner = 0; corner < 3; ++corner) {
        areas[triangles(f, corner)] += area;
      }
    }
    return areas;
  };
  const Eigen::VectorXd before = areas_around(rest);
  const Eigen::VectorXd after = areas_around(points);
  Eigen::VectorXd stretch = Eigen::VectorXd::Ones(rest.rows());
  for (Eigen::Index v = 0; v < rest.rows(); ++v) {
    if (before[v] > 0) stretch[v] = after[v] / before[v];
  }
  return stretch;
}

std::vector<MuscleLines> LinesOf(const PreparedScene& scene,
                                 const Frame& frame) {
  std::vector<MuscleLines> muscles;
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    const MuscleModel& model = scene.muscles[i].model;
    MuscleLines lines{
        model.name, {}, frame.muscles[i].fibres, frame.muscles[i].bare_tendons};
    for (size_t k = 0; k < model.lines.size(); ++k) {
      lines.lines.push_back({model.lines[k].name, frame.muscles[i].lines[k]});
    }
    muscles.push_back(std::move(lines));
  }
  return muscles;
}

void WriteFrame(const PreparedScene& scene,
                const Frame& frame,
                const FrameFileOptions& options,
                const std::string& dir) {
  const bool is_rest = frame.index < 0;
  const auto write_all = [&](const std::string& partial) {
    const fs::path folder(partial);
    WriteLinesFile((folder / kLinesFile).string(), LinesOf(scene, frame));
    if (!is_rest && options.bones == BoneFiles::kOnce) {
      WriteBonesFile((folder / kBonesFile).string(),
                     NamedMotions(scene, frame));
    }
    for (const std::string& format : options.formats) {
      WriteMuscles(scene, frame, format, folder);
      if (is_rest || options.HasBonesInFrames(format)) {
        WriteBones(scene, frame, format, folder);
      }
    }
  };
  const std::string name = is_rest ? kRestFolder : FrameFolder(frame.index);
  WriteFolderAtomically((fs::path(dir) / name).string(), write_all);
}

std::vector<std::string> FilesThatDiffer(const PreparedScene& scene,
                                         const Frame& frame,
                                         const FrameFileOptions& options,
                                         const std::string& dir) {
  const fs::path folder = FrameFolder(frame.index);
  const std::string bones_file = (folder / kBonesFile).string();
  BoneMotions motions;
  if (options.bones == BoneFiles::kOnce) {
    motions = ReadBonesFile((fs::path(dir) / bones_file).string());
  }
  std::vector<std::string> different;
  const auto compare = [&](const fs::path& file,
                           const Eigen::Matrix4d* motion,
                           const TriangleSoup& expected) {
    TriangleSoup soup = ReadTriangleSoup((fs::path(dir) / file).string());
    if (motion) soup.points = Transformed(soup.points, *motion);
    if (!AreSame(soup, expected)) different.push_back(file.string());
  };
  for (const std::string& format : options.formats) {
    const auto file_of = [&](const std::string& name) {
      return name + "." + format;
    };
    for (size_t i = 0; i < scene.muscles.size(); ++i) {
      const MuscleModel& model = scene.muscles[i].model;
      compare(folder / file_of(model.name),
              nullptr,
              {frame.muscles[i].points, model.fine_triangles});
    }
    for (size_t i = 0; i < scene.bones.size(); ++i) {
      const std::string file = file_of(scene.bones[i].mesh.name);
      const TriangleSoup expected = {frame.bones[i],
                                     scene.bones[i].rest.triangles};
      if (options.HasBonesInFrames(format)) {
        compare(folder / file, nullptr, expected);
      }
      if (options.bones == BoneFiles::kEvery) continue;
      const auto motion = motions.find(scene.bones[i].mesh.name);
      if (motion == motions.end()) {
        different.push_back(bones_file);
      } else {
        compare(fs::path(kRestFolder) / file, &motion->second, expected);
      }
    }
  }
  return different;
}

void WritePvd(const PreparedScene& scene,
              const std::vector<int>& frames,
              const std::string& dir) {
  const bool has_times = scene.scene.is_motion;
  std::ostringstream pvd;
  pvd << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" "
         "version=\"0.1\">\n  <Collection>\n"
      << std::setprecision(17);
  for (const int frame : frames) {
    int part = 0;
    const auto add = [&](const std::string& name) {
      pvd << "    <DataSet timestep=\"";
      // Poses without times are played by their indices.
      if (has_times) {
        pvd << scene.scene.poses[frame].time;
      } else {
        pvd << frame;
      }
      pvd << "\" part=\"" << part++ << "\" name=\"" << XmlEscaped(name)
          << "\" file=\"" << XmlEscaped(FrameFolder(frame) + "/" + name)
          << ".vtp\"/>\n";
    };
    for (const auto& muscle : scene.muscles) add(muscle.model.name);
    for (const auto& bone : scene.bones) add(bone.mesh.name);
    for (const auto& muscle : scene.muscles) {
      add(kLines + muscle.model.name);
      if (muscle.fibres.num_lines() > 0) add(kFibres + muscle.model.name);
    }
  }
  pvd << "  </Collection>\n</VTKFile>\n";
  WriteTextAtomically((fs::path(dir) / "motion.pvd").string(), pvd.str());
}

}  // namespace musclewarp
