// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/mesh_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "mesh_files/format_checks.h"
#include "musclewarp/base/input_error.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::string BytesOf(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

// What ReadTriangleSoup says of the file, "" if it reads it.
std::string ProblemWith(const std::string& path) {
  try {
    ReadTriangleSoup(path);
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(path));
    return error.what();
  }
  return "";
}

std::string ProblemWith(const std::string& name, const std::string& bytes) {
  const std::string path = TestTempDir() + "/" + name;
  std::ofstream(path, std::ios::binary) << bytes;
  return ProblemWith(path);
}

std::string TetrahedronBytes(const std::string& extension) {
  const std::string path = TestTempDir() + "/whole" + extension;
  WriteTriangleSoup(path, UnitTetrahedron());
  return BytesOf(path);
}

class MeshIoFormat : public ::testing::TestWithParam<const char*> {};

TEST_P(MeshIoFormat, KeepsEveryBitOfASoup) {
  const std::string path = TestTempDir() + "/soup" + GetParam();
  const TriangleSoup soup = HardSoup();
  WriteTriangleSoup(path, soup);
  EXPECT_TRUE(SameBits(ReadTriangleSoup(path), soup));
}

TEST_P(MeshIoFormat, WritesTheSameBytesAgain) {
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/a" + GetParam(), HardSoup());
  WriteTriangleSoup(dir + "/b" + GetParam(), HardSoup());
  EXPECT_EQ(BytesOf(dir + "/a" + GetParam()), BytesOf(dir + "/b" + GetParam()));
}

TEST_P(MeshIoFormat, IsChosenByExtensionInAnyCase) {
  const std::string extension = GetParam();
  std::string upper = extension;
  for (char& c : upper) c = std::toupper(c);
  EXPECT_TRUE(IsMeshExtension(extension));
  EXPECT_TRUE(IsMeshExtension(extension.substr(1)));
  EXPECT_TRUE(IsMeshExtension(upper));
  const std::string path = TestTempDir() + "/a.b" + upper;
  WriteTriangleSoup(path, UnitTetrahedron());
  EXPECT_TRUE(SameBits(ReadTriangleSoup(path), UnitTetrahedron()));
}

INSTANTIATE_TEST_SUITE_P(Double,
                         MeshIoFormat,
                         ::testing::Values(".ply",
                                           ".obj",
                                           ".off",
                                           ".vtk"
#ifdef MUSCLEWARP_WITH_VTK
                                           ,
                                           ".vtp"
#endif
                                           ),
                         [](const auto& test) {
                           return std::string(test.param + 1);
                         });

TEST(MeshIo, OtherExtensionsAreNoMeshes) {
  for (const char* extension : {"", ".", ".txt", "png", ".pl", ".plyx"}) {
    EXPECT_FALSE(IsMeshExtension(extension)) << extension;
  }
  EXPECT_TRUE(IsMeshExtension(".STL"));
#ifndef MUSCLEWARP_WITH_VTK
  EXPECT_FALSE(IsMeshExtension(".vtp"));
#endif
}

// Four corners, two triangles, in each text format.
constexpr char kPly[] =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\n"
    "property double y\nproperty double z\nelement face 2\n"
    "property list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
constexpr char kObj[] =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
constexpr char kOff[] =
    "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
constexpr char kStl[] =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
    "vertex 1 1 0\nendloop\nendfacet\nendsolid a\n";
constexpr char kVtk[] =
    "# vtk DataFile Version 3.0\na\nASCII\nDATASET POLYDATA\n"
    "POINTS 4 double\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
    "POLYGONS 2 8\n3 0 1 2\n3 0 2 3\n";

struct TextFormat {
  const char* name;
  const char* bytes;
  int first_index;  // Of vertices and faces.
};

class MeshIoText : public ::testing::TestWithParam<TextFormat> {
 protected:
  std::string ProblemWithChange(const std::string& old_part,
                                const std::string& new_part) {
    return ProblemWith(GetParam().name,
                       With(GetParam().bytes, old_part, new_part));
  }
};

TEST_P(MeshIoText, WholeFileReads) {
  EXPECT_EQ(ProblemWith(GetParam().name, GetParam().bytes), "");
}

TEST_P(MeshIoText, CoordinateThatIsNotFiniteIsNamed) {
  for (const char* bad : {"nan", "-inf", "1e999"}) {
    EXPECT_THAT(
        ProblemWithChange("1 1 0", std::string("1 ") + bad + " 0"),
        AllOf(HasSubstr("vertex " + std::to_string(2 + GetParam().first_index)),
              HasSubstr("must be finite")))
        << bad;
  }
}

TEST_P(MeshIoText, TinyCoordinateIsZero) {
  EXPECT_EQ(ProblemWithChange("1 1 0", "1 1e-999 0"), "");
}

TEST_P(MeshIoText, WordInPlaceOfANumberIsQuoted) {
  EXPECT_THAT(ProblemWithChange("1 1 0", "1 1,0 0"),
              AllOf(HasSubstr("'1,0'"), HasSubstr("line ")));
}

TEST_P(MeshIoText, BinaryJunkIsRefused) {
  std::string png = "\x89PNG\r\n\x1a\n";
  png.resize(3000, '\0');
  EXPECT_NE(ProblemWith(GetParam().name, png), "");
  EXPECT_NE(ProblemWith(GetParam().name,
                        "Dear reader,\nthis is a letter, not a mesh.\n"),
            "");
  EXPECT_NE(ProblemWith(GetParam().name, "\n"), "");
}

INSTANTIATE_TEST_SUITE_P(Formats,
                         MeshIoText,
                         ::testing::Values(TextFormat{"a.ply", kPly, 0},
                                           TextFormat{"a.obj", kObj, 1},
                                           TextFormat{"a.off", kOff, 0},
                                           TextFormat{"a.stl", kStl, 0},
                                           TextFormat{"a.vtk", kVtk, 0}),
                         [](const auto& test) {
                           return std::string(test.param.name + 2);
                         });

TEST(MeshIo, MissingFile) {
  EXPECT_THAT(ProblemWith(TestTempDir() + "/none.ply"),
              HasSubstr("does not exist"));
}

TEST(MeshIo, FolderInPlaceOfAFile) {
  const std::string path = TestTempDir() + "/folder.ply";
  fs::create_directory(path);
  EXPECT_THAT(ProblemWith(path), HasSubstr("is a folder"));
}

TEST(MeshIo, EmptyFile) {
  for (const char* name : {"a.ply", "a.obj", "a.off", "a.stl", "a.vtk"}) {
    EXPECT_THAT(ProblemWith(name, ""), HasSubstr("is empty")) << name;
  }
}

TEST(MeshIo, UnknownExtensionListsTheKnownOnes) {
  EXPECT_THAT(ProblemWith("a.png", "x"),
              AllOf(HasSubstr("'.png'"), HasSubstr(".ply, .obj, .off, .stl")));
  EXPECT_THAT(ProblemWith("mesh", "x"), HasSubstr("no extension"));
}

TEST(MeshIo, NoFaces) {
  EXPECT_THAT(ProblemWith("a.obj", "v 0 0 0\nv 1 0 0\n"),
              HasSubstr("no faces (2 vertices)"));
  EXPECT_THAT(ProblemWith("a.off", "OFF 1 0 0\n0 0 0\n"),
              HasSubstr("no faces"));
  EXPECT_THAT(ProblemWith("a.stl", "solid a\nendsolid a\n"),
              HasSubstr("no faces"));
  const std::string vtk = kVtk;
  EXPECT_THAT(ProblemWith("a.vtk", vtk.substr(0, vtk.find("POLYGONS"))),
              HasSubstr("no faces (4 vertices)"));
}

TEST(MeshIo, FaceOutOfRangeIsNamedWithItsVertex) {
  EXPECT_THAT(ProblemWith("a.ply", With(kPly, "3 0 2 3", "3 0 2 4")),
              AllOf(HasSubstr("line 15, face 1"),
                    HasSubstr("vertex 4, the file has 4 vertices")));
  EXPECT_THAT(ProblemWith("a.ply", With(kPly, "3 0 2 3", "3 0 -1 3")),
              HasSubstr("vertex -1"));
  EXPECT_THAT(ProblemWith("a.obj", With(kObj, "f 1 3 4", "f 1 3 5")),
              AllOf(HasSubstr("line 6, face 2"), HasSubstr("vertex 5")));
  EXPECT_THAT(ProblemWith("a.obj", With(kObj, "f 1 3 4", "f 1 0 4")),
              AllOf(HasSubstr("line 6"), HasSubstr("vertex 0")));
  EXPECT_THAT(ProblemWith("a.obj", With(kObj, "f 1 3 4", "f 1 -5 4")),
              HasSubstr("vertex -5"));
  EXPECT_THAT(ProblemWith("a.off", With(kOff, "3 0 2 3", "3 0 2 99")),
              AllOf(HasSubstr("line 8, face 1"), HasSubstr("vertex 99")));
  EXPECT_THAT(ProblemWith("a.vtk", With(kVtk, "3 0 2 3", "3 0 2 99")),
              AllOf(HasSubstr("face 1"), HasSubstr("vertex 99")));
}

TEST(MeshIo, FaceWithTwoCornersIsNamed) {
  EXPECT_THAT(ProblemWith("a.ply", With(kPly, "3 0 2 3", "2 0 2")),
              AllOf(HasSubstr("face 1"), HasSubstr("2 corners")));
  EXPECT_THAT(ProblemWith("a.obj", With(kObj, "f 1 3 4", "f 1 3")),
              AllOf(HasSubstr("face 2"), HasSubstr("2 corners")));
  EXPECT_THAT(ProblemWith("a.off", With(kOff, "3 0 2 3", "2 0 2")),
              AllOf(HasSubstr("face 1"), HasSubstr("2 corners")));
  EXPECT_THAT(
      ProblemWith("a.vtk", With(With(kVtk, "3 0 2 3", "2 0 2"), "2 8", "2 7")),
      AllOf(HasSubstr("face 1"), HasSubstr("2 corners")));
}

TEST(MeshIo, TextFileThatEndsEarly) {
  const auto without_last_line = [](std::string text) {
    text.pop_back();
    return text.substr(0, text.rfind('\n') + 1);
  };
  for (const auto& [name, bytes] : {std::pair("a.ply", kPly),
                                    std::pair("a.off", kOff),
                                    std::pair("a.stl", kStl),
                                    std::pair("a.vtk", kVtk)}) {
    EXPECT_THAT(ProblemWith(name, without_last_line(bytes)),
                HasSubstr("is truncated"))
        << name;
  }
}

// Binary formats: no shorter file may pass for a whole one. Files are removed
// before they are written again: writing over one may wait for the disk.
class MeshIoBinary : public ::testing::TestWithParam<const char*> {};

TEST_P(MeshIoBinary, EveryTruncationIsSeen) {
  const std::string whole = TetrahedronBytes(GetParam());
  const std::string path = TestTempDir() + "/cut" + GetParam();
  // The last byte is a line end that may be missing.
  for (std::size_t size = 0; size + 1 < whole.size(); ++size) {
    fs::remove(path);
    std::ofstream(path, std::ios::binary) << whole.substr(0, size);
    EXPECT_NE(ProblemWith(path), "") << size << " of " << whole.size();
  }
}

TEST_P(MeshIoBinary, FlippedBytesNeverGetPastTheChecks) {
  const std::string whole = TetrahedronBytes(GetParam());
  const std::string path = TestTempDir() + "/flipped" + GetParam();
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string flipped = whole;
    flipped[at] = static_cast<char>(flipped[at] ^ (at % 2 == 0 ? 0xff : 0x10));
    fs::remove(path);
    std::ofstream(path, std::ios::binary) << flipped;
    try {
      const TriangleSoup soup = ReadTriangleSoup(path);
      EXPECT_TRUE(soup.points.allFinite()) << at;
      EXPECT_GT(soup.triangles.rows(), 0) << at;
      EXPECT_GE(soup.triangles.minCoeff(), 0) << at;
      EXPECT_LT(soup.triangles.maxCoeff(), soup.points.rows()) << at;
    } catch (const InputError&) {
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats,
                         MeshIoBinary,
                         ::testing::Values(".ply",
                                           ".stl",
                                           ".vtk"
#ifdef MUSCLEWARP_WITH_VTK
                                           ,
                                           ".vtp"
#endif
                                           ),
                         [](const auto& test) {
                           return std::string(test.param + 1);
                         });

#ifdef MUSCLEWARP_WITH_VTK
TEST(MeshIo, ErrorsOfVtkAreCaughtNotPrinted) {
  // The blocks start with the two bytes that begin all zlib data.
  const std::string bytes = With(TetrahedronBytes(".vtp"), "==eA", "==AA");
  ::testing::internal::CaptureStderr();
  EXPECT_THAT(ProblemWith("a.vtp", bytes),
              AllOf(HasSubstr("piece 0, array 'Points'"),
                    HasSubstr("cannot be unpacked")));
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}
#else
TEST(MeshIo, VtpNeedsVtk) {
  EXPECT_THAT(ProblemWith("a.vtp", "<VTKFile>"),
              AllOf(HasSubstr("lacks"), HasSubstr("MUSCLEWARP_WITH_VTK")));
}
#endif

TEST(MeshIo, AWriteThatFailsLeavesNothing) {
  const std::string dir = TestTempDir();
  EXPECT_THROW(WriteTriangleSoup(dir + "/a.txt", UnitTetrahedron()),
               InputError);
  EXPECT_THROW(WriteTriangleSoup(dir + "/nowhere/a.ply", UnitTetrahedron()),
               InputError);
  TriangleSoup huge = UnitTetrahedron();
  huge.points(1, 0) = 1e39;
  EXPECT_THROW(WriteTriangleSoup(dir + "/a.stl", huge), InputError);
  EXPECT_TRUE(fs::is_empty(dir));
}

}  // namespace
}  // namespace musclewarp
