// SPDX-License-Identifier: Apache-2.0
#include "remeshing/remeshing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <set>

#include "base/ascending.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "remeshing/patch_mesh.hpp"
#include "support/curved_shapes.hpp"
#include "support/shapes.hpp"
#include "surface/mending.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

PatchedSurface patches_of(const TriangleMesh& mesh) {
  return patched(mend_surface(CheckedMesh(mesh)).surface, CreaseAngles());
}

Remeshing of_size(double size) {
  Remeshing options;
  options.size = size;
  return options;
}

PatchedSurface remeshed_shape(const TriangleMesh& mesh, double size) {
  return remeshed(patches_of(mesh), of_size(size));
}

TriangleMesh mesh_of(const PatchedSurface& surface) {
  TriangleMesh mesh;
  mesh.vertices = surface.vertices;
  mesh.triangles = surface.triangles;
  return mesh;
}

double volume_of(const PatchedSurface& surface) {
  return enclosed_volume(prepare_surface(CheckedMesh(mesh_of(surface))));
}

double worst_quality(const PatchedSurface& surface) {
  double worst = 1;
  for (const auto& triangle : surface.triangles)
    worst = std::min(worst, quality_of(corners_of(triangle, surface.vertices)));
  return worst;
}

std::vector<double> edge_lengths(const PatchedSurface& surface) {
  std::vector<double> lengths;
  for (const auto& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      lengths.push_back(norm(surface.vertices[t[(k + 1) % 3]] - surface.vertices[t[k]]));
  return lengths;
}

int euler_number(const PatchedSurface& surface) {
  std::set<std::array<std::uint32_t, 2>> edges;
  for (const auto& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.insert(ascending(std::array{t[k], t[(k + 1) % 3]}));
  return static_cast<int>(surface.vertices.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(surface.triangles.size());
}

TEST(PatchedSurface, OfABoxHasSixPatchesAndTwelveCurves) {
  const PatchedSurface box = patches_of(make_box({1, 2, 3}));
  EXPECT_EQ(box.tags, (std::vector<std::int32_t>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(box.curves.size(), 12u);
  EXPECT_EQ(std::count(box.is_sharp.begin(), box.is_sharp.end(), true), 12);
}

TEST(PatchedSurface, OfACylinderHasThreePatchesAndTwoClosedCurves) {
  const PatchedSurface cylinder = patches_of(make_cylinder(1, 2, 36));
  EXPECT_EQ(cylinder.patches(), 3u);
  ASSERT_EQ(cylinder.curves.size(), 2u);
  for (const auto& curve : cylinder.curves) EXPECT_EQ(curve.front(), curve.back());
}

TEST(PatchedSurface, IsAlsoCutBetweenFacesThatMeetSmoothly) {
  TriangleMesh sphere = make_sphere(1, 3);
  for (const auto& [a, b, c] : sphere.triangles) {
    const double middle = sphere.vertices[a][2] + sphere.vertices[b][2] + sphere.vertices[c][2];
    sphere.faces.push_back(middle > 0 ? 7 : 9);
  }
  const PatchedSurface halves = patches_of(sphere);
  EXPECT_EQ(std::set<std::int32_t>(halves.tags.begin(), halves.tags.end()), (std::set<std::int32_t>{7, 9}));
  ASSERT_EQ(halves.patches(), 2u);
  ASSERT_FALSE(halves.curves.empty());
  EXPECT_EQ(std::count(halves.is_sharp.begin(), halves.is_sharp.end(), true), 0);
}

TEST(Remeshing, OfABoxKeepsItsVolumeItsFacesAndItsEdges) {
  const PatchedSurface box = remeshed_shape(make_box({1, 2, 3}), 0.2);
  EXPECT_NEAR(volume_of(box), 6, 1e-12);
  EXPECT_TRUE(analyse_topology(mesh_of(box)).watertight);
  for (std::size_t t = 0; t < box.triangles.size(); ++t) {
    const auto corners = corners_of(box.triangles[t], box.vertices);
    const auto first = std::find(box.patch_of.begin(), box.patch_of.end(), box.patch_of[t]);
    const auto& other = box.triangles[static_cast<std::size_t>(first - box.patch_of.begin())];
    EXPECT_NEAR(dot(shape_of(corners).normal, shape_of(corners_of(other, box.vertices)).normal), 1, 1e-9);
  }
  ASSERT_EQ(box.curves.size(), 12u);
  for (const auto& curve : box.curves) {
    EXPECT_GE(curve.size(), 5u);
    const Vector3 &from = box.vertices[curve.front()], &to = box.vertices[curve.back()];
    for (const std::uint32_t v : curve) EXPECT_LT(distance_to_segment(box.vertices[v], from, to), 1e-12);
  }
}

TEST(Remeshing, MakesEdgesOfTheWantedSize) {
  for (const double size : {0.3, 0.15}) {
    std::vector<double> lengths = edge_lengths(remeshed_shape(make_box({1, 1, 1}), size));
    EXPECT_LT(*std::max_element(lengths.begin(), lengths.end()), 1.5 * size);
    EXPECT_GT(*std::min_element(lengths.begin(), lengths.end()), 0.4 * size);
    std::nth_element(lengths.begin(), lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2),
                     lengths.end());
    EXPECT_NEAR(lengths[lengths.size() / 2], 0.93 * size, 0.15 * size);
  }
}

TEST(Remeshing, MakesEvenTrianglesOfSlivers) {
  const TriangleMesh strips = make_cylinder(1, 10, 60);
  ASSERT_LT(worst_quality(patches_of(strips)), 0.02);
  const PatchedSurface even = remeshed_shape(strips, 1);
  EXPECT_GT(worst_quality(even), 0.3);
  EXPECT_NEAR(volume_of(even) / volume_of(patches_of(strips)), 1, 0.02);
}

TEST(Remeshing, FollowsCurvature) {
  Remeshing options = of_size(2);
  for (const double around : {12.0, 24.0}) {
    options.edges_per_circle = around;
    const PatchedSurface sphere = remeshed(patches_of(make_sphere(1, 5)), options);
    double sum = 0;
    const std::vector<double> lengths = edge_lengths(sphere);
    for (const double length : lengths) sum += length;
    const double wanted = 2 * std::numbers::pi / around;
    EXPECT_NEAR(sum / static_cast<double>(lengths.size()), wanted, 0.2 * wanted);
    EXPECT_GT(worst_quality(sphere), 0.5);
  }
}

TEST(Remeshing, KeepsHandles) {
  EXPECT_EQ(euler_number(remeshed_shape(make_torus(3, 1, 40, 20), 0.5)), 0);
  EXPECT_EQ(euler_number(remeshed_shape(make_box_with_hole(24), 0.2)), 0);
  EXPECT_EQ(euler_number(remeshed_shape(make_sphere(1, 4), 0.3)), 2);
}

TEST(Remeshing, StaysOnTheGivenSurface) {
  const double radius = 2;
  const PatchedSurface sphere = remeshed_shape(make_sphere(radius, 5), 0.4);
  for (const Vector3& vertex : sphere.vertices) EXPECT_NEAR(norm(vertex), radius, 2e-3);
}

TEST(Remeshing, IsTheSameTwice) {
  const PatchedSurface given = patches_of(make_knobbly_sphere(4, 0.1, 0.01, 3));
  const PatchedSurface first = remeshed(given, of_size(0.2)), second = remeshed(given, of_size(0.2));
  EXPECT_EQ(first.vertices, second.vertices);
  EXPECT_EQ(first.triangles, second.triangles);
  EXPECT_EQ(first.curves, second.curves);
}

/// The sheet on which both lie, with the same triangles at the edge in common.
TEST(Remeshing, LeavesAnEdgeOfFourTrianglesAsItIs) {
  TriangleMesh boxes = join_meshes(make_box({1, 1, 1}), translate_mesh(make_box({1, 1, 1}), {1, 1, 0}));
  const MendedSurface touching = mend_surface(CheckedMesh(boxes));
  ASSERT_GT(touching.topology.nonmanifold_edges, 0u);
  const PatchedSurface result = remeshed(patched(touching.surface, CreaseAngles()), of_size(0.3));
  EXPECT_NEAR(volume_of(result), 2, 1e-12);
  EXPECT_EQ(analyse_topology(mesh_of(result)).nonmanifold_edges, touching.topology.nonmanifold_edges);
  EXPECT_EQ(analyse_topology(mesh_of(result)).unbalanced_edges, 0u);
}

TEST(Remeshing, EndsWhenItIsInterrupted) {
  Monitor monitor;
  monitor.cancel();
  EXPECT_THROW(remeshed(patches_of(make_sphere(1, 4)), of_size(0.1), monitor), Error);
}

TEST(PatchMesh, RefusesToCollapseATriangleThatIsNoFace) {
  // Two pyramids with a common base that is no face: its edges have two triangles each, in a waist.
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 1}, {0.2, 0.2, -1}};
  mesh.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}};
  PatchedSurface surface;
  surface.vertices = mesh.vertices;
  surface.triangles = mesh.triangles;
  surface.patch_of.assign(6, 0);
  surface.tags = {1};
  const PatchMesh waist(surface, std::vector<double>(5, 1));
  PatchEdge edge;
  ASSERT_TRUE(waist.find(0, 1, edge));
  EXPECT_FALSE(waist.may_collapse(edge));
}

TEST(PatchMesh, ASplitAndTheCollapseOfItGiveTheSameTriangles) {
  const PatchedSurface box = patches_of(make_box({1, 1, 1}));
  PatchMesh mesh(box, std::vector<double>(box.vertices.size(), 1));
  for (const auto& [a, b] : mesh.edges()) {
    PatchEdge edge;
    ASSERT_TRUE(mesh.find(a, b, edge));
    const bool on_curve = mesh.curve_of(a, b) != kNoCurve;
    const Vector3 middle = 0.5 * (mesh.vertices[a].position + mesh.vertices[b].position);
    const std::uint32_t home = on_curve ? mesh.curve_of(a, b) : mesh.patch_of(edge.triangles[0]);
    const std::uint32_t v = mesh.split(edge, {middle, 1, on_curve ? Hold::kCurve : Hold::kPatch, home});
    ASSERT_TRUE(mesh.find(v, b, edge));
    ASSERT_TRUE(mesh.may_collapse(edge));
    mesh.collapse(edge);
  }
  const PatchedSurface after = mesh.result(box);
  EXPECT_EQ(after.vertices, box.vertices);
  const auto sorted = [](const PatchedSurface& surface) {
    std::set<std::array<std::uint32_t, 3>> all;
    for (const auto& t : surface.triangles) all.insert(ascending(t));
    return all;
  };
  EXPECT_EQ(sorted(after), sorted(box));
  EXPECT_EQ(after.curves, box.curves);
}

}  // namespace
}  // namespace crossgrain
