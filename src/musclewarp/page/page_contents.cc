// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/page_contents.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>

#include "musclewarp/base/angles.h"
#include "musclewarp/page/packed_motion.h"
#include "musclewarp/page/packed_numbers.h"
#include "musclewarp/page/page_parts.h"
#include "musclewarp/page/shown_frames.h"
#include "musclewarp/run/frame_files.h"
#include "musclewarp/run/motion_tables.h"
#include "musclewarp/run/paths_in_json.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

// The step to which gaps are rounded, mm; the largest gap is 100 steps.
double GapStepOf(const RecordedRun& run) {
  return kGapLimit * run.body_size / 100;
}

// To which bones are rounded, by everything at rest.
double StepOf(const RecordedRun& run) {
  std::vector<const Points*> points;
  for (const RecordedMuscle& muscle : run.muscles) {
    points.push_back(&muscle.points[0]);
  }
  for (const RecordedBone& bone : run.bones)
    points.push_back(&bone.rest.points);
  return RoundingStep(points);
}

// Packs positions of muscles, and keeps the largest error.
class MotionPacker {
 public:
  MotionPacker(double tolerance, PackedNumbers* packed)
      : tolerance_(tolerance), packed_(packed) {}

  PackedNumbers* packed() { return packed_; }
  double max_error() const { return max_error_; }

  OrderedJson Add(const std::vector<const Points*>& poses) {
    PackedMotion motion = PackMotion(poses, tolerance_, packed_);
    max_error_ = std::max(max_error_, motion.max_error);
    return std::move(motion.json);
  }

 private:
  double tolerance_;
  PackedNumbers* packed_;
  double max_error_ = 0;
};

// Returns polylines, one after the other; each has the same number of points in
// all poses.
OrderedJson PolylinesJson(
    const std::vector<std::vector<const Points*>>& by_pose,
    MotionPacker* packer) {
  OrderedJson counts = OrderedJson::array();
  Eigen::Index points = 0;
  for (const Points* line : by_pose[0]) {
    counts.push_back(line->rows());
    points += line->rows();
  }
  std::vector<Points> joined;
  std::vector<const Points*> poses;
  for (const auto& lines : by_pose) {
    Points& all = joined.emplace_back(points, 3);
    Eigen::Index row = 0;
    for (const Points* line : lines) {
      all.middleRows(row, line->rows()) = *line;
      row += line->rows();
    }
  }
  for (const Points& all : joined) poses.push_back(&all);
  return {{"counts", counts}, {"motion", packer->Add(poses)}};
}

OrderedJson AreasJson(const std::vector<AttachedArea>& areas,
                      PackedNumbers* packed) {
  OrderedJson list = OrderedJson::array();
  for (const AttachedArea& area : areas) {
    list.push_back(
        {{"body", area.body}, {"vertices", packed->Add(area.vertices, 1)}});
  }
  return list;
}

OrderedJson MuscleJson(const RecordedMuscle& muscle,
                       double gap_step,
                       MotionPacker* packer) {
  std::vector<int> gaps;
  std::vector<const Points*> points;
  std::vector<std::vector<const Points*>> lines, fibres, tendons;
  for (std::size_t pose = 0; pose < muscle.points.size(); ++pose) {
    points.push_back(&muscle.points[pose]);
    for (const double gap : muscle.gaps[pose]) {
      // Gaps are rounded away from zero, so that what is inside stays inside.
      const double steps = gap / gap_step;
      gaps.push_back(static_cast<int>(
          std::max(-100.0, steps < 0 ? std::floor(steps) : std::ceil(steps))));
    }
    lines.emplace_back();
    for (const NamedLine& line : muscle.lines[pose].lines) {
      lines.back().push_back(&line.points);
    }
    fibres.emplace_back();
    for (const Points& fibre : muscle.lines[pose].fibres) {
      fibres.back().push_back(&fibre);
    }
    tendons.emplace_back();
    for (const Points& tendon : muscle.lines[pose].tendons) {
      tendons.back().push_back(&tendon);
    }
  }
  OrderedJson names = OrderedJson::array();
  for (const NamedLine& line : muscle.lines[0].lines) {
    names.push_back(line.name);
  }
  const int vertices = static_cast<int>(muscle.points[0].rows());
  PackedNumbers* packed = packer->packed();
  OrderedJson line_json = PolylinesJson(lines, packer);
  line_json["names"] = names;
  return {{"name", muscle.name},
          {"vertices", vertices},
          {"triangles", packed->Add(muscle.triangles)},
          {"motion", packer->Add(points)},
          {"gaps", packed->Add(gaps, vertices)},
          {"attached", AreasJson(muscle.attached, packed)},
          {"lines", line_json},
          {"fibres", PolylinesJson(fibres, packer)},
          {"tendons", PolylinesJson(tendons, packer)}};
}

OrderedJson BoneJson(const RecordedBone& bone,
                     double step,
                     const PageOptions& options,
                     PackedNumbers* packed) {
  OrderedJson json = BoneShapeJson(
      bone.name, bone.rest, step, options.max_bone_triangles, packed);
  OrderedJson poses = OrderedJson::array();
  for (const Eigen::Matrix4d& motion : bone.from_rest) {
    OrderedJson rows = OrderedJson::array();
    for (int i = 0; i < 12; ++i) rows.push_back(motion(i / 4, i % 4));
    poses.push_back(rows);
  }
  json["poses"] = poses;
  return json;
}

// Returns what crosses, by pose. Triangles of bones are left out, because the
// page shows simplified bones with other triangles.
OrderedJson CrossingsJson(const RecordedRun& run, PackedNumbers* packed) {
  const auto is_muscle = [&](const std::string& name) {
    return std::any_of(run.muscles.begin(),
                       run.muscles.end(),
                       [&](const auto& muscle) { return muscle.name == name; });
  };
  OrderedJson poses = OrderedJson::array();
  for (const SceneIntersections& intersections : run.intersections) {
    OrderedJson pairs = OrderedJson::array();
    for (const PairFigures& pair : intersections.pairs) {
      OrderedJson json = {{"a", pair.a},
                          {"b", pair.b},
                          {"triangle_pairs", pair.triangle_pairs},
                          {"vertices_inside", pair.vertices_inside},
                          {"max_depth_mm", pair.max_depth_mm},
                          {"a_triangles", packed->Add(pair.triangles_of_a, 1)}};
      if (is_muscle(pair.b)) {
        json["b_triangles"] = packed->Add(pair.triangles_of_b, 1);
      }
      pairs.push_back(json);
    }
    poses.push_back(pairs);
  }
  return poses;
}

// Returns the moment arms of a line in all frames, or nothing if one lacks
// them.
std::optional<std::vector<double>> RecordedMomentArms(
    const RecordedRun& run,
    std::size_t muscle,
    const std::string& line,
    const std::string& coordinate) {
  std::vector<double> arms;
  for (const FrameFigures& frame : run.frames) {
    const auto& lines = frame.muscles.at(muscle).line_moment_arms;
    const auto of_line = lines.find(line);
    if (of_line == lines.end()) return std::nullopt;
    const auto arm = of_line->second.find(coordinate);
    if (arm == of_line->second.end()) return std::nullopt;
    arms.push_back(arm->second);
  }
  return arms;
}

// Returns the moment arms of the lines that muscles carry, over the frames, in
// mm (mm/m for a translation), if a single coordinate moves; otherwise null.
// Runs that do not have them get differences of the lengths.
OrderedJson CarriedMomentArmsJson(const RecordedRun& run) {
  const OrderedJson motion = run.report.value("motion", OrderedJson());
  if (motion.is_null()) return nullptr;
  std::vector<OrderedJson> moving;
  for (const OrderedJson& coordinate : motion.at("coordinates")) {
    if (coordinate.at("moves").get<bool>()) moving.push_back(coordinate);
  }
  if (moving.size() != 1 || run.frames.size() < 2) return nullptr;
  const std::string name = moving[0].at("name");
  const double unit = moving[0].at("unit") == "degrees" ? kRadiansPerDegree : 1;
  std::vector<double> values;
  for (const FrameFigures& frame : run.frames) {
    const auto value = frame.coordinates.find(name);
    if (value == frame.coordinates.end()) return nullptr;
    values.push_back(unit * value->second);
  }
  OrderedJson arms;
  for (std::size_t m = 0; m < run.frames[0].muscles.size(); ++m) {
    const MuscleFigures& muscle = run.frames[0].muscles[m];
    for (const auto& item : muscle.line_lengths) {
      std::vector<double> lengths;
      for (const FrameFigures& frame : run.frames) {
        lengths.push_back(frame.muscles.at(m).line_lengths.at(item.first));
      }
      arms[muscle.name][item.first] =
          RecordedMomentArms(run, m, item.first, name)
              .value_or(SeriesMomentArms(lengths, values));
    }
  }
  return {{"coordinate", name}, {"muscles", arms}};
}

// Returns "anna/flexion" for the two last parts of "out/anna/flexion/".
std::string LastParts(const std::string& dir, int count) {
  auto path = std::filesystem::absolute(dir).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  std::filesystem::path last = path.filename();
  for (int i = 1; i < count && path.has_relative_path(); ++i) {
    path = path.parent_path();
    last = path.filename() / last;
  }
  return last.generic_string();
}

// Returns the names of the runs on the page: the last parts of their folders,
// as many as tell them apart.
std::vector<std::string> Labels(const std::vector<RecordedRun>& runs) {
  constexpr int kMostParts = 8;
  std::vector<std::string> labels;
  for (int count = 1; count <= kMostParts; ++count) {
    labels.clear();
    for (const RecordedRun& run : runs) {
      labels.push_back(LastParts(run.dir, count));
    }
    const std::set<std::string> different(labels.begin(), labels.end());
    if (different.size() == labels.size()) break;
  }
  return labels;
}

OrderedJson RunJson(const RecordedRun& run,
                    const std::string& label,
                    const PageOptions& options,
                    PackedNumbers* packed) {
  const double step = StepOf(run);
  MotionPacker packer(options.position_tolerance * run.body_size, packed);
  OrderedJson muscles = OrderedJson::array();
  for (const RecordedMuscle& muscle : run.muscles) {
    muscles.push_back(MuscleJson(muscle, GapStepOf(run), &packer));
  }
  OrderedJson bones = OrderedJson::array();
  for (const RecordedBone& bone : run.bones) {
    bones.push_back(BoneJson(bone, step, options, packed));
  }
  OrderedJson report = run.report;
  report.erase("frames");

  return {{"folder", label},
          {"report", report},
          {"frames", ShownFrames(run.frames)},
          {"step_mm", step},
          {"position_error_mm", packer.max_error()},
          {"gap_step_mm", GapStepOf(run)},
          {"contact_gap_mm", kContactGap * run.body_size},
          {"muscles", muscles},
          {"bones", bones},
          {"crossings", CrossingsJson(run, packed)},
          {"carried_moment_arms_mm", CarriedMomentArmsJson(run)},
          {"warnings", run.warnings}};
}

OrderedJson ViewsJson(const RecordedRun& run, const PageOptions& options) {
  const auto chosen = [&](const std::string& option, const char* key) {
    return option.empty() ? run.report.at(key).get<std::string>() : option;
  };
  const std::string axes = chosen(options.axes, "axes");
  const std::string side = chosen(options.side, "side");
  OrderedJson views;
  for (const char* name :
       {"anterior", "posterior", "lateral", "medial", "superior", "inferior"}) {
    views[name] = ViewJson(ParseView(name, axes, side));
  }
  return views;
}

OrderedJson MeasuredJson(const MeasuredArms& measured, const ArmsOfRun& run) {
  OrderedJson list = OrderedJson::array();
  for (const MeasuredArm& arm : measured.arms) {
    const std::optional<ArmPlace> place = PlaceOf(arm, run);
    if (!place) continue;
    const double sign = place->turned ? -1 : 1;
    list.push_back(
        {{"coordinate", place->coordinate},
         {"muscles", place->muscles},
         {"measured", arm.joint + " " + arm.coordinate + ", " + arm.muscle},
         {"turned", place->turned},
         {"angle",
          arm.angle_deg ? OrderedJson(sign * *arm.angle_deg) : OrderedJson()},
         {"arm_mm", sign * arm.arm_mm},
         {"sd_mm", arm.sd_mm ? OrderedJson(*arm.sd_mm) : OrderedJson()},
         {"source", arm.source},
         {"detail", arm.detail}});
  }
  if (measured.arms.empty()) return nullptr;
  return {{"arms", list}, {"note", MeasuredNote(measured, run)}};
}

}  // namespace

ArmsOfRun ArmsOf(const std::vector<RecordedRun>& runs) {
  ArmsOfRun arms;
  for (const RecordedRun& run : runs) {
    AddArms(MovingRotations(run.report), run.frames, &arms);
  }
  return arms;
}

PageContents PageContentsOf(const std::vector<RecordedRun>& runs,
                            const PageOptions& options) {
  PackedNumbers packed;
  PageContents contents;
  contents.json = {{"views", ViewsJson(runs.at(0), options)},
                   {"measured", MeasuredJson(options.measured, ArmsOf(runs))},
                   {"functions", options.path_table},
                   {"runs", OrderedJson::array()}};
  const std::vector<std::string> labels = Labels(runs);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    contents.json["runs"].push_back(
        RunJson(runs[i], labels[i], options, &packed));
  }
  RemoveFolders(&contents.json);
  contents.numbers = packed.Base64();
  return contents;
}

}  // namespace musclewarp
