// SPDX-License-Identifier: Apache-2.0
// Notation: x = (1, h) in R^10. A quadratic in h is a symmetric 10 x 10 matrix, here M for E over its weight;
// Q_k, k = 1 ... 15, for those that vanish on frames, Q_0 = -e_0 e_0^T for the constant -t. W(y) = M + sum
// y_k Q_k with y_0 = t. The barrier method follows the minimum of -s t - log det W(y) while s grows; at a
// minimum t is within 10 / s of the optimum (the matrices have 10 rows; Boyd & Vandenberghe, Convex
// Optimization, section 11.2).
#include "constraint/log_det_shift.hpp"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <numbers>

#include "constraint/dense.hpp"
#include "harmonics/evaluation.hpp"
#include "harmonics/frame.hpp"
#include "harmonics/generators.hpp"
#include "harmonics/sphere_quadrature.hpp"

namespace crossgrain {

namespace {

constexpr int kSize = 10;
constexpr int kMultipliers = 16;  // t, then the 15 quadratics
using Matrix10 = Eigen::Matrix<double, kSize, kSize>;
using Multipliers = Eigen::Matrix<double, kMultipliers, 1>;
using MultiplierHessian = Eigen::Matrix<double, kMultipliers, kMultipliers>;
using Quadratics = std::array<Matrix10, kMultipliers>;

constexpr double kFirstSharpness = 10;   // s; the forms are of size 1
constexpr double kLastSharpness = 2e8;   // t to 10 / s = 5e-8
constexpr double kSharpnessFactor = 20;  // 3 to 6 Newton steps per stage
constexpr int kMaxSteps = 200;           // about 40 are taken
constexpr double kCentred = 0.1;         // Newton decrement at which a stage ends

DenseMatrix<4> generator_matrix(int axis) {
  DenseMatrix<4> matrix;
  for (int column = 0; column < kCoefficientCount<4>; ++column) {
    Coefficients<4> unit{};
    unit[column] = 1;
    matrix.col(column) = to_dense<4>(apply_generator<4>(axis, unit));
  }
  return matrix;
}

// Sets the quadratics (h x h)_4 - c h: (h x h)_4 is the degree-4 part of the square of the function h, by
// integrals of three harmonics, of degree 12; c = (h~ x h~)_4 . h~.
void set_products(Quadratics& quadratics) {
  for (const auto& [direction, weight] : sphere_quadrature<12>()) {
    const DenseVector<4> y = to_dense<4>(evaluate_harmonics<4>(direction));
    for (int k = 0; k < kCoefficientCount<4>; ++k) {
      quadratics[7 + k].bottomRightCorner<9, 9>() +=
          4 * std::numbers::pi * weight * y[k] * (y * y.transpose());
    }
  }
  const DenseVector<4> frame = to_dense<4>(reference_frame<4>());
  double c = 0;
  for (int k = 0; k < kCoefficientCount<4>; ++k) {
    c += frame[k] * frame.dot(quadratics[7 + k].bottomRightCorner<9, 9>() * frame);
  }
  for (int k = 0; k < kCoefficientCount<4>; ++k) {
    quadratics[7 + k](0, 1 + k) = quadratics[7 + k](1 + k, 0) = -c / 2;
  }
}

Quadratics build_quadratics() {
  Quadratics quadratics;
  for (Matrix10& q : quadratics) q.setZero();
  quadratics[0](0, 0) = -1;
  quadratics[1].setIdentity();
  quadratics[1](0, 0) = -1;
  std::array<DenseMatrix<4>, 3> l{generator_matrix(0), generator_matrix(1), generator_matrix(2)};
  const auto gram = [&](int a, int b) -> DenseMatrix<4> {
    return 0.5 * (l[a].transpose() * l[b] + l[b].transpose() * l[a]);
  };
  const std::array<DenseMatrix<4>, 5> traceless{gram(0, 1), gram(0, 2), gram(1, 2), gram(0, 0) - gram(1, 1),
                                                gram(0, 0) + gram(1, 1) - 2 * gram(2, 2)};
  for (int k = 0; k < 5; ++k) quadratics[2 + k].bottomRightCorner<9, 9>() = traceless[k];
  set_products(quadratics);
  return quadratics;
}

const Quadratics& quadratics() {
  static const Quadratics table = build_quadratics();
  return table;
}

Matrix10 combination(const Matrix10& m, const Multipliers& y) {
  Matrix10 w = m;
  for (int k = 0; k < kMultipliers; ++k) w += y[k] * quadratics()[k];
  return w;
}

// Multipliers of W = M + (|h|^2 - 1) + a constant such that det W = det(A + I): W is positive definite.
Multipliers feasible_start(const Matrix10& m) {
  const DenseMatrix<4> a = m.bottomRightCorner<9, 9>() + DenseMatrix<4>::Identity();
  const DenseVector<4> b = m.bottomLeftCorner<9, 1>();
  Multipliers y = Multipliers::Zero();
  y[1] = 1;
  y[0] = m(0, 0) - 1 - b.dot(a.llt().solve(b)) - 1;
  return y;
}

// The Newton step of the barrier function at sharpness s, and its decrement: the length of the step in the
// Hessian.
double newton_step(const Matrix10& w, double s, Multipliers& step) {
  const Eigen::LLT<Matrix10> factor(w);
  std::array<Matrix10, kMultipliers> scaled_q;  // W^-1 Q_k
  Multipliers gradient;
  for (int k = 0; k < kMultipliers; ++k) {
    scaled_q[k] = factor.solve(quadratics()[k]);
    gradient[k] = -scaled_q[k].trace();
  }
  gradient[0] -= s;
  MultiplierHessian hessian;
  for (int k = 0; k < kMultipliers; ++k) {
    for (int l = 0; l <= k; ++l) {
      hessian(k, l) = hessian(l, k) = scaled_q[k].transpose().cwiseProduct(scaled_q[l]).sum();
    }
  }
  step = -hessian.ldlt().solve(gradient);
  return std::sqrt(std::max(0.0, -gradient.dot(step)));
}

}  // namespace

QuadraticForm<4> log_det_shifted(const QuadraticForm<4>& form) {
  Matrix10 m;
  m(0, 0) = form.constant;
  m.bottomLeftCorner<9, 1>() = -to_dense<4>(form.linear);
  m.topRightCorner<1, 9>() = m.bottomLeftCorner<9, 1>().transpose();
  m.bottomRightCorner<9, 9>() = dense_matrix(form);
  m /= form.weight;
  Multipliers y = feasible_start(m), step;
  double s = kFirstSharpness;
  for (int i = 0; i < kMaxSteps; ++i) {
    const double decrement = newton_step(combination(m, y), s, step);
    // A step of length 1 / (1 + decrement) keeps W positive definite, since -log det is self-concordant.
    y += (decrement > 0.25 ? 1 / (1 + decrement) : 1) * step;
    if (decrement > kCentred) continue;
    if (s >= kLastSharpness) break;
    s *= kSharpnessFactor;
  }
  const Matrix10 w = form.weight * combination(m, y);
  QuadraticForm<4> result;
  for (int row = 0; row < kCoefficientCount<4>; ++row) {
    for (int column = row; column < kCoefficientCount<4>; ++column) {
      result.matrix[form_entry<4>(row, column)] = w(1 + row, 1 + column);
    }
    result.linear[row] = -w(0, 1 + row);
  }
  result.constant = w(0, 0);
  result.weight = form.weight;
  return result;
}

}  // namespace crossgrain
