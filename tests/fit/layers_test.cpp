// SPDX-License-Identifier: Apache-2.0
#include "fit/layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "base/degree.hpp"
#include "fit/curve_wedges.hpp"
#include "fit/embedded_lattice.hpp"
#include "fit/hex_lattice.hpp"
#include "fit/layer_needs.hpp"
#include "measure/hex_faces.hpp"
#include "measure/hex_quality.hpp"
#include "measure/hex_validity.hpp"

namespace crossgrain {
namespace {

using testing::EmbeddedLattice;
using testing::lattice_mesh;
using testing::LatticeModel;

/// Faces by their planes; all cubes of a lattice.
int plane_of(const Vector3& centre, const Vector3& normal) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(normal[axis]) > 0.5) return 100 * axis + static_cast<int>(std::lround(2 * centre[axis]));
  return -1;
}

double volume_of(const HexMesh& mesh) {
  const std::vector<double> volumes = volumes_of(mesh);
  return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

/// Vertices - edges + quads of each face.
std::vector<int> euler_of_faces(const QuadComplex& surface, const Embedding& embedding, std::size_t faces) {
  std::vector<std::set<std::uint32_t>> vertices(faces), edges(faces);
  std::vector<int> euler(faces, 0);
  for (std::uint32_t q = 0; q < surface.quads().size(); ++q) {
    const std::uint32_t face = embedding.face_of_quad[q];
    const QuadComplex::Quad& quad = surface.quads()[q];
    vertices[face].insert(quad.vertices.begin(), quad.vertices.end());
    edges[face].insert(quad.edges.begin(), quad.edges.end());
    ++euler[face];
  }
  for (std::size_t f = 0; f < faces; ++f)
    euler[f] += static_cast<int>(vertices[f].size()) - static_cast<int>(edges[f].size());
  return euler;
}

/// A model in a lattice, and what comes of the mesh with layers.
class Layered {
 public:
  using Addition = AddedLayers (*)(HexMesh&, const FeatureComplex&, Embedding&);

  Layered(const HexMesh& given, const LatticeModel& lattice, Addition add = add_layers)
      : before(given), mesh(given), model(given, lattice), embedding(model.embedding) {
    needs_before = needs();
    euler_before = euler();
    added = add(mesh, model.features, embedding);
    needs_after = needs();
  }

  void expect_sound() const {
    const HexTopology topology = topology_of(mesh);
    EXPECT_TRUE(topology.is_closed());
    EXPECT_EQ(topology.pinched_vertices, 0u);
    EXPECT_EQ(added.left_out, 0u);
    EXPECT_NEAR(volume_of(mesh), volume_of(before), 1e-9);
    EXPECT_EQ(mesh.hexahedra.size(), before.hexahedra.size() + added.hexahedra());
    EXPECT_TRUE(std::equal(before.vertices.begin(), before.vertices.end(), mesh.vertices.begin()));
    expect_true_embedding();
  }

  LayerNeeds needs() const {
    const auto wedges = wedges_of_curves(model.features);
    const QuadComplex surface = surface_of(mesh, model.features);
    return layer_needs({mesh, model.features, embedding, wedges, surface});
  }

  std::vector<int> euler() const {
    return euler_of_faces(surface_of(mesh, model.features), embedding, model.features.faces.size());
  }

  const HexMesh before;
  HexMesh mesh;
  const EmbeddedLattice model;
  Embedding embedding;
  LayerNeeds needs_before, needs_after;
  std::vector<int> euler_before;
  AddedLayers added;

 private:
  /// Paths are disjoint and along edges, with the model's faces on their sides; faces end there only.
  void expect_true_embedding() const {
    const FeatureComplex& features = model.features;
    const QuadComplex surface = surface_of(mesh, features);
    std::set<std::uint32_t> on_path, inner;
    for (std::size_t c = 0; c < features.curves.size(); ++c) {
      const auto& path = embedding.path_of_curve[c];
      EXPECT_EQ(path.front(), features.curves[c].vertices.front());
      EXPECT_EQ(path.back(), features.curves[c].vertices.back());
      for (std::size_t k = 0; k + 1 < path.size(); ++k) {
        const std::uint32_t edge = surface.edge_between(path[k], path[k + 1]);
        ASSERT_NE(edge, QuadComplex::kNone) << "curve " << c;
        EXPECT_TRUE(on_path.insert(edge).second);
        EXPECT_TRUE(k == 0 || inner.insert(path[k]).second);
        std::multiset<std::pair<std::uint32_t, bool>> found, expected;
        for (const QuadComplex::Use& use : surface.uses_of_edge(edge))
          found.insert({embedding.face_of_quad[use.quad], use.is_left == (path[k] < path[k + 1])});
        for (const auto& [face, is_left] : features.curves[c].sides) expected.insert({face, is_left});
        EXPECT_EQ(found, expected) << "curve " << c << " place " << k;
      }
    }
    for (std::uint32_t edge = 0; edge < surface.edges().size(); ++edge) {
      if (on_path.contains(edge)) continue;
      const auto uses = surface.uses_of_edge(edge);
      ASSERT_EQ(uses.size(), 2u);
      EXPECT_EQ(embedding.face_of_quad[uses[0].quad], embedding.face_of_quad[uses[1].quad]);
    }
    EXPECT_EQ(euler(), euler_before);
  }
};

TEST(Layers, OfABoxAreNone) {
  const Layered box(lattice_mesh({3, 4, 3}, [](int, int, int) { return 1; }), {.face = plane_of});
  EXPECT_EQ(box.added.hexahedra(), 0u);
  EXPECT_EQ(box.mesh.vertices, box.before.vertices);
  EXPECT_EQ(box.needs_before.wide_sectors + box.needs_before.flat_edges + box.needs_before.unsuited_edges,
            0u);
  box.expect_sound();
}

TEST(Padding, GivesEachQuadOfABoxAHexahedron) {
  const Layered box(lattice_mesh({3, 4, 3}, [](int, int, int) { return 1; }), {.face = plane_of},
                    add_padding);
  EXPECT_EQ(box.added.layer_hexahedra, 2u * (12 + 12 + 9));
  EXPECT_EQ(box.added.pillows, 0u);
  EXPECT_EQ(box.added.inverted, 0u);
  box.expect_sound();
  std::vector<std::size_t> sides(box.mesh.hexahedra.size(), 0);
  for (const HexSide& side : boundary_of(box.mesh)) ++sides[side.hexahedron];
  EXPECT_EQ(*std::ranges::max_element(sides), 1u);
}

TEST(Layers, OfAnLShapeAndOfANotchAreNone) {
  const Layered shape(lattice_mesh({4, 3, 4}, [](int x, int, int z) { return x < 2 || z < 2; }),
                      {.face = plane_of});
  EXPECT_EQ(shape.added.hexahedra(), 0u);
  shape.expect_sound();
  const Layered notch(
      lattice_mesh({6, 4, 4}, [](int x, int y, int z) { return z < 2 || x < 2 || x > 3 || y > 2; }),
      {.face = plane_of});
  EXPECT_EQ(notch.added.hexahedra(), 0u);
  notch.expect_sound();
}

/// The disk of cubes around the middle of a lattice.
bool is_in_disk(int x, int y, double radius, double middle) {
  return std::hypot(x + 0.5 - middle, y + 0.5 - middle) < radius;
}

/// Vertices of the disk's outline go to the circle.
Vector3 to_circle(const Vector3& at, double radius, double middle) {
  int inside = 0;
  for (const int x : {-1, 0})
    for (const int y : {-1, 0})
      inside += is_in_disk(static_cast<int>(at[0]) + x, static_cast<int>(at[1]) + y, radius, middle);
  if (inside == 0 || inside == 4) return at;
  const double x = at[0] - middle, y = at[1] - middle, share = radius / std::hypot(x, y);
  return {middle + share * x, middle + share * y, at[2]};
}

TEST(Layers, OfACylinderGiveEachQuadOneEdgeOnItsCirclesAndItsWallStraightAnglesOfTwo) {
  const double radius = 3.2, middle = 4;
  LatticeModel model;
  model.face = [](const Vector3& centre, const Vector3& normal) {
    return std::abs(normal[2]) > 0.5 ? (centre[2] > 1 ? 1 : 2) : 3;
  };
  model.place = [&](const Vector3& at) { return to_circle(at, radius, middle); };
  const Layered cylinder(
      lattice_mesh({8, 8, 4}, [&](int x, int y, int) { return is_in_disk(x, y, radius, middle); }), model);
  ASSERT_EQ(cylinder.model.features.faces.size(), 3u);
  ASSERT_EQ(cylinder.model.features.curves.size(), 2u);
  EXPECT_GT(cylinder.needs_before.flat_edges, 0u);
  EXPECT_GT(cylinder.needs_before.wide_sectors, 0u);
  EXPECT_EQ(cylinder.needs_after.flat_edges, 0u);
  EXPECT_EQ(cylinder.needs_after.wide_sectors, 0u);
  EXPECT_EQ(cylinder.needs_after.unsuited_edges, 0u);
  EXPECT_EQ(cylinder.added.layers, 1u);  // under the wall, and along both disks
  EXPECT_EQ(cylinder.added.inverted, 0u);
  cylinder.expect_sound();
}

TEST(Layers, AtTheFootOfABossAreOnBothSidesOfTheConcaveCircle) {
  const double radius = 3.2, middle = 5;
  LatticeModel model;
  model.face = [](const Vector3& centre, const Vector3& normal) {
    return centre[2] > 2 && std::abs(normal[2]) < 0.5 ? 1000 : plane_of(centre, normal);
  };
  model.place = [&](const Vector3& at) { return at[2] < 2 ? at : to_circle(at, radius, middle); };
  const Layered boss(
      lattice_mesh({10, 10, 5},
                   [&](int x, int y, int z) { return z < 2 || is_in_disk(x, y, radius, middle); }),
      model);
  ASSERT_EQ(boss.model.features.faces.size(), 8u);
  EXPECT_GT(boss.needs_before.flat_edges, 0u);
  EXPECT_EQ(boss.needs_after.flat_edges + boss.needs_after.wide_sectors, 0u);
  EXPECT_EQ(boss.needs_after.unsuited_edges, 0u);
  EXPECT_EQ(boss.added.layers, 1u);
  EXPECT_EQ(boss.added.inverted, 0u);
  boss.expect_sound();
  // Bottom and sides of the plate keep their quads, but for the row along which the layer of the top dives.
  EXPECT_LT(boss.added.layer_hexahedra, 180u);
}

TEST(Layers, OfABlindHoleAreUnderItsWallAndItsTwoFlatFacesAreDividedAlongTheCircles) {
  const double radius = 3.2, middle = 5;
  LatticeModel model;
  const auto is_hole = [&](int x, int y, int z) { return z >= 2 && is_in_disk(x, y, radius, middle); };
  model.face = [&](const Vector3& centre, const Vector3& normal) {
    const bool is_inside = std::max(std::abs(centre[0] - middle), std::abs(centre[1] - middle)) < 4.5;
    return is_inside && std::abs(normal[2]) < 0.5 ? 1000 : plane_of(centre, normal);
  };
  model.place = [&](const Vector3& at) { return at[2] < 2 ? at : to_circle(at, radius, middle); };
  const Layered hole(lattice_mesh({10, 10, 5}, [&](int x, int y, int z) { return !is_hole(x, y, z); }),
                     model);
  ASSERT_EQ(hole.model.features.faces.size(), 8u);
  EXPECT_EQ(hole.needs_after.flat_edges + hole.needs_after.wide_sectors, 0u);
  EXPECT_EQ(hole.added.inverted, 0u);
  hole.expect_sound();
}

TEST(Layers, OfAPinInABlockAreOnBothSidesOfTheInterface) {
  const double radius = 3.2, middle = 5;
  LatticeModel model;
  model.face = [&](const Vector3& centre, const Vector3& normal) {
    const double off = std::hypot(centre[0] - middle, centre[1] - middle);
    const bool is_inside = std::max(std::abs(centre[0] - middle), std::abs(centre[1] - middle)) < 4.5;
    if (std::abs(normal[2]) < 0.5) return is_inside ? 1000 : plane_of(centre, normal);
    return plane_of(centre, normal) + (off < radius ? 500 : 0);
  };
  model.place = [&](const Vector3& at) { return to_circle(at, radius, middle); };
  const Layered pin(
      lattice_mesh({10, 10, 3}, [&](int x, int y, int) { return 1 + is_in_disk(x, y, radius, middle); }),
      model);
  ASSERT_EQ(pin.model.features.faces.size(), 9u);
  ASSERT_EQ(pin.model.features.curves.size(), 14u);
  EXPECT_GT(pin.needs_before.flat_edges, 0u);
  EXPECT_EQ(pin.needs_after.flat_edges + pin.needs_after.wide_sectors + pin.needs_after.unsuited_edges, 0u);
  EXPECT_EQ(pin.added.inverted, 0u);
  pin.expect_sound();
  double inside = 0, before = 0;
  for (std::size_t h = 0; h < pin.mesh.hexahedra.size(); ++h)
    if (pin.mesh.regions[h] == 2) inside += volumes_of(pin.mesh)[h];
  for (std::size_t h = 0; h < pin.before.hexahedra.size(); ++h) before += pin.before.regions[h] == 2;
  EXPECT_NEAR(inside, before, 1e-9);
}

TEST(Layers, DivideAnAngleOfAHundredAndFiftyDegreesAndLeaveOneOfThirty) {
  LatticeModel model;
  model.face = plane_of;
  model.place = [](const Vector3& at) {
    return Vector3{at[0] + std::tan(60 * kDegree) * at[2], at[1], at[2]};
  };
  const Layered sheared(lattice_mesh({4, 3, 3}, [](int, int, int) { return 1; }), model);
  EXPECT_EQ(sheared.needs_before.unsuited_edges, 2u * 3u);
  EXPECT_EQ(sheared.needs_before.flat_edges, 0u);
  EXPECT_EQ(sheared.needs_after.unsuited_edges, 0u);
  EXPECT_EQ(sheared.needs_after.wide_sectors, 0u);
  EXPECT_EQ(sheared.added.layers, 2u);
  EXPECT_EQ(sheared.added.inverted, 0u);
  sheared.expect_sound();
}

/// Stacks of cubes of random heights, with smooth faces by quarters, heights and directions.
TEST(Layers, OfRoughHeapsLeaveNoTwoSidesOfAHexahedronOnOneSmoothFace) {
  std::size_t tried = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    std::array<std::array<int, 4>, 4> heights{};
    for (auto& row : heights)
      for (int& height : row) height = 1 + static_cast<int>(random() % 4);
    const HexMesh heap = lattice_mesh({4, 4, 5}, [&](int x, int y, int z) {
      return z <= heights[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)];
    });
    const HexTopology topology = topology_of(heap);
    if (!topology.is_closed() || topology.pinched_vertices > 0) continue;
    LatticeModel model;
    model.face = [](const Vector3& centre, const Vector3& normal) {
      const bool is_up = std::abs(normal[2]) > 0.5;
      return (centre[0] < 2) + 2 * (centre[1] < 2) + (is_up ? 4 : 0) + (centre[2] < 2 ? 8 : 0);
    };
    const Layered layered(heap, model);
    EXPECT_EQ(layered.needs_after.flat_edges, 0u) << seed;
    const HexTopology after = topology_of(layered.mesh);
    EXPECT_TRUE(after.is_closed() && after.pinched_vertices == 0) << seed;
    ++tried;
  }
  EXPECT_GT(tried, 10u);
}

TEST(CurveWedges, OfABoxAreRightAnglesAndOfANotchThreeOfThem) {
  const HexMesh box = lattice_mesh({2, 2, 2}, [](int, int, int) { return 1; });
  for (const auto& wedges : wedges_of_curves(EmbeddedLattice(box, {.face = plane_of}).features)) {
    ASSERT_EQ(wedges.size(), 1u);
    EXPECT_NEAR(wedges[0].mean_rad, 90 * kDegree, 1e-12);
    EXPECT_NEAR(wedges[0].most_rad, 90 * kDegree, 1e-12);
  }
  const HexMesh notch = lattice_mesh({2, 2, 2}, [](int x, int, int z) { return x == 0 || z == 0; });
  const auto wedges = wedges_of_curves(EmbeddedLattice(notch, {.face = plane_of}).features);
  EXPECT_EQ(std::ranges::count_if(
                wedges, [](const auto& of) { return std::abs(of.at(0).mean_rad - 270 * kDegree) < 1e-12; }),
            1);
}

}  // namespace
}  // namespace crossgrain
