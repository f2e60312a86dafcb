// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "musclewarp/base/input_error.h"

namespace musclewarp {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Returns a direction in body axes, which are left, posterior and superior.
Vector3d BodyDirection(char letter) {
  switch (letter) {
    case 'L':
      return Vector3d::UnitX();
    case 'R':
      return -Vector3d::UnitX();
    case 'P':
      return Vector3d::UnitY();
    case 'A':
      return -Vector3d::UnitY();
    case 'S':
      return Vector3d::UnitZ();
    case 'I':
      return -Vector3d::UnitZ();
    default:
      return Vector3d::Zero();
  }
}

// Returns the matrix whose columns are the axes of the meshes in body axes.
Matrix3d BodyFromMesh(const std::string& axes) {
  Matrix3d body_from_mesh = Matrix3d::Zero();
  for (std::size_t i = 0; i < std::min<std::size_t>(axes.size(), 3); ++i) {
    body_from_mesh.col(i) = BodyDirection(axes[i]);
  }
  return body_from_mesh;
}

// Returns the same for the value of a flag, after checking it.
Matrix3d CheckedBodyFromMesh(const std::string& axes) {
  if (!AreBodyAxes(axes)) {
    throw InputError("{axes}",
                     "'" + axes + "' does not name three different directions",
                     "give one letter for +x, +y and +z out of L or R, A or P, "
                     "S or I, such as LPS");
  }
  return BodyFromMesh(axes);
}

bool ParseVector(const std::string& text, Vector3d* vector) {
  std::istringstream in(text);
  char comma1 = 0, comma2 = 0;
  in >> (*vector)[0] >> comma1 >> (*vector)[1] >> comma2 >> (*vector)[2];
  return in && comma1 == ',' && comma2 == ',' && in.peek() == EOF &&
         vector->norm() > 0;
}

[[noreturn]] void FailView(const std::string& name) {
  throw InputError("{view}",
                   "'" + name + "' is not a view",
                   "use anterior, posterior, lateral, medial, left, right, "
                   "superior, inferior, or x,y,z or x,y,z;upx,upy,upz");
}

View ViewFromVectors(const std::string& text, const Vector3d& superior) {
  const std::size_t semicolon = text.find(';');
  View view{Vector3d::Zero(), superior};
  if (!ParseVector(text.substr(0, semicolon), &view.toward_viewer) ||
      (semicolon != std::string::npos &&
       !ParseVector(text.substr(semicolon + 1), &view.up))) {
    FailView(text);
  }
  view.toward_viewer.normalize();
  view.up -= view.up.dot(view.toward_viewer) * view.toward_viewer;
  // Below this the two are parallel up to rounding.
  if (view.up.norm() < 1e-6) {
    throw InputError("{view}",
                     "'" + text + "' looks along its upward direction",
                     "give another one after a semicolon: x,y,z;upx,upy,upz");
  }
  view.up.normalize();
  return view;
}

char SideLetter(const std::string& side) {
  if (side == "right") return 'R';
  if (side == "left") return 'L';
  throw InputError("{side}",
                   "'" + side + "' is not a side of the body",
                   "use right or left");
}

}  // namespace

bool AreRightHanded(const std::string& axes) {
  return BodyFromMesh(axes).determinant() > 0;
}

bool AreBodyAxes(const std::string& axes) {
  return axes.size() == 3 && std::abs(BodyFromMesh(axes).determinant()) == 1;
}

View ParseView(const std::string& name,
               const std::string& axes,
               const std::string& side) {
  const Matrix3d mesh_from_body = CheckedBodyFromMesh(axes).transpose();
  const Vector3d superior = mesh_from_body * BodyDirection('S');
  const Vector3d anterior = mesh_from_body * BodyDirection('A');
  const Vector3d lateral = mesh_from_body * BodyDirection(SideLetter(side));
  const Vector3d left = mesh_from_body * BodyDirection('L');
  if (name == "anterior") return {anterior, superior};
  if (name == "posterior") return {-anterior, superior};
  if (name == "lateral") return {lateral, superior};
  if (name == "medial") return {-lateral, superior};
  if (name == "left") return {left, superior};
  if (name == "right") return {-left, superior};
  if (name == "superior") return {superior, anterior};
  if (name == "inferior") return {-superior, anterior};
  if (name.find(',') == std::string::npos) FailView(name);
  return ViewFromVectors(name, superior);
}

}  // namespace musclewarp
