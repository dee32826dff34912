// SPDX-License-Identifier: Apache-2.0
#include "hex/surface_feet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>
#include <set>

#include "base/vector3.hpp"
#include "map/arced_cylinder.hpp"

namespace crossgrain {
namespace {

using testing::AskewBox;
using testing::MappedSolid;
using Kind = Foot::Kind;

/// Of what is held along so many axes.
constexpr std::array kKinds{Kind::kInside, Kind::kFace, Kind::kCurve, Kind::kCorner};

/// The carrier of a vertex, edge, face or tet.
Carrier carrier_of(std::vector<std::uint32_t> vertices) {
  std::sort(vertices.begin(), vertices.end());
  Carrier carrier{};
  for (const std::uint32_t v : vertices) carrier.vertices[carrier.count++] = v;
  return carrier;
}

bool operator==(const Foot& a, const Foot& b) {
  return a.kind == b.kind && a.index == b.index;
}

/// On which of the sides of a box each vertex of its tets lies: -1 low, 1 high, 0 between, along each axis.
std::array<int, 3> sides_of(const std::array<std::uint32_t, 3>& cells, std::uint32_t vertex) {
  std::array<int, 3> sides{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t at = vertex % (cells[k] + 1);
    vertex /= cells[k] + 1;
    sides[k] = at == 0 ? -1 : at == cells[k] ? 1 : 0;
  }
  return sides;
}

TEST(SurfaceFeet, OfABoxAreItsCornersEdgesAndSides) {
  constexpr std::array<std::uint32_t, 3> kCells{3, 4, 2};
  const AskewBox box(kCells);
  const MapSurface surface(box.field);
  std::map<std::array<int, 3>, std::set<std::uint32_t>> found;
  for (std::uint32_t v = 0; v < box.solid.mesh.vertices.size(); ++v) {
    const std::array<int, 3> sides = sides_of(kCells, v);
    const auto held = static_cast<std::size_t>(3 - std::count(sides.begin(), sides.end(), 0));
    const Foot foot = surface.foot_of(carrier_of({v}));
    EXPECT_EQ(foot.kind, kKinds[held]);
    if (foot.kind == Kind::kCorner) {
      EXPECT_EQ(foot.index, v);
    }
    if (held > 0) found[sides].insert(foot.index);
  }
  EXPECT_EQ(found.size(), 6u + 12 + 8);
  std::map<std::ptrdiff_t, std::set<std::uint32_t>> indices;
  for (const auto& [sides, its_indices] : found) {
    EXPECT_EQ(its_indices.size(), 1u) << "one foot for all of a side or an edge";
    indices[std::count(sides.begin(), sides.end(), 0)].insert(*its_indices.begin());
  }
  EXPECT_EQ(indices[2], (std::set<std::uint32_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(indices[1].size(), 12u);
}

TEST(SurfaceFeet, OfEdgesAndFacesAreThoseOfTheVerticesThatTheyAddTo) {
  constexpr std::array<std::uint32_t, 3> kCells{3, 3, 3};
  const AskewBox box(kCells);
  const MapSurface surface(box.field);
  const auto expect_foot = [&](const std::vector<std::uint32_t>& vertices) {
    // What all of them lie on is what each point between them lies on.
    std::array<int, 3> common = sides_of(kCells, vertices[0]);
    for (const std::uint32_t v : vertices)
      for (std::size_t k = 0; k < 3; ++k)
        if (sides_of(kCells, v)[k] != common[k]) common[k] = 0;
    const auto held = static_cast<std::size_t>(3 - std::count(common.begin(), common.end(), 0));
    const Foot foot = surface.foot_of(carrier_of(vertices));
    EXPECT_EQ(foot.kind, kKinds[held]);
    for (std::uint32_t v = 0; v < box.solid.mesh.vertices.size(); ++v)
      if (held > 0 && sides_of(kCells, v) == common) {
        EXPECT_TRUE(surface.foot_of(carrier_of({v})) == foot);
      }
  };
  for (const auto& edge : box.complex.edges()) expect_foot({edge.ends[0], edge.ends[1]});
  for (const auto& [a, b, c] : box.solid.boundary) expect_foot({a, b, c});
  for (const auto& face : box.solid.inner_faces)
    EXPECT_EQ(surface.foot_of(carrier_of({face.vertices.begin(), face.vertices.end()})).kind, Kind::kInside);
  for (const auto& [a, b, c, d] : box.solid.mesh.tets)
    EXPECT_EQ(surface.foot_of(carrier_of({a, b, c, d})).kind, Kind::kInside);
}

TEST(SurfaceFeet, OfACylinderAreThreeFacesTwoRimsAndNoCorner) {
  const testing::ArcedCylinder cylinder;
  const MatchedField& field = cylinder.cut.field();
  const MapSurface surface(field);
  const std::vector<Vector3>& vertices = field.complex().solid().mesh.vertices;
  std::map<Kind, std::set<std::uint32_t>> found;
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    const Foot foot = surface.foot_of(carrier_of({v}));
    found[foot.kind].insert(foot.index);
    const Vector3& p = vertices[v];
    const bool is_at_end = std::abs(p[2]) == 1, is_at_side = std::hypot(p[0], p[1]) > 1 - 1e-12;
    if (is_at_end && is_at_side) {
      EXPECT_EQ(foot.kind, Kind::kCurve);
    }
  }
  EXPECT_EQ(found[Kind::kFace].size(), 3u);
  EXPECT_EQ(found[Kind::kCurve].size(), 2u);
  EXPECT_FALSE(found.contains(Kind::kCorner));
}

double squared_distance(const Vector3& a, const Vector3& b) {
  return dot(a - b, a - b);
}

/// The least of the distances to the ends and, if it is between them, to the foot of the perpendicular.
double to_segment(const Vector3& p, const Vector3& a, const Vector3& b) {
  const double along = dot(p - a, b - a), length = dot(b - a, b - a);
  double least = std::min(squared_distance(p, a), squared_distance(p, b));
  if (along > 0 && along < length) {
    const Vector3 across = cross(p - a, b - a);
    least = std::min(least, dot(across, across) / length);
  }
  return least;
}

/// The least of the distances to the sides and, if it is inside, to the foot of the perpendicular.
double to_triangle(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 normal = normalised(cross(b - a, c - a));
  double least = std::min({to_segment(p, a, b), to_segment(p, b, c), to_segment(p, c, a)});
  if (dot(cross(b - a, p - a), normal) >= 0 && dot(cross(c - b, p - b), normal) >= 0 &&
      dot(cross(a - c, p - c), normal) >= 0)
    least = std::min(least, dot(p - a, normal) * dot(p - a, normal));
  return least;
}

std::vector<Vector3> random_points(int count, double reach) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-reach, reach);
  std::vector<Vector3> points;
  for (int k = 0; k < count; ++k) points.push_back({uniform(random), uniform(random), uniform(random)});
  return points;
}

TEST(SurfaceFeet, HaveTheNearestPlaceOfAllTriangles) {
  const testing::ArcedCylinder cylinder;
  const MatchedField& field = cylinder.cut.field();
  const MapSurface surface(field);
  const TetSolid& solid = field.complex().solid();
  const auto corner = [&](std::uint32_t f, std::size_t k) {
    return solid.mesh.vertices[solid.boundary[f][k]];
  };
  for (const Vector3& p : random_points(300, 1.6)) {
    std::map<std::uint32_t, double> least;
    for (std::uint32_t f = 0; f < solid.boundary.size(); ++f) {
      const auto& [a, b, c] = solid.boundary[f];
      const std::uint32_t face = surface.foot_of(carrier_of({a, b, c})).index;
      const double distance = to_triangle(p, corner(f, 0), corner(f, 1), corner(f, 2));
      least[face] = least.contains(face) ? std::min(least[face], distance) : distance;
    }
    double of_all = std::numeric_limits<double>::infinity();
    for (const auto& [face, distance] : least) {
      const MapSurface::Place place = surface.nearest({Kind::kFace, face}, p);
      EXPECT_NEAR(squared_distance(place.point, p), distance, 1e-12);
      // The triangle that it names has the point, and its normal.
      const Vector3 a = corner(place.face, 0), b = corner(place.face, 1), c = corner(place.face, 2);
      EXPECT_LT(to_triangle(place.point, a, b, c), 1e-24);
      EXPECT_LT(norm(place.direction - normalised(cross(b - a, c - a))), 1e-12);
      of_all = std::min(of_all, distance);
    }
    EXPECT_NEAR(squared_distance(surface.nearest_of_all(p).point, p), of_all, 1e-12);
  }
}

TEST(SurfaceFeet, HaveTheNearestPlaceOfAllSegmentsOfACurve) {
  const testing::ArcedCylinder cylinder;
  const MatchedField& field = cylinder.cut.field();
  const MapSurface surface(field);
  const std::vector<Vector3>& vertices = field.complex().solid().mesh.vertices;
  std::map<std::uint32_t, std::vector<std::array<std::uint32_t, 2>>> curves;
  for (const auto& edge : field.complex().edges()) {
    const Foot foot = surface.foot_of(carrier_of({edge.ends[0], edge.ends[1]}));
    if (foot.kind == Kind::kCurve) curves[foot.index].push_back(edge.ends);
  }
  for (const Vector3& p : random_points(300, 1.6)) {
    for (const auto& [curve, segments] : curves) {
      const MapSurface::Place place = surface.nearest({Kind::kCurve, curve}, p);
      double least = std::numeric_limits<double>::infinity();
      bool is_along_a_segment = false;
      for (const auto& [a, b] : segments) {
        least = std::min(least, to_segment(p, vertices[a], vertices[b]));
        is_along_a_segment |= to_segment(place.point, vertices[a], vertices[b]) < 1e-24 &&
                              norm(cross(place.direction, normalised(vertices[b] - vertices[a]))) < 1e-12;
      }
      EXPECT_NEAR(squared_distance(place.point, p), least, 1e-12);
      EXPECT_TRUE(is_along_a_segment);
    }
  }
}

TEST(SurfaceFeet, LeaveWhatIsInsideAndHoldCorners) {
  const AskewBox box({2, 2, 2});
  const MapSurface surface(box.field);
  for (const Vector3& p : random_points(10, 3)) {
    EXPECT_EQ(surface.nearest({}, p).point, p);
    EXPECT_EQ(surface.nearest({Kind::kCorner, 26}, p).point, box.solid.mesh.vertices[26]);
  }
}

TEST(SurfaceFeet, TurnWithTheSolid) {
  const Quaternion turn = from_rotation_vector({-0.8, 0.5, 0.3});
  const AskewBox box({3, 2, 2});
  TetMesh mesh = box.solid.mesh;
  for (Vector3& p : mesh.vertices) p = rotate(turn, p);
  const MappedSolid turned(mesh, [&](const TetSolid&) {
    std::vector<Quaternion> frames;
    for (const Quaternion& frame : box.frames) frames.push_back(turn * frame);
    return frames;
  });
  const MapSurface before(box.field), after(turned.field);
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    const Foot foot = before.foot_of(carrier_of({v}));
    EXPECT_TRUE(after.foot_of(carrier_of({v})) == foot);
    for (const Vector3& p : random_points(5, 3)) {
      const Vector3 expected = rotate(turn, before.nearest(foot, p).point);
      EXPECT_LT(norm(after.nearest(foot, rotate(turn, p)).point - expected), 1e-12);
    }
  }
}

}  // namespace
}  // namespace crossgrain
