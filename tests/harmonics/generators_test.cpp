// SPDX-License-Identifier: Apache-2.0
#include "harmonics/generators.hpp"

#include "harmonics/random_samples.hpp"
#include "harmonics/rotation.hpp"

namespace crossgrain {
namespace {

// The entry (row order, column order) of L_axis.
template <int D>
double entry(int axis, int row_order, int column_order) {
  Coefficients<D> unit{};
  unit[index_of_order<D>(column_order)] = 1;
  return apply_generator<D>(axis, unit)[index_of_order<D>(row_order)];
}

TEST(Generators, OfDegreeThreeHaveTheEntriesOfTheirTable) {
  const double a = std::sqrt(6.0), b = std::sqrt(2.5), c = std::sqrt(1.5);
  EXPECT_DOUBLE_EQ((entry<3>(0, -1, 0)), -a);
  EXPECT_DOUBLE_EQ((entry<3>(0, -2, 1)), -b);
  EXPECT_DOUBLE_EQ((entry<3>(0, -1, 2)), -b);
  EXPECT_DOUBLE_EQ((entry<3>(0, -3, 2)), -c);
  EXPECT_DOUBLE_EQ((entry<3>(0, -2, 3)), -c);
  EXPECT_DOUBLE_EQ((entry<3>(1, -3, -2)), c);
  EXPECT_DOUBLE_EQ((entry<3>(1, -2, -1)), b);
  EXPECT_DOUBLE_EQ((entry<3>(1, 0, 1)), -a);
  EXPECT_DOUBLE_EQ((entry<3>(1, 1, 2)), -b);
  EXPECT_DOUBLE_EQ((entry<3>(1, 2, 3)), -c);
  for (int m = 1; m <= 3; ++m) EXPECT_DOUBLE_EQ((entry<3>(2, -m, m)), m);
}

TEST(Generators, OfDegreeFourHaveTheEntriesOfTheirTable) {
  const double a = std::sqrt(10.0), b = std::sqrt(4.5), c = std::sqrt(3.5), d = std::sqrt(2.0);
  EXPECT_DOUBLE_EQ((entry<4>(0, -1, 0)), -a);
  EXPECT_DOUBLE_EQ((entry<4>(0, -2, 1)), -b);
  EXPECT_DOUBLE_EQ((entry<4>(0, -1, 2)), -b);
  EXPECT_DOUBLE_EQ((entry<4>(0, -3, 2)), -c);
  EXPECT_DOUBLE_EQ((entry<4>(0, -2, 3)), -c);
  EXPECT_DOUBLE_EQ((entry<4>(0, -4, 3)), -d);
  EXPECT_DOUBLE_EQ((entry<4>(0, -3, 4)), -d);
  EXPECT_DOUBLE_EQ((entry<4>(1, -4, -3)), d);
  EXPECT_DOUBLE_EQ((entry<4>(1, -3, -2)), c);
  EXPECT_DOUBLE_EQ((entry<4>(1, -2, -1)), b);
  EXPECT_DOUBLE_EQ((entry<4>(1, 0, 1)), -a);
  EXPECT_DOUBLE_EQ((entry<4>(1, 1, 2)), -b);
  EXPECT_DOUBLE_EQ((entry<4>(1, 2, 3)), -c);
  EXPECT_DOUBLE_EQ((entry<4>(1, 3, 4)), -d);
  for (int m = 1; m <= 4; ++m) EXPECT_DOUBLE_EQ((entry<4>(2, -m, m)), m);
}

template <class Degree>
class GeneratorsOf : public ::testing::Test {};
TYPED_TEST_SUITE(GeneratorsOf, testing::BothDegrees);

TYPED_TEST(GeneratorsOf, EitherDegreeAreAntisymmetric) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(1);
  const auto g = random.coefficients<D>(), h = random.coefficients<D>();
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(dot(g, apply_generator<D>(axis, h)), -dot(apply_generator<D>(axis, g), h), 1e-13);
  }
}

TYPED_TEST(GeneratorsOf, EitherDegreeCommuteToTheThirdOne) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(2);
  const auto h = random.coefficients<D>();
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    const auto commutator = difference(apply_generator<D>(a, apply_generator<D>(b, h)),
                                       apply_generator<D>(b, apply_generator<D>(a, h)));
    EXPECT_LT(testing::largest_difference(commutator, apply_generator<D>(c, h)), 1e-13);
  }
}

TYPED_TEST(GeneratorsOf, EitherDegreeHaveTheCasimirOfTheirDegree) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(3);
  const auto h = random.coefficients<D>();
  Coefficients<D> sum{};
  for (int axis = 0; axis < 3; ++axis)
    add_scaled(sum, 1, apply_generator<D>(axis, apply_generator<D>(axis, h)));
  EXPECT_LT(testing::largest_difference(sum, scaled(h, -D * (D + 1.0))), 1e-13);
}

TYPED_TEST(GeneratorsOf, EitherDegreeAreDerivativesOfRightHandedTurns) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(4);
  const auto h = random.coefficients<D>();
  const double step = 1e-4;  // central differences err by (4 step)^2 |h| / 6 or so
  for (int axis = 0; axis < 3; ++axis) {
    Vector3 turn{0, 0, 0};
    turn[axis] = step;
    const auto forth = rotated(rotation_matrix<D>(from_rotation_vector(turn)), h);
    const auto back = rotated(rotation_matrix<D>(from_rotation_vector(-turn)), h);
    const auto slope = scaled(difference(forth, back), 1 / (2 * step));
    EXPECT_LT(testing::largest_difference(slope, apply_generator<D>(axis, h)), 1e-6);
  }
}

}  // namespace
}  // namespace crossgrain
