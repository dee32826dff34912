// SPDX-License-Identifier: Apache-2.0
// Fields as whole arrays, against one cell, vertex or tet at a time.
#include <gtest/gtest.h>

#include "crossgrain/error.hpp"
#include "crossgrain/solve.hpp"
#include "field/field_data.hpp"
#include "support/shapes.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

FrameField solved_bracket() {
  SolveOptions options;
  options.resolution = 12;
  return solve(make_bracket(16), options);
}

/// The axes of the frame of a unit quaternion.
template <class Number>
Frame frame_of(const std::array<Number, 4>& q) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  return {{{{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
            {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
            {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}}}};
}

void expect_near(const Frame& a, const Frame& b, double tolerance) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a.axes[axis][k], b.axes[axis][k], tolerance);
}

template <class Call>
ErrorKind error_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.kind();
  }
  ADD_FAILURE() << "no error";
  return ErrorKind::kInterrupted;
}

TEST(FrameField, GivesArraysOfWhatItsCellsHave) {
  const FrameField field = solved_bracket();
  const auto centers = field.centers();
  const auto sizes = field.sizes();
  const auto levels = field.levels();
  const auto frames = field.frames();
  const auto quaternions = field.quaternions();
  ASSERT_EQ(centers.size(), field.size());
  ASSERT_EQ(quaternions.size(), field.size());
  for (std::size_t i = 0; i < field.size(); ++i) {
    const FrameField::Cell cell = field.cell(i);
    EXPECT_EQ(centers[i], cell.center);
    EXPECT_EQ(sizes[i], cell.size);
    EXPECT_EQ(levels[i], cell.depth);
    EXPECT_EQ(frames[i].axes, cell.frame.axes);
    expect_near(frame_of(quaternions[i]), cell.frame, 1e-6);  // single precision
  }
}

TEST(FrameField, ClassifiesTheCellsThatHoldSurfaceAndMeasuresTheirAlignment) {
  const FrameField field = solved_bracket();
  const auto classes = field.constraint_classes();
  const auto alignment = field.alignment_deg();
  const auto density = field.energy_density();
  ASSERT_EQ(classes.size(), field.size());
  ASSERT_EQ(alignment.size(), field.size());
  ASSERT_EQ(density.size(), field.size());
  EXPECT_TRUE(field.regions().empty()) << "one solid";
  double energy = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    EXPECT_EQ(classes[i] != CellConstraint::kNoSurface, field.cell(i).on_boundary);
    if (classes[i] == CellConstraint::kNoSurface) {
      EXPECT_EQ(alignment[i], 0);
    }
    energy += static_cast<double>(density[i]) * field.cell(i).size * field.cell(i).size * field.cell(i).size;
  }
  EXPECT_NEAR(energy, field.report().energy.smoothness, 1e-4 * energy);
}

TEST(FrameField, RefusesCellsAndSpansThatDoNotFit) {
  const FrameField field = solved_bracket();
  EXPECT_EQ(error_of([&] { field.cell(field.size()); }), ErrorKind::kUsage);
  const std::vector<Vector3> points(3);
  std::vector<FrameField::Sample> samples(2);
  EXPECT_EQ(error_of([&] { field.sample(points, samples); }), ErrorKind::kUsage);
}

TEST(TetFrameField, GivesArraysOfWhatItsVerticesAndTetsHave) {
  const TetDomain domain(TetBox{{2, 2, 2}}.mesh(0.1));
  const TetFrameField field = solve_onto(domain);
  const auto vertices = field.vertex_frames(), tets = field.tet_frames();
  ASSERT_EQ(vertices.size(), domain.mesh().vertices.size());
  ASSERT_EQ(tets.size(), domain.mesh().tets.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    EXPECT_EQ(vertices[i].axes, field.vertex_frame(i).axes);
    expect_near(frame_of(field.vertex_quaternions()[i]), vertices[i], 1e-14);
  }
  for (std::size_t i = 0; i < tets.size(); ++i) {
    EXPECT_EQ(tets[i].axes, field.tet_frame(i).axes);
    expect_near(frame_of(field.tet_quaternions()[i]), tets[i], 1e-14);
  }
  EXPECT_EQ(error_of([&] { field.vertex_frame(vertices.size()); }), ErrorKind::kUsage);
  EXPECT_EQ(error_of([&] { field.tet_frame(tets.size()); }), ErrorKind::kUsage);
}

}  // namespace
}  // namespace crossgrain
