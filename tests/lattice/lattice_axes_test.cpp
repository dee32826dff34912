// SPDX-License-Identifier: Apache-2.0
#include "lattice/lattice_axes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/vector3.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

Surface surface_of(TriangleMesh mesh) {
  return prepare_surface(CheckedMesh::derived(std::move(mesh)));
}

/// How far each axis of one frame is from the nearest of another, in radians, at most.
double angle_between(const Quaternion& a, const Quaternion& b) {
  double most = 0;
  for (const Vector3& of_a : axes_of(a)) {
    double nearest = 10;
    for (const Vector3& of_b : axes_of(b)) nearest = std::min(nearest, norm(cross(of_a, of_b)));
    most = std::max(most, nearest);
  }
  return most;
}

TEST(LatticeAxes, OfATurnedBoxAreItsOwn) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-3, 3);
  for (int k = 0; k < 20; ++k) {
    const Quaternion turn = from_rotation_vector({any(random), any(random), any(random)});
    const Surface surface = surface_of(rotate_mesh(make_box({1, 2, 3}), turn));
    const double is_worth = 1 - alignment_with(surface, Quaternion());
    const Quaternion axes = lattice_axes(surface);
    EXPECT_LT(angle_between(axes, is_worth > kAxesGain ? turn : Quaternion()), 1e-7) << k;
  }
}

TEST(LatticeAxes, StayThoseOfTheCoordinatesWhereTurningGainsNothing) {
  for (const TriangleMesh& mesh : {make_box({1, 1, 1}), make_sphere(1, 3), make_cylinder(1, 2, 32)}) {
    const Quaternion axes = lattice_axes(surface_of(mesh));
    EXPECT_EQ(axes.w, 1);
    EXPECT_EQ(axes.x, 0);
  }
}

TEST(LatticeAxes, AreExactOnTheLargeFacesBesideSlantedOnes) {
  // A bracket has a cylindrical hole: its normals pull the mean towards nothing in particular.
  const Quaternion turn = from_rotation_vector({0.3, -0.2, 0.5});
  EXPECT_LT(angle_between(lattice_axes(surface_of(rotate_mesh(make_bracket(24), turn))), turn), 1e-7);
}

TEST(LatticeAxes, AlignFromAThirdToOne) {
  EXPECT_NEAR(alignment_with(surface_of(make_box({1, 2, 3})), Quaternion()), 1, 1e-12);
  EXPECT_NEAR(alignment_with(surface_of(make_sphere(1, 4)), Quaternion()), 0.6, 1e-3);
}

}  // namespace
}  // namespace crossgrain
