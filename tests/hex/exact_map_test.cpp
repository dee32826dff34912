// SPDX-License-Identifier: Apache-2.0
#include "hex/exact_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "map/arced_cylinder.hpp"
#include "map/integer_grid_map.hpp"

namespace crossgrain {
namespace {

/// A point in eighths of a unit: determinants of a few units fit 64 bits.
using Eighths = std::array<std::int64_t, 3>;

ExactPoint exact(const Eighths& p) {
  return {p[0] * kGridUnit / 8, p[1] * kGridUnit / 8, p[2] * kGridUnit / 8};
}

Eighths minus(const Eighths& a, const Eighths& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Eighths across(const Eighths& a, const Eighths& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

std::int64_t product(const Eighths& a, const Eighths& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::int64_t six_times_volume(const std::array<Eighths, 4>& t) {
  return product(across(minus(t[1], t[0]), minus(t[2], t[0])), minus(t[3], t[0]));
}

/// Whether the hull of points meets the open cell, by the separating axes of two convex bodies: normals of
/// both, products of their edges, and, for flat hulls, normals of their borders within the plane.
bool meets_cell(std::span<const Eighths> points, const Eighths& low) {
  std::vector<Eighths> axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, edges, normals;
  for (std::size_t a = 0; a < points.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) edges.push_back(minus(points[a], points[b]));
  for (const Eighths& e : edges)
    for (const Eighths& f : edges) normals.push_back(across(e, f));
  for (const Eighths& e : edges)
    for (std::size_t k = 0; k < 3; ++k) normals.push_back(across(e, axes[k]));
  axes.insert(axes.end(), normals.begin(), normals.end());
  for (const Eighths& n : normals)
    for (const Eighths& e : edges) axes.push_back(across(n, e));
  for (const Eighths& axis : axes) {
    if (axis == Eighths{0, 0, 0}) continue;
    std::int64_t least = INT64_MAX, most = INT64_MIN, cell_least = product(axis, low), cell_most = cell_least;
    for (const Eighths& p : points) {
      least = std::min(least, product(axis, p));
      most = std::max(most, product(axis, p));
    }
    for (const std::int64_t x : axis) (x < 0 ? cell_least : cell_most) += 8 * x;
    if (most <= cell_least || least >= cell_most) return false;
  }
  return true;
}

std::vector<std::array<Eighths, 4>> random_tets(int count) {
  std::mt19937 random(7);
  std::uniform_int_distribution<std::int64_t> coordinate(-12, 20), choice(0, 3);
  std::vector<std::array<Eighths, 4>> tets;
  for (int k = 0; k < count; ++k) {
    std::array<Eighths, 4> tet{};
    for (Eighths& p : tet)
      for (std::int64_t& x : p) x = coordinate(random) & (k % 2 ? -1 : -8);  // half of them on the grid
    // Some are flat.
    if (k % 5 == 0) tet[3] = tet[static_cast<std::size_t>(choice(random))];
    tets.push_back(tet);
  }
  return tets;
}

template <class Visit>
void for_each_cell_nearby(const Visit& visit) {
  for (std::int64_t x = -24; x <= 32; x += 8)
    for (std::int64_t y = -24; y <= 32; y += 8)
      for (std::int64_t z = -24; z <= 32; z += 8) visit(Eighths{x, y, z});
}

TEST(TetPart, HasTheVerticesOfTheGridThatAreInTheTet) {
  std::size_t found = 0;
  for (const std::array<Eighths, 4>& tet : random_tets(400)) {
    const std::int64_t volume = six_times_volume(tet);
    std::vector<ExactPoint> expected, are;
    for_each_cell_nearby([&](const Eighths& p) {
      bool is_inside = volume != 0;
      for (std::size_t k = 0; k < 4; ++k) {
        std::array<Eighths, 4> other = tet;
        other[k] = p;
        is_inside = is_inside && (volume > 0 ? six_times_volume(other) >= 0 : six_times_volume(other) <= 0);
      }
      if (is_inside) expected.push_back(exact(p));
    });
    const TetPart part = part_of({exact(tet[0]), exact(tet[1]), exact(tet[2]), exact(tet[3])});
    for (const TetPart::Vertex& vertex : part.vertices) are.push_back(vertex.at);
    EXPECT_EQ(are, expected) << "ascending";
    found += are.size();
  }
  EXPECT_GT(found, 400u);
}

TEST(TetPart, HasTheCellsThatMeetTheTetAndItsFaces) {
  std::size_t found = 0;
  for (const std::array<Eighths, 4>& tet : random_tets(100)) {
    const TetPart part = part_of({exact(tet[0]), exact(tet[1]), exact(tet[2]), exact(tet[3])});
    EXPECT_TRUE(std::is_sorted(part.cells.begin(), part.cells.end()));
    auto cell = part.cells.begin();
    for_each_cell_nearby([&](const Eighths& low) {
      const bool is_listed = cell != part.cells.end() && cell->low == exact(low);
      EXPECT_EQ(is_listed, meets_cell(tet, low));
      if (!is_listed) return;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::array<Eighths, 3> face{tet[(k + 1) % 4], tet[(k + 2) % 4], tet[(k + 3) % 4]};
        EXPECT_EQ(cell->meets_face[k], meets_cell(face, low));
      }
      ++cell;
    });
    EXPECT_EQ(cell, part.cells.end());
    found += part.cells.size();
  }
  EXPECT_GT(found, 200u);
}

TEST(TetPart, WeighsItsVerticesSoThatTheyAreTheMeanOfTheCorners) {
  for (const std::array<Eighths, 4>& tet : random_tets(100)) {
    const std::array<ExactPoint, 4> corners{exact(tet[0]), exact(tet[1]), exact(tet[2]), exact(tet[3])};
    const ExactPoint anywhere{12345, -6789, 3 * kGridUnit + 1};
    const std::array<Int128, 4> weights = weights_of(corners, anywhere);
    const Int128 volume = part_of(corners).volume;
    constexpr std::int64_t kEighth = kGridUnit / 8;
    EXPECT_TRUE(volume == Int128{kEighth} * kEighth * kEighth * six_times_volume(tet));
    EXPECT_TRUE(weights[0] + weights[1] + weights[2] + weights[3] == volume);
    for (std::size_t k = 0; k < 3; ++k) {
      Int128 sum = 0;
      for (std::size_t c = 0; c < 4; ++c) sum += weights[c] * corners[c][k];
      EXPECT_TRUE(sum == volume * anywhere[k]);
    }
  }
}

TEST(ExactMap, TurnsPointsAsTheGroupOfTheCubeDoes) {
  const CubeGroup& group = CubeGroup::instance();
  const ExactPoint p{3, -70, 1100};
  for (std::uint8_t a = 0; a < CubeGroup::kCount; ++a) {
    const Vector3 expected = rotate(to_quaternion(group[a]), Vector3{3, -70, 1100});
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(turned(a, p)[k], std::llround(expected[k]));
    EXPECT_EQ(turned(group.inverse_of(a), turned(a, p)), p);
    for (std::uint8_t b = 0; b < CubeGroup::kCount; ++b)
      EXPECT_EQ(turned(group.product(a, b), p), turned(a, turned(b, p)));
  }
}

struct MappedCylinder {
  testing::ArcedCylinder cylinder;
  MapCoordinates map = integer_grid_map(MapEnergy(cylinder.unknowns, 0.5)).coordinates;
  ExactMap exact{cylinder.unknowns, map};
};

std::size_t corner_of(const TetSolid& solid, std::uint32_t tet, std::uint32_t vertex) {
  const auto& corners = solid.mesh.tets[tet];
  return static_cast<std::size_t>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
}

TEST(ExactMap, IsContinuousToTheLastBitAcrossTheCut) {
  const MappedCylinder mapped;
  const TetSolid& solid = mapped.exact.solid();
  std::size_t cut = 0;
  for (std::uint32_t f = 0; f < solid.inner_faces.size(); ++f) {
    const auto& [vertices, tets] = solid.inner_faces[f];
    cut += mapped.exact.cut().is_cut(f);
    for (const std::uint32_t v : vertices) {
      const ExactPoint before = mapped.exact.corners(tets[0])[corner_of(solid, tets[0], v)],
                       after = mapped.exact.corners(tets[1])[corner_of(solid, tets[1], v)];
      EXPECT_EQ(mapped.exact.carried(before, {f, false}), after);
      EXPECT_EQ(mapped.exact.carried(after, {f, true}), before);
    }
  }
  EXPECT_GT(cut, 0u);
}

TEST(ExactMap, IsTheGivenOneButForRounding) {
  const MappedCylinder mapped;
  const TetSolid& solid = mapped.exact.solid();
  for (std::uint32_t t = 0; t < solid.mesh.tets.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto row = static_cast<Eigen::Index>(3 * mapped.exact.cut().copy_of(t, k) + axis);
        const double found = std::ldexp(static_cast<double>(mapped.exact.corners(t)[k][axis]), -20);
        // Half a step, and what translations of the map miss of whole numbers.
        EXPECT_NEAR(found, mapped.map[row], std::ldexp(0.5, -20) + 1e-8);
      }
}

TEST(ExactMap, CarriesCellsAsItsCornersAndTurnsAsItsDifferences) {
  const MappedCylinder mapped;
  const ExactPoint low{5 * kGridUnit, -3 * kGridUnit, 7 * kGridUnit};
  for (std::uint32_t f = 0; f < mapped.exact.solid().inner_faces.size(); ++f) {
    for (const bool reversed : {false, true}) {
      const Crossing crossing{f, reversed};
      const ExactPoint origin = mapped.exact.carried({0, 0, 0}, crossing);
      ExactPoint least = mapped.exact.carried(low, crossing);
      for (unsigned corner = 0; corner < 8; ++corner) {
        ExactPoint p = low;
        for (std::size_t k = 0; k < 3; ++k) p[k] += corner >> k & 1 ? kGridUnit : 0;
        const ExactPoint there = mapped.exact.carried(p, crossing);
        const ExactPoint turn = turned(mapped.exact.rotation_across(crossing), p);
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_EQ(there[k] - origin[k], turn[k]);
          least[k] = std::min(least[k], there[k]);
        }
      }
      EXPECT_EQ(mapped.exact.carried_cell(low, crossing), least);
    }
  }
}

TEST(ExactMap, RefusesCoordinatesBeyondItsLimitOnly) {
  const testing::AskewBox box({1, 1, 1});
  const auto of = [&](double coordinate) {
    return MapCoordinates::Constant(static_cast<Eigen::Index>(3 * box.cut.copies()), coordinate).eval();
  };
  EXPECT_EQ(ExactMap(box.unknowns, of(kLargestCoordinate)).corners(0)[0][0], 4000 * kGridUnit);
  for (const double beyond : {kLargestCoordinate * (1 + 1e-15), -kLargestCoordinate - 1}) {
    try {
      const ExactMap map(box.unknowns, of(beyond));
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kLimit);
    }
  }
}

}  // namespace
}  // namespace crossgrain
