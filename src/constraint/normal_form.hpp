// SPDX-License-Identifier: Apache-2.0
// The constraints that forms are sums of: a frame has one axis along a unit vector n (a surface normal or the
// tangent of a crease), or is a given frame.
//
// Notation (arXiv 2309.13477; docs/design.md section 3): u, v complete n to a right-handed frame. P_n = C C^T
// + S S^T projects onto the two harmonics about n with |m| = 2 (degree 3) or |m| = 4 (degree 4), b_n =
// sqrt(7/12) times the unit zonal harmonic about n. E_n(h) = h^T (I - P_n) h, in degree 4 minus 2 b_n.h plus
// 7/12.
#pragma once

#include "constraint/quadratic_form.hpp"
#include "harmonics/frame.hpp"

namespace crossgrain {

/// C, S and b_n for an axis n. Another choice of u, v rotates C and S into each other and changes no energy.
template <int D, class Real = double>
struct NormalBasis;

template <class Real>
struct NormalBasis<3, Real> {
  Coefficients<3, Real> cosine, sine;  ///< of unit norm
};

template <class Real>
struct NormalBasis<4, Real> {
  Coefficients<4, Real> cosine, sine;  ///< of unit norm
  Coefficients<4, Real> zonal;         ///< b_n, of squared norm 7/12
};

/// |b_n|^2, the constant of E_n in degree 4.
inline constexpr double kZonalShare = 7.0 / 12;

/// C, S and b_n for a unit vector n; even in n.
///
/// Degree 3: n (u^2 - v^2) / 2 and u v n, each of unit norm once normalised as a frame is.
template <int D, class Real = double>
requires(D == 3) NormalBasis<D, Real> normal_basis(const BasicVector3<Real>& n) {
  const BasicVector3<Real> u = orthogonal_unit(n), v = cross(n, u);
  const QuadraticFactor<Real> uu = product_of(u, u), vv = product_of(v, v);
  const QuadraticFactor<Real> half_difference{
      0.5 * (uu.order2_re - vv.order2_re), 0.5 * (uu.order2_im - vv.order2_im),
      0.5 * (uu.order1_re - vv.order1_re), 0.5 * (uu.order1_im - vv.order1_im),
      0.5 * (uu.order0 - vv.order0)};
  return {octupole_of(half_difference, n), octupole_of(product_of(u, v), n)};
}

/// A complex number with plain products: std::complex checks every product for NaN.
template <class Real>
struct PlainComplex {
  Real re, im;
};
template <class Real>
PlainComplex<Real> operator*(const PlainComplex<Real>& a, const PlainComplex<Real>& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
template <class Real>
PlainComplex<Real> operator*(double s, const PlainComplex<Real>& a) {
  return {s * a.re, s * a.im};
}
template <class Real>
PlainComplex<Real> operator-(const PlainComplex<Real>& a, const PlainComplex<Real>& b) {
  return {a.re - b.re, a.im - b.im};
}

/// Degree 4: with w = u + i v, a null vector, (w.x)^4 is harmonic, and its coefficients are proportional to
/// the harmonics evaluated at w, where x^2 + y^2 + z^2 = 0. So C + i S is evaluate_harmonics<4>(w) without
/// that term, scaled to be e_4 + i e_{-4} for n = z.
template <int D, class Real = double>
requires(D == 4) NormalBasis<D, Real> normal_basis(const BasicVector3<Real>& n) {
  constexpr double k3 = 2.828427124746190098 / 8;  // 2 sqrt 2, over the factor 8 of (w.x)^4
  constexpr double k2 = 5.291502622129181181 / 8;  // 2 sqrt 7
  constexpr double k1 = 7.483314773547882772 / 8;  // 2 sqrt 14
  constexpr double k0 = 5.916079783099616042 / 8;  // sqrt 35
  constexpr double kZonal = 0.9024893263989445;    // sqrt(7/12) sqrt(4 pi / 9)
  using Complex = PlainComplex<Real>;
  const BasicVector3<Real> u = orthogonal_unit(n), v = cross(n, u);
  const Complex x{u[0], v[0]}, y{u[1], v[1]}, z{u[2], v[2]};
  const Complex xx = x * x, yy = y * y, zz = z * z, xy = x * y, zx = z * x, zy = z * y;
  const Complex square = xx - yy;
  const std::array<Complex, 9> harmonics{0.5 * (xy * square),
                                         k3 * (zy * (3 * xx - yy)),
                                         2 * k2 * (zz * xy),
                                         k1 * (zz * zy),
                                         k0 * (zz * zz),
                                         k1 * (zz * zx),
                                         k2 * (zz * square),
                                         k3 * (zx * (xx - 3 * yy)),
                                         0.125 * (square * square - 4 * (xy * xy))};
  NormalBasis<4, Real> basis;
  for (int i = 0; i < kCoefficientCount<4>; ++i) {
    basis.cosine[i] = harmonics[i].re;
    basis.sine[i] = harmonics[i].im;
  }
  basis.zonal = scaled(evaluate_harmonics<4>(n), kZonal);
  return basis;
}

/// E_n(h) for the n of the basis.
template <int D>
inline double normal_value(const NormalBasis<D>& basis, const Coefficients<D>& h) {
  const double along_cosine = dot(basis.cosine, h), along_sine = dot(basis.sine, h);
  double result = squared_norm(h) - along_cosine * along_cosine - along_sine * along_sine;
  if constexpr (D == 4) result += kZonalShare - 2 * dot(basis.zonal, h);
  return result;
}

/// form += weight * E_n: the frame has an axis along the surface normal n.
template <int D>
void add_normal(QuadraticForm<D>& form, const Vector3& unit_normal, double weight) {
  const NormalBasis<D> basis = normal_basis<D>(unit_normal);
  add_identity(form, weight);
  add_outer_product(form, -weight, basis.cosine);
  add_outer_product(form, -weight, basis.sine);
  if constexpr (D == 4) {
    add_scaled(form.linear, weight, basis.zonal);
    form.constant += weight * kZonalShare;
  }
  form.weight += weight;
}

/// The form weight * E_n.
template <int D>
QuadraticForm<D> normal_form(const Vector3& unit_normal, double weight = 1) {
  QuadraticForm<D> form;
  add_normal(form, unit_normal, weight);
  return form;
}

/// form += weight * E_t: the frame has an axis along t, the tangent of a crease or a direction that the user
/// prescribes. The same energy as for a normal.
template <int D>
void add_axis(QuadraticForm<D>& form, const Vector3& unit_axis, double weight) {
  add_normal(form, unit_axis, weight);
}

}  // namespace crossgrain
