// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/glb_container.h"

#include <filesystem>
#include <limits>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/binary_scalar.h"

namespace musclewarp {
namespace {

// Numbers of the glTF 2.0 specification.
constexpr std::uint32_t kMagic = 0x46546C67;  // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;

void AppendNumber(std::uint32_t value, std::string* bytes) {
  AppendBytes(value, ByteOrder::kLittle, bytes);
}

std::vector<float> ToVector(const Eigen::RowVectorXf& row) {
  return {row.data(), row.data() + row.size()};
}

}  // namespace

GlbArrays::GlbArrays(const std::string& path)
    : path_(path), file_(path, std::ios::binary) {}

GlbArrays::~GlbArrays() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

int GlbArrays::AddAccessor(const void* data,
                           std::size_t bytes,
                           int target,
                           nlohmann::ordered_json accessor) {
  file_.write(static_cast<const char*>(data),
              static_cast<std::streamsize>(bytes));
  nlohmann::ordered_json view = {
      {"buffer", 0}, {"byteOffset", size_}, {"byteLength", bytes}};
  if (target != 0) view["target"] = target;
  size_ += bytes;
  accessor["bufferView"] = views_.size();
  views_.push_back(std::move(view));
  accessors_.push_back(std::move(accessor));
  return static_cast<int>(accessors_.size()) - 1;
}

int GlbArrays::AddFloats(const Eigen::MatrixXf& values,
                         bool is_vertex_data,
                         bool has_bounds) {
  using RowMajor =
      Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const RowMajor rows = values;
  const char* const type = rows.cols() == 1   ? "SCALAR"
                           : rows.cols() == 3 ? "VEC3"
                                              : "VEC4";
  nlohmann::ordered_json accessor = {
      {"componentType", kFloat}, {"count", rows.rows()}, {"type", type}};
  if (has_bounds) {
    accessor["min"] = ToVector(rows.colwise().minCoeff());
    accessor["max"] = ToVector(rows.colwise().maxCoeff());
  }
  return AddAccessor(rows.data(),
                     rows.size() * sizeof(float),
                     is_vertex_data ? kArrayBuffer : 0,
                     std::move(accessor));
}

int GlbArrays::AddTriangles(const Triangles& triangles) {
  static_assert(sizeof(int) == sizeof(std::uint32_t));
  return AddAccessor(triangles.data(),
                     triangles.size() * sizeof(int),
                     kElementArrayBuffer,
                     {{"componentType", kUnsignedInt},
                      {"count", triangles.size()},
                      {"type", "SCALAR"}});
}

void GlbArrays::WriteGlb(const std::string& path,
                         const std::string& path_for_messages,
                         nlohmann::ordered_json json) {
  json["buffers"].push_back({{"byteLength", size_}});
  json["bufferViews"] = std::move(views_);
  json["accessors"] = std::move(accessors_);
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::uint64_t total = 12 + 8 + text.size() + 8 + size_;
  if (total > std::numeric_limits<std::uint32_t>::max()) {
    throw InputError(path_for_messages,
                     "would have " + std::to_string(total >> 20) +
                         " MB, which is more than the 4096 MB that the format "
                         "allows",
                     "export fewer frames, for example with {frames}=0:100:2");
  }
  std::string head;
  AppendNumber(kMagic, &head);
  AppendNumber(2, &head);
  AppendNumber(static_cast<std::uint32_t>(total), &head);
  AppendNumber(static_cast<std::uint32_t>(text.size()), &head);
  AppendNumber(kJsonChunk, &head);
  head += text;
  AppendNumber(static_cast<std::uint32_t>(size_), &head);
  AppendNumber(kBinaryChunk, &head);
  file_.close();
  std::ofstream out(path, std::ios::binary);
  out << head << std::ifstream(path_, std::ios::binary).rdbuf();
  out.close();
  if (!file_ || !out) {
    throw InputError(path_for_messages,
                     "cannot be written",
                     "choose a folder that exists, can be written and has "
                     "room for twice the file");
  }
}

}  // namespace musclewarp
