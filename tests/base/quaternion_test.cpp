// SPDX-License-Identifier: Apache-2.0
#include "base/quaternion.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <random>

namespace crossgrain {
namespace {

constexpr double kPi = std::numbers::pi;

// A few roundings of numbers of size one.
constexpr double kRounding = 1e-14;

class QuaternionTest : public ::testing::Test {
 protected:
  Quaternion rotation() {
    return normalised(Quaternion{normal_(random_), normal_(random_), normal_(random_), normal_(random_)});
  }
  Vector3 vector() { return {normal_(random_), normal_(random_), normal_(random_)}; }

 private:
  std::mt19937 random_{20240117};
  std::normal_distribution<double> normal_;
};

double distance(const Vector3& a, const Vector3& b) {
  return norm(a - b);
}

/// The smaller distance of q to p and to -p, which are the same rotation.
double distance_up_to_sign(const Quaternion& p, const Quaternion& q) {
  const double minus = std::hypot(std::hypot(p.w - q.w, p.x - q.x), std::hypot(p.y - q.y, p.z - q.z));
  const double plus = std::hypot(std::hypot(p.w + q.w, p.x + q.x), std::hypot(p.y + q.y, p.z + q.z));
  return std::min(minus, plus);
}

TEST_F(QuaternionTest, TurnsRightHanded) {
  const Vector3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_LT(distance(rotate(from_rotation_vector((kPi / 2) * z), x), y), kRounding);
  EXPECT_LT(distance(rotate(from_rotation_vector((kPi / 2) * x), y), z), kRounding);
  EXPECT_LT(distance(rotate(from_rotation_vector((kPi / 2) * y), z), x), kRounding);
}

TEST_F(QuaternionTest, ProductTurnsByTheRightFactorFirst) {
  for (int i = 0; i < 50; ++i) {
    const Quaternion p = rotation(), q = rotation();
    const Vector3 v = vector();
    EXPECT_LT(distance(rotate(p * q, v), rotate(p, rotate(q, v))), kRounding * norm(v));
  }
}

TEST_F(QuaternionTest, RotateIsTheProductQVQConjugate) {
  for (int i = 0; i < 50; ++i) {
    const Quaternion q = rotation();
    const Vector3 v = vector();
    const Quaternion turned = q * Quaternion{0, v[0], v[1], v[2]} * conjugate(q);
    EXPECT_LT(distance(rotate(q, v), {turned.x, turned.y, turned.z}), kRounding * norm(v));
    EXPECT_NEAR(turned.w, 0, kRounding * norm(v));
  }
}

TEST_F(QuaternionTest, ConjugateUndoes) {
  for (int i = 0; i < 50; ++i) {
    const Quaternion q = rotation();
    EXPECT_LT(distance_up_to_sign(conjugate(q) * q, {}), kRounding);
  }
}

TEST_F(QuaternionTest, AxesAreTheTurnedUnitVectorsAndRightHanded) {
  for (int i = 0; i < 50; ++i) {
    const Quaternion q = rotation();
    const auto axes = axes_of(q);
    EXPECT_LT(distance(axes[0], rotate(q, {1, 0, 0})), kRounding);
    EXPECT_LT(distance(axes[1], rotate(q, {0, 1, 0})), kRounding);
    EXPECT_LT(distance(axes[2], rotate(q, {0, 0, 1})), kRounding);
    EXPECT_LT(distance(cross(axes[0], axes[1]), axes[2]), kRounding);
    EXPECT_NEAR(dot(axes[0], axes[1]), 0, kRounding);
  }
}

TEST_F(QuaternionTest, OfARotationVectorTurnsByItsLengthAboutIt) {
  for (const double angle_rad : {1e-3, 0.5, 2.0, 3.1}) {
    const Vector3 about = normalised(vector());
    const Quaternion q = from_rotation_vector(angle_rad * about);
    EXPECT_LT(distance(rotate(q, about), about), kRounding);
    const Vector3 side = orthogonal_unit(about);
    const Vector3 expected = std::cos(angle_rad) * side + std::sin(angle_rad) * cross(about, side);
    EXPECT_LT(distance(rotate(q, side), expected), kRounding);
  }
}

TEST_F(QuaternionTest, OfAZeroRotationVectorIsTheIdentity) {
  const Quaternion q = from_rotation_vector({0, 0, 0});
  EXPECT_EQ(q.w, 1);
  EXPECT_EQ(q.x, 0);
  EXPECT_EQ(q.y, 0);
  EXPECT_EQ(q.z, 0);
}

TEST_F(QuaternionTest, OfATinyRotationVectorIsItsHalf) {
  // Just below and above where the series takes over.
  for (const double angle_rad : {0.9e-8, 1.1e-8}) {
    const Quaternion q = from_rotation_vector({angle_rad, 0, 0});
    EXPECT_NEAR(q.x / angle_rad, 0.5, 1e-15);
  }
}

TEST_F(QuaternionTest, TakesSixteenBytesWhenStored) {
  EXPECT_EQ(sizeof(StoredQuaternion), 16u);
}

TEST_F(QuaternionTest, ComesBackFromStorageToSinglePrecisionAndOfUnitNorm) {
  for (int i = 0; i < 50; ++i) {
    const Quaternion q = rotation(), back = from_stored(to_stored(q));
    EXPECT_NEAR(back.w * back.w + back.x * back.x + back.y * back.y + back.z * back.z, 1, kRounding);
    EXPECT_LT(distance_up_to_sign(back, q), 2 * std::numeric_limits<float>::epsilon());
  }
}

}  // namespace
}  // namespace crossgrain
