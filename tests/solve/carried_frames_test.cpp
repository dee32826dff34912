// SPDX-License-Identifier: Apache-2.0
#include "solve/carried_frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "field/field_data.hpp"
#include "field/made_grid.hpp"
#include "measure/made_tets.hpp"
#include "sampling/nearest_leaf.hpp"
#include "singularity/matching.hpp"

namespace crossgrain {
namespace {

using testing::all_open;
using testing::frames_of;
using testing::octree_of;
using testing::uniform_octree;

/// Single precision in which frames are stored, and the interpolation between equal ones.
constexpr double kStored_rad = 1e-6;

const Quaternion kLowerFrame = turn_about_z(0), kUpperFrame = turn_about_z(30);

double angle_between_rad(const Quaternion& p, const Quaternion& q) {
  const Quaternion r = conjugate(p) * q;
  const Quaternion rest = r * conjugate(to_quaternion(nearest_cube_rotation(r)));
  return 2 * std::atan2(norm(Vector3{rest.x, rest.y, rest.z}), std::abs(rest.w));
}

/// Two plates of cells of 1/8 in the unit cube, of one frame each, with a gap at z = 1/2 that is thinner than
/// a cell: their cells touch, and the faces between them are closed.
FieldData two_plates() {
  FieldData data;
  std::vector<CellAddress> leaves = uniform_octree(3).leaves();
  std::erase_if(leaves, [](CellAddress leaf) { return leaf.corner()[0] >= 6 << (kMaxDepth - 3); });
  data.tree = octree_of(std::move(leaves));
  const auto is_upper = [&](CellIndex i) { return data.tree.centre(i)[2] > 0.5; };
  data.frames =
      frames_of(data.tree, [](const Vector3& centre) { return centre[2] > 0.5 ? kUpperFrame : kLowerFrame; });
  data.open_faces = all_open(data.tree);
  for (CellIndex i = 0; i < data.tree.size(); ++i) {
    for (int face = 0; face < kFaceCount; ++face) {
      const CellIndex j = data.tree.neighbour(i, face);
      if (j != kNoCell && is_upper(i) != is_upper(j))
        data.open_faces[i] = static_cast<std::uint8_t>(data.open_faces[i] & ~(1u << face));
    }
  }
  return data;
}

GridFrames grid_frames(const FieldData& data) {
  return {data.tree, data.frames, data.open_faces};
}

/// The tets of two plates that fill these cells but for a gap of 1/50, the lower one first.
TetMesh plates_of_tets() {
  TetMesh mesh;
  for (const double low : {0.1, 0.51}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const TetMesh box = TetBox{{4, 4, 2}}.mesh();
    for (const Vector3& v : box.vertices)
      mesh.vertices.push_back({0.15 * v[0], 0.2 * v[1], low + 0.195 * v[2]});
    for (const auto& [a, b, c, d] : box.tets)
      mesh.tets.push_back({first + a, first + b, first + c, first + d});
  }
  return mesh;
}

/// The corner of the lower plate at the gap, and of most x and least y.
std::size_t corner_at_the_gap(const TetMesh& mesh) {
  const Vector3 corner{0.6, 0, 0.49};
  const auto found = std::find_if(mesh.vertices.begin(), mesh.vertices.end(),
                                  [&](const Vector3& v) { return norm(v - corner) < 1e-9; });
  return static_cast<std::size_t>(found - mesh.vertices.begin());
}

TEST(CarriedFrames, AreThoseOfTheCellsThatVerticesAreIn) {
  const TetSolid solid = solid_of(plates_of_tets());
  const CarriedFrames carried = carried_frames(grid_frames(two_plates()), solid);
  EXPECT_EQ(carried.outside, 0u);
  ASSERT_EQ(carried.frames.size(), solid.mesh.vertices.size());
  for (std::size_t i = 0; i < carried.frames.size(); ++i) {
    const Quaternion& expected = solid.mesh.vertices[i][2] > 0.5 ? kUpperFrame : kLowerFrame;
    EXPECT_LT(angle_between_rad(carried.frames[i], expected), kStored_rad) << i;
  }
}

TEST(CarriedFrames, OfAVertexOutsideAreOfItsOwnPlateThoughAnotherIsNearer) {
  const FieldData data = two_plates();
  TetMesh mesh = plates_of_tets();
  const std::size_t vertex = corner_at_the_gap(mesh);
  mesh.vertices.at(vertex) = {0.8, 0, 0.505};
  const CellIndex nearest = nearest_leaf(data.tree, mesh.vertices[vertex]);
  ASSERT_EQ(from_stored(data.frames[nearest]).z, from_stored(to_stored(kUpperFrame)).z);

  const CarriedFrames carried = carried_frames(grid_frames(data), solid_of(mesh));
  EXPECT_EQ(carried.outside, 1u);
  EXPECT_LT(angle_between_rad(carried.frames[vertex], kLowerFrame), kStored_rad);
}

TEST(CarriedFrames, OfVerticesOfNoTetAreFiniteAndNotCounted) {
  TetMesh mesh = plates_of_tets();
  const std::size_t first = mesh.vertices.size();
  mesh.vertices.insert(mesh.vertices.end(), {{5, -3, 7}, {0.8, 0, 0.505}, {0.3, 0.3, 0.3}});
  const CarriedFrames carried = carried_frames(grid_frames(two_plates()), solid_of(mesh));
  EXPECT_EQ(carried.outside, 0u);
  for (std::size_t i = first; i < mesh.vertices.size(); ++i) {
    const Quaternion& q = carried.frames.at(i);
    EXPECT_NEAR(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1, 1e-6) << i;
  }
}

TEST(CarriedFrames, OfAComponentThatIsInNoCellAreThoseOfTheNearest) {
  TetMesh mesh = plates_of_tets();
  const std::size_t half = mesh.vertices.size() / 2;
  // The lower plate stays; the upper one goes beside the cells, half of it at each height.
  for (std::size_t i = half; i < mesh.vertices.size(); ++i) mesh.vertices[i] += Vector3{0.8, 0, -0.2};
  const TetSolid solid = solid_of(mesh);
  const CarriedFrames carried = carried_frames(grid_frames(two_plates()), solid);
  EXPECT_EQ(carried.outside, half);
  for (std::size_t i = half; i < mesh.vertices.size(); ++i) {
    const Quaternion& expected = mesh.vertices[i][2] > 0.5 ? kUpperFrame : kLowerFrame;
    EXPECT_LT(angle_between_rad(carried.frames[i], expected), kStored_rad) << i;
  }
}

}  // namespace
}  // namespace crossgrain
