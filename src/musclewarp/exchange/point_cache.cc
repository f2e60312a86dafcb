// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/point_cache.h"

#include <filesystem>
#include <fstream>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/binary_scalar.h"
#include "musclewarp/mesh_files/mesh_io.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// Throws InputError.
void CheckReplaceable(const std::string& dir) {
  if (!fs::exists(dir)) return;
  if (!fs::is_directory(dir)) {
    throw InputError(dir, "is no folder", "name another one in {out}");
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(dir)) {
    const fs::path extension = entry.path().extension();
    if (extension == ".obj" || extension == ".pc2") continue;
    throw InputError(dir,
                     "holds " + entry.path().filename().string() +
                         ", and would be replaced as a whole",
                     "name a new folder in {out}");
  }
}

// How samples are counted as frames.
struct SampleNumbers {
  float first = 0;
  float step = 1;
};

// Of frames that are not evenly spaced, samples keep their own numbers.
SampleNumbers SampleNumbersOf(const std::vector<int>& numbers) {
  if (numbers.empty()) return {};
  const int step = numbers.size() > 1 ? numbers[1] - numbers[0] : 1;
  for (size_t i = 1; i < numbers.size(); ++i) {
    if (numbers[i] - numbers[i - 1] != step) return {};
  }
  return {static_cast<float>(numbers[0]), static_cast<float>(step)};
}

std::string Header(Eigen::Index vertices, const std::vector<int>& frames) {
  const SampleNumbers numbers = SampleNumbersOf(frames);
  std::string bytes("POINTCACHE2\0", 12);
  AppendBytes<std::int32_t>(1, ByteOrder::kLittle, &bytes);  // version
  AppendBytes(static_cast<std::int32_t>(vertices), ByteOrder::kLittle, &bytes);
  AppendBytes(numbers.first, ByteOrder::kLittle, &bytes);
  AppendBytes(numbers.step, ByteOrder::kLittle, &bytes);  // frames per sample
  AppendBytes(
      static_cast<std::int32_t>(frames.size()), ByteOrder::kLittle, &bytes);
  return bytes;
}

class PointCaches {
 public:
  PointCaches(const fs::path& dir, const Animation& animation)
      : conversion_(GltfFromAxes(animation.axes)) {
    const auto add = [&](const std::vector<std::string>& names,
                         const std::vector<TriangleSoup>& soups) {
      for (size_t i = 0; i < names.size(); ++i) {
        WriteTriangleSoup((dir / (names[i] + ".obj")).string(),
                          {conversion_.Convert(soups[i].points),
                           conversion_.Convert(soups[i].triangles)});
        files_.emplace_back(dir / (names[i] + ".pc2"), std::ios::binary);
        files_.back() << Header(soups[i].points.rows(), animation.numbers);
      }
    };
    add(animation.names.muscles, animation.rest.muscles);
    add(animation.names.bones, animation.rest.bones);
  }

  void AddFrame(const RecordedPose& pose) {
    size_t file = 0;
    for (const auto* soups : {&pose.muscles, &pose.bones}) {
      for (const TriangleSoup& soup : *soups) {
        const Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> points =
            conversion_.Convert(soup.points).cast<float>();
        files_[file++].write(reinterpret_cast<const char*>(points.data()),
                             points.size() * sizeof(float));
      }
    }
  }

  // Throws InputError if anything could not be written.
  void Close(const std::string& dir) {
    for (std::ofstream& file : files_) {
      file.close();
      if (file) continue;
      throw InputError(
          dir, "cannot be written", "choose a folder on a disk with room");
    }
  }

 private:
  GltfConversion conversion_;
  std::vector<std::ofstream> files_;
};

}  // namespace

void WritePointCaches(const std::string& dir, const Animation& animation) {
  CheckReplaceable(dir);
  WriteFolderAtomically(dir, [&](const std::string& partial) {
    PointCaches caches(partial, animation);
    for (size_t i = 0; i < animation.times.size(); ++i) {
      caches.AddFrame(animation.read(static_cast<int>(i)));
    }
    caches.Close(dir);
  });
}

}  // namespace musclewarp
