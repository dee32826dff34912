// SPDX-License-Identifier: Apache-2.0
// Notation: E(h) = h^T A h - 2 b.h + c, h* = h(R) the frame that minimises it, t = E(h*), r = A h* - b, L_a
// the generators.
//
// Degree 4. Quadratics that vanish on all frames may be added to E - t. Six of them, |h|^2 - 1 and sum S_ab
// (L_a h).(L_b h), S symmetric and traceless (docs/design.md section 4), suffice for most cells, in closed
// form: with multipliers mu and S
//   W(h) = E(h) - t + mu (|h|^2 - 1) + sum S_ab (L_a h).(L_b h)
// vanishes at h* together with its gradient, that is W(h) = (h - h*)^T A' (h - h*), if
//   r + mu h* + sum S_ab L_a^T L_b h* = 0.
// In nine dimensions h*, the three tangents L_a h*, and the five L_a^T L_b h* are a basis; r has no part
// along the tangents, since h* is a minimum; so mu and S are unique. mu = -r.h*. In the axes of the frame, S
// follows from the symmetry of the cube: its diagonal and its off-diagonal part are each multiplied by a
// factor, whose squares are 280/3 and 70/3. W is the shifted form if A' is positive semidefinite. Otherwise
// log_det_shift.hpp solves the complete problem.
#include "constraint/spectral_shift.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

#include "constraint/dense.hpp"
#include "constraint/log_det_shift.hpp"
#include "constraint/minimising_frame.hpp"
#include "constraint/spectrum.hpp"
#include "harmonics/frame.hpp"
#include "harmonics/generators.hpp"

namespace crossgrain {

namespace {

// The squared norm of S -> sum S_ab L_a^T L_b h~ on traceless diagonal and on off-diagonal S of unit
// Frobenius norm.
constexpr double kDiagonalGain = 280.0 / 3;
constexpr double kOffDiagonalGain = 70.0 / 3;

// Eigenvalues of A' over weight this far below zero count as zero: rounding of h* and of the sums.
constexpr double kNegligible = 1e-9;

using Matrix3 = Eigen::Matrix3d;

// S of the equation above, in the axes of space.
Matrix3 symmetrisation_multiplier(const Quaternion& frame, const Coefficients<4>& h,
                                  const Coefficients<4>& r) {
  const auto lh = apply_generators<4>(h), lr = apply_generators<4>(r);
  Matrix3 k, axes;
  const auto r_axes = axes_of(frame);
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      k(a, b) = 0.5 * (dot(lh[a], lr[b]) + dot(lh[b], lr[a]));
      axes(a, b) = r_axes[b][a];
    }
  }
  k -= k.trace() / 3 * Matrix3::Identity();
  const Matrix3 in_frame = axes.transpose() * k * axes;
  Matrix3 s = -in_frame / kOffDiagonalGain;
  s.diagonal() = -in_frame.diagonal() / kDiagonalGain;
  return axes * s * axes.transpose();
}

// A += sum S_ab L_a^T L_b.
void add_symmetrisation(QuadraticForm<4>& form, const Matrix3& s) {
  for (int column = 0; column < kCoefficientCount<4>; ++column) {
    Coefficients<4> unit{};
    unit[column] = 1;
    const auto lh = apply_generators<4>(unit);
    for (int a = 0; a < 3; ++a) {
      Coefficients<4> mixed{};
      for (int b = 0; b < 3; ++b) add_scaled(mixed, s(a, b), lh[b]);
      const Coefficients<4> image = apply_generator<4>(a, mixed);
      for (int row = 0; row <= column; ++row) form.matrix[form_entry<4>(row, column)] -= image[row];
    }
  }
}

bool is_positive_semidefinite(const QuadraticForm<4>& form, double tolerance) {
  const DenseMatrix<4> matrix = dense_matrix(form) + tolerance * DenseMatrix<4>::Identity();
  return Eigen::LLT<DenseMatrix<4>>(matrix).info() == Eigen::Success;
}

/// W above for a minimum at `frame`; nothing if it is negative somewhere, as it is if another frame has a
/// lower value.
std::optional<QuadraticForm<4>> shifted_at(const QuadraticForm<4>& form, const Quaternion& frame) {
  const Coefficients<4> h = frame_coefficients<4>(frame);
  const Coefficients<4> r = half_gradient(form, h);
  const double mu = -dot(r, h);
  QuadraticForm<4> result = form;
  add_identity(result, mu);
  add_symmetrisation(result, symmetrisation_multiplier(frame, h, r));
  result.constant -= value(form, h) + mu;
  if (!is_positive_semidefinite(result, kNegligible * form.weight)) return std::nullopt;
  return result;
}

}  // namespace

template <>
QuadraticForm<3> shifted<3>(const QuadraticForm<3>& form) {
  QuadraticForm<3> result = form;
  add_identity(result, -spectrum(form).eigenvalues[0]);
  return result;
}

template <>
QuadraticForm<4> shifted<4>(const QuadraticForm<4>& form) {
  if (!(form.weight > 0)) return form;
  const auto result = shifted_at(form, minimising_frame(form));
  return result ? *result : log_det_shifted(form);
}

double least_value(const QuadraticForm<4>& form, const Quaternion& start) {
  const auto value_at = [&](const Quaternion& frame) { return value(form, frame_coefficients<4>(frame)); };
  const Quaternion near = refine_minimising_frame(form, start);
  if (shifted_at(form, near)) return value_at(near);
  return std::min(value_at(near), value_at(minimising_frame(form)));
}

namespace {

/// Constants of the energy of a unit vector in a coordinate plane of a frame, at angle phi from its axis:
///   E(phi) = kConstant - kFourfold cos(4 phi) - kEightfold cos(8 phi).
constexpr double kConstant = 1265.0 / 1536, kFourfold = 105.0 / 128, kEightfold = 5.0 / 1536;

/// The value at a minimum of -Re(z1 exp(-i psi)) kFourfold - Re(z2 exp(-2 i psi)) kEightfold near `psi`.
double minimum_near(double psi, const std::complex<double>& z1, const std::complex<double>& z2) {
  // Newton steps never go uphill near here; the last ones are at rounding.
  constexpr int kSteps = 8;
  for (int step = 0; step < kSteps; ++step) {
    const std::complex<double> first = kFourfold * z1 * std::polar(1.0, -psi),
                               second = kEightfold * z2 * std::polar(1.0, -2 * psi);
    const double slope = -first.imag() - 2 * second.imag();
    const double curvature = first.real() + 4 * second.real();
    if (!(curvature > 0)) break;
    psi -= slope / curvature;
  }
  return -kFourfold * std::real(z1 * std::polar(1.0, -psi)) -
         kEightfold * std::real(z2 * std::polar(1.0, -2 * psi));
}

}  // namespace

double least_value_of_two(const Vector3& a, double weight_a, const Vector3& b, double weight_b) {
  // psi is four times the angle of the frame from a in the plane of a and b.
  const double between = 4 * std::atan2(norm(cross(a, b)), dot(a, b));
  const std::complex<double> z1 = weight_a + weight_b * std::polar(1.0, between),
                             z2 = weight_a + weight_b * std::polar(1.0, 2 * between);
  // At 45 degrees the fourfold parts cancel and the eightfold ones decide.
  double least = minimum_near(std::arg(z1), z1, z2);
  for (const double turn : {0.0, std::numbers::pi})
    least = std::min(least, minimum_near(std::arg(z2) / 2 + turn, z1, z2));
  return std::max(0.0, kConstant * (weight_a + weight_b) + least);
}

}  // namespace crossgrain
