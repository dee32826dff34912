// SPDX-License-Identifier: Apache-2.0
#include "reduction/map_unknowns.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <random>

#include "matching/made_matchings.hpp"
#include "tets/tet_meshes.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

using testing::random_tet_frames;
using testing::turn_random_faces;

Eigen::Matrix3d matrix_of(std::uint8_t rotation) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  for (SignedAxis axis = 0; axis < 3; ++axis) {
    const SignedAxis image = CubeGroup::instance().image(rotation, axis);
    matrix(image % 3, axis) = image < 3 ? 1 : -1;
  }
  return matrix;
}

/// The equations of a map straight from the field, without a cut: unknowns are 12 coordinates of each tet, in
/// the names of its own frame, and a translation of each inner face.
Eigen::MatrixXd equations_of(const MatchedField& field) {
  const TetSolid& solid = field.complex().solid();
  const auto tets = static_cast<Eigen::Index>(solid.mesh.tets.size()),
             faces = static_cast<Eigen::Index>(solid.inner_faces.size());
  std::vector<Eigen::RowVectorXd> rows;
  const auto row = [&]() -> Eigen::RowVectorXd& {
    return rows.emplace_back(Eigen::RowVectorXd::Zero(12 * tets + 3 * faces));
  };
  const auto column = [&](std::uint32_t tet, std::uint32_t vertex, Eigen::Index k) {
    return static_cast<Eigen::Index>(12 * tet + 3 * corner_of(solid.mesh.tets[tet], vertex)) + k;
  };
  for (std::uint32_t f = 0; f < solid.inner_faces.size(); ++f) {
    const auto& [vertices, sides] = solid.inner_faces[f];
    const Eigen::Matrix3d rotation = matrix_of(field.matching(f));
    for (const std::uint32_t v : vertices) {
      for (Eigen::Index k = 0; k < 3; ++k) {
        Eigen::RowVectorXd& equation = row();
        equation[column(sides[1], v, k)] = 1;
        for (Eigen::Index j = 0; j < 3; ++j) equation[column(sides[0], v, j)] = -rotation(k, j);
        equation[12 * tets + 3 * static_cast<Eigen::Index>(f) + k] = -1;
      }
    }
  }
  for (std::uint32_t f = 0; f < solid.boundary.size(); ++f) {
    const Eigen::Index axis = field.normal_axis(f) % 3;
    for (std::size_t k = 1; k < 3; ++k) {
      Eigen::RowVectorXd& equation = row();
      equation[column(solid.boundary_tets[f], solid.boundary[f][k], axis)] = 1;
      equation[column(solid.boundary_tets[f], solid.boundary[f][0], axis)] = -1;
    }
  }
  Eigen::MatrixXd equations(static_cast<Eigen::Index>(rows.size()), 12 * tets + 3 * faces);
  for (std::size_t r = 0; r < rows.size(); ++r) equations.row(static_cast<Eigen::Index>(r)) = rows[r];
  return equations;
}

/// Coordinates of the corners in the names of their tets' own frames, for values of the columns.
Eigen::VectorXd corners_for(const MapUnknowns& unknowns, const Eigen::VectorXd& columns) {
  const CutSolid& cut = unknowns.cut();
  const std::size_t tets = cut.copies_of_tets().size();
  Eigen::VectorXd corners(static_cast<Eigen::Index>(12 * tets));
  for (std::uint32_t t = 0; t < tets; ++t) {
    const Eigen::Matrix3d back = matrix_of(cut.names_of(t)).transpose();
    for (std::size_t a = 0; a < 4; ++a) {
      Eigen::Vector3d point = Eigen::Vector3d::Zero();
      for (std::size_t k = 0; k < 3; ++k)
        for (const auto& [column, factor] : unknowns.point(cut.copy_of(t, a))[k].terms)
          point[static_cast<Eigen::Index>(k)] += static_cast<double>(factor) * columns[column];
      corners.segment<3>(static_cast<Eigen::Index>(12 * t + 3 * a)) = back * point;
    }
  }
  return corners;
}

/// Translations across inner faces, from one vertex of each.
Eigen::VectorXd with_translations(const MatchedField& field, const Eigen::VectorXd& corners) {
  const TetSolid& solid = field.complex().solid();
  Eigen::VectorXd all(corners.size() + static_cast<Eigen::Index>(3 * solid.inner_faces.size()));
  all.head(corners.size()) = corners;
  for (std::uint32_t f = 0; f < solid.inner_faces.size(); ++f) {
    const auto& [vertices, sides] = solid.inner_faces[f];
    const auto at = [&](std::uint32_t tet) -> Eigen::Vector3d {
      return corners.segment<3>(
          static_cast<Eigen::Index>(12 * tet + 3 * corner_of(solid.mesh.tets[tet], vertices[0])));
    };
    all.segment<3>(corners.size() + 3 * static_cast<Eigen::Index>(f)) =
        at(sides[1]) - matrix_of(field.matching(f)) * at(sides[0]);
  }
  return all;
}

void expect_all_maps(const MatchedField& field, std::uint64_t seed) {
  const CutSolid cut(field);
  const MapUnknowns unknowns(cut);
  const Eigen::MatrixXd equations = equations_of(field);
  // Without a cut each tet but the first may be shifted by itself; that is the gauge.
  const auto tets = static_cast<Eigen::Index>(cut.copies_of_tets().size());
  const Eigen::Index dimension = equations.cols() - equations.fullPivLu().rank() - 3 * (tets - 1);
  const auto columns = static_cast<Eigen::Index>(unknowns.columns());
  EXPECT_EQ(columns, dimension) << "seed " << seed;
  std::mt19937_64 random(seed);
  Eigen::MatrixXd maps(12 * tets, columns);
  for (Eigen::Index c = 0; c < columns; ++c)
    maps.col(c) = corners_for(unknowns, Eigen::VectorXd::Unit(columns, c));
  EXPECT_EQ(maps.fullPivLu().rank(), columns);
  Eigen::VectorXd values(columns);
  for (double& value : values) value = static_cast<double>(random() % 201) - 100;
  const Eigen::VectorXd all = with_translations(field, maps * values);
  EXPECT_LT((equations * all).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(MapUnknowns, AreAllMapsOfRandomMatchingsAndNoOthers) {
  for (const std::array<std::uint32_t, 3> cells :
       {std::array<std::uint32_t, 3>{1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {2, 2, 2}}) {
    const TetSolid solid = solid_of(TetBox{cells}.mesh(0.1));
    const TetComplex complex(solid);
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const auto frames = random_tet_frames(solid, seed);
      MatchedField field(complex, frames);
      turn_random_faces(field, static_cast<int>(seed), seed);
      expect_all_maps(field, seed);
    }
  }
}

TEST(MapUnknowns, OfEveryMatchingBetweenTwoTets) {
  const TetSolid solid =
      solid_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, {{0, 1, 2, 3}, {1, 2, 3, 4}}});
  const TetComplex complex(solid);
  const std::vector<Quaternion> frames(2, from_rotation_vector({0.3, -0.2, 0.1}));
  for (std::uint8_t g = 0; g < CubeGroup::kCount; ++g) {
    MatchedField field(complex, frames);
    field.set_matching(0, g);
    expect_all_maps(field, g);
  }
}

TEST(MapUnknowns, OfABoxAreItsSidesAndTheVerticesBetween) {
  const TetBox box{{3, 3, 3}};
  const TetSolid solid = solid_of(box.mesh());
  const TetComplex complex(solid);
  const std::vector<Quaternion> frames(solid.mesh.tets.size(), Quaternion{1, 0, 0, 0});
  const MatchedField field(complex, frames);
  const CutSolid cut(field);
  const MapUnknowns unknowns(cut);
  std::size_t integers = 0;
  for (std::uint32_t c = 0; c < unknowns.columns(); ++c) integers += unknowns.is_integer(c);
  EXPECT_EQ(integers, 6u);  // a coordinate of each side
  EXPECT_EQ(unknowns.columns(),
            6u + 3 * 2 * 4 * 4);  // and each coordinate of the vertices that it is not fixed at
}

}  // namespace
}  // namespace crossgrain
