// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/vtk_errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkPoints.h>

namespace musclewarp {
namespace {

TEST(VtkErrorScope, KeepsTheFirstErrorAndPrintsNothing) {
  ::testing::internal::CaptureStderr();
  std::string first;
  {
    const VtkErrorScope errors;
    EXPECT_EQ(errors.FirstError(), "");
    const vtkNew<vtkPoints> points;
    vtkErrorWithObjectMacro(points, "it broke\nin two");
    vtkErrorWithObjectMacro(points, "and again");
    first = errors.FirstError();
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(first, "it broke");
}

TEST(VtkErrorScope, EndsWithItsErrors) {
  const vtkNew<vtkPoints> points;
  {
    const VtkErrorScope errors;
    vtkErrorWithObjectMacro(points, "it broke");
  }
  const VtkErrorScope errors;
  EXPECT_EQ(errors.FirstError(), "");
}

}  // namespace
}  // namespace musclewarp
