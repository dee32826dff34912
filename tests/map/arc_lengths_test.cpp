// SPDX-License-Identifier: Apache-2.0
#include "reduction/arc_lengths.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "map/arced_cylinder.hpp"
#include "map/poisson_map.hpp"
#include "matching/repaired_graph.hpp"

namespace crossgrain {
namespace {

TEST(ArcLengths, OfTheArcsOfACylinderAreItsLength) {
  const testing::ArcedCylinder cylinder;
  const MapEnergy energy(cylinder.unknowns, 0.1);
  const PoissonMap poisson(energy);
  const Eigen::VectorXd columns = poisson.columns_for(poisson.relaxed());
  const std::vector<LinearForm> lengths =
      arc_lengths(cylinder.unknowns, repaired_graph(*cylinder.split.field));
  ASSERT_EQ(lengths.size(), 4u);
  for (const LinearForm& length : lengths) {
    double sum = 0;
    for (const auto& [column, factor] : length.terms) sum += static_cast<double>(factor) * columns[column];
    EXPECT_NEAR(sum, 20, 0.1);
    EXPECT_TRUE(cylinder.unknowns.is_integer(length));
  }
}

TEST(ArcLengths, AreZeroFromAFaceOfTheSurfaceToTheSameFace) {
  // A face with one edge in the middle of the side z = 0 gets a quarter turn about z: its two other edges
  // become an arc.
  const TetSolid box = solid_of(TetBox{{4, 4, 3}}.mesh());
  const TetComplex complex(box);
  const std::vector<Quaternion> frames(box.mesh.tets.size(), Quaternion{1, 0, 0, 0});
  MatchedField field(complex, frames);
  const auto height = [&](std::uint32_t v) { return box.mesh.vertices[v][2]; };
  const auto is_chosen = [&](const TetSolid::InnerFace& face) {
    const auto low = std::count_if(face.vertices.begin(), face.vertices.end(), [&](std::uint32_t v) {
      const Vector3& p = box.mesh.vertices[v];
      return p[2] == 0 && p[0] > 0 && p[0] < 4 && p[1] > 0 && p[1] < 4;
    });
    return low == 2 && std::any_of(face.vertices.begin(), face.vertices.end(), [&](std::uint32_t v) {
             return height(v) > 0 && !complex.is_on_boundary(v);
           });
  };
  const auto chosen = std::find_if(box.inner_faces.begin(), box.inner_faces.end(), is_chosen);
  ASSERT_NE(chosen, box.inner_faces.end());
  CubeRotation turn;
  turn.z = 1;  // a quarter turn about z
  field.set_matching(static_cast<std::uint32_t>(chosen - box.inner_faces.begin()),
                     CubeGroup::instance().number_of(turn));
  const CutSolid cut(field);
  const MapUnknowns unknowns(cut);
  const SingularityGraph graph = repaired_graph(field);
  ASSERT_EQ(graph.arcs.size(), 1u);
  EXPECT_EQ(graph.arcs[0].vertices.size(), 3u);
  EXPECT_TRUE(arc_lengths(unknowns, graph)[0].is_zero());
}

}  // namespace
}  // namespace crossgrain
