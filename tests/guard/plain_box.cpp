// SPDX-License-Identifier: Apache-2.0
//
// Notation: h the coefficients of a cell, v the sum of its neighbours', L the generators; the step minimises
// -v.h(w) to second order in the rotation vector w, as in field/manifold_sweep.cpp.
#include "guard/plain_box.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>

#include "harmonics/frame.hpp"
#include "harmonics/generators.hpp"
#include "harmonics/symmetric_matrix3.hpp"

namespace crossgrain {
namespace {

constexpr double kLargestPlainStep_rad = 0.5;
constexpr double kStartTurn_rad = 0.1;

/// Calls visit(x, y, z) for the eighteen steps to cells that share a face or an edge.
template <class Visit>
void for_each_step(const Visit& visit) {
  for (int number = 0; number < 27; ++number) {
    const std::array<int, 3> step{number % 3 - 1, number / 3 % 3 - 1, number / 9 - 1};
    const int length = std::abs(step[0]) + std::abs(step[1]) + std::abs(step[2]);
    if (length == 1 || length == 2) visit(step);
  }
}

}  // namespace

PlainBox::PlainBox(std::uint32_t across) {
  const int n = static_cast<int>(across);
  const int cells = n * n * n;
  row_begin_.push_back(0);
  for (int cell = 0; cell < cells; ++cell) {
    const std::array<int, 3> at{cell % n, cell / n % n, cell / n / n};
    for_each_step([&](const std::array<int, 3>& step) {
      const int x = at[0] + step[0], y = at[1] + step[1], z = at[2] + step[2];
      if (std::min({x, y, z}) < 0 || std::max({x, y, z}) >= n) return;
      neighbours_.push_back(static_cast<std::uint32_t>((z * n + y) * n + x));
    });
    row_begin_.push_back(static_cast<std::uint32_t>(neighbours_.size()));
  }
  std::mt19937_64 random(1);
  const auto deviate = [&] { return kStartTurn_rad * (0x1p-63 * static_cast<double>(random()) - 1); };
  for (int cell = 0; cell < cells; ++cell) {
    frames_.push_back(from_rotation_vector({deviate(), deviate(), deviate()}));
    coefficients_.push_back(frame_coefficients<4>(frames_.back()));
  }
}

void PlainBox::sweep() {
  for (std::size_t cell = 0; cell < size(); ++cell) {
    Coefficients<4> v{};
    for (std::uint32_t k = row_begin_[cell]; k < row_begin_[cell + 1]; ++k)
      add_scaled(v, 1.0, coefficients_[neighbours_[k]]);
    const Coefficients<4>& h = coefficients_[cell];
    const auto lh = apply_generators<4>(h), lv = apply_generators<4>(v);
    const Vector3 gradient{-dot(lh[0], v), -dot(lh[1], v), -dot(lh[2], v)};
    SymmetricMatrix3 hessian;
    int entry = 0;
    for (int a = 0; a < 3; ++a) {
      for (int b = a; b < 3; ++b) hessian[entry++] = 0.5 * (dot(lv[a], lh[b]) + dot(lv[b], lh[a]));
    }
    const Vector3 step = guarded_newton_step(hessian, gradient, kLargestPlainStep_rad);
    const Quaternion turned = normalised(from_rotation_vector(step) * frames_[cell]);
    const Coefficients<4> after = frame_coefficients<4>(turned);
    if (dot(after, v) <= dot(h, v)) continue;
    frames_[cell] = turned;
    coefficients_[cell] = after;
  }
}

double PlainBox::energy() const {
  double sum = 0;
  for (std::size_t cell = 0; cell < size(); ++cell) {
    for (std::uint32_t k = row_begin_[cell]; k < row_begin_[cell + 1]; ++k)
      sum += squared_norm(difference(coefficients_[cell], coefficients_[neighbours_[k]]));
  }
  return sum / 2;
}

}  // namespace crossgrain
