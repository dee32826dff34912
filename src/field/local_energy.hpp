// SPDX-License-Identifier: Apache-2.0
// The energy as a cell sees it while its neighbours stand still, for W cells side by side.
//
// Notation: f(h) = h^T A h - 2 b.h, up to constants on |h| = 1. With neighbours h_j, weights w_j and the
// cell's form h^T A_c h - 2 b_c.h (scaled as in CellForms), docs/design.md section 5 gives
//   degree 4: A = A_c, b = b_c + v / 2, v = sum w_j h_j;
//   degree 3: A = A_c - (5/6) sum w_j h_j h_j^T, b = 0.
#pragma once

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>

#include "constraint/normal_form.hpp"
#include "field/cells_in_lanes.hpp"
#include "field/field_graph.hpp"
#include "field/field_state.hpp"

namespace crossgrain {

template <int D, class Real>
class LocalEnergy {
 public:
  static constexpr int W = Real::kCount;
  using Vector = Coefficients<D, Real>;

  LocalEnergy(const FieldGraph<D>& graph, const std::vector<StoredCoefficients<D>>& coefficients,
              const CellsInLanes<W>& cells) {
    if constexpr (D == 3) matrix_.emplace();
    add_neighbours(graph.adjacency(), coefficients, cells);
    for (int lane = 0; lane < W; ++lane) {
      if (graph.forms.empty(cells[lane])) continue;
      if (const PlaneForm* plane = graph.forms.plane(cells[lane])) add_plane(lane, *plane);
      if (const PackedForm<D>* form = graph.forms.general(cells[lane])) add_form(lane, *form);
    }
    if (has_planes_) finish_planes();
  }

  /// f(h) for |h| = 1.
  Real value(const Vector& h) const { return dot(h, apply_matrix(h)) - 2 * dot(linear_, h); }

  /// A x, up to a multiple of x that changes nothing on |h| = 1.
  Vector apply_matrix(const Vector& x) const {
    Vector result{};
    if (matrix_) result = matrix_times<D>(*matrix_, x);
    if (has_planes_) {
      add_scaled(result, -plane_weight_ * dot(plane_.cosine, x), plane_.cosine);
      add_scaled(result, -plane_weight_ * dot(plane_.sine, x), plane_.sine);
    }
    return result;
  }

  const Vector& linear() const { return linear_; }

  /// Whether A is zero for all cells, so that f is -2 b.h.
  bool is_linear() const { return !matrix_ && !has_planes_; }

  const Real& neighbour_weight() const { return neighbour_weight_; }

  /// Whether any of the cells has a plane form, and what they are; of weight 0 for cells without.
  bool has_planes() const { return has_planes_; }
  const Real& plane_weight() const { return plane_weight_; }
  const NormalBasis<D, Real>& plane() const { return plane_; }

  /// A without plane forms; null where it is zero for all cells.
  const FormMatrix<D, Real>* matrix() const { return matrix_ ? &*matrix_ : nullptr; }

 private:
  using Number = std::remove_cvref_t<decltype(std::declval<Real>()[0])>;

  void add_neighbours(const Adjacency& adjacency, const std::vector<StoredCoefficients<D>>& coefficients,
                      const CellsInLanes<W>& cells) {
    for (int lane = 0; lane < W; ++lane) add_to_lane(lane, adjacency[cells[lane]], coefficients);
  }

  /// Coefficients of one cell are summed side by side, as they are stored, eight at most.
  static constexpr int kWidth = std::min(W, 8), kGroups = 8 / kWidth;
  using Group = BasicLanes<Number, kWidth>;

  /// add(its cell, its weight in all lanes) for each neighbour.
  template <class Add>
  static void for_each_weighted(const Adjacency::Row& neighbours, const Add& add) {
    for (std::size_t k = 0; k < neighbours.size(); k += kWidth) {
      const Group weights = neighbours.template weights_from<Group>(k);
      const auto add_one = [&]<int J>() {
        if (k + J < neighbours.size()) add(neighbours.cell(k + J), repeated<J>(weights));
      };
      [&]<int... J>(std::integer_sequence<int, J...>) {
        (add_one.template operator()<J>(), ...);
      }
      (std::make_integer_sequence<int, kWidth>());
    }
  }

  /// Row by row of the matrix, with columns side by side.
  void add_to_lane(int lane, const Adjacency::Row& neighbours,
                   const std::vector<StoredCoefficients<3>>& coefficients) {
    constexpr int n = kCoefficientCount<3>;
    std::array<std::array<Group, kGroups>, n> rows;
    Number total_weight = 0;
    const auto add = [&](const StoredCoefficients<3>& stored, const Group& weight) {
      std::array<Group, kGroups> h, weighted;
      for (int g = 0; g < kGroups; ++g) {
        h[g] = lanes_of<Group>(stored.data() + g * kWidth);
        weighted[g] = weight * h[g];
      }
      const auto add_row = [&]<int Row>() {
        const Group factor = repeated<Row % kWidth>(weighted[Row / kWidth]);
        for (int g = Row / kWidth; g < kGroups; ++g) rows[Row][g] += factor * h[g];
      };
      [&]<int... Row>(std::integer_sequence<int, Row...>) {
        (add_row.template operator()<Row>(), ...);
      }
      (std::make_integer_sequence<int, n>());
      total_weight += weight[0];
    };
    if (neighbours.has_equal_weights()) {
      const Group weight = neighbours.weight(0);
      for (std::size_t k = 0; k < neighbours.size(); ++k) add(coefficients[neighbours.cell(k)], weight);
    } else {
      for_each_weighted(neighbours,
                        [&](std::uint32_t cell, const Group& weight) { add(coefficients[cell], weight); });
    }
    FormMatrix<3, Real>& matrix = *matrix_;
    int entry = 0;
    for (int row = 0; row < n; ++row) {
      for (int column = row; column < n; ++column)
        matrix[entry++].set(lane, -5.0 / 6 * rows[row][column / kWidth][column % kWidth]);
    }
    neighbour_weight_.set(lane, total_weight);
  }

  /// Here the eight orders below the last stand side by side, since that is how they are stored.
  void add_to_lane(int lane, const Adjacency::Row& neighbours,
                   const std::vector<StoredCoefficients<4>>& coefficients) {
    std::array<Group, kGroups> sums;
    sums.fill(0.0);
    Number last = 0, total_weight = 0;
    if (neighbours.has_equal_weights()) {
      // Inside the solid: one multiplication for all.
      for (std::size_t k = 0; k < neighbours.size(); ++k) {
        const StoredCoefficients<4>& h = coefficients[neighbours.cell(k)];
        for (int g = 0; g < kGroups; ++g) sums[g] += lanes_of<Group>(h.data() + g * kWidth);
        last += h[8];
      }
      const Number weight = neighbours.weight(0);
      for (Group& sum : sums) sum = 0.5 * weight * sum;
      last *= weight / 2;
      total_weight = weight * static_cast<Number>(neighbours.size());
    } else {
      for_each_weighted(neighbours, [&](std::uint32_t cell, const Group& weight) {
        const StoredCoefficients<4>& h = coefficients[cell];
        const Group half_weight = 0.5 * weight;
        for (int g = 0; g < kGroups; ++g) sums[g] += half_weight * lanes_of<Group>(h.data() + g * kWidth);
        last += half_weight[0] * h[8];
        total_weight += weight[0];
      });
    }
    for (int m = 0; m < 8; ++m) linear_[m].set(lane, sums[m / kWidth][m % kWidth]);
    linear_[8].set(lane, last);
    neighbour_weight_.set(lane, total_weight);
  }

  void add_plane(int lane, const PlaneForm& form) {
    if (!has_planes_) normal_ = {0.0, 0.0, 1.0};
    const Vector3 normal = normalised(Vector3{form.normal[0], form.normal[1], form.normal[2]});
    for (int axis = 0; axis < 3; ++axis) normal_[axis].set(lane, normal[axis]);
    plane_weight_.set(lane, form.weight);
    has_planes_ = true;
  }

  void finish_planes() {
    plane_ = normal_basis<D>(normal_);
    if constexpr (D == 4) add_scaled(linear_, plane_weight_, plane_.zonal);
  }

  void add_form(int lane, const PackedForm<D>& form) {
    if (!matrix_) matrix_.emplace();
    FormMatrix<D, Real>& matrix = *matrix_;
    for (int e = 0; e < kFormEntryCount<D>; ++e) matrix[e].set(lane, matrix[e][lane] + form[e]);
    if constexpr (D == 4) {
      for (int m = 0; m < kCoefficientCount<D>; ++m)
        linear_[m].set(lane, linear_[m][lane] + form[kFormEntryCount<D> + m]);
    }
  }

  std::optional<FormMatrix<D, Real>> matrix_;  // where it is zero, clearing it would take a while
  bool has_planes_ = false;
  BasicVector3<Real> normal_;
  Real plane_weight_ = 0;
  NormalBasis<D, Real> plane_;
  Vector linear_{};
  Real neighbour_weight_ = 0;
};

}  // namespace crossgrain
