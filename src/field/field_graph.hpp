// SPDX-License-Identifier: Apache-2.0
// Input of the solver: cells, their neighbours with weights, and a quadratic form for some cells. Octrees are
// converted to such a graph (field/octree_graph.hpp), and so are tet meshes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/vector3.hpp"
#include "constraint/quadratic_form.hpp"
#include "field/adjacency.hpp"
#include "field/sweep_halo.hpp"
#include "field/sweep_order.hpp"
#include "grid/share.hpp"

namespace crossgrain {

/// Cells ordered by colour. Neighbours never share a colour, so cells of one colour can be updated in
/// parallel with the same result as one after the other.
struct Colouring {
  std::vector<std::uint32_t> cells;
  std::vector<std::size_t> begin;  ///< colour c is cells[begin[c] .. begin[c + 1])

  std::size_t colour_count() const { return begin.size() - 1; }
};

/// Builds the order from a colour per cell, each below 256.
Colouring colouring_of(std::span<const std::uint8_t> colour_of_cell);

/// Gives every cell the lowest colour that no neighbour of lower index has. Throws Error(kLimit) beyond 256
/// colours.
Colouring greedy_colouring(const Adjacency& adjacency);

/// weight * E_n of a single normal: cells whose surface is flat need no matrix.
struct PlaneForm {
  std::array<float, 3> normal;
  float weight;
};

/// h^T A h - 2 b.h + c in single precision: A packed as in QuadraticForm, then (degree 4) b and c.
template <int D>
inline constexpr int kPackedFormSize = D == 3 ? 28 : 45 + 9 + 1;
template <int D>
using PackedForm = std::array<float, kPackedFormSize<D>>;

/// Maximum number of forms of each kind; by default what CellForms can index.
struct FormLimits {
  std::size_t planes = std::size_t{1} << 31;
  std::size_t generals = std::size_t{1} << 30;
  std::size_t held_axes = (std::size_t{1} << 30) - 1;
};

/// Boundary forms of a graph, scaled as in the energy: by kappa / dx, in degree 3 also by 5/3 (docs/design.md
/// sections 5 and 7). At most one form per cell. Throws Error(kLimit) if setting or reserving exceeds the
/// limits.
template <int D>
class CellForms {
 public:
  CellForms() = default;
  explicit CellForms(std::size_t cell_count, const FormLimits& limits = {})
      : slot_(cell_count, kNone), limits_(limits) {}

  void set_plane(std::size_t cell, const Vector3& unit_normal, double weight);

  /// Reserves the forms of these cells; each is then set once, in any order and from any thread.
  void reserve_planes(std::span<const std::uint32_t> cells);
  void reserve_general(std::span<const std::uint32_t> cells);
  void set_general(std::size_t cell, const QuadraticForm<D>& form, double scale);

  /// Constrains the frame of the cell from now on to keep one of its axes along `unit_axis` exactly, so that
  /// it only rotates about it. Precondition: the cell's frame has such an axis.
  void hold_axis(std::size_t cell, const Vector3& unit_axis);

  const Vector3* held_axis(std::size_t cell) const {
    return slot_[cell] >= kHeld && slot_[cell] != kNone ? &held_axes_[slot_[cell] - kHeld] : nullptr;
  }
  const PlaneForm* plane(std::size_t cell) const {
    return slot_[cell] < kGeneral ? &planes_[slot_[cell]] : nullptr;
  }
  const PackedForm<D>* general(std::size_t cell) const {
    return slot_[cell] >= kGeneral && slot_[cell] < kHeld ? &generals_[slot_[cell] - kGeneral] : nullptr;
  }
  bool empty(std::size_t cell) const { return slot_[cell] == kNone; }

 private:
  friend struct MemoryOfForms;  // of a test, which compares it with the budget

  // A slot is an index into one of three lists; its two highest bits tell which.
  static constexpr std::uint32_t kGeneral = std::uint32_t{2} << 30;
  static constexpr std::uint32_t kHeld = std::uint32_t{3} << 30;
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  static_assert(FormLimits{}.planes == kGeneral && FormLimits{}.generals == kHeld - kGeneral &&
                FormLimits{}.held_axes == kNone - kHeld);
  std::vector<std::uint32_t> slot_;
  std::vector<PlaneForm> planes_;
  std::vector<PackedForm<D>> generals_;
  std::vector<Vector3> held_axes_;
  FormLimits limits_;
};

extern template class CellForms<3>;
extern template class CellForms<4>;

/// Neighbours of the cells, and the order in which cells are visited.
struct Connectivity {
  Adjacency adjacency;  ///< ghosts have no neighbours
  SweepOrder order;
  SweepHalo halo = {};  ///< empty if this process has all cells
  Share part = {};      ///< of the cells, if this process does not have all

  Share share() const { return share_of(part, adjacency.size()); }
};

/// The graph of one sweep. Graphs of both degrees over the same cells share their connectivity.
template <int D>
struct FieldGraph {
  std::shared_ptr<const Connectivity> connectivity;
  CellForms<D> forms;

  const Adjacency& adjacency() const { return connectivity->adjacency; }
  const SweepOrder& order() const { return connectivity->order; }
  const SweepHalo& halo() const { return connectivity->halo; }
  Share share() const { return connectivity->share(); }
  std::size_t size() const { return adjacency().size(); }
};

}  // namespace crossgrain
