// SPDX-License-Identifier: Apache-2.0
#include "lattice/lattice_axes.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/vector3.hpp"
#include "harmonics/coefficients.hpp"
#include "harmonics/evaluation.hpp"
#include "harmonics/frame.hpp"

namespace crossgrain {
namespace {

/// Normals within 5 degrees of an axis make the frame exact.
constexpr double kNearCosine = 0.9961947;

/// Rounds of that: each leaves out what is no longer near. The frame stays after two or three on parts.
constexpr int kRounds = 4;

struct AxisNormals {
  Coefficients<4> sum{};
  double area = 0;
};

template <class Counts>
AxisNormals sum_of(const Surface& surface, const Counts& counts) {
  AxisNormals normals;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    if (!counts(surface.normals[t])) continue;
    add_scaled(normals.sum, surface.areas[t], evaluate_harmonics<4>(surface.normals[t]));
    normals.area += surface.areas[t];
  }
  return normals;
}

bool is_near_axis(const std::array<Vector3, 3>& axes, const Vector3& normal) {
  for (const Vector3& axis : axes)
    if (std::abs(dot(axis, normal)) >= kNearCosine) return true;
  return false;
}

}  // namespace

double alignment_with(const Surface& surface, const Quaternion& frame) {
  const std::array<Vector3, 3> axes = axes_of(frame);
  double sum = 0, area = 0;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    for (const Vector3& axis : axes) {
      const double cosine = dot(axis, surface.normals[t]);
      sum += surface.areas[t] * cosine * cosine * cosine * cosine;
    }
    area += surface.areas[t];
  }
  return sum / area;
}

Quaternion lattice_axes(const Surface& surface) {
  Quaternion frame = nearest_frame<4>(sum_of(surface, [](const Vector3&) { return true; }).sum);
  for (int round = 0; round < kRounds; ++round) {
    const std::array<Vector3, 3> axes = axes_of(frame);
    const AxisNormals near =
        sum_of(surface, [&](const Vector3& normal) { return is_near_axis(axes, normal); });
    if (near.area == 0) break;
    frame = refine_frame<4>(near.sum, frame);
  }
  const double gained = alignment_with(surface, frame) - alignment_with(surface, Quaternion());
  return gained > kAxesGain ? frame : Quaternion();
}

}  // namespace crossgrain
