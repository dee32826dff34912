// SPDX-License-Identifier: Apache-2.0
#include "reduction/integer_elimination.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <bit>
#include <numeric>
#include <random>

#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

/// The solutions that an elimination leaves: the unknowns, first those of the equations, as forms of what is
/// free.
Eigen::MatrixXd basis_of(IntegerElimination& elimination, std::uint32_t unknowns) {
  std::vector<std::uint32_t> free;
  for (std::uint32_t u = 0; u < elimination.size(); ++u)
    if (!elimination.is_eliminated(u)) free.push_back(u);
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(unknowns, static_cast<Eigen::Index>(free.size()));
  for (std::uint32_t u = 0; u < unknowns; ++u)
    for (const auto& [unknown, factor] : elimination.reduced({u, 1}).terms)
      basis(u, std::find(free.begin(), free.end(), unknown) - free.begin()) = static_cast<double>(factor);
  return basis;
}

/// The greatest common divisor of all minors of full size: 1 if every integer solution is a sum of columns
/// with integer factors.
long gcd_of_minors(const Eigen::MatrixXd& basis) {
  long gcd = 0;
  const auto rows = static_cast<unsigned>(basis.rows()), size = static_cast<unsigned>(basis.cols());
  for (unsigned choice = 0; choice < 1u << rows; ++choice) {
    if (static_cast<unsigned>(std::popcount(choice)) != size) continue;
    Eigen::MatrixXd minor(size, size);
    for (unsigned row = 0, at = 0; row < rows; ++row)
      if (choice >> row & 1) minor.row(at++) = basis.row(row);
    gcd = std::gcd(gcd, std::lround(minor.determinant()));
  }
  return gcd;
}

TEST(IntegerElimination, LeavesExactlyTheIntegerSolutions) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> factors(-4, 4);
  for (int trial = 0; trial < 300; ++trial) {
    constexpr std::uint32_t kUnknowns = 5;
    const int count = 1 + trial % 4;
    Eigen::MatrixXd equations(count, kUnknowns);
    IntegerElimination elimination(kUnknowns);
    for (int e = 0; e < count; ++e) {
      LinearForm form;
      for (std::uint32_t u = 0; u < kUnknowns; ++u) {
        const int factor = factors(random);
        equations(e, u) = factor;
        form = added(form, {u, factor});
      }
      elimination.impose(form, trial % 2 == 0 ? 0 : 3);
    }
    const Eigen::MatrixXd basis = basis_of(elimination, kUnknowns);
    EXPECT_EQ(basis.cols(), static_cast<Eigen::Index>(kUnknowns) - equations.fullPivLu().rank());
    EXPECT_LT((equations * basis).cwiseAbs().sum(), 1e-9) << equations;
    if (basis.cols() > 0) {
      EXPECT_EQ(gcd_of_minors(basis), 1) << equations << "\n\n" << basis;
    }
  }
}

TEST(IntegerElimination, EliminatesPreferredUnknownsFirst) {
  IntegerElimination elimination(3);
  elimination.impose(added(added({0, 1}, {1, 1}), {2, 1}), 1);
  EXPECT_FALSE(elimination.is_eliminated(0));
  EXPECT_TRUE(elimination.is_eliminated(1));
  IntegerElimination by_size(2);
  by_size.impose(added({0, 1}, {1, 2}), 1);  // a factor of 1 comes before a preference
  EXPECT_TRUE(by_size.is_eliminated(0));
}

TEST(LinearForm, AddsExactlyAndRefusesWhatDoublesCannotHold) {
  const LinearForm a({3, 2}), b = added(a, {1, 5}, -1);
  EXPECT_EQ(b.terms, (std::vector<LinearForm::Term>{{1, -5}, {3, 2}}));
  EXPECT_TRUE(added(b, b, -1).is_zero());
  EXPECT_TRUE(multiplied(b, 0).is_zero());
  const std::int64_t large = std::int64_t{1} << 52;
  EXPECT_THROW(static_cast<void>(multiplied({0, large}, 4)), Error);
  EXPECT_THROW(static_cast<void>(added({0, large}, {0, large}, 4)), Error);
}

}  // namespace
}  // namespace crossgrain
