// SPDX-License-Identifier: Apache-2.0
#include "solve/kept_forms.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "crossgrain/page.hpp"
#include "grid/cell_constraints.hpp"
#include "grid/merged_depth.hpp"

namespace crossgrain {
namespace {

/// A form takes ten times the bytes of all other data of a cell of the page.
constexpr std::size_t kMostForms = 8000;

/// A cell of the merged field, which contains the leaves [first, last).
struct Cell {
  CellAddress address;
  CellIndex first, last;
};

struct CellsWithSurface {
  std::vector<Cell> planes, others;
};

CellsWithSurface cells_with_surface(const Octree& tree, std::span<const CellConstraint> constraints,
                                    int depth) {
  CellsWithSurface result;
  for (CellIndex first = 0; first < tree.size();) {
    const CellAddress address = tree[first].ancestor_at(depth);
    CellIndex last = first;
    bool has_surface = false, only_planes = true;
    for (; last < tree.size() && address.contains(tree[last]); ++last) {
      if (constraints[last] == CellConstraint::kNoSurface) continue;
      has_surface = true;
      only_planes = only_planes && constraints[last] == CellConstraint::kPlane;
    }
    if (has_surface) (only_planes ? result.planes : result.others).push_back({address, first, last});
    first = last;
  }
  return result;
}

/// Appends `count` of `cells`, evenly spaced, or all of them if there are fewer.
void add_evenly(const std::vector<Cell>& cells, std::size_t count, std::vector<Cell>& chosen) {
  count = std::min(count, cells.size());
  for (std::size_t k = 0; k < count; ++k) chosen.push_back(cells[k * cells.size() / count]);
}

template <int D>
void write_form(const QuadraticForm<D>& form, std::size_t row, KeptForms& forms) {
  constexpr std::size_t n = kCoefficientCount<D>;
  const auto to_float = [](double value) { return static_cast<float>(value); };
  std::transform(form.matrix.begin(), form.matrix.end(), forms.matrices.begin() + row * form.matrix.size(),
                 to_float);
  const Coefficients<D> linear = linear_part(form);
  std::transform(linear.begin(), linear.end(), forms.linear_parts.begin() + row * n, to_float);
  forms.constants[row] = to_float(constant_part(form));
  forms.weights[row] = to_float(form.weight);
}

template <int D>
KeptForms forms_of(const GridLevel& level, const Solid& solid, const std::vector<Cell>& cells) {
  KeptForms forms;
  for (const Cell& cell : cells) forms.cells.push_back(cell.address);
  forms.matrices.resize(cells.size() * kFormEntryCount<D>);
  forms.linear_parts.resize(cells.size() * kCoefficientCount<D>);
  forms.constants.resize(cells.size());
  forms.weights.resize(cells.size());
  parallel_for(cells.size(), [&](std::size_t k) {
    QuadraticForm<D> sum{};
    for (CellIndex i = cells[k].first; i < cells[k].last; ++i)
      if (level.is_constrained(i)) sum += cell_form<D>(level, solid, i);
    write_form(sum, k, forms);
  });
  return forms;
}

}  // namespace

KeptForms kept_forms(const GridLevel& level, const Solid& solid, Degree degree,
                     std::span<const CellConstraint> constraints) {
  if (!level.share().is_whole()) return {};
  const int depth = merged_depth(level.tree, kMostCellsOfPage, kDeepestShown);
  const CellsWithSurface found = cells_with_surface(level.tree, constraints, depth);
  std::vector<Cell> chosen;
  add_evenly(found.others, kMostForms, chosen);
  add_evenly(found.planes, kMostForms - chosen.size(), chosen);
  std::ranges::sort(chosen, {}, &Cell::first);
  return degree == Degree::kThree ? forms_of<3>(level, solid, chosen) : forms_of<4>(level, solid, chosen);
}

}  // namespace crossgrain
