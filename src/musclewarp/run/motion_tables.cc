// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/motion_tables.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/scene/perturbed_poses.h"
#include "musclewarp/scene/scene_names.h"

namespace musclewarp {
namespace {

constexpr double kMetres = 1e-3;  // in a mm

using Series = std::vector<double>;

class TableBuilder {
 public:
  TableBuilder(const std::string& name,
               const std::vector<FrameFigures>& frames) {
    table_.name = name;
    table_.in_degrees = false;
    bool rises = true;
    for (size_t i = 0; i + 1 < frames.size(); ++i) {
      rises = rises && frames[i].time < frames[i + 1].time;
    }
    for (const FrameFigures& frame : frames) {
      table_.times.push_back(rises ? frame.time : frame.index);
    }
  }

  void Add(const std::string& label, Series values) {
    std::string unique = ColumnName(label);
    while (!labels_.insert(unique).second) unique += "_";
    table_.labels.push_back(unique);
    columns_.push_back(std::move(values));
  }

  StorageTable Table() {
    table_.values.resize(table_.times.size(), columns_.size());
    for (size_t k = 0; k < columns_.size(); ++k) {
      for (size_t i = 0; i < columns_[k].size(); ++i) {
        table_.values(i, k) = columns_[k][i];
      }
    }
    return table_;
  }

 private:
  StorageTable table_;
  std::vector<Series> columns_;
  std::set<std::string> labels_;
};

// One figure of every frame.
template <typename Figure>
Series SeriesOf(const std::vector<FrameFigures>& frames, const Figure& figure) {
  Series series;
  for (const FrameFigures& frame : frames) series.push_back(figure(frame));
  return series;
}

std::string FibreLabel(const std::string& muscle, size_t fibre) {
  return muscle + "_fibre_" + std::to_string(fibre + 1);
}

// A coordinate that the motion moves, in rad or m.
struct MovingCoordinate {
  std::string name;
  Series values;
};

std::vector<MovingCoordinate> MovingCoordinates(
    const std::vector<FrameFigures>& frames, const Scene& scene) {
  std::vector<MovingCoordinate> moving;
  if (!scene.model) return moving;
  for (const int index : scene.model->moving_coordinates) {
    const Coordinate& coordinate = scene.model->model.coordinates[index];
    const double unit =
        coordinate.kind == CoordinateKind::kRotational ? kRadiansPerDegree : 1;
    moving.push_back(
        {coordinate.name, SeriesOf(frames, [&](const FrameFigures& frame) {
           return unit * frame.coordinates.at(coordinate.name);
         })});
  }
  return moving;
}

Series LineLengths(const std::vector<FrameFigures>& frames,
                   size_t muscle,
                   const std::string& line) {
  return SeriesOf(frames, [&](const FrameFigures& frame) {
    return kMetres * frame.muscles[muscle].line_lengths.at(line);
  });
}

Series FibreLengths(const std::vector<FrameFigures>& frames,
                    size_t muscle,
                    size_t fibre) {
  return SeriesOf(frames, [&](const FrameFigures& frame) {
    return kMetres * frame.muscles[muscle].fibre_lengths[fibre];
  });
}

std::vector<std::string> CoordinateNames(const ModelPoses& poses) {
  std::vector<std::string> names;
  for (const int coordinate : MomentArmCoordinates(poses)) {
    names.push_back(poses.model.coordinates[coordinate].name);
  }
  return names;
}

using ArmsByLine = std::map<std::string, std::map<std::string, double>>;

// The moment arm of a line, mm, if the frame has it.
std::optional<double> ArmOfLine(const ArmsByLine& arms,
                                const std::string& line,
                                const std::string& coordinate) {
  const auto of_line = arms.find(line);
  if (of_line == arms.end()) return std::nullopt;
  const auto arm = of_line->second.find(coordinate);
  if (arm == of_line->second.end()) return std::nullopt;
  return arm->second;
}

// The same of a fibre. Its coordinates are those of the lines, but those by
// which no fibre is moved are left out.
std::optional<double> ArmOfFibre(const MuscleFigures& muscle,
                                 size_t fibre,
                                 const std::string& coordinate) {
  if (muscle.line_moment_arms.empty()) return std::nullopt;
  const auto arms = muscle.fibre_moment_arms.find(coordinate);
  return arms == muscle.fibre_moment_arms.end() ? 0 : arms->second[fibre];
}

// Adds a column of the moment arms that `arm` returns for each frame, mm. There
// is none if a frame lacks it.
template <typename Arm>
bool AddArms(const std::string& label,
             const std::vector<FrameFigures>& frames,
             const Arm& arm,
             TableBuilder* table) {
  Series series;
  for (const FrameFigures& frame : frames) {
    const std::optional<double> value = arm(frame);
    if (!value) return false;
    series.push_back(kMetres * *value);
  }
  table->Add(label, std::move(series));
  return true;
}

// Adds the columns of a line or fibre: the moment arms that the frames have or,
// if they have none, differences of lengths where these mean something.
template <typename Arm>
void AddCarriedArms(const std::string& label,
                    const Series& lengths_m,
                    const std::vector<std::string>& coordinates,
                    const std::vector<MovingCoordinate>& moving,
                    const std::vector<FrameFigures>& frames,
                    const Arm& arm,
                    TableBuilder* table) {
  bool has_arms = false;
  for (const std::string& coordinate : coordinates) {
    has_arms |= AddArms(
        label + "." + coordinate,
        frames,
        [&](const FrameFigures& frame) { return arm(frame, coordinate); },
        table);
  }
  if (has_arms || moving.size() != 1 || frames.size() < 2) return;
  table->Add(label + "." + moving[0].name,
             SeriesMomentArms(lengths_m, moving[0].values));
}

const std::vector<MuscleFigures>& MusclesOf(
    const std::vector<FrameFigures>& frames) {
  static const std::vector<MuscleFigures> kNone;
  return frames.empty() ? kNone : frames[0].muscles;
}

}  // namespace

std::vector<double> SeriesMomentArms(const std::vector<double>& lengths,
                                     const std::vector<double>& coordinates) {
  CHECK_EQ(lengths.size(), coordinates.size());
  // Coordinates come from files of some digits: below this they are equal.
  constexpr double kSame = 1e-9;
  const int count = static_cast<int>(lengths.size());
  const auto next = [&](int from, int step) {
    int i = from + step;
    while (i >= 0 && i < count &&
           std::abs(coordinates[i] - coordinates[from]) < kSame) {
      i += step;
    }
    return i >= 0 && i < count ? i : -1;
  };
  const auto slope = [&](int a, int b) {
    return (lengths[b] - lengths[a]) / (coordinates[b] - coordinates[a]);
  };
  // At the ends the parabola goes through two on the same side.
  const auto beyond = [&](int i, int neighbour, int step) {
    const int far = neighbour < 0 ? -1 : next(neighbour, step);
    const bool turns_round =
        far >= 0 && std::abs(coordinates[far] - coordinates[i]) < kSame;
    return turns_round ? -1 : far;
  };
  std::vector<double> arms(count, 0);
  for (int i = 0; i < count; ++i) {
    int a = next(i, -1);
    int b = next(i, 1);
    if (a < 0) a = beyond(i, b, 1);
    if (b < 0) b = beyond(i, a, -1);
    if (a < 0 && b < 0) continue;
    if (a < 0 || b < 0) {
      arms[i] = -slope(i, std::max(a, b));
    } else if (std::abs(coordinates[a] - coordinates[b]) < kSame) {
      arms[i] = -slope(a, i);  // the motion turns round here
    } else {
      // The slope of Newton's parabola at the value itself.
      const double bend =
          (slope(i, b) - slope(a, i)) / (coordinates[b] - coordinates[a]);
      arms[i] = -(slope(a, i) + bend * (coordinates[i] - coordinates[a]));
    }
  }
  return arms;
}

StorageTable LengthTable(const std::vector<FrameFigures>& frames) {
  TableBuilder table("lengths", frames);
  const auto& muscles = MusclesOf(frames);
  for (size_t m = 0; m < muscles.size(); ++m) {
    for (const auto& item : muscles[m].line_lengths) {
      const std::string& line = item.first;
      table.Add(line, LineLengths(frames, m, line));
      table.Add(line + "_path",
                SeriesOf(frames, [&](const FrameFigures& frame) {
                  return kMetres * frame.muscles[m].path_lengths.at(line);
                }));
    }
  }
  return table.Table();
}

StorageTable VolumeTable(const std::vector<FrameFigures>& frames) {
  TableBuilder table("volumes", frames);
  const auto& muscles = MusclesOf(frames);
  for (size_t m = 0; m < muscles.size(); ++m) {
    table.Add(muscles[m].name, SeriesOf(frames, [&](const FrameFigures& frame) {
                return kMetres * kMetres * kMetres * frame.muscles[m].volume;
              }));
  }
  return table.Table();
}

StorageTable FibreLengthTable(const std::vector<FrameFigures>& frames) {
  TableBuilder table("fibre_lengths", frames);
  const auto& muscles = MusclesOf(frames);
  for (size_t m = 0; m < muscles.size(); ++m) {
    for (size_t k = 0; k < muscles[m].fibre_lengths.size(); ++k) {
      table.Add(FibreLabel(muscles[m].name, k), FibreLengths(frames, m, k));
    }
  }
  return table.Table();
}

StorageTable MomentArmTable(const std::vector<FrameFigures>& frames,
                            const Scene& scene) {
  TableBuilder table("moment_arms", frames);
  if (!scene.model) return table.Table();
  const std::vector<std::string> coordinates = CoordinateNames(*scene.model);
  const auto moving = MovingCoordinates(frames, scene);
  const auto& muscles = MusclesOf(frames);
  for (size_t m = 0; m < muscles.size(); ++m) {
    for (const auto& item : muscles[m].line_lengths) {
      const std::string& line = item.first;
      AddCarriedArms(
          line,
          LineLengths(frames, m, line),
          coordinates,
          moving,
          frames,
          [&](const FrameFigures& frame, const std::string& coordinate) {
            return ArmOfLine(
                frame.muscles[m].line_moment_arms, line, coordinate);
          },
          &table);
      for (const std::string& coordinate : coordinates) {
        AddArms(
            line + "_path." + coordinate,
            frames,
            [&](const FrameFigures& frame) {
              return ArmOfLine(frame.path_moment_arms, line, coordinate);
            },
            &table);
      }
    }
  }
  return table.Table();
}

StorageTable FibreMomentArmTable(const std::vector<FrameFigures>& frames,
                                 const Scene& scene) {
  TableBuilder table("fibre_moment_arms", frames);
  if (!scene.model) return table.Table();
  const std::vector<std::string> coordinates = CoordinateNames(*scene.model);
  const auto moving = MovingCoordinates(frames, scene);
  const auto& muscles = MusclesOf(frames);
  for (size_t m = 0; m < muscles.size(); ++m) {
    for (size_t k = 0; k < muscles[m].fibre_lengths.size(); ++k) {
      AddCarriedArms(
          FibreLabel(muscles[m].name, k),
          FibreLengths(frames, m, k),
          coordinates,
          moving,
          frames,
          [&](const FrameFigures& frame, const std::string& coordinate) {
            return ArmOfFibre(frame.muscles[m], k, coordinate);
          },
          &table);
    }
  }
  return table.Table();
}

std::vector<std::string> MotionTableNames() {
  return {"lengths.sto",
          "volumes.sto",
          "moment_arms.sto",
          "fibre_lengths.sto",
          "fibre_moment_arms.sto"};
}

void WriteMotionTables(const std::vector<FrameFigures>& frames,
                       const Scene& scene,
                       const std::string& dir) {
  const StorageTable tables[] = {LengthTable(frames),
                                 VolumeTable(frames),
                                 MomentArmTable(frames, scene),
                                 FibreLengthTable(frames),
                                 FibreMomentArmTable(frames, scene)};
  for (const StorageTable& table : tables) {
    if (table.labels.empty()) continue;
    WriteTextAtomically(
        (std::filesystem::path(dir) / (table.name + ".sto")).string(),
        StorageText(table));
  }
}

}  // namespace musclewarp
