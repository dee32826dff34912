// SPDX-License-Identifier: Apache-2.0
#include "measure/feature_measure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <vector>

#include "base/vector3.hpp"
#include "crossgrain/thread_limit.hpp"
#include "measure/surface_quads.hpp"
#include "support/shapes.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

using std::numbers::pi;
using Kind = FeatureMeasure::Kind;

FeatureComplex features_of_mesh(const TriangleMesh& mesh) {
  return feature_complex(prepare_surface(weld(mesh)));
}

/// The box of this size about the origin, as hexahedra.
HexMesh hexahedra_of_box(const Vector3& size, const std::array<std::uint32_t, 3>& cells) {
  HexMesh mesh;
  for (std::uint32_t z = 0; z <= cells[2]; ++z)
    for (std::uint32_t y = 0; y <= cells[1]; ++y)
      for (std::uint32_t x = 0; x <= cells[0]; ++x)
        mesh.vertices.push_back({size[0] * (1.0 * x / cells[0] - 0.5), size[1] * (1.0 * y / cells[1] - 0.5),
                                 size[2] * (1.0 * z / cells[2] - 0.5)});
  const auto at = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return (z * (cells[1] + 1) + y) * (cells[0] + 1) + x;
  };
  for (std::uint32_t z = 0; z < cells[2]; ++z)
    for (std::uint32_t y = 0; y < cells[1]; ++y)
      for (std::uint32_t x = 0; x < cells[0]; ++x)
        mesh.hexahedra.push_back({at(x, y, z), at(x + 1, y, z), at(x + 1, y + 1, z), at(x, y + 1, z),
                                  at(x, y, z + 1), at(x + 1, y, z + 1), at(x + 1, y + 1, z + 1),
                                  at(x, y + 1, z + 1)});
  return mesh;
}

std::uint32_t vertex_at(const HexMesh& mesh, const Vector3& place) {
  const auto found =
      std::ranges::find_if(mesh.vertices, [&](const Vector3& vertex) { return norm(vertex - place) < 1e-9; });
  EXPECT_NE(found, mesh.vertices.end());
  return static_cast<std::uint32_t>(found - mesh.vertices.begin());
}

std::vector<Kind> kinds_of(const std::vector<FeatureMeasure::Lack>& lacks) {
  std::vector<Kind> kinds;
  for (const auto& lack : lacks) kinds.push_back(lack.kind);
  return kinds;
}

TEST(FeatureMeasure, FindsNothingLackingOnABoxOfCubes) {
  const FeatureMeasure measure =
      feature_measure(hexahedra_of_box({4, 4, 4}, {4, 4, 4}), features_of_mesh(make_box({4, 4, 4})), 1);
  EXPECT_TRUE(measure.is_faithful());
  EXPECT_EQ(measure.corners.all, 8);
  EXPECT_EQ(measure.corners.kept, 8);
  EXPECT_EQ(measure.curves.kept, 12);
  EXPECT_NEAR(measure.curve_length.kept, 48, 1e-9);
  EXPECT_EQ(measure.faces.kept, 6);
  for (const std::size_t quads : measure.quads_of_faces) EXPECT_EQ(quads, 16u);
  EXPECT_NEAR(measure.distances.of_mesh.largest_in_all, 0, 1e-12);
  EXPECT_NEAR(measure.distances.of_model.largest_in_all, 0, 1e-12);
  EXPECT_NEAR(measure.volume_ratio, 1, 1e-12);
}

TEST(FeatureMeasure, CountsTunnelsAndClosedSurfaces) {
  HexMesh mesh = hexahedra_of_box({5, 5, 5}, {5, 5, 5});
  const FeatureComplex box = features_of_mesh(make_box({5, 5, 5}));
  EXPECT_EQ(feature_measure(mesh, box, 1).shells, std::vector{2});
  EXPECT_EQ(feature_measure(mesh, box, 1).model_shells, std::vector{2});
  mesh.hexahedra.erase(mesh.hexahedra.begin() + 62);  // the one in the middle
  EXPECT_EQ(feature_measure(mesh, box, 1).shells, (std::vector{2, 2}));
  for (const int index : {111, 86, 37, 12}) mesh.hexahedra.erase(mesh.hexahedra.begin() + index);
  EXPECT_EQ(feature_measure(mesh, box, 1).shells, std::vector{0});
}

TEST(FeatureMeasure, TellsHowFarAVertexIsOffItsCorner) {
  HexMesh mesh = hexahedra_of_box({4, 4, 4}, {4, 4, 4});
  const FeatureComplex complex = features_of_mesh(make_box({4, 4, 4}));
  mesh.vertices[vertex_at(mesh, {2, 2, 2})] = {1.89, 2, 2};
  EXPECT_TRUE(feature_measure(mesh, complex, 1).is_faithful());
  mesh.vertices[vertex_at(mesh, {1.89, 2, 2})] = {1.85, 2, 2};
  const FeatureMeasure measure = feature_measure(mesh, complex, 1);
  EXPECT_EQ(measure.corners.kept, 7);
  EXPECT_EQ(measure.curves.kept, 9);
  ASSERT_FALSE(measure.lacking.empty());
  EXPECT_EQ(measure.lacking[0].kind, Kind::kCorner);
  EXPECT_EQ(measure.lacking[0].place, (Vector3{2, 2, 2}));
}

TEST(FeatureMeasure, TellsTheShareOfACurveThatIsKept) {
  HexMesh mesh = hexahedra_of_box({4, 4, 4}, {4, 4, 4});
  const FeatureComplex complex = features_of_mesh(make_box({4, 4, 4}));
  mesh.vertices[vertex_at(mesh, {0, 2, 2})] = {0, 1.7, 1.7};
  const FeatureMeasure measure = feature_measure(mesh, complex, 1);
  EXPECT_EQ(measure.curves.kept, 11);
  EXPECT_NEAR(measure.curve_length.kept, 46, 1e-9);
  ASSERT_FALSE(measure.lacking.empty());
  EXPECT_EQ(measure.lacking[0].kind, Kind::kCurve);
  EXPECT_NEAR(measure.lacking[0].share, 0.5, 1e-9);
  EXPECT_LT(norm(measure.lacking[0].place - Vector3{0, 2, 2}), 1.01);
}

TEST(FeatureMeasure, MeasuresAGivenPathAsOneThatItFinds) {
  HexMesh mesh = hexahedra_of_box({4, 4, 4}, {4, 4, 4});
  const FeatureComplex complex = features_of_mesh(make_box({4, 4, 4}));
  FeaturePlaces places;
  const auto quads = surface_quads(mesh, std::vector<std::int32_t>(64, 1));
  for (const auto& corner : complex.corners) places.vertex_of_corner.push_back(vertex_at(mesh, corner.point));
  for (const auto& curve : complex.curves) {
    const Vector3 a = complex.vertices[curve.vertices.front()], b = complex.vertices[curve.vertices.back()];
    auto& path = places.path_of_curve.emplace_back();
    for (int k = 0; k <= 4; ++k) path.push_back(vertex_at(mesh, a + (k / 4.0) * (b - a)));
  }
  for (const auto& quad : quads) {
    Vector3 centre{0, 0, 0};
    for (const std::uint32_t v : quad.vertices) centre += 0.25 * mesh.vertices[v];
    const auto face = std::ranges::find_if(complex.faces, [&](const auto& it) {
      const std::array<Vector3, 3> corners = complex.points_of(it.triangles[0]);
      return std::abs(dot(centre - corners[0], shape_of(corners).normal)) < 1e-9;
    });
    places.face_of_quad.push_back(static_cast<std::uint32_t>(face - complex.faces.begin()));
  }
  EXPECT_TRUE(feature_measure(mesh, complex, 1, &places).is_faithful());
  mesh.vertices[vertex_at(mesh, {0, 2, 2})] = {0, 1.7, 1.7};
  const FeatureMeasure given = feature_measure(mesh, complex, 1, &places);
  const FeatureMeasure found = feature_measure(mesh, complex, 1);
  EXPECT_EQ(kinds_of(given.lacking), kinds_of(found.lacking));
  EXPECT_EQ(given.curve_length.kept, found.curve_length.kept);
  // The given path tells how far it is off.
  EXPECT_NEAR(given.lacking[0].figure, 0.3 * std::sqrt(2), 0.01);
  // A path of no edges of the mesh keeps nothing.
  for (auto& path : places.path_of_curve) path = {path.front(), path.back()};
  EXPECT_EQ(feature_measure(mesh, complex, 1, &places).curves.kept, 0);
}

/// A cylinder about the z axis: a square of cells around which rings of cells reach the circle.
HexMesh hexahedra_of_cylinder(double radius, double height, std::uint32_t side, std::uint32_t rings,
                              std::uint32_t layers) {
  const std::uint32_t around = 4 * side;
  HexMesh mesh;
  std::map<std::array<std::uint32_t, 4>, std::uint32_t> numbers;
  const auto number = [&](const std::array<std::uint32_t, 4>& key, const Vector3& place) {
    const auto [entry, is_new] = numbers.try_emplace(key, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (is_new) mesh.vertices.push_back(place);
    return entry->second;
  };
  const auto square_at = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    const double share = 0.5 * radius;
    return number({0, x, y, z},
                  {share * (2.0 * x / side - 1), share * (2.0 * y / side - 1), height * z / layers});
  };
  const auto on_square = [&](std::uint32_t k) -> std::array<std::uint32_t, 2> {
    const std::uint32_t s = k / side % 4, rest = k % side;
    if (s == 0) return {rest, 0};
    if (s == 1) return {side, rest};
    if (s == 2) return {side - rest, side};
    return {0, side - rest};
  };
  const auto ring_at = [&](std::uint32_t k, std::uint32_t ring, std::uint32_t z) {
    const auto [x, y] = on_square(k % around);
    const std::uint32_t inner = square_at(x, y, z);
    if (ring == 0) return inner;
    const double angle = 2 * pi * (k % around) / around - 3 * pi / 4, share = 1.0 * ring / rings;
    const Vector3 outer{radius * std::cos(angle), radius * std::sin(angle), height * z / layers};
    const Vector3 from = mesh.vertices[inner];
    return number({1, k % around, ring, z}, from + share * (outer - from));
  };
  for (std::uint32_t z = 0; z < layers; ++z) {
    for (std::uint32_t x = 0; x < side; ++x)
      for (std::uint32_t y = 0; y < side; ++y)
        mesh.hexahedra.push_back({square_at(x, y, z), square_at(x + 1, y, z), square_at(x + 1, y + 1, z),
                                  square_at(x, y + 1, z), square_at(x, y, z + 1), square_at(x + 1, y, z + 1),
                                  square_at(x + 1, y + 1, z + 1), square_at(x, y + 1, z + 1)});
    for (std::uint32_t k = 0; k < around; ++k)
      for (std::uint32_t r = 0; r < rings; ++r)
        mesh.hexahedra.push_back({ring_at(k, r, z), ring_at(k, r + 1, z), ring_at(k + 1, r + 1, z),
                                  ring_at(k + 1, r, z), ring_at(k, r, z + 1), ring_at(k, r + 1, z + 1),
                                  ring_at(k + 1, r + 1, z + 1), ring_at(k + 1, r, z + 1)});
  }
  return mesh;
}

TriangleMesh cylinder_from_zero(double radius, double height, int segments) {
  return translate_mesh(make_cylinder(radius, height / 2, segments, 24), {0, 0, height / 2});
}

TEST(FeatureMeasure, AllowsWhatStraightEdgesCutOffAroundACylinder) {
  // Chords of 30 degrees are 3.4 % of the radius off the circle.
  const FeatureComplex complex = features_of_mesh(cylinder_from_zero(2, 3, 192));
  const FeatureMeasure measure = feature_measure(hexahedra_of_cylinder(2, 3, 3, 2, 3), complex, 1);
  EXPECT_EQ(measure.curves.all, 2);
  EXPECT_EQ(measure.curves.kept, 2);
  EXPECT_NEAR(measure.curve_length.kept, 8 * pi, 0.01);
  EXPECT_EQ(measure.faces.kept, 3);
  EXPECT_NEAR(measure.distances.of_mesh.largest_in_all, 2 * (1 - std::cos(pi / 12)), 0.002);
  EXPECT_LT(measure.distances.of_mesh.largest, 0.01);
  EXPECT_LT(measure.distances.of_model.largest, 0.01);
  // Twelve edges around: sin(30 degrees) / (30 degrees) of the volume.
  EXPECT_NEAR(measure.volume_ratio, std::sin(pi / 6) / (pi / 6), 0.001);
  EXPECT_TRUE(measure.is_faithful());
}

TEST(FeatureMeasure, LetsNoMeshOfEightEdgesAroundPass) {
  const FeatureComplex complex = features_of_mesh(cylinder_from_zero(2, 3, 192));
  const FeatureMeasure measure = feature_measure(hexahedra_of_cylinder(2, 3, 2, 2, 3), complex, 1.5);
  EXPECT_EQ(kinds_of(measure.lacking), (std::vector<Kind>{Kind::kVolume}));
  EXPECT_NEAR(measure.lacking[0].figure, std::sin(pi / 4) / (pi / 4), 0.001);
}

TEST(FeatureMeasure, TellsWhatIsTooFarOff) {
  HexMesh mesh = hexahedra_of_box({4, 4, 4}, {4, 4, 4});
  const FeatureComplex complex = features_of_mesh(make_box({4, 4, 4}));
  mesh.vertices[vertex_at(mesh, {0, 0, 2})][2] += 0.3;
  const FeatureMeasure measure = feature_measure(mesh, complex, 1);
  EXPECT_NEAR(measure.distances.of_mesh.largest, 0.3, 1e-12);
  EXPECT_EQ(measure.distances.of_mesh.place, (Vector3{0, 0, 2.3}));
  EXPECT_EQ(kinds_of(measure.lacking), (std::vector<Kind>{Kind::kOffModel, Kind::kOffMesh}));
}

TEST(FeatureMeasure, MissesTheModelsPartsThatNoHexahedronFills) {
  HexMesh mesh = hexahedra_of_box({4, 4, 4}, {4, 4, 4});
  mesh.hexahedra.erase(mesh.hexahedra.begin() + 63);
  const FeatureMeasure measure = feature_measure(mesh, features_of_mesh(make_box({4, 4, 4})), 1);
  EXPECT_EQ(measure.corners.kept, 7);
  EXPECT_EQ(measure.curves.kept, 9);
  EXPECT_NEAR(measure.curve_length.kept, 45, 1e-9);
  EXPECT_NEAR(measure.distances.of_model.largest, 1, 1e-9);
  EXPECT_EQ(measure.distances.of_model.place, (Vector3{2, 2, 2}));
}

TEST(FeatureResolution, OfAThinPlateLeavesItsRimToSmallerHexahedra) {
  const FeatureComplex complex = features_of_mesh(make_box({8, 8, 0.5}));
  std::vector<MeasuredCurve> lines;
  for (const auto& curve : complex.curves) lines.emplace_back(complex, curve);
  const FeatureResolution coarse = feature_resolution(complex, lines, 1);
  for (std::size_t c = 0; c < lines.size(); ++c) {
    EXPECT_FALSE(coarse.curves[c].is_resolved);
    EXPECT_NEAR(coarse.curves[c].size_to_show, lines[c].length() < 1 ? 0.25 : 0.5, 0.01);
  }
  EXPECT_EQ(std::ranges::count_if(coarse.faces, &Resolution::is_resolved), 2);
  for (const Resolution& corner : coarse.corners) EXPECT_NEAR(corner.size_to_show, 0.5, 1e-12);
  const FeatureResolution fine = feature_resolution(complex, lines, 0.24);
  EXPECT_TRUE(std::ranges::all_of(fine.curves, &Resolution::is_resolved));
  EXPECT_TRUE(std::ranges::all_of(fine.corners, &Resolution::is_resolved));
  EXPECT_TRUE(std::ranges::all_of(fine.faces, &Resolution::is_resolved));
}

TEST(FeatureResolution, NeedsThreeEdgesAroundAHole) {
  const FeatureComplex complex = features_of_mesh(make_box_with_hole(48));
  std::vector<MeasuredCurve> lines;
  for (const auto& curve : complex.curves) lines.emplace_back(complex, curve);
  for (const auto& [size, expected] : std::vector<std::pair<double, bool>>{{0.2, true}, {0.55, false}}) {
    const FeatureResolution resolution = feature_resolution(complex, lines, size);
    for (std::size_t c = 0; c < lines.size(); ++c)
      EXPECT_TRUE(!lines[c].is_closed() || resolution.curves[c].is_resolved == expected) << size;
  }
}

TEST(FeatureMeasure, ListsWhatIsSmallerThanTheHexahedraApart) {
  const FeatureComplex complex = features_of_mesh(make_box({8, 8, 0.5}));
  HexMesh mesh = hexahedra_of_box({8, 8, 0.5}, {8, 8, 1});
  EXPECT_TRUE(feature_measure(mesh, complex, 1).too_small.empty()) << "all are kept";
  for (Vector3& vertex : mesh.vertices)
    for (const std::size_t axis : {0u, 1u}) vertex[axis] *= 0.98;
  const FeatureMeasure measure = feature_measure(mesh, complex, 1);
  EXPECT_EQ(measure.corners.all, 0);
  EXPECT_EQ(std::ranges::count(measure.too_small, Kind::kCorner, &FeatureMeasure::Lack::kind), 0);
  for (Vector3& vertex : mesh.vertices)
    for (const std::size_t axis : {0u, 1u}) vertex[axis] *= 0.95;
  const FeatureMeasure smaller = feature_measure(mesh, complex, 1);
  EXPECT_EQ(std::ranges::count(smaller.too_small, Kind::kCorner, &FeatureMeasure::Lack::kind), 8);
  EXPECT_EQ(std::ranges::count(smaller.too_small, Kind::kCurve, &FeatureMeasure::Lack::kind), 12);
  for (const auto& lack : smaller.too_small) EXPECT_GT(lack.size_to_show, 0);
}

TEST(FeatureMeasure, MeasuresTheFaceBetweenTwoSolids) {
  TriangleMesh left = translate_mesh(make_box({4, 4, 4}), {-2, 0, 0}), right = left;
  for (Vector3& vertex : right.vertices) vertex[0] = -vertex[0];
  right = flip_mesh(std::move(right));
  TriangleMesh both = join_meshes(left, right);
  both.solids.assign(left.triangles.size(), 0);
  both.solids.resize(both.triangles.size(), 1);
  const FeatureComplex complex = features_of_mesh(both);
  HexMesh mesh = hexahedra_of_box({8, 4, 4}, {8, 4, 4});
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h) mesh.regions.push_back(h % 8 < 4 ? 0 : 1);
  const FeatureMeasure measure = feature_measure(mesh, complex, 1);
  EXPECT_TRUE(measure.is_faithful());
  EXPECT_EQ(measure.faces.kept, 11);
  EXPECT_EQ(measure.curves.kept, 20);
  // A cell that changes sides carries the interface along.
  mesh.regions[8 * 4 * 2 + 8 * 2 + 3] = 1;
  const FeatureMeasure moved = feature_measure(mesh, complex, 1);
  EXPECT_NEAR(moved.distances.of_mesh.largest, 1, 1e-9);
  EXPECT_FALSE(moved.is_faithful());
}

TEST(FeatureMeasure, IsTheSameForAnyNumberOfThreads) {
  const FeatureComplex complex = features_of_mesh(cylinder_from_zero(2, 3, 96));
  HexMesh mesh = hexahedra_of_cylinder(2, 3, 4, 3, 6);
  std::mt19937 random(5);
  for (Vector3& vertex : mesh.vertices)
    for (double& x : vertex) x += 0.1 * (static_cast<double>(random()) / 4294967296.0 - 0.5);
  const auto figures = [&](unsigned threads) {
    const ThreadLimit limit(threads);
    const FeatureMeasure measure = feature_measure(mesh, complex, 0.6);
    std::vector<double> all{measure.curve_length.kept,          measure.distances.of_mesh.percentile_99,
                            measure.distances.of_mesh.largest,  measure.distances.of_model.percentile_99,
                            measure.distances.of_model.largest, measure.volume_ratio};
    for (const auto& lack : measure.lacking) all.insert(all.end(), {lack.figure, lack.share, lack.place[0]});
    return all;
  };
  EXPECT_EQ(figures(1), figures(2));
  EXPECT_EQ(figures(1), figures(3));
}

TEST(FeatureMeasure, MeasuresAnyMeshAgainstAnyModel) {
  // No crash and no endless loop, whatever lies where.
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const auto number = [&] { return 4 * (static_cast<double>(random()) / 4294967296.0 - 0.5); };
    TriangleMesh soup;
    for (int k = 0; k < 12; ++k) soup.vertices.push_back({number(), number(), number()});
    for (int t = 0; t < 20; ++t)
      soup.triangles.push_back({static_cast<std::uint32_t>(random() % 12),
                                static_cast<std::uint32_t>(random() % 12),
                                static_cast<std::uint32_t>(random() % 12)});
    HexMesh mesh = hexahedra_of_box({4, 4, 4}, {3, 3, 3});
    for (Vector3& vertex : mesh.vertices)
      if (random() % 3 == 0) vertex = {number(), number(), number()};
    const FeatureMeasure measure = feature_measure(mesh, feature_complex(prepare_surface(soup)), 0.5);
    EXPECT_LE(measure.curves.kept, measure.curves.all);
    EXPECT_LE(measure.curve_length.kept, measure.curve_length.all * (1 + 1e-9));
  }
}

}  // namespace
}  // namespace crossgrain
