// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/nrrd_voxels.h"

#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/mesh_files/export_advice.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

[[noreturn]] void ThrowEndsEarly(const std::string& file,
                                 std::uint64_t there,
                                 std::uint64_t needed,
                                 const char* what) {
  throw InputError(file,
                   "is truncated: it has " + std::to_string(there) + " " +
                       what + " of voxels, its header promises " +
                       std::to_string(needed),
                   kCopyAgain);
}

std::string_view WithoutLines(const std::string& file,
                              std::int64_t lines,
                              std::string_view bytes) {
  for (std::int64_t i = 0; i < lines; ++i) {
    const std::size_t end = bytes.find('\n');
    if (end == std::string_view::npos) {
      throw InputError(file,
                       "has fewer than the " + std::to_string(lines) +
                           " lines that are to be skipped",
                       kCopyAgain);
    }
    bytes.remove_prefix(end + 1);
  }
  return bytes;
}

// Decompresses at most `most` bytes. A gzip file may have several members.
class Unpacker {
 public:
  explicit Unpacker(std::string_view packed) : packed_(packed) {
    constexpr int kAnyHeader = 15 + 32;
    inflateInit2(&stream_, kAnyHeader);
  }
  ~Unpacker() { inflateEnd(&stream_); }
  Unpacker(const Unpacker&) = delete;
  Unpacker& operator=(const Unpacker&) = delete;

  std::string Unpack(const std::string& file, std::size_t most) {
    std::string bytes;
    while (bytes.size() < most) {
      FeedPacked();
      const std::size_t before = bytes.size();
      bytes.resize(std::min(most, before + kStep));
      stream_.next_out = reinterpret_cast<Bytef*>(bytes.data() + before);
      stream_.avail_out = static_cast<uInt>(bytes.size() - before);
      const int outcome = inflate(&stream_, Z_NO_FLUSH);
      bytes.resize(bytes.size() - stream_.avail_out);
      const bool is_over = stream_.avail_in == 0 && packed_.empty();
      if (outcome == Z_STREAM_END && !is_over) {
        inflateReset(&stream_);
      } else if (outcome == Z_STREAM_END || outcome == Z_BUF_ERROR) {
        break;
      } else if (outcome != Z_OK) {
        throw InputError(
            file, "cannot be unpacked: its gzip data are damaged", kCopyAgain);
      }
    }
    return bytes;
  }

 private:
  static constexpr std::size_t kStep = 1 << 26;

  void FeedPacked() {
    if (stream_.avail_in > 0) return;
    const std::string_view part = packed_.substr(0, kStep);
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(part.data()));
    stream_.avail_in = static_cast<uInt>(part.size());
    packed_.remove_prefix(part.size());
  }

  std::string_view packed_;
  z_stream stream_ = {};
};

// Appends `count` numbers of a text as doubles in native byte order.
void AppendNumbers(const std::string& file,
                   std::string_view text,
                   std::int64_t count,
                   std::string* bytes) {
  constexpr std::string_view kBetween = " \t\r\n\v\f,";
  std::size_t begin = 0;
  for (std::int64_t i = 0; i < count; ++i) {
    begin = text.find_first_not_of(kBetween, begin);
    if (begin == std::string_view::npos) {
      ThrowEndsEarly(file, i, count, "numbers");
    }
    const std::size_t end =
        std::min(text.find_first_of(kBetween, begin), text.size());
    double number = 0;
    const auto [rest, error] =
        std::from_chars(text.data() + begin, text.data() + end, number);
    if (error != std::errc() || rest != text.data() + end) {
      throw InputError(file,
                       "has " + Quoted(text.substr(begin, end - begin)) +
                           ", which is no number, for voxel " +
                           std::to_string(i),
                       kCopyAgain);
    }
    AppendBytes(number, ByteOrder::kLittle, bytes);
    begin = end;
  }
}

// Appends the values in one of the files.
void AppendFile(const NrrdSource& source,
                const std::string& file,
                std::int64_t count,
                std::string* out) {
  const std::string all = ReadFile(file);
  std::string_view bytes = all;
  bytes.remove_prefix(std::min<std::size_t>(source.begin, bytes.size()));
  bytes = WithoutLines(file, source.line_skip, bytes);
  const std::size_t needed = count * SizeOf(source.type);
  const bool is_last = source.byte_skip < 0;
  const std::size_t skip = is_last ? 0 : source.byte_skip;
  std::string unpacked;
  if (source.encoding == NrrdEncoding::kGzip) {
    unpacked = Unpacker(bytes).Unpack(file, skip + needed);
    bytes = unpacked;
  }
  bytes.remove_prefix(std::min(skip, bytes.size()));
  if (source.encoding == NrrdEncoding::kText) {
    AppendNumbers(file, bytes, count, out);
    return;
  }
  if (bytes.size() < needed) {
    ThrowEndsEarly(file, bytes.size(), needed, "bytes");
  }
  out->append(bytes.substr(is_last ? bytes.size() - needed : 0, needed));
}

}  // namespace

NrrdVoxels ReadNrrdVoxels(const NrrdSource& source, std::int64_t count) {
  NrrdVoxels voxels;
  voxels.type = source.type;
  voxels.order = source.order;
  if (source.encoding == NrrdEncoding::kText) {
    voxels.type = ScalarType::kFloat64;
    voxels.order = ByteOrder::kLittle;
  }
  const auto files = static_cast<std::int64_t>(source.files.size());
  if (count % files != 0) {
    throw InputError(source.files[0],
                     "is one of " + std::to_string(files) +
                         " files of the same size for " +
                         std::to_string(count) + " voxels",
                     "check the list of files, or save one .nrrd file");
  }
  for (const std::string& file : source.files) {
    AppendFile(source, file, count / files, &voxels.bytes);
  }
  return voxels;
}

}  // namespace musclewarp
