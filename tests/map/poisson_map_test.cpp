// SPDX-License-Identifier: Apache-2.0
#include "map/poisson_map.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "repair/made_matchings.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

/// A box that lies askew, with frames along its sides, each named in another way.
struct Askew {
  Quaternion turn = from_rotation_vector({0.4, -0.3, 0.7});
  TetSolid solid;
  TetComplex complex;
  std::vector<Quaternion> frames;
  MatchedField field;
  CutSolid cut;
  MapUnknowns unknowns;

  explicit Askew(const std::array<std::uint32_t, 3>& cells)
      : solid(solid_of(turned(TetBox{cells}.mesh(0.1)))),
        complex(solid),
        frames(named()),
        field(complex, frames),
        cut(field),
        unknowns(cut) {}

  TetMesh turned(TetMesh mesh) const {
    for (Vector3& p : mesh.vertices) p = rotate(turn, p);
    return mesh;
  }
  std::vector<Quaternion> named() const {
    std::vector<Quaternion> result;
    std::mt19937 random(3);
    for (std::size_t t = 0; t < solid.mesh.tets.size(); ++t)
      result.push_back(turn * to_quaternion(CubeGroup::instance()[static_cast<std::uint8_t>(random() % 24)]));
    return result;
  }
};

TEST(PoissonMap, OfABoxIsTheBoxInHexahedra) {
  const Askew box({4, 3, 2});
  const MapEnergy energy(box.unknowns, 0.5);
  const PoissonMap poisson(energy);
  const Eigen::VectorXd columns = poisson.columns_for(poisson.relaxed());
  const MapCoordinates map = energy.basis() * columns;
  for (std::size_t t = 0; t < box.solid.mesh.tets.size(); ++t) {
    const Eigen::Matrix3d jacobian = energy.jacobian(map, t);
    EXPECT_NEAR((jacobian * jacobian.transpose() - Eigen::Matrix3d::Identity()).norm(), 0, 1e-7);
    EXPECT_NEAR(jacobian.determinant(), 1, 1e-7);
  }
  EXPECT_EQ(flips_of(energy, map).tets, 0u);
  EXPECT_EQ(poisson.integers().size(), 6u);
  EXPECT_EQ(std::count(poisson.is_pinned().begin(), poisson.is_pinned().end(), true), 3);
  for (const double integer : poisson.relaxed()) EXPECT_NEAR(integer, std::round(integer), 1e-6);
}

TEST(PoissonMap, HasTheLeastEnergyForItsIntegers) {
  const Askew box({3, 3, 3});
  const MapEnergy energy(box.unknowns, 1);
  const PoissonMap poisson(energy);
  const Eigen::VectorXd integers = Eigen::VectorXd::LinSpaced(6, -3, 7).array().round();
  const Eigen::VectorXd columns = poisson.columns_for(integers);
  const Eigen::VectorXd residual = energy.matrix() * columns - energy.right();
  for (const std::uint32_t column : poisson.continuous()) EXPECT_NEAR(residual[column], 0, 1e-8);
  // S is how the energy grows with the integers.
  const auto value = [&](const Eigen::VectorXd& x) {
    return x.dot(energy.matrix() * x) - 2 * x.dot(energy.right());
  };
  const Eigen::VectorXd off = integers - poisson.relaxed();
  const double grown = value(columns) - value(poisson.columns_for(poisson.relaxed()));
  EXPECT_NEAR(off.dot(poisson.schur() * off), grown, 1e-7 * std::abs(grown));
}

TEST(PoissonMap, MovesToOtherIntegersAsItWouldBeMadeForThem) {
  const Askew box({3, 2, 2});
  const MapEnergy energy(box.unknowns, 1);
  const PoissonMap poisson(energy);
  const Eigen::VectorXd one = Eigen::VectorXd::LinSpaced(6, 0, 5),
                        other = Eigen::VectorXd::LinSpaced(6, 4, -6);
  const Eigen::VectorXd moved = poisson.moved(poisson.columns_for(one), other);
  EXPECT_LT((moved - poisson.columns_for(other)).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(MapFlips, CountTetsThatAreInsideOut) {
  const Askew box({2, 2, 2});
  const MapEnergy energy(box.unknowns, 1);
  const PoissonMap poisson(energy);
  const MapCoordinates map = energy.basis() * poisson.columns_for(poisson.relaxed());
  const MapFlips flips = flips_of(energy, -map);
  EXPECT_EQ(flips.tets, box.solid.mesh.tets.size());
  EXPECT_NEAR(flips.share_of_volume, 1, 1e-12);
  EXPECT_NEAR(flips.least_determinant, -1, 1e-6);
}

}  // namespace
}  // namespace crossgrain
