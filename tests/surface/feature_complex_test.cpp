// SPDX-License-Identifier: Apache-2.0
#include "surface/feature_complex.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "base/quaternion.hpp"
#include "base/vector3.hpp"
#include "support/curved_shapes.hpp"
#include "support/extrusion.hpp"
#include "support/shapes.hpp"
#include "surface/edge_uses.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

using std::numbers::pi;
constexpr std::uint32_t kNone = FeatureComplex::kNone;

FeatureComplex features_of(const TriangleMesh& mesh, const FeatureOptions& options = {}) {
  return feature_complex(prepare_surface(weld(mesh)), options);
}

std::size_t soft_curves(const FeatureComplex& complex) {
  return static_cast<std::size_t>(std::ranges::count_if(complex.curves, &FeatureComplex::Curve::is_soft));
}

/// Vertices - edges + triangles.
int euler_of(const FeatureComplex& complex) {
  std::set<std::uint32_t> vertices;
  for (const auto& triangle : complex.triangles) vertices.insert(triangle.begin(), triangle.end());
  int edges = 0;
  for_each_edge(sorted_edge_uses(complex.triangles), [&](std::span<const EdgeUse>) { ++edges; });
  return static_cast<int>(vertices.size()) - edges + static_cast<int>(complex.triangles.size());
}

/// The same from corners, curves and faces.
int euler_of_cells(const FeatureComplex& complex) {
  int sum = static_cast<int>(complex.corners.size());
  for (const auto& curve : complex.curves) sum -= curve.corners[0] != kNone;
  for (const auto& face : complex.faces) sum += face.euler;
  // A face all around a corner counts it among its own points.
  for (const auto& corner : complex.corners)
    sum -= static_cast<int>(
        std::ranges::count_if(corner.sectors, [](const auto& sector) { return sector.from == kNone; }));
  return sum;
}

void expect_faces_partition_the_triangles(const FeatureComplex& complex) {
  ASSERT_EQ(complex.face_of.size(), complex.triangles.size());
  ASSERT_EQ(complex.source_of.size(), complex.triangles.size());
  std::size_t count = 0;
  for (std::uint32_t f = 0; f < complex.faces.size(); ++f) {
    const FeatureComplex::Face& face = complex.faces[f];
    EXPECT_TRUE(std::ranges::is_sorted(face.triangles));
    count += face.triangles.size();
    for (const std::uint32_t t : face.triangles) EXPECT_EQ(complex.face_of[t], f);
    EXPECT_NE(face.below, face.above);
  }
  EXPECT_EQ(count, complex.triangles.size());
}

using Sides = std::vector<std::pair<std::uint32_t, bool>>;

Sides sorted_sides(Sides sides) {
  std::ranges::sort(sides);
  return sides;
}

/// Every edge of a curve has just the faces that the curve names, on the sides that it names, and borders of
/// faces are curves.
void expect_true_sides(const FeatureComplex& complex) {
  std::map<std::uint64_t, Sides> uses;
  for (const EdgeUse& use : sorted_edge_uses(complex.triangles))
    uses[use.edge].push_back({complex.face_of[use.triangle], use.forward});
  std::set<std::uint64_t> on_curves;
  for (const auto& curve : complex.curves) {
    ASSERT_GE(curve.vertices.size(), 2u);
    Sides sides, reverse;
    for (const auto& side : curve.sides) {
      sides.push_back({side.face, side.is_left});
      reverse.push_back({side.face, !side.is_left});
    }
    for (std::size_t k = 0; k + 1 < curve.vertices.size(); ++k) {
      const auto [low, high] = std::minmax(curve.vertices[k], curve.vertices[k + 1]);
      const std::uint64_t edge = (std::uint64_t{low} << 32) | high;
      EXPECT_TRUE(on_curves.insert(edge).second) << "two curves share an edge";
      EXPECT_EQ(sorted_sides(uses[edge]), sorted_sides(low == curve.vertices[k] ? sides : reverse));
    }
  }
  for (const auto& [edge, sides] : uses) {
    const bool is_inside =
        sides.size() == 2 && sides[0].first == sides[1].first && sides[0].second != sides[1].second;
    EXPECT_TRUE(is_inside || on_curves.contains(edge));
  }
}

/// As many sectors begin at the end of a curve as faces lie left of it, and end there as lie right.
void expect_true_sectors(const FeatureComplex& complex) {
  for (std::uint32_t k = 0; k < complex.corners.size(); ++k) {
    const FeatureComplex::Corner& corner = complex.corners[k];
    for (std::uint32_t e = 0; e < corner.ends.size(); ++e) {
      const FeatureComplex::Curve& curve = complex.curves[corner.ends[e].curve];
      EXPECT_EQ(curve.corners[corner.ends[e].is_last], k);
      Sides begun, ended, left, right;
      for (const auto& sector : corner.sectors) {
        if (sector.from == e) begun.push_back({sector.face, true});
        if (sector.to == e) ended.push_back({sector.face, true});
      }
      for (const auto& side : curve.sides)
        (side.is_left != corner.ends[e].is_last ? left : right).push_back({side.face, true});
      EXPECT_EQ(sorted_sides(begun), sorted_sides(left));
      EXPECT_EQ(sorted_sides(ended), sorted_sides(right));
    }
    for (const auto& sector : corner.sectors) {
      EXPECT_EQ(sector.from == kNone, sector.to == kNone);
      EXPECT_GT(sector.angle_rad, 0);
    }
  }
}

void expect_consistent(const FeatureComplex& complex) {
  expect_faces_partition_the_triangles(complex);
  expect_true_sides(complex);
  expect_true_sectors(complex);
  EXPECT_EQ(euler_of(complex), euler_of_cells(complex));
}

struct Counts {
  std::size_t corners, curves, faces;

  friend bool operator==(const Counts&, const Counts&) = default;
};

Counts counts_of(const FeatureComplex& complex) {
  return {complex.corners.size(), complex.curves.size(), complex.faces.size()};
}

/// Faces by the direction of their normals, as a CAD file numbers them.
TriangleMesh with_faces(TriangleMesh mesh, const std::function<std::int32_t(const Vector3& normal)>& number) {
  for (const auto& triangle : mesh.triangles)
    mesh.faces.push_back(number(shape_of(corners_of(triangle, mesh.vertices)).normal));
  return mesh;
}

TEST(FeatureComplex, OfABoxHasItsCornersEdgesAndSides) {
  const FeatureComplex complex = features_of(make_box({1, 2, 3}));
  EXPECT_EQ(counts_of(complex), (Counts{8, 12, 6}));
  expect_consistent(complex);
  for (const auto& corner : complex.corners) {
    EXPECT_EQ(corner.ends.size(), 3u);
    ASSERT_EQ(corner.sectors.size(), 3u);
    for (const auto& sector : corner.sectors) EXPECT_NEAR(sector.angle_rad, pi / 2, 1e-12);
    // Counter-clockwise seen from outside, the three follow each other in one cycle.
    EXPECT_NE(corner.sectors[0].to, corner.sectors[1].to);
  }
  double area = 0;
  for (const auto& face : complex.faces) {
    EXPECT_EQ(face.euler, 1);
    EXPECT_EQ(face.loops, 1u);
    EXPECT_EQ(face.below, 1);
    EXPECT_EQ(face.above, 0);
    area += face.area;
  }
  EXPECT_NEAR(area, 22, 1e-12);
  EXPECT_EQ(soft_curves(complex), 0u);
}

TEST(FeatureComplex, OrdersSectorsCounterClockwiseAsTheNormalsSeeThem) {
  const FeatureComplex complex = features_of(make_box({1, 1, 1}));
  for (const auto& corner : complex.corners) {
    for (const auto& sector : corner.sectors) {
      const auto direction = [&](std::uint32_t end) {
        const auto& [c, is_last] = corner.ends[end];
        const auto& chain = complex.curves[c].vertices;
        return complex.vertices[is_last ? chain[chain.size() - 2] : chain[1]] - corner.point;
      };
      const std::uint32_t triangle = complex.faces[sector.face].triangles[0];
      const Vector3 normal = shape_of(complex.points_of(triangle)).normal;
      EXPECT_GT(dot(cross(direction(sector.from), direction(sector.to)), normal), 0);
    }
  }
}

TEST(FeatureComplex, OfACylinderHasTwoClosedCurvesAndNoCorner) {
  const FeatureComplex complex = features_of(make_cylinder(0.5, 0.7, 32, 4));
  EXPECT_EQ(counts_of(complex), (Counts{0, 2, 3}));
  expect_consistent(complex);
  for (const auto& curve : complex.curves) {
    EXPECT_TRUE(curve.is_closed());
    EXPECT_EQ(curve.corners[0], kNone);
    EXPECT_NEAR(curve.length, pi, 0.01);
  }
  std::multiset<int> eulers;
  for (const auto& face : complex.faces) eulers.insert(face.euler);
  EXPECT_EQ(eulers, (std::multiset<int>{0, 1, 1}));
}

TEST(FeatureComplex, OfASmoothSurfaceIsOneFace) {
  const FeatureComplex sphere = features_of(make_sphere(1, 3));
  EXPECT_EQ(counts_of(sphere), (Counts{0, 0, 1}));
  EXPECT_EQ(sphere.faces[0].euler, 2);
  EXPECT_EQ(sphere.faces[0].loops, 0u);
  const FeatureComplex torus = features_of(make_torus(0.6, 0.25, 32, 16));
  EXPECT_EQ(counts_of(torus), (Counts{0, 0, 1}));
  EXPECT_EQ(torus.faces[0].euler, 0);
  expect_consistent(torus);
}

TEST(FeatureComplex, OfAHoleHasFacesOfTwoLoops) {
  const FeatureComplex complex = features_of(make_box_with_hole(48));
  EXPECT_EQ(counts_of(complex), (Counts{8, 14, 7}));
  expect_consistent(complex);
  EXPECT_EQ(std::ranges::count(complex.faces, 2u, &FeatureComplex::Face::loops), 3);
  EXPECT_EQ(std::ranges::count(complex.faces, 0, &FeatureComplex::Face::euler), 3);
}

/// A cone over a circle of radius 1 at z = 0, with rings of triangles.
TriangleMesh make_cone(double height, int segments, int rings) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {0, 0, height}};
  for (int r = 0; r < rings; ++r) {
    const double share = 1 - static_cast<double>(r) / rings;
    for (int s = 0; s < segments; ++s) {
      const double angle = 2 * pi * s / segments;
      mesh.vertices.push_back({share * std::cos(angle), share * std::sin(angle), (1 - share) * height});
    }
  }
  const auto at = [&](int r, int s) { return static_cast<std::uint32_t>(2 + r * segments + s % segments); };
  for (int s = 0; s < segments; ++s) {
    mesh.triangles.push_back({0, at(0, s + 1), at(0, s)});
    mesh.triangles.push_back({1, at(rings - 1, s), at(rings - 1, s + 1)});
    for (int r = 0; r + 1 < rings; ++r) {
      mesh.triangles.push_back({at(r, s), at(r, s + 1), at(r + 1, s + 1)});
      mesh.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r + 1, s)});
    }
  }
  return mesh;
}

TEST(FeatureComplex, HasTheTipOfAConeAsACornerWithoutEnds) {
  // 1/tan(59 degrees): the end of a drilled hole.
  for (const double height : {2.0, 1.0, 0.6}) {
    const FeatureComplex complex = features_of(make_cone(height, 32, 4));
    ASSERT_EQ(counts_of(complex), (Counts{1, 1, 2})) << height;
    EXPECT_EQ(complex.corners[0].vertex, 1u);
    EXPECT_TRUE(complex.corners[0].ends.empty());
    ASSERT_EQ(complex.corners[0].sectors.size(), 1u);
    EXPECT_EQ(complex.corners[0].sectors[0].from, kNone);
    expect_consistent(complex);
  }
}

TEST(FeatureComplex, TakesNoVertexOfACoarseSphereForATip) {
  // Edges of 20 subdivided faces turn by less than 35 degrees from here on.
  EXPECT_TRUE(features_of(make_sphere(1, 2)).corners.empty());
  EXPECT_TRUE(features_of(make_knobbly_sphere(3, 0.05, 0, 1)).corners.empty());
}

TEST(FeatureComplex, OfAFilletHasSoftCurvesThatEndAtCorners) {
  // A square with one corner rounded by eight facets, whose faces have numbers.
  Loop2 outline{{0, 0}, {2, 0}};
  for (const Point2& point : arc({1.5, 1.5}, 0.5, 0, pi / 2, 8)) outline.push_back(point);
  outline.push_back({0, 2});
  const TriangleMesh mesh = with_faces(extrude(outline, {}, 0, {1}), [](const Vector3& normal) {
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(normal[static_cast<std::size_t>(axis)]) > 0.999)
        return 2 * axis + (normal[static_cast<std::size_t>(axis)] > 0) + 1;
    return 7;
  });
  const FeatureComplex complex = features_of(mesh);
  EXPECT_EQ(counts_of(complex), (Counts{10, 15, 7}));
  EXPECT_EQ(soft_curves(complex), 2u);
  expect_consistent(complex);
  for (const auto& curve : complex.curves) EXPECT_TRUE(!curve.is_soft || std::abs(curve.length - 1) < 1e-12);
}

/// An open sheet along y: a plane of face 1 for x < 0, then `rows` strips of face 2 that lie `first_deg` off
/// it and turn by `row_deg` from each to the next.
TriangleMesh make_bent_sheet(double first_deg, double row_deg, int rows) {
  std::vector<Point2> profile{{-3, 0}, {-2, 0}, {-1, 0}, {0, 0}};
  for (int k = 0; k < rows; ++k) {
    const double angle = (first_deg + k * row_deg) * pi / 180;
    profile.push_back({profile.back()[0] + std::cos(angle), profile.back()[1] - std::sin(angle)});
  }
  TriangleMesh mesh;
  const std::uint32_t columns = 6;
  for (const auto& [x, z] : profile)
    for (std::uint32_t c = 0; c <= columns; ++c) mesh.vertices.push_back({x, c * 1.0, z});
  for (std::uint32_t r = 0; r + 1 < profile.size(); ++r) {
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint32_t a = r * (columns + 1) + c, b = a + columns + 1;
      mesh.triangles.insert(mesh.triangles.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
      mesh.faces.insert(mesh.faces.end(), 2, r < 3 ? 1 : 2);
    }
  }
  return mesh;
}

TEST(FeatureComplex, TellsAFilletOfCoarseFacetsFromAChamfer) {
  const auto soft_of = [](double first_deg, double row_deg) {
    const FeatureComplex complex = features_of(make_bent_sheet(first_deg, row_deg, 4));
    EXPECT_EQ(complex.faces.size(), 2u);
    expect_consistent(complex);
    return soft_curves(complex);
  };
  EXPECT_EQ(soft_of(0, 0), 1u);
  EXPECT_EQ(soft_of(10, 20), 1u);
  // A tangent fillet of facets of 33 degrees, whose first one is 16.5 off the plane.
  EXPECT_EQ(soft_of(16.5, 33), 1u);
  EXPECT_EQ(soft_of(16.5, 0), 0u);
  EXPECT_EQ(soft_of(20, 0), 0u);
  EXPECT_EQ(soft_of(30, 20), 0u);
}

TEST(FeatureComplex, EndsADanglingCurveInACorner) {
  const FeatureComplex complex = features_of(make_fading_ridge(8, 110));
  expect_consistent(complex);
  const auto dangling = std::ranges::find_if(complex.corners, [](const auto& corner) {
    return corner.ends.size() == 1 && corner.sectors.size() == 1;
  });
  ASSERT_NE(dangling, complex.corners.end());
  EXPECT_EQ(dangling->sectors[0].from, 0u);
  EXPECT_EQ(dangling->sectors[0].to, 0u);
  EXPECT_NEAR(dangling->sectors[0].angle_rad, 2 * pi, 0.5);
  const auto& curve = complex.curves[dangling->ends[0].curve];
  ASSERT_EQ(curve.sides.size(), 2u);
  EXPECT_EQ(curve.sides[0].face, curve.sides[1].face);
  EXPECT_NE(curve.sides[0].is_left, curve.sides[1].is_left);
}

TEST(FeatureComplex, LeavesOutCreasesThatFadeAsASolveDoes) {
  const FeatureComplex complex = features_of(make_fading_ridge(8, 60));
  EXPECT_TRUE(
      std::ranges::none_of(complex.curves, [](const auto& curve) { return curve.sides.size() == 2; }));
  const FeatureComplex all =
      features_of(make_fading_ridge(8, 60), {.angles = {.least_deg = 35, .fading = {.least_radii = 0}}});
  EXPECT_TRUE(std::ranges::any_of(all.curves, [](const auto& curve) { return curve.sides.size() == 2; }));
}

TriangleMesh of_solids(const TriangleMesh& first, const TriangleMesh& second) {
  TriangleMesh both = join_meshes(first, second);
  both.solids.assign(first.triangles.size(), 0);
  both.solids.resize(both.triangles.size(), 1);
  return both;
}

TEST(FeatureComplex, OfTwoBoxesHasTheirCommonFaceOnce) {
  // Reflected, so that diagonals of the common face agree.
  TriangleMesh other = make_box({1, 1, 1});
  for (Vector3& vertex : other.vertices) vertex[0] = 1 - vertex[0];
  other = flip_mesh(std::move(other));
  const FeatureComplex complex = features_of(of_solids(make_box({1, 1, 1}), other));
  EXPECT_EQ(counts_of(complex), (Counts{12, 20, 11}));
  expect_consistent(complex);
  std::size_t between = 0, of_three = 0;
  for (const auto& face : complex.faces) {
    if (face.above == 0) continue;
    ++between;
    EXPECT_EQ(face.below, 2);
    EXPECT_EQ(face.above, 1);
    // It looks out of the second box, towards -x.
    EXPECT_LT(shape_of(complex.points_of(face.triangles[0])).normal[0], -0.9);
  }
  EXPECT_EQ(between, 1u);
  for (const auto& curve : complex.curves) of_three += curve.sides.size() == 3;
  EXPECT_EQ(of_three, 4u);
  for (const auto& corner : complex.corners)
    EXPECT_EQ(corner.ends.size(), corner.sectors.size() == 5 ? 4u : 3u);
}

TEST(FeatureComplex, OfUnitedBoxesHasNoFaceBetween) {
  TriangleMesh other = make_box({1, 1, 1});
  for (Vector3& vertex : other.vertices) vertex[0] = 1 - vertex[0];
  other = flip_mesh(std::move(other));
  const FeatureComplex complex = features_of(of_solids(make_box({1, 1, 1}), other), {.unite_solids = true});
  EXPECT_EQ(counts_of(complex), (Counts{8, 12, 6}));
  for (const auto& face : complex.faces) EXPECT_EQ(face.below, 1);
  expect_consistent(complex);
}

/// Two boxes of which the second covers half of the first's side, cut along it.
TriangleMesh half_shared_face() {
  const auto box = [](double x0, double x1, const std::vector<double>& ys) {
    TriangleMesh mesh;
    const auto add = [&](const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.insert(mesh.vertices.end(), {a, b, c, d});
      // Both boxes cut the common face along the same diagonal, from the lowest point to the highest.
      mesh.triangles.push_back({first, first + 1, first + 2});
      mesh.triangles.push_back({first, first + 2, first + 3});
    };
    for (std::size_t k = 0; k + 1 < ys.size(); ++k) {
      const double y0 = ys[k], y1 = ys[k + 1];
      add({x0, y0, 0}, {x0, y1, 0}, {x1, y1, 0}, {x1, y0, 0});
      add({x0, y0, 1}, {x1, y0, 1}, {x1, y1, 1}, {x0, y1, 1});
      add({x0, y0, 0}, {x0, y0, 1}, {x0, y1, 1}, {x0, y1, 0});
      add({x1, y0, 0}, {x1, y1, 0}, {x1, y1, 1}, {x1, y0, 1});
    }
    const double low = ys.front(), high = ys.back();
    add({x0, low, 0}, {x1, low, 0}, {x1, low, 1}, {x0, low, 1});
    add({x0, high, 0}, {x0, high, 1}, {x1, high, 1}, {x1, high, 0});
    return mesh;
  };
  return of_solids(box(0, 1, {0, 0.5, 1}), box(1, 2, {0, 0.5}));
}

TEST(FeatureComplex, OfAHalfSharedFaceHasATeeOfThreeFaces) {
  const FeatureComplex complex = features_of(half_shared_face());
  expect_consistent(complex);
  // Two corners and one edge of the second box lie on the side of the first, two of its edges on edges there.
  EXPECT_EQ(counts_of(complex), (Counts{14, 23, 12}));
  std::size_t tees = 0;
  for (const auto& curve : complex.curves) {
    if (curve.sides.size() != 3) continue;
    std::set<std::pair<std::int32_t, std::int32_t>> regions;
    for (const auto& side : curve.sides)
      regions.insert({complex.faces[side.face].below, complex.faces[side.face].above});
    EXPECT_EQ(regions.size(), 3u);
    ++tees;
  }
  EXPECT_EQ(tees, 4u);
}

TEST(FeatureComplex, OfTouchingTipsHasOneCorner) {
  TriangleMesh cone = make_cone(1, 16, 2), other = cone;
  for (Vector3& vertex : other.vertices) vertex[2] = 2 - vertex[2];
  const FeatureComplex complex = features_of(join_meshes(cone, flip_mesh(other)));
  ASSERT_EQ(complex.corners.size(), 1u);
  EXPECT_EQ(complex.corners[0].sectors.size(), 2u);
  expect_consistent(complex);
}

TEST(FeatureComplex, TakesOpenEdgesForCurves) {
  TriangleMesh mesh = make_box({1, 1, 1});
  mesh.triangles.resize(10);
  const FeatureComplex complex = features_of(mesh);
  expect_consistent(complex);
  EXPECT_EQ(counts_of(complex), (Counts{8, 12, 5}));
  EXPECT_EQ(std::ranges::count_if(complex.curves, [](const auto& it) { return it.sides.size() == 1; }), 4);
}

TEST(FeatureComplex, CutsAMoebiusStrip) {
  TriangleMesh mesh;
  const int count = 24;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * pi * k / count;
    for (const double side : {-0.3, 0.3}) {
      const double r = 1 + side * std::cos(angle / 2);
      mesh.vertices.push_back({r * std::cos(angle), r * std::sin(angle), side * std::sin(angle / 2)});
    }
  }
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t a = 2 * k, b = 2 * k + 1;
    const std::uint32_t c = k + 1 < count ? a + 2 : 1, d = k + 1 < count ? b + 2 : 0;
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({b, c, d});
  }
  const FeatureComplex complex = features_of(mesh);
  expect_consistent(complex);
  ASSERT_EQ(complex.faces.size(), 1u);
  EXPECT_EQ(complex.faces[0].euler, 1);
}

TEST(FeatureComplex, TakesCurvesOfTheMeshWithTheirTags) {
  TriangleMesh mesh = make_cylinder(0.5, 0.7, 32);
  CreaseCurve circle;
  for (int s = 0; s <= 32; ++s) {
    const auto v = std::ranges::find_if(mesh.vertices, [&](const Vector3& p) {
      return p[2] > 0.6 &&
             norm(p - Vector3{0.5 * std::cos(2 * pi * s / 32), 0.5 * std::sin(2 * pi * s / 32), 0.7}) < 1e-9;
    });
    ASSERT_NE(v, mesh.vertices.end());
    circle.points.push_back(*v);
    circle.tangents.push_back({-std::sin(2 * pi * s / 32), std::cos(2 * pi * s / 32), 0});
  }
  circle.tag = 42;
  mesh.creases = {circle};
  const FeatureComplex complex = features_of(mesh);
  ASSERT_EQ(complex.curves.size(), 1u);
  EXPECT_EQ(complex.curves[0].tag, 42);
  EXPECT_FALSE(complex.curves[0].is_soft);
  EXPECT_TRUE(complex.corners.empty());
}

TEST(FeatureComplex, FollowsExactTangentsAroundACoarseCircle) {
  // Six chords turn by 60 degrees each, the circle by none.
  TriangleMesh mesh = make_cylinder(0.5, 0.7, 6);
  CreaseCurve circle;
  for (int s = 0; s <= 6; ++s) {
    const double angle = 2 * pi * (s % 6) / 6;
    const auto v = std::ranges::find_if(mesh.vertices, [&](const Vector3& p) {
      return norm(p - Vector3{0.5 * std::cos(angle), 0.5 * std::sin(angle), 0.7}) < 1e-9;
    });
    ASSERT_NE(v, mesh.vertices.end());
    circle.points.push_back(*v);
    circle.tangents.push_back({-std::sin(angle), std::cos(angle), 0});
  }
  mesh.creases = {circle};
  const FeatureComplex complex = features_of(mesh);
  ASSERT_EQ(complex.curves.size(), 1u);
  EXPECT_TRUE(complex.corners.empty());
  expect_consistent(complex);
}

TEST(FeatureComplex, TurnsWithTheModel) {
  const TriangleMesh mesh = make_bracket(48);
  const FeatureComplex straight = features_of(mesh);
  const Quaternion rotation = normalised(Quaternion{0.9, 0.3, -0.2, 0.4});
  const FeatureComplex turned = features_of(rotate_mesh(mesh, rotation));
  expect_consistent(straight);
  EXPECT_EQ(counts_of(straight), counts_of(turned));
  for (std::size_t c = 0; c < straight.curves.size(); ++c) {
    EXPECT_EQ(straight.curves[c].vertices, turned.curves[c].vertices);
    EXPECT_EQ(straight.curves[c].sides, turned.curves[c].sides);
    EXPECT_NEAR(straight.curves[c].length, turned.curves[c].length, 1e-12);
  }
}

TEST(FeatureComplex, IsConsistentForAnySoup) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    const auto below = [&](std::size_t count) { return static_cast<std::uint32_t>(random() % count); };
    TriangleMesh mesh;
    const std::size_t points = 4 + below(16), triangles = 1 + below(40);
    for (std::size_t k = 0; k < points; ++k)
      mesh.vertices.push_back({below(5) * 1.0, below(5) * 1.0, below(5) * 1.0});
    for (std::size_t t = 0; t < triangles; ++t) {
      mesh.triangles.push_back({below(points), below(points), below(points)});
      if (seed % 2) mesh.faces.push_back(static_cast<std::int32_t>(below(3)));
      if (seed % 3) mesh.solids.push_back(static_cast<std::int32_t>(below(3)));
    }
    if (seed % 5 == 0)
      for (std::size_t t = 0; t < triangles; ++t) {
        mesh.triangles.push_back({mesh.triangles[t][0], mesh.triangles[t][2], mesh.triangles[t][1]});
        if (seed % 2) mesh.faces.push_back(static_cast<std::int32_t>(below(3)));
        if (seed % 3) mesh.solids.push_back(static_cast<std::int32_t>(below(3)));
      }
    const bool has_area = std::ranges::any_of(mesh.triangles, [&](const auto& triangle) {
      return shape_of(corners_of(triangle, mesh.vertices)).area > 0;
    });
    if (!has_area) continue;
    SCOPED_TRACE(seed);
    const Surface surface = prepare_surface(mesh);
    expect_consistent(feature_complex(surface));
    const FeatureComplex united = feature_complex(surface, {.unite_solids = true});
    if (!united.triangles.empty()) expect_consistent(united);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace crossgrain
