// SPDX-License-Identifier: Apache-2.0
// Forms of random cells, and ways to turn and compare forms, for the tests of this layer.
#pragma once

#include <numbers>
#include <vector>

#include "constraint/normal_form.hpp"
#include "harmonics/random_samples.hpp"
#include "harmonics/rotation.hpp"

namespace crossgrain::testing {

struct Facet {
  Vector3 normal;
  double weight;
};

inline std::vector<Facet> random_facets(RandomSamples& random, int least, int most) {
  std::vector<Facet> facets(random.integer(least, most));
  for (Facet& facet : facets) facet = {random.direction(), random.uniform(0.1, 1)};
  return facets;
}

inline std::vector<Facet> turned(std::vector<Facet> facets, const Quaternion& rotation) {
  for (Facet& facet : facets) facet.normal = rotate(rotation, facet.normal);
  return facets;
}

template <int D>
QuadraticForm<D> form_of(const std::vector<Facet>& facets) {
  QuadraticForm<D> form;
  for (const auto& [normal, weight] : facets) add_normal(form, normal, weight);
  return form;
}

/// Normals around an axis tilted by `tilt_rad` from it, as of a pyramid's or cone's sides.
inline std::vector<Facet> cone_facets(int sides, double tilt_rad) {
  std::vector<Facet> facets;
  for (int i = 0; i < sides; ++i) {
    const double phi = 2 * std::numbers::pi * i / sides;
    facets.push_back(
        {{std::sin(tilt_rad) * std::cos(phi), std::sin(tilt_rad) * std::sin(phi), std::cos(tilt_rad)}, 1});
  }
  return facets;
}

/// The largest difference of any number in two forms.
template <int D>
double largest_difference(const QuadraticForm<D>& a, const QuadraticForm<D>& b) {
  return std::max({testing::largest_difference(a.matrix, b.matrix),
                   testing::largest_difference(linear_part(a), linear_part(b)),
                   std::fabs(constant_part(a) - constant_part(b)), std::fabs(a.weight - b.weight)});
}

}  // namespace crossgrain::testing
