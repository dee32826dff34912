// SPDX-License-Identifier: Apache-2.0
#include "reduction/demanded_splits.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>

#include "reduction/mapped_shapes.hpp"

namespace crossgrain {
namespace {

using testing::AskewBox;

double length_of_arcs(const MatchedField& field) {
  double length = 0;
  for (std::uint32_t e = 0; e < field.complex().edges().size(); ++e) {
    const TetComplex::Edge& edge = field.complex().edges()[e];
    if (!edge.is_on_boundary() && field.is_singular(e)) length += edge.length;
  }
  return length;
}

DemandedSplits demanded(const MatchedField& field) {
  const CutSolid cut(field);
  return demanded_splits(MapUnknowns(cut));
}

TEST(DemandedSplits, AreNoneInABoxWithoutEdgesAcrossItsCorners) {
  const AskewBox box({3, 3, 3});
  EXPECT_TRUE(demanded(box.field).empty());
}

Vector3 centre_of(const TetMesh& mesh, const std::array<std::uint32_t, 4>& tet) {
  Vector3 centre{0, 0, 0};
  for (const std::uint32_t v : tet) centre += 0.25 * mesh.vertices[v];
  return centre;
}

/// Number of the tet that a point is in; that of all tets if there is none.
std::size_t tet_around(const TetMesh& mesh, const Vector3& point) {
  std::vector<Vector3> vertices = mesh.vertices;
  vertices.push_back(point);
  const auto is_inside = [&](const std::array<std::uint32_t, 4>& tet) {
    for (std::size_t k = 0; k < 4; ++k) {
      auto with_point = tet;
      with_point[k] = static_cast<std::uint32_t>(mesh.vertices.size());
      if (volume_of_tets({vertices, {with_point}}) <= 0) return false;
    }
    return true;
  };
  return static_cast<std::size_t>(std::find_if(mesh.tets.begin(), mesh.tets.end(), is_inside) -
                                  mesh.tets.begin());
}

TEST(DemandedSplits, LeaveNoneAndKeepVolumesAndArcs) {
  const TetSolid box = solid_of(TetBox{{3, 3, 3}}.mesh(0.1));
  const TetComplex complex(box);
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const std::vector<Quaternion> frames(box.mesh.tets.size(), Quaternion{1, 0, 0, 0});
    MatchedField field(complex, frames);
    testing::turn_random_faces(field, 2, seed);
    const DemandedSplits splits = demanded(field);
    count += splits.edges.size() + splits.faces.size();
    const OwnedField split = split_for_map(field, 20);
    EXPECT_TRUE(demanded(*split.field).empty()) << seed;
    EXPECT_NEAR(length_of_arcs(*split.field), length_of_arcs(field), 1e-9);
    std::vector<double> volumes(box.mesh.tets.size(), 0);
    for (const auto& tet : split.solid->mesh.tets)
      volumes.at(tet_around(box.mesh, centre_of(split.solid->mesh, tet))) +=
          volume_of_tets({split.solid->mesh.vertices, {tet}});
    for (std::size_t t = 0; t < volumes.size(); ++t)
      EXPECT_NEAR(volumes[t], volume_of_tets({box.mesh.vertices, {box.mesh.tets[t]}}), 1e-14);
  }
  EXPECT_GT(count, 0u);
}

}  // namespace
}  // namespace crossgrain
