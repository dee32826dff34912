// SPDX-License-Identifier: Apache-2.0
#include "harmonics/rotation.hpp"

#include <numbers>

#include "harmonics/evaluation.hpp"
#include "harmonics/frame.hpp"
#include "harmonics/random_samples.hpp"

namespace crossgrain {
namespace {

constexpr double kPi = std::numbers::pi;

Quaternion turn_about(int axis, double angle_rad) {
  Vector3 v{0, 0, 0};
  v[axis] = angle_rad;
  return from_rotation_vector(v);
}

template <int D>
RotationMatrix<D> product(const RotationMatrix<D>& a, const RotationMatrix<D>& b) {
  RotationMatrix<D> result{};
  for (int row = 0; row < kCoefficientCount<D>; ++row) {
    for (int k = 0; k < kCoefficientCount<D>; ++k) add_scaled(result[row], a[row][k], b[k]);
  }
  return result;
}

template <int D>
RotationMatrix<D> transposed(const RotationMatrix<D>& a) {
  RotationMatrix<D> result;
  for (int row = 0; row < kCoefficientCount<D>; ++row) {
    for (int column = 0; column < kCoefficientCount<D>; ++column) result[row][column] = a[column][row];
  }
  return result;
}

template <int D>
void expect_same(const RotationMatrix<D>& a, const RotationMatrix<D>& b) {
  for (int row = 0; row < kCoefficientCount<D>; ++row) {
    EXPECT_LT(testing::largest_difference(a[row], b[row]), 1e-13) << "row " << row;
  }
}

// The appendix of arXiv 2309.13477: R_z has cos(m a) on the diagonal and sin(|m| a) on the antidiagonal.
template <int D>
RotationMatrix<D> appendix_z(double angle_rad) {
  RotationMatrix<D> matrix{};
  for (int m = -D; m <= D; ++m) {
    matrix[index_of_order<D>(m)][index_of_order<D>(-m)] = -std::sin(m * angle_rad);
    matrix[index_of_order<D>(m)][index_of_order<D>(m)] = std::cos(m * angle_rad);
  }
  return matrix;
}

// A quarter turn about x takes f(x, y, z) to f(x, z, -y): these are the coefficients of the substituted
// polynomials.
RotationMatrix<3> appendix_quarter_x3() {
  const double a = std::sqrt(6.0) / 4, b = std::sqrt(10.0) / 4, c = std::sqrt(15.0) / 4;
  return {{{0, 0, 0, b, 0, -a, 0},
           {0, -1, 0, 0, 0, 0, 0},
           {0, 0, 0, a, 0, b, 0},
           {-b, 0, -a, 0, 0, 0, 0},
           {0, 0, 0, 0, -0.25, 0, -c},
           {a, 0, -b, 0, 0, 0, 0},
           {0, 0, 0, 0, -c, 0, 0.25}}};
}

RotationMatrix<4> appendix_quarter_x4() {
  const double a = std::sqrt(14.0) / 4, b = std::sqrt(2.0) / 4, c = std::sqrt(7.0) / 4;
  const double d = std::sqrt(5.0) / 4, e = std::sqrt(35.0) / 8;
  return {{{0, 0, 0, 0, 0, a, 0, -b, 0},
           {0, -0.75, 0, c, 0, 0, 0, 0, 0},
           {0, 0, 0, 0, 0, b, 0, a, 0},
           {0, c, 0, 0.75, 0, 0, 0, 0, 0},
           {0, 0, 0, 0, 0.375, 0, d, 0, e},
           {-a, 0, -b, 0, 0, 0, 0, 0, 0},
           {0, 0, 0, 0, d, 0, 0.5, 0, -c},
           {b, 0, -a, 0, 0, 0, 0, 0, 0},
           {0, 0, 0, 0, e, 0, -c, 0, 0.125}}};
}

TEST(RotationMatrix, OfAQuarterTurnAboutXIsTheAppendixMatrixOfDegreeThree) {
  expect_same<3>(rotation_matrix<3>(turn_about(0, kPi / 2)), appendix_quarter_x3());
}

TEST(RotationMatrix, OfAQuarterTurnAboutXIsTheAppendixMatrixOfDegreeFour) {
  expect_same<4>(rotation_matrix<4>(turn_about(0, kPi / 2)), appendix_quarter_x4());
}

TEST(RotationMatrix, OfATurnAboutZIsTheAppendixMatrix) {
  expect_same<3>(rotation_matrix<3>(turn_about(2, 0.7)), appendix_z<3>(0.7));
  expect_same<4>(rotation_matrix<4>(turn_about(2, 0.7)), appendix_z<4>(0.7));
}

TEST(RotationMatrix, AboutYOfTheAppendixTurnsTheOtherWay) {
  const auto x3 = appendix_quarter_x3();
  const auto x4 = appendix_quarter_x4();
  expect_same<3>(product<3>(product<3>(x3, appendix_z<3>(0.7)), transposed<3>(x3)),
                 rotation_matrix<3>(turn_about(1, -0.7)));
  expect_same<4>(product<4>(product<4>(x4, appendix_z<4>(0.7)), transposed<4>(x4)),
                 rotation_matrix<4>(turn_about(1, -0.7)));
}

template <class Degree>
class RotationMatrixOf : public ::testing::Test {};
TYPED_TEST_SUITE(RotationMatrixOf, testing::BothDegrees);

TYPED_TEST(RotationMatrixOf, AProductIsTheProduct) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(1);
  const Quaternion p = random.rotation(), q = random.rotation();
  expect_same<D>(rotation_matrix<D>(p * q), product<D>(rotation_matrix<D>(p), rotation_matrix<D>(q)));
}

TYPED_TEST(RotationMatrixOf, AnInverseIsTheTranspose) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(2);
  const Quaternion q = random.rotation();
  expect_same<D>(rotation_matrix<D>(conjugate(q)), transposed<D>(rotation_matrix<D>(q)));
}

TYPED_TEST(RotationMatrixOf, AnyTurnMovesTheFunctionActively) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(3);
  const Quaternion q = random.rotation();
  const auto f = random.coefficients<D>();
  const auto turned = rotated(rotation_matrix<D>(q), f);
  const Vector3 x = random.direction();
  EXPECT_NEAR(dot(turned, evaluate_harmonics<D>(x)), dot(f, evaluate_harmonics<D>(rotate(conjugate(q), x))),
              1e-13);
}

TYPED_TEST(RotationMatrixOf, AFrameTurnsTheReferenceFrameIntoIt) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(4);
  for (int i = 0; i < 20; ++i) {
    const Quaternion q = random.rotation();
    const auto expected = rotated(rotation_matrix<D>(q), reference_frame<D>());
    EXPECT_LT(testing::largest_difference(frame_coefficients<D>(q), expected), 1e-14);
  }
}

}  // namespace
}  // namespace crossgrain
