// SPDX-License-Identifier: Apache-2.0
// The energy as a cell sees it while its neighbours stand still, for W cells side by side.
//
// Notation: f(h) = h^T A h - 2 b.h, up to constants on |h| = 1. With neighbours h_j, weights w_j and the
// cell's form h^T A_c h - 2 b_c.h (scaled as in CellForms), docs/design.md section 5 gives
//   degree 4: A = A_c, b = b_c + sum (w_j / 2) h_j;
//   degree 3: A = A_c - (5/6) sum w_j h_j h_j^T, b = 0.
// In degree 3 that is a matrix per neighbour. With the cell's present coefficients h_0 and s_j = h_j.h_0,
//   (h_j.h)^2 = 2 s_j (h_j.h) - s_j^2 + (h_j.(h - h_0))^2,
// and the last term is of fourth order in the turns where neighbours agree, since there h_j is across every
// small turn of h_0. There it is left out:
//   degree 3: A = A_c, b = sum (5/6) w_j s_j h_j.
// For positive weights f is then an upper bound of the energy that meets it at h_0, so that a step that
// lowers f lowers the energy at least as much. Where a neighbour disagrees, around singular arcs, sweeps keep
// the matrix: by the bound alone arcs come to rest early.
#pragma once

#include <algorithm>
#include <cstring>
#include <optional>
#include <type_traits>
#include <utility>

#include "constraint/normal_form.hpp"
#include "field/cells_in_lanes.hpp"
#include "field/field_graph.hpp"
#include "field/field_state.hpp"

namespace crossgrain {

/// How degree 3 treats neighbours: by the bound alone, or by the matrix if one of them disagrees.
enum class NeighbourTerm { kBound, kExactWhereFar };

/// Neighbours with a square (h_j.h_0)^2 below this disagree: 24 degrees apart for a rotation about an axis.
inline constexpr double kAgreeingSquare = 0.65;

template <int D, class Real>
class LocalEnergy {
 public:
  static constexpr int W = Real::kCount;
  using Vector = Coefficients<D, Real>;

  /// `coefficients` are those of the cells and of their neighbours.
  LocalEnergy(const FieldGraph<D>& graph, const std::vector<StoredCoefficients<D>>& coefficients,
              const CellsInLanes<W>& cells, NeighbourTerm term = NeighbourTerm::kExactWhereFar) {
    SumsOfLanes sums;
    for (int lane = 0; lane < W; ++lane) {
      const std::uint32_t cell = cells[lane];
      sums[lane] = add_neighbours(lane, graph.adjacency()[cell], coefficients[cell], coefficients, term);
    }
    for (int first = 0; first < 8; first += 4) {
      const auto four = four_from_rows<Real>([&](int lane) { return sums[lane].data() + first; });
      for (int m = first; m < std::min(first + 4, kCoefficientCount<D>); ++m) linear_[m] = four[m - first];
    }
    for (int lane = 0; lane < W; ++lane) {
      if (graph.forms.empty(cells[lane])) continue;
      if (const PlaneForm* plane = graph.forms.plane(cells[lane])) add_plane(lane, *plane);
      if (const PackedForm<D>* form = graph.forms.general(cells[lane])) add_form(lane, *form);
    }
    if (planes_) finish_planes();
  }

  /// Returns f(h) for |h| = 1.
  Real value(const Vector& h) const { return dot(h, apply_matrix(h)) - 2 * dot(linear_, h); }

  /// Returns A x, up to a multiple of x that changes nothing on |h| = 1.
  Vector apply_matrix(const Vector& x) const {
    Vector result{};
    if (matrix_) result = matrix_times<D>(*matrix_, x);
    if (planes_) {
      const NormalBasis<D, Real>& basis = planes_->basis;
      add_scaled(result, -planes_->weight * dot(basis.cosine, x), basis.cosine);
      add_scaled(result, -planes_->weight * dot(basis.sine, x), basis.sine);
    }
    return result;
  }

  const Vector& linear() const { return linear_; }

  /// Returns whether A is zero for all cells, so that f is -2 b.h.
  bool is_linear() const { return !matrix_ && !planes_; }

  /// Sum of w_j / 2, in degree 3 of (5/6) w_j: f(h) + stiffness |h|^2 is the energy of coefficients of any
  /// length.
  const Real& stiffness() const { return stiffness_; }

  /// Plane forms of the cells; weight 0 for cells without one.
  struct Planes {
    BasicVector3<Real> normal{0.0, 0.0, 1.0};
    Real weight = 0;
    NormalBasis<D, Real> basis;
  };

  /// Null if none of the cells has one.
  const Planes* planes() const { return planes_ ? &*planes_ : nullptr; }

  /// A without plane forms; null if it is zero for all cells.
  const FormMatrix<D, Real>* matrix() const { return matrix_ ? &*matrix_ : nullptr; }

 private:
  using Number = std::remove_cvref_t<decltype(std::declval<Real>()[0])>;

  /// Coefficients of one cell are summed side by side, as they are stored, at most eight at a time.
  static constexpr int kWidth = std::min(W, 8), kGroups = 8 / kWidth;
  using Group = BasicLanes<Number, kWidth>;
  using StoredRow = std::array<Group, kGroups>;

  static StoredRow loaded(const StoredCoefficients<D>& stored) {
    StoredRow h;
    for (int g = 0; g < kGroups; ++g) h[g] = lanes_of<Group>(stored.data() + g * kWidth);
    return h;
  }

  /// Calls visit<J>() for the lanes J below `count`.
  template <class Visit>
  static void for_each_lane(std::size_t count, const Visit& visit) {
    [&]<int... J>(std::integer_sequence<int, J...>) {
      ((J < count ? visit.template operator()<J>() : void()), ...);
    }
    (std::make_integer_sequence<int, kWidth>());
  }

  /// b of each lane without its ninth number; in degree 3 padded with a zero.
  using SumsOfLanes = std::array<std::array<Number, 8>, W>;

  /// Degree 3: first computes the overlaps s_j, kWidth neighbours at a time.
  std::array<Number, 8> add_neighbours(int lane, const Adjacency::Row& neighbours,
                                       const StoredCoefficients<3>& own,
                                       const std::vector<StoredCoefficients<3>>& coefficients,
                                       NeighbourTerm term) {
    const StoredRow h0 = loaded(own);
    const Group own_square = product(h0, h0);
    StoredRow sums;
    sums.fill(0.0);
    Group least_square = 1.0;
    Number total_weight = 0;
    for (std::size_t k = 0; k < neighbours.size(); k += kWidth) {
      std::array<Group, kWidth> products;
      products.fill(own_square);  // beyond the last neighbour; a cell agrees with itself
      for_each_lane(neighbours.size() - k, [&]<int J>() {
        products[J] = product(h0, loaded(coefficients[neighbours.cell(k + J)]));
      });
      Group factors = sums_over_lanes(products);
      const Group squares = factors * factors;
      least_square = select(squares < least_square, squares, least_square);
      if (!neighbours.has_equal_weights()) {
        const Group weights = neighbours.template weights_from<Group>(k);
        factors *= weights;
        for_each_lane(neighbours.size() - k, [&]<int J>() { total_weight += weights[J]; });
      }
      for_each_lane(neighbours.size() - k, [&]<int J>() {
        const StoredRow h = loaded(coefficients[neighbours.cell(k + J)]);
        const Group factor = repeated<J>(factors);
        for (int g = 0; g < kGroups; ++g) sums[g] += factor * h[g];
      });
    }
    if (term == NeighbourTerm::kExactWhereFar && any(least_square < kAgreeingSquare)) {
      add_products(lane, neighbours, coefficients);
      sums.fill(0.0);
    }
    return finished(lane, neighbours, sums, total_weight);
  }

  static Group product(const StoredRow& a, const StoredRow& b) {
    Group result = a[0] * b[0];
    for (int g = 1; g < kGroups; ++g) result += a[g] * b[g];
    return result;
  }

  /// Adds -(5/6) sum w_j h_j h_j^T to the matrix of a lane, row by row with columns side by side.
  void add_products(int lane, const Adjacency::Row& neighbours,
                    const std::vector<StoredCoefficients<3>>& coefficients) {
    constexpr int n = kCoefficientCount<3>;
    std::array<StoredRow, n> rows{};
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
      const StoredRow h = loaded(coefficients[neighbours.cell(k)]);
      StoredRow weighted = h;
      for (Group& numbers : weighted) numbers *= -5.0 / 6 * neighbours.weight(k);
      [&]<int... Row>(std::integer_sequence<int, Row...>) {
        (add_scaled(rows[Row], repeated<Row % kWidth>(weighted[Row / kWidth]), h), ...);
      }
      (std::make_integer_sequence<int, n>());
    }
    if (!matrix_) matrix_.emplace();
    int entry = 0;
    for (int row = 0; row < n; ++row) {
      for (int column = row; column < n; ++column)
        (*matrix_)[entry++].set(lane, rows[row][column / kWidth][column % kWidth]);
    }
  }

  /// Degree 4: eight orders side by side, as they are stored, then the last.
  std::array<Number, 8> add_neighbours(int lane, const Adjacency::Row& neighbours,
                                       const StoredCoefficients<4>&,
                                       const std::vector<StoredCoefficients<4>>& coefficients,
                                       NeighbourTerm) {
    StoredRow sums;
    sums.fill(0.0);
    Number last = 0, total_weight = 0;
    if (neighbours.has_equal_weights()) {
      // Inside the solid: one multiplication for all neighbours.
      for (std::size_t k = 0; k < neighbours.size(); ++k) {
        const StoredCoefficients<4>& h = coefficients[neighbours.cell(k)];
        for (int g = 0; g < kGroups; ++g) sums[g] += lanes_of<Group>(h.data() + g * kWidth);
        last += h[8];
      }
    } else {
      for (std::size_t k = 0; k < neighbours.size(); k += kWidth) {
        const Group weights = neighbours.template weights_from<Group>(k);
        for_each_lane(neighbours.size() - k, [&]<int J>() {
          const StoredCoefficients<4>& h = coefficients[neighbours.cell(k + J)];
          const Group weight = repeated<J>(weights);
          for (int g = 0; g < kGroups; ++g) sums[g] += weight * lanes_of<Group>(h.data() + g * kWidth);
          last += weight[0] * h[8];
          total_weight += weight[0];
        });
      }
    }
    linear_[8].set(lane, scale_of(neighbours) * last);
    return finished(lane, neighbours, sums, total_weight);
  }

  /// Factor of the sums at the end; it includes the weight if all weights are equal.
  static Number scale_of(const Adjacency::Row& neighbours) {
    const auto factor = static_cast<Number>(D == 3 ? 5.0 / 6 : 0.5);
    return neighbours.has_equal_weights() ? factor * neighbours.weight(0) : factor;
  }

  std::array<Number, 8> finished(int lane, const Adjacency::Row& neighbours, StoredRow sums,
                                 Number total_weight) {
    const Number scale = scale_of(neighbours);
    if (neighbours.has_equal_weights()) total_weight = static_cast<Number>(neighbours.size());
    stiffness_.set(lane, scale * total_weight);
    for (Group& sum : sums) sum *= scale;
    std::array<Number, 8> result;
    std::memcpy(result.data(), sums.data(), sizeof result);
    return result;
  }

  void add_plane(int lane, const PlaneForm& form) {
    if (!planes_) planes_.emplace();
    const Vector3 normal = normalised(Vector3{form.normal[0], form.normal[1], form.normal[2]});
    for (int axis = 0; axis < 3; ++axis) planes_->normal[axis].set(lane, normal[axis]);
    planes_->weight.set(lane, form.weight);
  }

  void finish_planes() {
    planes_->basis = normal_basis<D>(planes_->normal);
    if constexpr (D == 4) add_scaled(linear_, planes_->weight, planes_->basis.zonal);
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

  // Empty if zero, since clearing it would take time.
  std::optional<FormMatrix<D, Real>> matrix_;
  std::optional<Planes> planes_;
  Vector linear_{};
  Real stiffness_ = 0;
};

}  // namespace crossgrain
