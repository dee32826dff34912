// SPDX-License-Identifier: Apache-2.0
#include "page/shown_cells.hpp"

#include <algorithm>
#include <array>

#include "base/parallel.hpp"
#include "grid/cell_constraints.hpp"

namespace crossgrain {
namespace {

CellAddress ancestor_at(CellAddress cell, int depth) {
  while (cell.depth() > depth) cell = cell.parent();
  return cell;
}

/// The depth of the smallest cell that holds both.
int common_depth(CellAddress a, CellAddress b) {
  while (!a.contains(b)) a = a.parent();
  return a.depth();
}

/// A cell that is shown, with its leaves [first, last).
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
    const CellAddress address = ancestor_at(tree[first], depth);
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

/// `count` of `cells`, or all, evenly.
void add_evenly(const std::vector<Cell>& cells, std::size_t count, std::vector<Cell>& chosen) {
  count = std::min(count, cells.size());
  for (std::size_t k = 0; k < count; ++k) chosen.push_back(cells[k * cells.size() / count]);
}

template <int D>
void write_form(const QuadraticForm<D>& form, std::size_t row, ShownForms& forms) {
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
ShownForms forms_of(const GridLevel& level, const Solid& solid, const std::vector<Cell>& cells) {
  ShownForms forms;
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

int shown_depth(const Octree& tree, std::size_t most) {
  // A leaf is the first of a new cell at every depth below that of what it has in common with the leaf
  // before.
  std::array<std::size_t, kMaxDepth + 2> first_at{};
  for (CellIndex i = 1; i < tree.size(); ++i) ++first_at[common_depth(tree[i - 1], tree[i]) + 1];
  std::size_t cells = 1;
  int depth = 0;
  while (depth < kDeepestShown && cells + first_at[depth + 1] <= most) cells += first_at[++depth];
  return depth;
}

ShownForms shown_forms(const GridLevel& level, const Solid& solid, Degree degree,
                       std::span<const CellConstraint> constraints, std::size_t most) {
  const CellsWithSurface found = cells_with_surface(level.tree, constraints, shown_depth(level.tree));
  std::vector<Cell> chosen;
  add_evenly(found.others, most, chosen);
  add_evenly(found.planes, most - chosen.size(), chosen);
  std::sort(chosen.begin(), chosen.end(), [](const Cell& a, const Cell& b) { return a.first < b.first; });
  return degree == Degree::kThree ? forms_of<3>(level, solid, chosen) : forms_of<4>(level, solid, chosen);
}

}  // namespace crossgrain
