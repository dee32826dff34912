// SPDX-License-Identifier: Apache-2.0
#include "surface/closing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "base/vector3.hpp"
#include "support/shapes.hpp"
#include "surface/hole_filling.hpp"
#include "surface/loop_triangles.hpp"
#include "surface/topology.hpp"
#include "surface/united_surface.hpp"

namespace crossgrain {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

bool never_taken(std::uint32_t, std::uint32_t) {
  return false;
}

double area_of(const std::vector<Triangle>& triangles, const std::vector<Vector3>& vertices) {
  double area = 0;
  for (const Triangle& t : triangles) area += shape_of(corners_of(t, vertices)).area;
  return area;
}

MendedSurface closed(TriangleMesh mesh) {
  std::vector<Warning> warnings;
  return closed_surface(CheckedMesh(std::move(mesh)), warnings);
}

MendedSurface united(TriangleMesh mesh) {
  return united_surface(SearchableSurface(closed(std::move(mesh))));
}

TriangleMesh without(TriangleMesh mesh, const Vector3& place, double radius) {
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return norm(1.0 / 3 * (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) - place) < radius;
  });
  return mesh;
}

/// Seen along z: a polygon counter-clockwise.
TEST(LoopTriangles, FillAConcavePolygonOfAPlaneWithoutFolds) {
  const std::vector<Vector3> vertices = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}};
  const EdgeLoop loop{{0, 1, 2, 3, 4}, std::vector<Vector3>(5, {0, 0, 1})};
  const auto triangles = loop_triangles(loop, vertices, never_taken);
  ASSERT_EQ(triangles.size(), 3u);
  EXPECT_DOUBLE_EQ(area_of(triangles, vertices), 10);
  for (const Triangle& t : triangles) EXPECT_GT(shape_of(corners_of(t, vertices)).normal[2], 0.99);
}

/// Two triangles beside an edge of a box, which the other diagonal would cut off.
TEST(LoopTriangles, FillAnEdgeThatAHoleCrosses) {
  const std::vector<Vector3> vertices = {{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {1, 0, -1}};
  const Vector3 up{0, 0, 1}, back{0, 1, 0};
  const EdgeLoop loop{{2, 1, 3, 0}, {up, back, back, up}};
  EXPECT_EQ(loop_triangles(loop, vertices, never_taken), (std::vector<Triangle>{{2, 1, 0}, {1, 3, 0}}));
}

TEST(LoopTriangles, DoNotTakeAnEdgeThatIsInUse) {
  const std::vector<Vector3> vertices = {{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {0, 1, 0}};
  const EdgeLoop loop{{0, 1, 2, 3}, std::vector<Vector3>(4, {0, 0, 1})};
  for (const auto& taken : {std::pair(0u, 2u), std::pair(1u, 3u)})
    for (const Triangle& t : loop_triangles(loop, vertices, [&](std::uint32_t a, std::uint32_t b) {
           return std::minmax(a, b) == std::minmax(taken.first, taken.second);
         }))
      EXPECT_FALSE(std::ranges::count(t, taken.first) && std::ranges::count(t, taken.second));
}

/// The triangulation of least area of a small loop that is not flat, by trying all of them.
double least_area(const std::vector<std::uint32_t>& loop, const std::vector<Vector3>& vertices) {
  if (loop.size() < 3) return 0;
  double least = HUGE_VAL;
  for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
    const std::vector<std::uint32_t> before(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(k) + 1),
        after(loop.begin() + static_cast<std::ptrdiff_t>(k), loop.end());
    const double own = shape_of(corners_of({loop.front(), loop[k], loop.back()}, vertices)).area;
    least = std::min(least, own + least_area(before, vertices) + least_area(after, vertices));
  }
  return least;
}

TEST(LoopTriangles, HaveTheLeastAreaOfAllWhereNoneTurns) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> height(-0.02, 0.02);  // turns of one class
  for (int run = 0; run < 20; ++run) {
    std::vector<Vector3> vertices;
    EdgeLoop loop;
    constexpr std::uint32_t kCount = 8;
    for (std::uint32_t k = 0; k < kCount; ++k) {
      const double angle = 2 * std::numbers::pi * k / kCount;
      vertices.push_back({std::cos(angle), std::sin(angle), height(random)});
      loop.vertices.push_back(k);
      loop.across.push_back({});
    }
    const std::vector<std::uint32_t> corners = loop.vertices;
    const auto triangles = loop_triangles(loop, vertices, never_taken);
    EXPECT_EQ(triangles.size(), kCount - 2);
    EXPECT_NEAR(area_of(triangles, vertices), least_area(corners, vertices), 1e-12);
  }
}

TEST(LoopTriangles, FillLoopsOfManyVertices) {
  EdgeLoop loop;
  std::vector<Vector3> vertices;
  const std::uint32_t count = 3 * kMostOptimal;
  for (std::uint32_t k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * k / count, radius = 1 + 0.3 * std::cos(5 * angle);
    vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    loop.vertices.push_back(k);
    loop.across.push_back({0, 0, 1});
  }
  const auto triangles = loop_triangles(loop, vertices, never_taken);
  EXPECT_EQ(triangles.size(), count - 2);
  EXPECT_NEAR(area_of(triangles, vertices), std::numbers::pi * (1 + 0.09 / 2), 1e-4);
  for (const Triangle& t : triangles) EXPECT_GE(shape_of(corners_of(t, vertices)).normal[2], 0);
}

TEST(HoleFilling, GivesBackTheFlatSidesOfABox) {
  for (const Vector3& side : {Vector3{1, 0, 0}, Vector3{0, 0, -1}}) {
    const TriangleMesh open = without(make_box({2, 2, 2}), side, 0.6);
    ASSERT_EQ(open.triangles.size(), 10u);
    const FilledSurface filled = with_filled_holes(open);
    EXPECT_EQ(filled.holes, 1u);
    EXPECT_EQ(filled.triangles, 2u);
    EXPECT_TRUE(analyse_topology(filled.mesh).watertight);
    EXPECT_NEAR(enclosed_volume(prepare_surface(CheckedMesh(filled.mesh))), 8, 1e-12);
  }
}

/// The rings at the ends of a tube: two loops each.
TEST(HoleFilling, TakesLoopsWithinOthersAsTheBorderOfOneFace) {
  TriangleMesh hole = make_box_with_hole(24);
  const double volume = enclosed_volume(prepare_surface(CheckedMesh(hole)));
  std::erase_if(hole.triangles, [&](const Triangle& t) {
    return std::ranges::all_of(t, [&](std::uint32_t v) { return hole.vertices[v][2] > 0.299; });
  });
  const FilledSurface filled = with_filled_holes(hole);
  EXPECT_EQ(filled.holes, 2u);
  EXPECT_TRUE(analyse_topology(filled.mesh).watertight);
  EXPECT_NEAR(enclosed_volume(prepare_surface(CheckedMesh(filled.mesh))), volume, 1e-12);
}

/// A tube within a tube, both without their ends: four loops in a plane, two rings.
TEST(HoleFilling, TakesRingsWithinRings) {
  TriangleMesh tubes;
  double volume = 0;
  for (const double radius : {2.0, 1.5, 1.0, 0.5}) {
    TriangleMesh cylinder = make_cylinder(radius, 1, 24);
    const double own = enclosed_volume(prepare_surface(CheckedMesh(cylinder)));
    const bool is_outer = radius == 2 || radius == 1;
    volume += is_outer ? own : -own;
    std::erase_if(cylinder.triangles, [&](const Triangle& t) {
      return std::abs(shape_of(corners_of(t, cylinder.vertices)).normal[2]) > 0.5;
    });
    tubes = join_meshes(tubes, is_outer ? cylinder : flip_mesh(cylinder));
  }
  const FilledSurface filled = with_filled_holes(weld(std::move(tubes)));
  EXPECT_EQ(filled.holes, 8u);
  EXPECT_TRUE(analyse_topology(filled.mesh).watertight);
  EXPECT_NEAR(enclosed_volume(prepare_surface(CheckedMesh(filled.mesh))), volume, 1e-9);
}

/// A plate whose top is missing, with square holes near to each other.
TEST(HoleFilling, TakesManyHolesOfAFace) {
  for (unsigned seed = 1; seed < 20; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> off(-0.8, 0.8);
    TriangleMesh plate = make_box({10, 10, 1});
    for (int i = 0; i < 9; ++i) {
      const Vector3 place{-3 + 3.0 * (i / 3) + off(random), -3 + 3.0 * (i % 3) + off(random), 0};
      plate = join_meshes(plate, flip_mesh(translate_mesh(make_box({1, 1, 3}), place)));
    }
    TriangleMesh open = united_surface(SearchableSurface(prepare_surface(CheckedMesh(plate)))).surface.mesh;
    ASSERT_NEAR(enclosed_volume(prepare_surface(CheckedMesh(open))), 91, 1e-9);
    std::erase_if(open.triangles, [&](const Triangle& t) {
      return std::ranges::all_of(t, [&](std::uint32_t v) { return open.vertices[v][2] > 0.499; });
    });
    const FilledSurface filled = with_filled_holes(open);
    EXPECT_EQ(filled.holes, 10u);
    EXPECT_NEAR(enclosed_volume(prepare_surface(CheckedMesh(filled.mesh))), 91, 1e-9);
    for (std::size_t t = open.triangles.size(); t < filled.mesh.triangles.size(); ++t)
      EXPECT_GT(shape_of(corners_of(filled.mesh.triangles[t], filled.mesh.vertices)).normal[2], 0.99);
  }
}

TEST(HoleFilling, NumbersFaces) {
  TriangleMesh box = make_box({2, 2, 2});
  const Triangle gone = box.triangles.front();
  box.triangles.erase(box.triangles.begin());
  box.faces.assign(box.triangles.size(), 3);
  EXPECT_EQ(with_filled_holes(box).mesh.faces.back(), 3);
  const auto is_beside = [&](const Triangle& t) {
    return std::ranges::count_if(t, [&](std::uint32_t v) { return std::ranges::count(gone, v) > 0; }) == 2;
  };
  const auto beside = std::ranges::find_if(box.triangles, is_beside) - box.triangles.begin();
  box.faces[static_cast<std::size_t>(beside)] = 1;
  EXPECT_EQ(with_filled_holes(box).mesh.faces.back(), 4);
}

TEST(ClosedSurface, IsFilledWhereTrianglesAreMissing) {
  std::mt19937 random(3);
  TriangleMesh sphere = make_sphere(1, 4);
  const double volume = enclosed_volume(prepare_surface(CheckedMesh(sphere)));
  std::erase_if(sphere.triangles, [&](const Triangle&) { return random() % 20 == 0; });
  const MendedSurface filled = closed(sphere);
  EXPECT_TRUE(filled.closed);
  EXPECT_NEAR(enclosed_volume(filled.surface), volume, 1e-3 * volume);
  ASSERT_NE(find(filled.findings, FindingKind::kHole), nullptr);
}

/// A side with four times as many triangles as its neighbours: vertices lie on edges, and in the middle of a
/// crack.
TEST(ClosedSurface, HasNoCracksWhereEdgesAreDividedOnOneSide) {
  for (const double off : {0.0, 1e-7}) {
    TriangleMesh box = make_box({2, 2, 2});
    TriangleMesh fine;
    for (std::size_t t = 0; t < box.triangles.size(); ++t) {
      const auto [a, b, c] = corners_of(box.triangles[t], box.vertices);
      const bool is_top = a[2] > 0 && b[2] > 0 && c[2] > 0;
      const Vector3 ab = 0.5 * (a + b) + Vector3{0, 0, off}, bc = 0.5 * (b + c), ca = 0.5 * (c + a);
      const std::vector<std::array<Vector3, 3>> parts =
          is_top ? std::vector<std::array<Vector3, 3>>{{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}}
                 : std::vector<std::array<Vector3, 3>>{{a, b, c}};
      for (const auto& part : parts) {
        const auto first = static_cast<std::uint32_t>(fine.vertices.size());
        fine.vertices.insert(fine.vertices.end(), part.begin(), part.end());
        fine.triangles.push_back({first, first + 1, first + 2});
      }
    }
    const MendedSurface whole = closed(fine);
    EXPECT_TRUE(whole.closed);
    EXPECT_EQ(find(whole.findings, FindingKind::kHole), nullptr) << off;
    EXPECT_NEAR(enclosed_volume(whole.surface), 8, 1e-6);
  }
}

/// Two boxes of side 2 that share one of side 2 - shift.
TEST(UnitedSurface, OfTwoBoxesHasTheirUnionsVolumeAndTopology) {
  for (const double shift : {0.5, 1.0, 2.0}) {
    for (const Vector3& way : {Vector3{1, 1, 1}, Vector3{1, 0, 0}}) {
      const TriangleMesh boxes =
          join_meshes(make_box({2, 2, 2}), translate_mesh(make_box({2, 2, 2}), shift * way));
      const MendedSurface one = united(boxes);
      const double common = (2 - shift) * (way[1] != 0 ? (2 - shift) * (2 - shift) : 4);
      EXPECT_TRUE(one.closed);
      EXPECT_NEAR(enclosed_volume(one.surface), 16 - common, 1e-9) << shift;
    }
  }
}

TEST(UnitedSurface, OfPartsThatAreInsideOutIsTheSame) {
  for (const double shift : {1.0, 2.0}) {
    const TriangleMesh boxes =
        join_meshes(make_box({2, 2, 2}), translate_mesh(make_box({2, 2, 2}), {shift, 0, 0}));
    const MendedSurface one = united(flip_mesh(boxes));
    EXPECT_TRUE(one.closed);
    EXPECT_NEAR(enclosed_volume(one.surface), 4 * (2 + shift), 1e-9);
  }
}

TEST(UnitedSurface, LeavesOutPartsWithinOthersAndKeepsVoids) {
  const TriangleMesh outer = make_box({2, 2, 2}), inner = make_box({1, 1, 1});
  EXPECT_NEAR(enclosed_volume(united(join_meshes(outer, inner)).surface), 8, 1e-12);
  EXPECT_NEAR(enclosed_volume(united(join_meshes(outer, flip_mesh(inner))).surface), 7, 1e-12);
}

/// A box that stands out of another by a little.
TEST(UnitedSurface, LeavesOutPiecesThinnerThanItsGap) {
  for (const double share : {0.1, 10.0}) {
    const double out = share * kUniteGap * 2;
    const MendedSurface one =
        united(join_meshes(make_box({2, 2, 2}), translate_mesh(make_box({1, 1, 1}), {0.5 + out, 0, 0})));
    EXPECT_TRUE(one.closed);
    EXPECT_NEAR(one.surface.box.high[0], share < 1 ? 1 : 1 + out, 0.5 * out);
  }
}

/// Winding numbers of the parts tell what is inside: a place is, if that of one part is 1.
TEST(UnitedSurface, EnclosesWhatItsPartsEnclose) {
  for (unsigned seed = 1; seed < 5; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const auto turned = [&](TriangleMesh mesh) {
      Quaternion turn{normal(random), normal(random), normal(random), normal(random)};
      const double length = std::sqrt(turn.w * turn.w + turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
      turn = {turn.w / length, turn.x / length, turn.y / length, turn.z / length};
      return translate_mesh(rotate_mesh(std::move(mesh), turn),
                            {0.4 * normal(random), 0.4 * normal(random), 0.4 * normal(random)});
    };
    const std::vector<TriangleMesh> parts = {turned(make_box({1, 1.5, 0.7})),
                                             turned(make_cylinder(0.5, 1, 32)), turned(make_sphere(0.6, 3))};
    const SearchableSurface one(united(join_meshes(join_meshes(parts[0], parts[1]), parts[2])));
    EXPECT_TRUE(one.mended().closed);
    std::vector<std::unique_ptr<SearchableSurface>> each;
    for (const TriangleMesh& part : parts) each.push_back(std::make_unique<SearchableSurface>(closed(part)));
    for (int k = 0; k < 500; ++k) {
      const Vector3 p{normal(random), normal(random), normal(random)};
      const bool inside =
          std::ranges::any_of(each, [&](const auto& part) { return part->winding().at(p) > 0.5; });
      EXPECT_NEAR(one.winding().at(p), inside ? 1 : 0, 0.05);
    }
  }
}

}  // namespace
}  // namespace crossgrain
