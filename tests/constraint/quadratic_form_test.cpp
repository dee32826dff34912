// SPDX-License-Identifier: Apache-2.0
#include "constraint/quadratic_form.hpp"

#include "constraint/random_cells.hpp"

namespace crossgrain {
namespace {

template <class Degree>
class QuadraticFormOf : public ::testing::Test {};
TYPED_TEST_SUITE(QuadraticFormOf, testing::BothDegrees);

template <int D>
QuadraticForm<D> random_form(testing::RandomSamples& random) {
  return testing::form_of<D>(testing::random_facets(random, 2, 8));
}

TYPED_TEST(QuadraticFormOf, TakesTwentyNineOrFiftySixNumbers) {
  constexpr int D = TypeParam::value;
  EXPECT_EQ(sizeof(QuadraticForm<D>), (D == 3 ? 29 : 56) * sizeof(double));
}

TYPED_TEST(QuadraticFormOf, ValueIsThatOfItsMatrixWrittenOut) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(1);
  const auto form = random_form<D>(random);
  const auto h = random.coefficients<D>();
  double expected = constant_part(form) - 2 * dot(linear_part(form), h);
  for (int row = 0; row < kCoefficientCount<D>; ++row) {
    for (int column = 0; column < kCoefficientCount<D>; ++column) {
      expected +=
          form.matrix[form_entry<D>(std::min(row, column), std::max(row, column))] * h[row] * h[column];
    }
  }
  EXPECT_NEAR(value(form, h), expected, 1e-12);
}

TYPED_TEST(QuadraticFormOf, HalfGradientIsHalfTheSlope) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(2);
  const auto form = random_form<D>(random);
  const auto h = random.coefficients<D>(), direction = random.coefficients<D>();
  auto forth = h, back = h;
  add_scaled(forth, 0.5, direction);
  add_scaled(back, -0.5, direction);
  // Central differences of a quadratic are exact.
  EXPECT_NEAR(value(form, forth) - value(form, back), 2 * dot(half_gradient(form, h), direction), 1e-11);
}

TYPED_TEST(QuadraticFormOf, ASumIsTheSumOfValues) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(3);
  const auto a = random_form<D>(random), b = random_form<D>(random);
  const auto h = random.coefficients<D>();
  auto sum = a;
  sum += scaled(b, 3);
  EXPECT_NEAR(value(sum, h), value(a, h) + 3 * value(b, h), 1e-11);
  EXPECT_NEAR(sum.weight, a.weight + 3 * b.weight, 1e-14);
}

}  // namespace
}  // namespace crossgrain
