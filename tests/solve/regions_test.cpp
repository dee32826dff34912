// SPDX-License-Identifier: Apache-2.0
// Fields of models of several solids.
#include "measure/regions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "crossgrain/solve.hpp"
#include "field/field_data.hpp"
#include "harmonics/random_samples.hpp"
#include "measure/made_tets.hpp"
#include "support/shapes.hpp"
#include "tets/inner_walls.hpp"

namespace crossgrain {
namespace {

using testing::RandomSamples;

/// The surface of tets with their regions as solids.
TriangleMesh surface_of(const TetMesh& tets) {
  const TetSolid solid = solid_of(tets);
  std::vector<Warning> warnings;
  return model_surface(solid, find_inner_walls(solid, warnings));
}

SolveOptions cells_across(int resolution) {
  SolveOptions options;
  options.resolution = resolution;
  return options;
}

/// Angle in degrees from a direction to the nearest axis of the frame at a point.
double angle_deg(const FrameField& field, const Vector3& point, const Vector3& direction) {
  double cosine = 0;
  for (const Vector3& axis : field.sample(point).frame.axes)
    cosine = std::max(cosine, std::abs(dot(axis, direction)));
  return std::acos(std::min(1.0, cosine)) * 180 / std::numbers::pi;
}

/// A cylinder of radius 1 whose inner half is region 0.
TetMesh core_in_sleeve(std::uint32_t across = 8) {
  // Circles of radius 1/2 and 1: squares of tet_cylinder.
  return with_regions(tet_cylinder(across),
                      [](const Vector3& p) { return std::hypot(p[0], p[1]) < 0.5 ? 0 : 1; });
}

TetMesh box_in_box() {
  const auto region_of = [](const Vector3& p) {
    const Vector3 off = p - Vector3{3, 3, 3};
    return std::max({std::abs(off[0]), std::abs(off[1]), std::abs(off[2])}) < 1 ? 1 : 0;
  };
  return with_regions(TetBox{{6, 6, 6}}.mesh(), region_of);
}

/// Appends a polygon that is seen from outside the solid in this order.
void add_face(const std::vector<Vector3>& corners, std::int32_t solid, TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  for (std::uint32_t k = 2; k < corners.size(); ++k) {
    mesh.triangles.push_back({first, first + k - 1, first + k});
    mesh.solids.push_back(solid);
  }
}

/// A regular polygon in a plane across z, anticlockwise seen from above.
std::vector<Vector3> ring(double radius, double z, double phase, std::size_t count = 24) {
  std::vector<Vector3> points;
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(k) + phase) / static_cast<double>(count);
    points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
  }
  return points;
}

/// The faces between two rings of equal count, outward where the second is anticlockwise around the first.
void add_wall(const std::vector<Vector3>& low, const std::vector<Vector3>& high, std::int32_t solid,
              TriangleMesh& mesh) {
  for (std::size_t k = 0; k < low.size(); ++k) {
    const std::size_t next = (k + 1) % low.size();
    add_face({low[k], low[next], high[next], high[k]}, solid, mesh);
  }
}

std::vector<Vector3> reversed(std::vector<Vector3> points) {
  std::ranges::reverse(points);
  return points;
}

/// A round plate of radius 3 and thickness 2 with a hole of radius 1, and a pin in the hole with a collar of
/// radius `collar` on the plate, if that is more than 1. The polygons of the pin are those of the hole turned
/// by a share of their edge.
TriangleMesh plate_with_pin(double turn, double collar) {
  TriangleMesh mesh;
  const auto hole_low = ring(1, 0, 0), hole_high = ring(1, 2, 0), low = ring(3, 0, 0), high = ring(3, 2, 0);
  add_wall(low, high, 0, mesh);
  // Cut along the same diagonals as the wall of the pin.
  for (std::size_t k = 0; k < hole_low.size(); ++k) {
    const std::size_t next = (k + 1) % hole_low.size();
    add_face({hole_low[k], hole_high[k], hole_high[next], hole_low[next]}, 0, mesh);
  }
  add_wall(high, hole_high, 0, mesh);
  add_wall(hole_low, low, 0, mesh);
  const auto foot = ring(1, 0, turn), neck = ring(1, 2, turn);
  add_face(reversed(foot), 1, mesh);
  add_wall(foot, neck, 1, mesh);
  const auto under = ring(collar, 2, turn), top = ring(collar, 3.5, turn);
  if (collar > 1) add_wall(neck, under, 1, mesh);
  add_wall(under, top, 1, mesh);
  add_face(top, 1, mesh);
  return mesh;
}

std::vector<WarningKind> kinds_of(const std::vector<Warning>& warnings) {
  std::vector<WarningKind> kinds;
  for (const Warning& warning : warnings) kinds.push_back(warning.kind);
  return kinds;
}

TetMesh rotated(TetMesh mesh, const Quaternion& rotation) {
  for (Vector3& p : mesh.vertices) p = rotate(rotation, p);
  return mesh;
}

TEST(Regions, OfACoreInASleeveFollowTheFaceBetweenThemOnBothSides) {
  const FrameField field = solve(surface_of(core_in_sleeve(24)), cells_across(48));
  const SolveReport& report = field.report();
  EXPECT_TRUE(report.model.watertight);
  double mean_deg = 0;
  constexpr int kPlaces = 48;
  for (int k = 0; k < kPlaces; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.3) / kPlaces;
    const Vector3 radial{std::cos(angle), std::sin(angle), 0};
    for (const double radius : {0.485, 0.515})  // within half a cell of the face
      mean_deg += angle_deg(field, radius * radial + Vector3{0, 0, 0.1}, radial) / (2 * kPlaces);
  }
  EXPECT_LT(mean_deg, 1);
  ASSERT_TRUE(report.interfaces);
  // Its facets' normals are up to 3.75 degrees off the radial ones, 1.9 in the mean.
  EXPECT_LT(report.interfaces->mean, 2);
  // Of a prism over a regular polygon of 48 sides.
  EXPECT_NEAR(report.interfaces->area, 2 * 48 * std::sin(std::numbers::pi / 48), 1e-9);
}

TEST(Regions, HaveTheVolumesOfTheirTetsAndAllCells) {
  for (const TetMesh& tets : {core_in_sleeve(), box_in_box()}) {
    const FrameField field = solve(surface_of(tets), cells_across(24));
    const SolveReport& report = field.report();
    EXPECT_TRUE(report.model.watertight);
    EXPECT_TRUE(report.warnings.empty());
    const TetSolid solid = solid_of(tets);
    ASSERT_EQ(report.regions.size(), 2u);
    std::size_t cells = 0;
    for (const SolveReport::Region& region : report.regions) {
      double volume = 0;
      for (std::size_t t = 0; t < solid.mesh.tets.size(); ++t) {
        TetMesh one{solid.mesh.vertices, {solid.mesh.tets[t]}};
        if (solid.mesh.regions[t] == region.region) volume += volume_of_tets(one);
      }
      EXPECT_NEAR(region.volume, volume, 1e-9 * volume);
      cells += region.cells;
    }
    EXPECT_EQ(cells, field.size());
  }
}

/// The mesh with its vertices in the opposite order, and a triangle that has a vertex of its own where it had
/// one in common with others.
TriangleMesh unwelded(TriangleMesh mesh) {
  const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  std::reverse(mesh.vertices.begin(), mesh.vertices.end());
  for (auto* triangles : {&mesh.triangles, &mesh.inner_faces}) {
    for (auto& triangle : *triangles)
      for (std::uint32_t& corner : triangle) corner = last - corner + 1;
  }
  mesh.vertices.insert(mesh.vertices.begin(), mesh.vertices[mesh.triangles[0][0] - 1]);
  mesh.triangles[0][0] = 0;
  return mesh;
}

TEST(Regions, HaveTheirCreasesWhereTheSurfaceHadToBeWelded) {
  TriangleMesh mesh =
      surface_of(with_regions(TetBox{{4, 2, 2}}.mesh(), [](const Vector3& p) { return p[0] < 2 ? 0 : 1; }));
  mesh.creases.clear();
  const auto creases_of = [](const TriangleMesh& model) {
    return solve(model, cells_across(16)).report().creases;
  };
  const SolveReport::Creases expected = creases_of(mesh), creases = creases_of(unwelded(mesh));
  EXPECT_EQ(creases.corners, expected.corners);
  EXPECT_NEAR(creases.length, expected.length, 1e-9);
  EXPECT_NEAR(creases.length, 4 * (4 + 2 + 2) + 4 * 2, 1e-9) << "of the box, and around the face between";
}

TEST(Regions, OfCellsAreTheSolidsThatTheirCentresAreIn) {
  const FrameField field = solve(surface_of(box_in_box()), cells_across(24));
  ASSERT_EQ(field.data().regions.size(), field.size());
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Vector3 off = field.cell(i).center - Vector3{3, 3, 3};
    const double distance = std::max({std::abs(off[0]), std::abs(off[1]), std::abs(off[2])});
    EXPECT_EQ(field.data().regions[i], distance < 1 ? 1 : 0);
  }
}

TEST(Regions, OfABoxInABoxFollowTheInnerBoxWhereverItStands) {
  RandomSamples random(4);
  const Quaternion rotation = random.rotation();
  const FrameField field = solve(surface_of(rotated(box_in_box(), rotation)), cells_across(32));
  ASSERT_TRUE(field.report().interfaces);
  EXPECT_LT(field.report().interfaces->max, 1);
  EXPECT_NEAR(field.report().interfaces->area, 24, 1e-9);
  // Its twelve edges and those of the outer one.
  EXPECT_EQ(field.report().creases.curves, 24u);
  EXPECT_EQ(field.report().creases.crowded_corners, 0u);
}

TEST(Regions, TurnedInsideABoxBendTheFieldTheirWay) {
  // The inner box turned by 30 degrees about z: away from its faces the outer box has its way.
  const Quaternion turn = turn_about_z(30);
  TriangleMesh inner = rotate_mesh(make_box({1, 1, 1}), turn);
  TriangleMesh model = join_meshes(make_box({3, 3, 3}), flip_mesh(inner));
  model.solids.assign(model.triangles.size(), 0);
  model = join_meshes(model, inner);
  model.solids.resize(model.triangles.size(), 1);
  const FrameField field = solve(model, cells_across(48));
  EXPECT_LT(field.report().interfaces->mean, 1);
  const Vector3 normal = rotate(turn, {1, 0, 0});
  // Outside it turns back by 30 degrees over one unit.
  EXPECT_LT(angle_deg(field, 0.44 * normal, normal), 1);
  EXPECT_LT(angle_deg(field, 0.56 * normal, normal), 3);
  EXPECT_LT(angle_deg(field, {1.45, 0, 0}, {1, 0, 0}), 2);
}

TEST(Regions, AreFieldsOfTheSameBitsForOneThreadAndTwo) {
  SolveOptions options = cells_across(24);
  const TriangleMesh model = surface_of(core_in_sleeve());
  options.threads = 1;
  const FrameField one = solve(model, options);
  options.threads = 2;
  const FrameField two = solve(model, options);
  EXPECT_EQ(one.data().regions, two.data().regions);
  EXPECT_EQ(one.report().energy.total, two.report().energy.total);
  EXPECT_EQ(one.report().interfaces->mean, two.report().interfaces->mean);
}

TEST(Regions, UnitedGiveTheFieldOfTheUnionToTheBit) {
  TetMesh as_one = core_in_sleeve();
  as_one.regions.clear();
  const FrameField whole = solve(surface_of(as_one), cells_across(24));
  SolveOptions options = cells_across(24);
  options.unite_solids = true;
  const FrameField united = solve(surface_of(core_in_sleeve()), options);
  EXPECT_EQ(united.report().energy.total, whole.report().energy.total);
  EXPECT_EQ(united.report().energy.boundary, whole.report().energy.boundary);
  EXPECT_EQ(united.report().creases.curves, whole.report().creases.curves);
  EXPECT_FALSE(united.report().interfaces);
  EXPECT_EQ(united.report().regions.size(), 2u);
  EXPECT_TRUE(whole.report().regions.empty());
  // And without being told to unite it is another field.
  const FrameField apart = solve(surface_of(core_in_sleeve()), cells_across(24));
  EXPECT_GT(apart.report().energy.total, 1.01 * whole.report().energy.total);
}

TEST(Regions, OfASingleSolidChangeNothing) {
  TriangleMesh model = make_bracket(24);
  SolveOptions options = cells_across(24);
  const FrameField plain = solve(model, options);
  model.solids.assign(model.triangles.size(), 0);
  options.unite_solids = true;
  const FrameField told = solve(model, options);
  EXPECT_EQ(told.report().energy.total, plain.report().energy.total);
  EXPECT_TRUE(told.report().regions.empty());
  EXPECT_TRUE(told.data().regions.empty());
}

TEST(Regions, ThatOverlapAreReportedAndCountForTheSmallest) {
  TriangleMesh model = make_box({2, 2, 2});
  model.solids.assign(model.triangles.size(), 0);
  model = join_meshes(model, make_box({1, 1, 1}));
  model.solids.resize(model.triangles.size(), 1);
  const FrameField field = solve(model, cells_across(24));
  const auto& warnings = field.report().warnings;
  EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(),
                          [](const Warning& warning) {
                            return warning.kind == WarningKind::kOverlappingSolids &&
                                   warning.text.starts_with("solids overlap: ");
                          }),
            1);
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Vector3 centre = field.cell(i).center;
    const double distance = std::max({std::abs(centre[0]), std::abs(centre[1]), std::abs(centre[2])});
    EXPECT_EQ(field.data().regions[i], distance < 0.5 ? 1 : 0);
  }
}

TEST(Regions, ThatTouchByOtherTrianglesAreReportedAndSolvedAsOneField) {
  // A small block stands on the middle of a large one, turned by 20 degrees.
  TriangleMesh block = rotate_mesh(make_box({1, 1, 1}), turn_about_z(20));
  TriangleMesh model = make_box({3, 3, 1});
  model.solids.assign(model.triangles.size(), 0);
  model = join_meshes(model, translate_mesh(block, {0.1, 0, 1}));
  model.solids.resize(model.triangles.size(), 1);
  const FrameField field = solve(model, cells_across(36));
  const auto& warnings = field.report().warnings;
  EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(),
                          [](const Warning& warning) {
                            return warning.kind == WarningKind::kTouchingSolids &&
                                   warning.text.starts_with(
                                       "solids touch by faces that are not the same triangles: ");
                          }),
            1);
  EXPECT_TRUE(field.report().model.watertight);
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Vector3 centre = field.cell(i).center;
    if (std::abs(centre[2] - 0.5) > 0.1) {
      EXPECT_EQ(field.data().regions[i], centre[2] < 0.5 ? 0 : 1);
    }
  }
  // Joined through the contact: across it frames change by little.
  EXPECT_LT(angle_deg(field, {0.1, 0, 0.5}, {0, 0, 1}), 1);
  const Frame below = field.sample({0.1, 0, 0.42}).frame;
  for (const Vector3& axis : below.axes) EXPECT_LT(angle_deg(field, {0.1, 0, 0.58}, axis), 6);
}

TEST(Regions, HaveTheCellsAtTheCapsOverTheirHoles) {
  TriangleMesh box = make_box({1, 1, 1});
  std::erase_if(box.triangles, [&](const auto& triangle) {
    return std::all_of(triangle.begin(), triangle.end(), [&](auto v) { return box.vertices[v][2] > 0; });
  });
  TriangleMesh model = join_meshes(box, translate_mesh(box, {1.5, 0, 0}));
  model.solids.assign(model.triangles.size(), 3);
  std::fill_n(model.solids.begin(), box.triangles.size(), 5);
  const Quaternion turn = RandomSamples(9).rotation();
  const FrameField field = solve(rotate_mesh(model, turn), cells_across(40));
  ASSERT_FALSE(field.report().input.closed);
  std::size_t beyond_cap = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Vector3 centre = rotate(conjugate(turn), field.cell(i).center);
    ASSERT_EQ(field.data().regions[i], centre[0] < 0.75 ? 5 : 3);
    beyond_cap += centre[2] > 0.5 && std::abs(centre[0] - 1.5) < 0.4 && std::abs(centre[1]) < 0.4;
  }
  EXPECT_GT(beyond_cap, 50u);
}

TEST(Regions, TooSmallForACellAreReported) {
  TriangleMesh model = make_box({1, 1, 1});
  TriangleMesh speck = translate_mesh(scale_mesh(make_box({1, 1, 1}), 1e-4), {0.011, 0.012, 0.013});
  model = join_meshes(model, flip_mesh(speck));
  model.solids.assign(model.triangles.size(), 0);
  model = join_meshes(model, speck);
  model.solids.resize(model.triangles.size(), 8);
  const auto warnings = solve(model, cells_across(8)).report().warnings;
  const Warning expected(WarningKind::kEmptySolids,
                         "solids too small to hold a cell: 1 of 2, the first is region 8",
                         Remedy::kRaiseResolution);
  EXPECT_EQ(std::count(warnings.begin(), warnings.end(), expected), 1);
}

TEST(Regions, OfSolidsThatTouchByOtherTrianglesAreNoKnifeEdgesNorThinWalls) {
  for (const auto& [turn, collar] : {std::pair(0.0, 1.8), {0.5, 1.0}, {0.3, 1.8}}) {
    SCOPED_TRACE(turn);
    const SolveReport report = solve(plate_with_pin(turn, collar), cells_across(24)).report();
    EXPECT_EQ(kinds_of(report.warnings), std::vector{WarningKind::kTouchingSolids});
    EXPECT_EQ(report.creases.knife_edges, 0u);
    EXPECT_EQ(report.walls.thin_share, 0);
    for (const SolveReport::Finding& finding : report.input.findings) {
      EXPECT_NE(finding.kind, FindingKind::kSelfIntersection);
      EXPECT_NE(finding.kind, FindingKind::kOverlappingComponents);
    }
    for (const Answer::Reason& reason : report.answer.reasons)
      EXPECT_NE(reason.kind, ReasonKind::kKnifeEdge) << reason.text;
  }
}

}  // namespace
}  // namespace crossgrain
