// SPDX-License-Identifier: Apache-2.0
// The energy as one cell sees it while its neighbours stand still.
//
// Notation: f(h) = h^T A h - 2 b.h, up to constants on |h| = 1. With neighbours h_j, weights w_j and the
// cell's form h^T A_c h - 2 b_c.h (scaled as in CellForms), docs/design.md section 5 gives
//   degree 4: A = A_c, b = b_c + v / 2, v = sum w_j h_j;
//   degree 3: A = A_c - (5/6) sum w_j h_j h_j^T, b = 0.
#pragma once

#include "constraint/normal_form.hpp"
#include "field/field_graph.hpp"
#include "field/field_state.hpp"

namespace crossgrain {

template <int D>
class LocalEnergy {
 public:
  LocalEnergy(const FieldGraph<D>& graph, const std::vector<StoredCoefficients<D>>& coefficients,
              std::size_t cell) {
    add_neighbours(graph.adjacency()[cell], coefficients);
    if (const PlaneForm* plane = graph.forms.plane(cell)) add_plane(*plane);
    if (const PackedForm<D>* form = graph.forms.general(cell)) add_form(*form);
  }

  /// f(h) for |h| = 1.
  double value(const Coefficients<D>& h) const { return dot(h, apply_matrix(h)) - 2 * dot(linear_, h); }

  /// A x, up to a multiple of x that changes nothing on |h| = 1.
  Coefficients<D> apply_matrix(const Coefficients<D>& x) const {
    Coefficients<D> result{};
    if (D == 3 || has_matrix_) result = matrix_times(quadratic_, x);
    if (plane_weight_ > 0) {
      add_scaled(result, -plane_weight_ * dot(plane_.cosine, x), plane_.cosine);
      add_scaled(result, -plane_weight_ * dot(plane_.sine, x), plane_.sine);
    }
    return result;
  }

  const Coefficients<D>& linear() const { return linear_; }

  /// Whether A is zero, so that f is -2 b.h.
  bool is_linear() const { return D == 4 && !has_matrix_ && plane_weight_ == 0; }

  double neighbour_weight() const { return neighbour_weight_; }
  double plane_weight() const { return plane_weight_; }
  const NormalBasis<D>& plane() const { return plane_; }
  bool has_matrix() const { return D == 3 || has_matrix_; }
  const QuadraticForm<D>& matrix() const { return quadratic_; }

 private:
  void add_neighbours(std::span<const Adjacency::Neighbour> neighbours,
                      const std::vector<StoredCoefficients<D>>& coefficients) {
    for (const auto& [neighbour, weight] : neighbours) {
      const Coefficients<D> h = from_stored<D>(coefficients[neighbour]);
      neighbour_weight_ += weight;
      if constexpr (D == 3) {
        add_outer_product(quadratic_, -5.0 / 6 * weight, h);
      } else {
        add_scaled(linear_, 0.5 * weight, h);
      }
    }
  }

  void add_plane(const PlaneForm& form) {
    const Vector3 normal = normalised(Vector3{form.normal[0], form.normal[1], form.normal[2]});
    plane_ = normal_basis<D>(normal);
    plane_weight_ = form.weight;
    if constexpr (D == 4) add_scaled(linear_, plane_weight_, plane_.zonal);
  }

  void add_form(const PackedForm<D>& form) {
    if constexpr (D == 3) {
      for (int e = 0; e < kFormEntryCount<D>; ++e) quadratic_.matrix[e] += form[e];
    } else {
      for (int e = 0; e < kFormEntryCount<D>; ++e) quadratic_.matrix[e] = form[e];
      for (int m = 0; m < kCoefficientCount<D>; ++m) linear_[m] += form[kFormEntryCount<D> + m];
    }
    has_matrix_ = true;
  }

  QuadraticForm<D> quadratic_;  // its matrix only
  bool has_matrix_ = false;
  double plane_weight_ = 0;
  NormalBasis<D> plane_;
  Coefficients<D> linear_{};
  double neighbour_weight_ = 0;
};

}  // namespace crossgrain
