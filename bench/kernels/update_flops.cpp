// SPDX-License-Identifier: Apache-2.0
//
// Notation of field/local_energy.hpp: f(h) = h^T A h - 2 b.h on |h| = 1. Coefficients and frames are
// arbitrary valid ones: only the number of ascent steps depends on them.
#include "kernels/update_flops.hpp"

#include "constraint/normal_form.hpp"
#include "field/small_solve.hpp"
#include "harmonics/deviation.hpp"
#include "harmonics/refined_frame.hpp"
#include "kernels/counted_real.hpp"

namespace crossgrain::bench {
namespace {

using Real = CountedReal;
template <int D>
using Vector = Coefficients<D, Real>;

constexpr BasicVector3<double> kSmallTurn{0.06, -0.05, 0.06};  // a tenth of a radian

BasicQuaternion<Real> turned_frame() {
  return normalised(
      from_small_rotation_vector(BasicVector3<Real>{kSmallTurn[0], kSmallTurn[1], kSmallTurn[2]}));
}

template <int D>
Vector<D> plain_coefficients() {
  return frame_coefficients<D>(BasicQuaternion<Real>{});
}

/// A and b of one cell's local energy, for any kind of cell.
template <int D>
class LocalWork {
 public:
  explicit LocalWork(const CellKind& kind)
      : kind_(kind), plane_(normal_basis<D>(BasicVector3<Real>{0.0, 0.0, 1.0})) {
    add_identity<D>(matrix_, 10.0);
  }

  /// Returns the operations to sum over neighbours, and to add the form if the cell has one.
  double gathering_flops() const {
    // Sums of w h, without the product if all weights are equal, and of w; then times the factor of the
    // degree. In degree 3 w is the weight times an overlap. No cell counts as far from a neighbour.
    constexpr int n = kCoefficientCount<D>, entries = kFormEntryCount<D>;
    const double overlap = D == 3 ? 2 * n - 1 : 0;
    const double weighing = kind_.equal_weights ? (D == 3 ? n : 0) : n + (D == 3 ? 2 : 1);
    double flops = kind_.neighbours * (overlap + weighing + n) + n + 2;
    if (kind_.has_plane)
      flops += Real::operations_in([] {
                 normal_basis<D>(BasicVector3<Real>{0.0, 0.0, 1.0});
               }) +
               (D == 4 ? 2 * n : 0);
    if (kind_.has_general_form) flops += D == 4 ? n : entries;
    return flops;
  }

  Vector<D> apply_matrix(const Vector<D>& x) const {
    Vector<D> result{};
    if (has_matrix()) result = matrix_times<D>(matrix_, x);
    if (kind_.has_plane) {
      add_scaled(result, -dot(plane_.cosine, x), plane_.cosine);
      add_scaled(result, -dot(plane_.sine, x), plane_.sine);
    }
    return result;
  }

  Real value(const Vector<D>& h) const { return dot(h, apply_matrix(h)) - 2 * dot(linear_, h); }
  bool has_matrix() const { return kind_.has_general_form; }
  bool is_linear() const { return !has_matrix() && !kind_.has_plane; }
  const CellKind& kind() const { return kind_; }
  const Vector<D>& linear() const { return linear_; }
  const FormMatrix<D, Real>& matrix() const { return matrix_; }
  const NormalBasis<D, Real>& plane() const { return plane_; }

 private:
  CellKind kind_;
  NormalBasis<D, Real> plane_;
  FormMatrix<D, Real> matrix_{};
  Vector<D> linear_ = plain_coefficients<D>();
};

template <int D>
void newton_update(const LocalWork<D>& energy, const BasicQuaternion<Real>& frame) {
  const Vector<D> h = frame_coefficients<D>(normalised(frame));
  const Vector<D> matrix_h = energy.apply_matrix(h);
  const Real before = dot(h, matrix_h) - 2 * dot(energy.linear(), h);
  const Vector<D> u = difference(matrix_h, energy.linear());
  const auto lh = apply_generators<D>(h), lu = apply_generators<D>(u);
  const BasicVector3<Real> gradient{2 * dot(lh[0], u), 2 * dot(lh[1], u), 2 * dot(lh[2], u)};
  BasicSymmetricMatrix3<Real> hessian;
  int entry = 0;
  for (int a = 0; a < 3; ++a) {
    const Vector<D> matrix_lh = energy.is_linear() ? Vector<D>{} : energy.apply_matrix(lh[a]);
    for (int b = a; b < 3; ++b) {
      hessian[entry] = -dot(lu[a], lh[b]) - dot(lu[b], lh[a]);
      if (!energy.is_linear()) hessian[entry] += 2 * dot(matrix_lh, lh[b]);
      ++entry;
    }
  }
  const BasicVector3<Real> step = Real(1.4) * guarded_newton_step(hessian, gradient, 0.5);
  const auto turned = normalised(from_small_rotation_vector(step) * normalised(frame));
  [[maybe_unused]] const bool falls = energy.value(frame_coefficients<D>(turned)) < before;
}

template <int D>
void relaxation_update(const LocalWork<D>& energy) {
  Vector<D> h = plain_coefficients<D>();
  const Vector<D> before = h;
  if (energy.has_matrix()) {
    h = solve_shifted<D>(energy.matrix(), Real(1.0), energy.linear());
  } else {
    h = scaled(energy.linear(), 1 / Real(9.0));
    if (energy.kind().has_plane) {
      add_scaled(h, dot(energy.plane().cosine, energy.linear()), energy.plane().cosine);
      add_scaled(h, dot(energy.plane().sine, energy.linear()), energy.plane().sine);
    }
  }
  h = scaled(h, Real(1.4));
  add_scaled(h, Real(-0.4), before);
  // One step of symmetrisation.
  const Real norm_before = squared_norm(h);
  add_scaled(h, -1 / (1600 * norm_before), deviation_gradient<D>(h));
  h = scaled(h, 1 - 0.5 * (squared_norm(h) - 1));
}

}  // namespace

template <int D>
double manifold_update_flops(const CellKind& kind) {
  const LocalWork<D> energy(kind);
  const BasicQuaternion<Real> frame = turned_frame();
  return energy.gathering_flops() + Real::operations_in([&] { newton_update(energy, frame); });
}

template <int D>
double relaxation_update_flops(const CellKind& kind) {
  const LocalWork<D> energy(kind);
  return energy.gathering_flops() + Real::operations_in([&] { relaxation_update(energy); });
}

template <int D>
double refined_frame_flops() {
  const Vector<D> target = plain_coefficients<D>();
  const BasicQuaternion<Real> start = turned_frame();
  return Real::operations_in([&] { refined_frame<D>(target, start); });
}

template <int D>
double add_normal_flops() {
  return Real::operations_in([] {
    const NormalBasis<D, Real> basis = normal_basis<D>(BasicVector3<Real>{0.6, 0.0, 0.8});
    FormMatrix<D, Real> matrix{};
    Vector<D> linear{};
    add_identity<D>(matrix, Real(1.0));
    add_outer_product<D>(matrix, Real(-1.0), basis.cosine);
    add_outer_product<D>(matrix, Real(-1.0), basis.sine);
    if constexpr (D == 4) add_scaled(linear, Real(1.0), basis.zonal);
  });
}

double sample_flops() {
  const auto turn = BasicVector3<Real>{kSmallTurn[0], kSmallTurn[1], kSmallTurn[2]};
  const BasicQuaternion<Real> frame = turned_frame();
  const double extending = Real::operations_in([&] {
    const BasicVector3<Real> rotation{dot(turn, turn), dot(turn, turn), dot(turn, turn)};  // W (x - c)
    Vector<4> h{};
    add_scaled(h, Real(0.125), frame_coefficients<4>(from_small_rotation_vector(rotation) * frame));
  });
  return 8 * extending + refined_frame_flops<4>();
}

template double manifold_update_flops<3>(const CellKind&);
template double manifold_update_flops<4>(const CellKind&);
template double relaxation_update_flops<3>(const CellKind&);
template double relaxation_update_flops<4>(const CellKind&);
template double refined_frame_flops<3>();
template double refined_frame_flops<4>();
template double add_normal_flops<3>();
template double add_normal_flops<4>();

}  // namespace crossgrain::bench
