// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/measured_arms.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include "musclewarp/base/csv_table.h"
#include "musclewarp/base/text.h"

namespace musclewarp {
namespace {

// What OpenSim's models call the coordinates of joints.
struct ModelCoordinate {
  const char* joint;
  const char* measured;
  const char* name;
  bool turned;
};
constexpr std::array kModelCoordinates = {
    ModelCoordinate{"hip", "internal_rotation", "hip_rotation", false},
    ModelCoordinate{"knee", "flexion", "knee_angle", false},
    ModelCoordinate{"ankle", "plantarflexion", "ankle_angle", true},
    ModelCoordinate{"subtalar", "inversion", "subtalar_angle", false},
    ModelCoordinate{"foot", "inversion", "subtalar_angle", false},
    ModelCoordinate{"shoulder", "flexion", "arm_flex", false},
    ModelCoordinate{"shoulder", "abduction", "arm_add", true},
    ModelCoordinate{"shoulder", "internal_rotation", "arm_rot", false},
};

// Knees do not extend so far, degrees: those that seem to count flexion
// negative.
constexpr double kFarthestExtension = -20;

// Words for the same thing in names of muscles.
constexpr std::array<std::array<const char*, 2>, 2> kSameWords = {{
    {"peroneus", "fibularis"},
    {"achilles", "calcaneal"},
}};

std::string LowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return text;
}

// Returns the words of a name, without those that tell the side.
std::vector<std::string> WordsOf(const std::string& name) {
  static const std::set<std::string> kSides = {"r", "l", "right", "left", ""};
  std::string spaced = LowerCase(name);
  for (char& c : spaced) {
    if (c == ' ' || c == '-') c = '_';
  }
  std::vector<std::string> words;
  for (std::string& word : Split(spaced, '_')) {
    if (kSides.count(word) > 0) continue;
    for (const auto& [other, common] : kSameWords) {
      if (word == other) word = common;
    }
    words.push_back(std::move(word));
  }
  return words;
}

std::string WithoutSide(const std::string& name) {
  std::string joined;
  for (const std::string& word : WordsOf(name)) {
    joined += (joined.empty() ? "" : "_") + word;
  }
  return joined;
}

// Returns true if words are equal but for a Latin ending: medial, medialis.
bool IsAlike(const std::string& a, const std::string& b) {
  constexpr std::size_t kFewestLetters = 5;
  const std::size_t letters = std::min(a.size(), b.size());
  return a == b || (letters >= kFewestLetters &&
                    a.compare(0, letters, b, 0, letters) == 0);
}

bool HasAllWords(const std::string& muscle, const std::string& measured) {
  const std::vector<std::string> words = WordsOf(muscle);
  const std::vector<std::string> wanted = WordsOf(measured);
  return !wanted.empty() &&
         std::all_of(wanted.begin(), wanted.end(), [&](const auto& want) {
           return std::any_of(
               words.begin(), words.end(), [&](const auto& word) {
                 return IsAlike(word, want);
               });
         });
}

// Returns true if a measured arm is that of the tendon of a muscle.
bool PullsOn(const std::string& measured, const std::string& muscle) {
  return HasAllWords("calcaneal_tendon", measured) &&
         (HasAllWords(muscle, "soleus") ||
          HasAllWords(muscle, "gastrocnemius"));
}

// Returns whether a coordinate of a run is the measured one, and if so whether
// it counts the other way.
std::optional<bool> TurnedIn(const ArmsOfRun::Coordinate& coordinate,
                             const MeasuredArm& arm) {
  const std::string name = WithoutSide(coordinate.name);
  const std::string measured = WithoutSide(arm.coordinate);
  const std::string joint = WithoutSide(arm.joint);
  if (name == measured || name == joint + "_" + measured) return false;
  for (const ModelCoordinate& model : kModelCoordinates) {
    if (joint != model.joint || measured != model.measured) continue;
    if (name != model.name) continue;
    const bool bends_down =
        joint == "knee" && coordinate.lowest_deg < kFarthestExtension;
    return model.turned != bends_down;
  }
  return std::nullopt;
}

}  // namespace

MeasuredArms ReadMeasuredArms(const std::string& path) {
  const CsvTable table(path);
  table.Require({"coordinate", "muscle", "moment_arm_mm"});
  MeasuredArms measured;
  for (std::size_t row = 0; row < table.NumRows(); ++row) {
    const std::optional<double> value = table.Number(row, "moment_arm_mm");
    if (!value) {
      ++measured.rows_without_arm;
      continue;
    }
    MeasuredArm arm;
    arm.joint = table.Text(row, "joint");
    arm.coordinate = table.Text(row, "coordinate");
    arm.muscle = table.Text(row, "muscle");
    arm.angle_deg = table.Number(row, "angle_deg");
    arm.arm_mm = *value;
    arm.sd_mm = table.Number(row, "sd_mm");
    arm.source = table.Text(row, "source");
    arm.method = table.Text(row, "method");
    arm.condition = table.Text(row, "condition");
    for (const char* column :
         {"method", "condition", "read_as", "where", "doi_or_pmcid"}) {
      const std::string text = table.Text(row, column);
      if (text.empty()) continue;
      arm.detail += (arm.detail.empty() ? "" : "; ") + text;
    }
    measured.arms.push_back(std::move(arm));
  }
  return measured;
}

void AddArms(const std::vector<std::string>& rotations,
             const std::vector<FrameFigures>& frames,
             ArmsOfRun* arms) {
  for (const FrameFigures& frame : frames) {
    for (const MuscleFigures& muscle : frame.muscles) {
      if (std::count(arms->muscles.begin(), arms->muscles.end(), muscle.name) ==
          0) {
        arms->muscles.push_back(muscle.name);
      }
    }
  }
  for (const std::string& name : rotations) {
    if (std::any_of(arms->coordinates.begin(),
                    arms->coordinates.end(),
                    [&](const auto& other) { return other.name == name; })) {
      continue;
    }
    arms->coordinates.push_back({name, 0});
    double& lowest = arms->coordinates.back().lowest_deg;
    for (const FrameFigures& frame : frames) {
      const auto value = frame.coordinates.find(name);
      if (value == frame.coordinates.end()) continue;
      lowest = std::min(lowest, value->second);
    }
  }
}

std::optional<ArmPlace> PlaceOf(const MeasuredArm& arm, const ArmsOfRun& run) {
  ArmPlace place;
  for (const std::string& muscle : run.muscles) {
    if (PullsOn(arm.muscle, muscle)) place.muscles.push_back(muscle);
  }
  // A tendon alone stands for its muscles.
  if (place.muscles.empty()) {
    for (const std::string& muscle : run.muscles) {
      if (HasAllWords(muscle, arm.muscle)) place.muscles.push_back(muscle);
    }
  }
  if (place.muscles.empty()) return std::nullopt;
  for (const ArmsOfRun::Coordinate& coordinate : run.coordinates) {
    const std::optional<bool> turned = TurnedIn(coordinate, arm);
    if (!turned) continue;
    place.coordinate = coordinate.name;
    place.turned = *turned;
    return place;
  }
  return std::nullopt;
}

std::string MeasuredNote(const MeasuredArms& measured, const ArmsOfRun& run) {
  const auto belongs = std::count_if(
      measured.arms.begin(), measured.arms.end(), [&](const MeasuredArm& arm) {
        return PlaceOf(arm, run).has_value();
      });
  const std::size_t others = measured.arms.size() - belongs;
  std::string note = std::to_string(belongs) + " of " +
                     std::to_string(measured.arms.size()) +
                     " measured moment arms are laid over the plots";
  if (others > 0) {
    note += "; " + std::to_string(others) +
            " are of muscles or coordinates that do not move in this run";
  }
  if (measured.rows_without_arm > 0) {
    note += "; " + std::to_string(measured.rows_without_arm) +
            " rows have no moment arm";
  }
  return note;
}

}  // namespace musclewarp
