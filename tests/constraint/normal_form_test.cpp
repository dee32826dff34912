// SPDX-License-Identifier: Apache-2.0
#include "constraint/normal_form.hpp"

#include "constraint/frame_form.hpp"
#include "constraint/random_cells.hpp"
#include "constraint/spectrum.hpp"
#include "harmonics/generators.hpp"

namespace crossgrain {
namespace {

template <class Degree>
class NormalForm : public ::testing::Test {};
TYPED_TEST_SUITE(NormalForm, testing::BothDegrees);

TYPED_TEST(NormalForm, IsZeroOnFramesWithAnAxisAlongTheNormal) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(1);
  for (int i = 0; i < 100; ++i) {
    const Quaternion q = random.rotation();
    for (const Vector3& axis : axes_of(q)) {
      EXPECT_NEAR(value(normal_form<D>(axis, 2), frame_coefficients<D>(q)), 0, 5e-14);
    }
  }
}

TYPED_TEST(NormalForm, IsPositiveOnOtherFrames) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(2);
  for (int i = 0; i < 100; ++i) {
    const Quaternion q = random.rotation();
    const Vector3 normal = random.direction();
    double cosine = 0;
    for (const Vector3& axis : axes_of(q)) cosine = std::max(cosine, std::fabs(dot(axis, normal)));
    // Of order 4 (degree 3) or 20/3 times the squared angle, so above the squared sine.
    EXPECT_GT(value(normal_form<D>(normal), frame_coefficients<D>(q)), 1 - cosine * cosine);
  }
}

TYPED_TEST(NormalForm, IsEvenInTheNormal) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(3);
  const Vector3 normal = random.direction();
  EXPECT_LT(testing::largest_difference(normal_form<D>(normal), normal_form<D>(-normal)), 1e-14);
}

TYPED_TEST(NormalForm, TurnsWithTheNormal) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(4);
  for (int i = 0; i < 20; ++i) {
    const Vector3 normal = random.direction();
    const Quaternion turn = random.rotation();
    const auto h = random.coefficients<D>();
    EXPECT_NEAR(value(normal_form<D>(rotate(turn, normal)), rotated(rotation_matrix<D>(turn), h)),
                value(normal_form<D>(normal), h), 1e-12);
  }
}

TYPED_TEST(NormalForm, DoesNotChangeAbruptlyWhereTheHelperAxesDo) {
  constexpr int D = TypeParam::value;
  const auto below = normal_form<D>(normalised(Vector3{1, 0, -1e-13})),
             above = normal_form<D>(Vector3{1, 0, 1e-13});
  EXPECT_LT(testing::largest_difference(below, above), 1e-11);
}

TYPED_TEST(NormalForm, AppliedByItsBasisIsTheMatrix) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(5);
  const Vector3 normal = random.direction();
  const auto basis = normal_basis<D>(normal);
  const auto form = normal_form<D>(normal);
  const auto h = random.coefficients<D>();
  EXPECT_NEAR(normal_value<D>(basis, h), value(form, h), 1e-13);
}

TYPED_TEST(NormalForm, HasOrthonormalHarmonicsOfTheRightOrderAboutTheNormal) {
  constexpr int D = TypeParam::value;
  constexpr int order = D == 3 ? 2 : 4;
  testing::RandomSamples random(6);
  const Vector3 normal = random.direction();
  const auto basis = normal_basis<D>(normal);
  EXPECT_NEAR(squared_norm(basis.cosine), 1, 1e-14);
  EXPECT_NEAR(squared_norm(basis.sine), 1, 1e-14);
  EXPECT_NEAR(dot(basis.cosine, basis.sine), 0, 1e-14);
  // Order m about n: the generator about n turns cosine into -m times sine or its like.
  Coefficients<D> turned{};
  const auto lh = apply_generators<D>(basis.cosine);
  for (int axis = 0; axis < 3; ++axis) add_scaled(turned, normal[axis], lh[axis]);
  EXPECT_LT(testing::largest_difference(turned, scaled(basis.sine, order)), 1e-13);
}

TEST(NormalFormOfDegreeThree, HasThePlaneSpectrum) {
  testing::RandomSamples random(7);
  const auto eigenvalues = spectrum(normal_form<3>(random.direction())).eigenvalues;
  EXPECT_LT(testing::largest_difference(eigenvalues, {0, 0, 1, 1, 1, 1, 1}), 1e-14);
}

TEST(NormalFormOfDegreeThree, CostsFourTimesTheSquaredTilt) {
  const double tilt = 1e-3;  // the next term is of order tilt^4
  const Vector3 normal{std::sin(tilt), 0, std::cos(tilt)};
  EXPECT_NEAR(value(normal_form<3>(normal), reference_frame<3>()) / (tilt * tilt), 4, 1e-4);
}

TEST(NormalFormOfDegreeFour, CostsTwentyThirdsOfTheSquaredTilt) {
  const double tilt = 1e-3;
  const Vector3 normal{std::sin(tilt), 0, std::cos(tilt)};
  EXPECT_NEAR(value(normal_form<4>(normal), reference_frame<4>()) / (tilt * tilt), 20.0 / 3, 1e-4);
}

TEST(NormalFormOfDegreeFour, HasTheZonalHarmonicOfItsShare) {
  const auto basis = normal_basis<4>({0, 0, 1});
  EXPECT_NEAR(basis.zonal[index_of_order<4>(0)], std::sqrt(kZonalShare), 1e-14);
  EXPECT_NEAR(squared_norm(basis.zonal), kZonalShare, 1e-14);
}

// Two planes whose normals are 20 degrees apart, unit weights: the frame with an axis along the crease and
// one along the mean normal, and the same turned by 45 degrees about the mean normal.
template <int D>
std::array<double, 2> shallow_crease_costs() {
  const double half = 10 * std::numbers::pi / 180;
  QuadraticForm<D> form;
  add_normal(form, {std::sin(half), 0, std::cos(half)}, 1);
  add_normal(form, {-std::sin(half), 0, std::cos(half)}, 1);
  const Quaternion turned = from_rotation_vector({0, 0, std::numbers::pi / 4});
  return {value(form, reference_frame<D>()), value(form, frame_coefficients<D>(turned))};
}

TEST(NormalFormOfDegreeThree, SlightlyPrefersTheFrameTurnedAcrossAShallowCrease) {
  const auto [along, turned] = shallow_crease_costs<3>();
  EXPECT_NEAR(along, 0.2340, 5e-5);
  EXPECT_NEAR(turned, 0.2318, 5e-5);
}

TEST(NormalFormOfDegreeFour, PrefersTheFrameAlongAShallowCrease) {
  const auto [along, turned] = shallow_crease_costs<4>();
  EXPECT_NEAR(along, 0.3892, 5e-5);
  EXPECT_NEAR(turned, 0.3944, 5e-5);
}

template <int D>
double crease_with_axis_difference() {
  const double half = 10 * std::numbers::pi / 180;
  QuadraticForm<D> form;
  add_normal(form, {std::sin(half), 0, std::cos(half)}, 1);
  add_normal(form, {-std::sin(half), 0, std::cos(half)}, 1);
  add_axis(form, {0, 1, 0}, 0.1);
  const Quaternion turned = from_rotation_vector({0, 0, std::numbers::pi / 4});
  return value(form, frame_coefficients<D>(turned)) - value(form, reference_frame<D>());
}

TYPED_TEST(NormalForm, WithTheCreaseAsAnAxisPrefersTheFrameAlongIt) {
  EXPECT_GT(crease_with_axis_difference<TypeParam::value>(), 0.09);
}

TYPED_TEST(NormalForm, OfAWholeFrameIsZeroOnItAlone) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(8);
  const Quaternion q = random.rotation();
  QuadraticForm<D> form;
  add_frame(form, q, 2);
  EXPECT_NEAR(value(form, frame_coefficients<D>(q)), 0, 1e-14);
  const Quaternion other = from_rotation_vector(0.01 * random.direction()) * q;
  // |L_a h~|^2 is 4 or 20/3, so a turn by t costs weight times that times t^2.
  EXPECT_NEAR(value(form, frame_coefficients<D>(other)), 2 * (D == 3 ? 4.0 : 20.0 / 3) * 1e-4, 1e-6);
  EXPECT_EQ(form.weight, 2);
}

TYPED_TEST(NormalForm, OfParentsIsTheSumOverChildren) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(9);
  const auto facets = testing::random_facets(random, 6, 6);
  QuadraticForm<D> children;
  for (const auto& facet : facets) children += normal_form<D>(facet.normal, facet.weight);
  EXPECT_LT(testing::largest_difference(children, testing::form_of<D>(facets)), 1e-14);
}

TYPED_TEST(NormalForm, SpectrumIsInvariantUnderRotation) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(10);
  const auto facets = testing::random_facets(random, 3, 8);
  const auto before = spectrum(testing::form_of<D>(facets)).eigenvalues;
  const auto after = spectrum(testing::form_of<D>(testing::turned(facets, random.rotation()))).eigenvalues;
  EXPECT_LT(testing::largest_difference(before, after), 1e-13);
}

}  // namespace
}  // namespace crossgrain
