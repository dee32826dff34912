// SPDX-License-Identifier: Apache-2.0
#include "display/surface_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.hpp"
#include "crossgrain/solve.hpp"
#include "display/leaf_corner_means.hpp"
#include "display/region_sections.hpp"
#include "measure/alignment.hpp"
#include "measure/made_tets.hpp"
#include "support/shapes.hpp"
#include "tets/inner_walls.hpp"

namespace crossgrain {
namespace {

FieldData solved(const TriangleMesh& mesh, double resolution) {
  SolveOptions options;
  options.resolution = resolution;
  return solve(mesh, options).data();
}

ShownField shown(FieldData data) {
  return ShownField(FrameField(std::make_shared<const FieldData>(std::move(data))));
}

/// A box on a grid with a frame turned by this angle about z in all cells.
ShownField turned_box(double degrees) {
  FieldData data = solved(make_box({1, 1, 1}), 12);
  std::fill(data.frames.begin(), data.frames.end(), to_stored(turn_about_z(degrees)));
  return shown(std::move(data));
}

/// The point of a triangle with these barycentric coordinates.
SurfacePoint point_of(const SolvedSurface& surface, std::uint32_t triangle, float u, float v) {
  const auto& [a, b, c] = surface.triangles[triangle];
  const double du = static_cast<double>(u), dv = static_cast<double>(v);
  return {(1 - du - dv) * surface.vertices[a] + du * surface.vertices[b] + dv * surface.vertices[c], triangle,
          u, v};
}

bool is_across_z(const SolvedSurface& surface, std::uint32_t triangle) {
  const auto& [a, b, c] = surface.triangles[triangle];
  return surface.vertices[a][2] == surface.vertices[b][2] && surface.vertices[a][2] == surface.vertices[c][2];
}

/// Expects the angle of a frame turned about z on all faces of a box, up to their edges.
void expect_turned(const ShownField& field, double degrees, double tolerance) {
  const SurfaceNumbers numbers(field, SurfaceNumber::kAlignment);
  for (std::uint32_t t = 0; t < field.surface().triangles.size(); ++t)
    for (const auto& [u, v] : {std::array{0.3f, 0.3f}, {0.99f, 0.005f}, {0.f, 0.5f}, {0.f, 0.f}})
      EXPECT_NEAR(numbers.at(point_of(field.surface(), t, u, v)),
                  is_across_z(field.surface(), t) ? 0 : degrees, tolerance);
}

// Frames are stored in single precision, and the arc cosine near 1 shows its square root.
constexpr double kRoundingDeg = 0.05;

TEST(SurfaceNumbers, AreTheAngleOfOneFrameOnEachFaceOfABoxUpToItsEdges) {
  for (const double degrees : {0.0, 7.0, 17.0, 40.0})
    expect_turned(turned_box(degrees), degrees, kRoundingDeg);
}

TEST(SurfaceNumbers, DoNotTakeAxesOffToOppositeSidesForOneThatIsRight) {
  FieldData data = solved(make_box({1, 1, 1}), 12);
  for (CellIndex i = 0; i < data.tree.size(); ++i)
    data.frames[i] = to_stored(turn_about_z(data.tree.centre(i)[2] > 0 ? 40 : -40));
  const ShownField field = shown(std::move(data));
  expect_turned(field, 40, 1);
}

TEST(SurfaceNumbers, FollowACurvedSurfaceMoreCloselyThanTheFrameOfEachCell) {
  // The frames of cells around the axis of a cylinder, as their centres have them.
  FieldData data = solved(make_cylinder(0.5, 0.3, 256), 12);
  for (CellIndex i = 0; i < data.tree.size(); ++i) {
    const Vector3 centre = data.tree.centre(i);
    data.frames[i] = to_stored(from_rotation_vector({0, 0, std::atan2(centre[1], centre[0])}));
  }
  const ShownField field = shown(std::move(data));
  double worst = 0;
  for (const auto& sample : SurfaceNumbers(field, SurfaceNumber::kAlignment).samples())
    worst = std::max(worst, sample.number);
  // Cells are 1/12: a normal is up to 6.8 degrees off that of the cell's centre.
  EXPECT_LT(worst, 1.5);
}

TEST(SurfaceNumbers, AreEqualToALinearEnergyInside) {
  FieldData data = solved(make_box({1, 1, 1}), 12);
  const auto linear = [](const Vector3& place) { return 5 + place[0] + 2 * place[1] - place[2]; };
  for (CellIndex i = 0; i < data.tree.size(); ++i)
    data.energy_density[i] = static_cast<float>(linear(data.tree.centre(i)));
  const ShownField field = shown(std::move(data));
  const SurfaceNumbers numbers(field, SurfaceNumber::kEnergy);
  for (const Vector3& place : {Vector3{0, 0, 0}, {-0.19, 0.12, -0.1}, {-0.2, -0.17, 0.2}})
    EXPECT_NEAR(numbers.energy_at(place), linear(place), 1e-5);
  EXPECT_TRUE(std::isnan(numbers.energy_at({3, 0, 0})));
}

TEST(SurfaceNumbers, AreThoseOfCellsInThePartNotOfCellsThatDipIntoIt) {
  // Cells whose centre is outside have another energy.
  FieldData data = solved(make_box({1, 1, 1}), 11.3);
  for (CellIndex i = 0; i < data.tree.size(); ++i) {
    const Vector3 centre = data.tree.centre(i);
    const bool is_inside =
        std::all_of(centre.begin(), centre.end(), [](double x) { return std::abs(x) < 0.5; });
    data.energy_density[i] = is_inside ? 1 : 1000;
  }
  const ShownField field = shown(std::move(data));
  const SurfaceNumbers numbers(field, SurfaceNumber::kEnergy);
  double area = 0, off = 0;
  for (const auto& sample : numbers.samples()) {
    area += sample.area;
    if (sample.number > 400) off += sample.area;
  }
  EXPECT_NEAR(area, 6, 6 * 0.2);
  EXPECT_LT(off, 0.2 * area) << "only where there is no cell with its centre inside beside";
}

TEST(SurfaceNumbers, AtTheCornersOfLeavesGiveTheNumbersOnTheSurface) {
  const ShownField field = turned_box(10);
  const auto leaves =
      SurfaceNumbers(field, SurfaceNumber::kAlignment).at_leaf_corners(CornersOfLeaves(field.grid()));
  const auto& on_boundary = field.grid().on_boundary;
  EXPECT_EQ(leaves.size(), static_cast<std::size_t>(std::count(on_boundary.begin(), on_boundary.end(), 1)));
  for (const auto& [leaf, numbers] : leaves) {
    EXPECT_EQ(on_boundary[leaf], 1);
    for (const float number : numbers) {
      EXPECT_GE(number, 0.f);
      EXPECT_LE(number, 10.1f);
    }
  }
}

TEST(SurfaceNumbers, AreTheSameForAnyNumberOfThreads) {
  const ShownField field = turned_box(3);
  std::vector<double> first;
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    std::vector<double> now;
    for (const auto& sample : SurfaceNumbers(field, SurfaceNumber::kAlignment).samples())
      now.push_back(sample.number), now.push_back(sample.area);
    if (threads == 1) first = now;
    EXPECT_TRUE(now == first);
  }
}

/// A field on tets that turns about z by this angle per length along x.
ShownField turning_tets(double degrees_per_length, double degrees) {
  const TetDomain domain(tet_box({4, 3, 3}));
  auto field = std::make_shared<TetField>();
  for (const Vector3& vertex : domain.mesh().vertices)
    field->vertex_frames.push_back(turn_about_z(degrees + degrees_per_length * vertex[0]));
  field->tet_frames = tet_frames_of(domain.mesh(), field->vertex_frames);
  SolveOptions options;
  options.resolution = 6;
  const FrameField grid = solve(domain.boundary(), options);
  return ShownField(TetFrameField(grid, domain, std::move(field), grid.report()));
}

TEST(SurfaceNumbers, OfTetsAreTheAngleOfOneFrameOnEachFaceOfABox) {
  expect_turned(turning_tets(0, 20), 20, 1e-3);
  const ShownField field = turning_tets(0, 0);
  const auto at_vertices = SurfaceNumbers(field, SurfaceNumber::kAlignment).at_vertices();
  EXPECT_EQ(at_vertices.size(), field.surface().vertices.size());
  EXPECT_LT(*std::max_element(at_vertices.begin(), at_vertices.end()), 1e-3f);
}

TEST(SurfaceNumbers, OfTetsHaveTheEnergyOfATurn) {
  // A rotation by t costs (10/3) t^2 (docs/design.md, section 5).
  const ShownField field = turning_tets(0.5, 0);
  const SurfaceNumbers numbers(field, SurfaceNumber::kEnergy);
  const double turn_rad = 0.5 * std::numbers::pi / 180, expected = 10.0 / 3 * turn_rad * turn_rad;
  for (std::uint32_t tet = 0; tet < field.tets().solid.mesh.tets.size(); ++tet)
    EXPECT_NEAR(numbers.energy_of_tet(tet), expected, 1e-3 * expected);
  for (std::uint32_t t = 0; t < field.surface().triangles.size(); ++t)
    EXPECT_NEAR(numbers.at(point_of(field.surface(), t, 0.2f, 0.3f)), expected, 1e-3 * expected);
}

/// Two boxes side by side along x; the one on the low side is solid 7, the other 2.
TriangleMesh two_boxes() {
  const TetSolid solid = solid_of(
      with_regions(TetBox{{2, 1, 1}}.mesh(), [](const Vector3& place) { return place[0] < 1 ? 7 : 2; }));
  std::vector<Warning> warnings;
  return model_surface(solid, find_inner_walls(solid, warnings));
}

TEST(RegionSections, KnowTheSolidOfEachPointOfAPlane) {
  const FieldData data = solved(two_boxes(), 12);
  const SolvedSurface& surface = *data.surface.get();
  const Box& box = data.report.model.bounding_box;
  const double middle = 0.5 * (box.low[0] + box.high[0]);
  const RegionSections sections(surface, {2, 7}, 2, box.low[2] + 0.4);
  for (const double y : {0.03, 0.5, 0.97})
    for (const double off : {0.01, 0.5, 0.99}) {
      EXPECT_EQ(sections.at({middle - off, box.low[1] + y, 0}), 7);
      EXPECT_EQ(sections.at({middle + off, box.low[1] + y, 0}), 2);
    }
  EXPECT_EQ(sections.at({middle + 1.01, box.low[1] + 0.5, 0}), std::nullopt);
  EXPECT_EQ(sections.at({middle, box.low[1] - 0.5, 0}), std::nullopt);
}

}  // namespace
}  // namespace crossgrain
