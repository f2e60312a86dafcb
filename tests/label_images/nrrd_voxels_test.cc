// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/nrrd_voxels.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

constexpr int kValues = 6;

// The values 0, 300, 600, ... of voxels, as `order` has them.
std::string RawValues(ByteOrder order) {
  std::string bytes;
  for (int i = 0; i < kValues; ++i) {
    AppendBytes<std::uint16_t>(
        static_cast<std::uint16_t>(300 * i), order, &bytes);
  }
  return bytes;
}

std::string Gzipped(const std::string& bytes) {
  constexpr int kGzip = 15 + 16;
  z_stream stream = {};
  deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, kGzip, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, bytes.size()), 0);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

NrrdSource Source(NrrdEncoding encoding,
                  const std::vector<std::string>& contents) {
  NrrdSource source;
  source.encoding = encoding;
  source.type = ScalarType::kUInt16;
  const std::string dir = TestTempDir();
  for (const std::string& bytes : contents) {
    source.files.push_back(dir + "/" + std::to_string(source.files.size()));
    WriteTextAtomically(source.files.back(), bytes);
  }
  return source;
}

void ExpectValues(const NrrdSource& source) {
  const NrrdVoxels voxels = ReadNrrdVoxels(source, kValues);
  for (int i = 0; i < kValues; ++i) EXPECT_EQ(voxels.At(i), 300 * i);
}

void ExpectVoxelsRefused(const NrrdSource& source,
                         const std::vector<std::string>& words) {
  ExpectInputError([&] { ReadNrrdVoxels(source, kValues); }, words);
}

}  // namespace

TEST(NrrdVoxels, AreTheSameInEveryEncoding) {
  for (const ByteOrder order : {ByteOrder::kLittle, ByteOrder::kBig}) {
    const std::string raw = RawValues(order);
    NrrdSource source = Source(NrrdEncoding::kRaw, {raw});
    source.order = order;
    ExpectValues(source);
    source = Source(NrrdEncoding::kGzip, {Gzipped(raw)});
    source.order = order;
    ExpectValues(source);
  }
  ExpectValues(Source(NrrdEncoding::kText, {"0 300\t600\r\n900, 1200 1500\n"}));
}

TEST(NrrdVoxels, MayBeInSeveralFilesAndMembers) {
  const std::string raw = RawValues(ByteOrder::kLittle);
  const std::string begin = raw.substr(0, 6), end = raw.substr(6);
  ExpectValues(Source(NrrdEncoding::kRaw, {begin, end}));
  ExpectValues(Source(NrrdEncoding::kText, {"0 300 600", "900 1200 1500"}));
  ExpectValues(Source(NrrdEncoding::kGzip, {Gzipped(begin), Gzipped(end)}));
  ExpectValues(Source(NrrdEncoding::kGzip, {Gzipped(begin) + Gzipped(end)}));
  ExpectVoxelsRefused(Source(NrrdEncoding::kRaw, {raw, raw, raw, raw}),
                      {"one of 4 files", "6 voxels"});
}

// Lines are skipped in the file, bytes where it is unpacked.
TEST(NrrdVoxels, MayStandBehindOtherData) {
  const std::string raw = RawValues(ByteOrder::kLittle);
  NrrdSource source = Source(NrrdEncoding::kRaw, {"a\nb\nxyz" + raw});
  source.line_skip = 2;
  source.byte_skip = 3;
  ExpectValues(source);
  source = Source(NrrdEncoding::kRaw, {"anything" + raw});
  source.byte_skip = -1;
  ExpectValues(source);
  source = Source(NrrdEncoding::kGzip, {"a\nb\n" + Gzipped("xyz" + raw)});
  source.line_skip = 2;
  source.byte_skip = 3;
  ExpectValues(source);
  source = Source(NrrdEncoding::kText, {"a\n0 300 600 900 1200 1500"});
  source.line_skip = 1;
  ExpectValues(source);
  source.line_skip = 3;
  ExpectVoxelsRefused(source, {"fewer than the 3 lines"});
}

TEST(NrrdVoxels, DamagedDataAreRefused) {
  const std::string raw = RawValues(ByteOrder::kLittle);
  ExpectVoxelsRefused(
      Source(NrrdEncoding::kRaw, {raw.substr(1)}),
      {"is truncated: it has 11 bytes of voxels", "promises 12"});
  ExpectVoxelsRefused(
      Source(NrrdEncoding::kGzip, {Gzipped(raw.substr(2))}),
      {"is truncated: it has 10 bytes of voxels", "promises 12"});
  const std::string packed = Gzipped(raw);
  ExpectVoxelsRefused(
      Source(NrrdEncoding::kGzip, {packed.substr(0, packed.size() / 2)}),
      {"is truncated"});
  ExpectVoxelsRefused(Source(NrrdEncoding::kGzip, {raw}), {"damaged"});
  ExpectVoxelsRefused(Source(NrrdEncoding::kText, {"0 300 600"}),
                      {"is truncated: it has 3 numbers", "promises 6"});
  ExpectVoxelsRefused(Source(NrrdEncoding::kText, {"0 300 x 1 2 3"}),
                      {"'x'", "no number", "voxel 2"});
}

}  // namespace musclewarp
