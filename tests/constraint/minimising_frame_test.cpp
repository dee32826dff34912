// SPDX-License-Identifier: Apache-2.0
#include "constraint/minimising_frame.hpp"

#include "constraint/random_cells.hpp"

namespace crossgrain {
namespace {

template <class Degree>
class MinimisingFrame : public ::testing::Test {};
TYPED_TEST_SUITE(MinimisingFrame, testing::BothDegrees);

TYPED_TEST(MinimisingFrame, OfThreeOrthogonalPlanesIsTheirFrame) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(1);
  for (int i = 0; i < 50; ++i) {
    const Quaternion q = random.rotation();
    QuadraticForm<D> form;
    for (const Vector3& axis : axes_of(q)) add_normal(form, axis, random.uniform(0.1, 1));
    EXPECT_LT(testing::misorientation_rad(minimising_frame(form), q), 1e-7);
  }
}

TYPED_TEST(MinimisingFrame, OfRandomCellsIsNotBeatenByDenseSampling) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(2);
  std::vector<Coefficients<D>> sample;
  for (int i = 0; i < 20000; ++i) sample.push_back(frame_coefficients<D>(random.rotation()));
  for (int i = 0; i < 200; ++i) {
    const auto form = testing::form_of<D>(testing::random_facets(random, 1, 9));
    const double found = value(form, frame_coefficients<D>(minimising_frame(form)));
    double best = INFINITY;
    for (const auto& h : sample) best = std::min(best, value(form, h));
    EXPECT_LE(found, best + 1e-13);
  }
}

TYPED_TEST(MinimisingFrame, OfOneNormalHasAnAxisAlongIt) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(3);
  const Vector3 normal = random.direction();
  double alignment = 0;
  for (const Vector3& axis : axes_of(minimising_frame(normal_form<D>(normal)))) {
    alignment = std::max(alignment, std::fabs(dot(axis, normal)));
  }
  EXPECT_NEAR(alignment, 1, 1e-14);
}

}  // namespace
}  // namespace crossgrain
