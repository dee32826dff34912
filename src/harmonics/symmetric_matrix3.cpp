// SPDX-License-Identifier: Apache-2.0
#include "harmonics/symmetric_matrix3.hpp"

#include <utility>

namespace crossgrain {

namespace {

// Jacobi converges quadratically, within 5 sweeps for 3 x 3 matrices; the bound only ends pathological input.
constexpr int kMaxSweeps = 20;

using Matrix3 = std::array<Vector3, 3>;

// Annihilates a[p][q] by a rotation in the plane of p and q, accumulated into the columns of v.
void jacobi_rotation(Matrix3& a, Matrix3& v, int p, int q) {
  if (a[p][q] == 0) return;
  const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const double t = std::copysign(1.0, theta) / (std::fabs(theta) + std::hypot(theta, 1.0));
  const double c = 1 / std::sqrt(t * t + 1), s = t * c;
  for (int k = 0; k < 3; ++k) {
    const double kp = a[k][p], kq = a[k][q];
    a[k][p] = c * kp - s * kq;
    a[k][q] = s * kp + c * kq;
  }
  for (int k = 0; k < 3; ++k) {
    const double pk = a[p][k], qk = a[q][k];
    a[p][k] = c * pk - s * qk;
    a[q][k] = s * pk + c * qk;
  }
  a[p][q] = a[q][p] = 0;
  for (int k = 0; k < 3; ++k) {
    const double kp = v[k][p], kq = v[k][q];
    v[k][p] = c * kp - s * kq;
    v[k][q] = s * kp + c * kq;
  }
}

}  // namespace

Eigensystem3 eigensystem(const SymmetricMatrix3& m) {
  Matrix3 a{Vector3{m[0], m[1], m[2]}, Vector3{m[1], m[3], m[4]}, Vector3{m[2], m[4], m[5]}};
  Matrix3 v{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    const double off_diagonal = std::fabs(a[0][1]) + std::fabs(a[0][2]) + std::fabs(a[1][2]);
    if (!(off_diagonal > 0)) break;
    jacobi_rotation(a, v, 0, 1);
    jacobi_rotation(a, v, 0, 2);
    jacobi_rotation(a, v, 1, 2);
  }
  std::array<int, 3> order{0, 1, 2};
  if (a[order[1]][order[1]] < a[order[0]][order[0]]) std::swap(order[0], order[1]);
  if (a[order[2]][order[2]] < a[order[1]][order[1]]) std::swap(order[1], order[2]);
  if (a[order[1]][order[1]] < a[order[0]][order[0]]) std::swap(order[0], order[1]);
  Eigensystem3 result{};
  for (int i = 0; i < 3; ++i) {
    const int k = order[i];
    result.values[i] = a[k][k];
    result.vectors[i] = {v[0][k], v[1][k], v[2][k]};
  }
  return result;
}

Vector3 guarded_spectral_step(const SymmetricMatrix3& hessian, const Vector3& gradient, double max_angle_rad,
                              double floor) {
  const double slope = norm(gradient);
  if (!(slope > 0)) return {0, 0, 0};
  const Eigensystem3 system = eigensystem(hessian);
  const double largest = std::max(std::fabs(system.values[0]), std::fabs(system.values[2]));
  // Without curvature the step has the largest angle allowed, downhill.
  const double least = floor * std::max(largest, slope / max_angle_rad);
  Vector3 step{0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    const double curvature = std::max(std::fabs(system.values[i]), least);
    step += (-dot(system.vectors[i], gradient) / curvature) * system.vectors[i];
  }
  const double length = norm(step);
  return length > max_angle_rad ? (max_angle_rad / length) * step : step;
}

}  // namespace crossgrain
