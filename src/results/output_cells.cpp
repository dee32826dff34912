// SPDX-License-Identifier: Apache-2.0
// Notation: h is the volume-weighted mean of the coefficients of a cell's leaves.
#include "results/output_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "grid/leaf_finder.hpp"
#include "harmonics/frame.hpp"
#include "results/result_files.hpp"

namespace crossgrain {
namespace {

/// Leaves that one task processes between two queries of the monitor.
constexpr std::size_t kLeavesAtOnce = 1 << 14;

/// If h . h(R) exceeds this share of |h| at a local maximum R, then R is the nearest frame: any other as near
/// would be within 0.36 rad of R, where there is one maximum only.
constexpr double kCertainlyNearest = 0.95;

/// Cells of the output in the order of their leaves, and the first leaf of each.
struct ChosenCells {
  std::vector<CellAddress> addresses;
  std::vector<CellIndex> first_leaves;
};

/// Returns whether two boxes intersect.
bool meet(const Box& a, const Box& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (a.high[axis] < b.low[axis] || b.high[axis] < a.low[axis]) return false;
  }
  return true;
}

ChosenCells chosen_cells(const Octree& tree, const OutputOptions& options, const Monitor& monitor) {
  const int level = options.level.value_or(kMaxDepth);
  std::vector<ChosenCells> runs((tree.size() + kLeavesAtOnce - 1) / kLeavesAtOnce);
  parallel_for_chunks(tree.size(), kLeavesAtOnce, [&](std::size_t begin, std::size_t end) {
    monitor.check();
    ChosenCells& run = runs[begin / kLeavesAtOnce];
    for (std::size_t i = begin; i < end; ++i) {
      const CellAddress cell = tree.leaves()[i].ancestor_at(level);
      const bool is_first = i == 0 || !cell.contains(tree.leaves()[i - 1]);
      if (!is_first || (options.clip && !meet(tree.root().box(cell), *options.clip))) continue;
      run.addresses.push_back(cell);
      run.first_leaves.push_back(static_cast<CellIndex>(i));
    }
  });
  std::size_t count = 0;
  for (const ChosenCells& run : runs) count += run.addresses.size();
  ChosenCells cells;
  cells.addresses.reserve(count);
  cells.first_leaves.reserve(count);
  for (ChosenCells& run : runs) {
    cells.addresses.insert(cells.addresses.end(), run.addresses.begin(), run.addresses.end());
    cells.first_leaves.insert(cells.first_leaves.end(), run.first_leaves.begin(), run.first_leaves.end());
    run = {};
  }
  return cells;
}

/// The leaves of a cell merged as output_cells promises.
class MergedLeaves {
 public:
  MergedLeaves(const FieldData& field, CellAddress cell, CellIndex first_leaf)
      : field_(field), cell_(cell), first_(first_leaf), last_(first_leaf) {
    while (last_ < field.tree.size() && cell_.contains(field.tree[last_])) ++last_;
  }

  StoredQuaternion frame() const {
    if (last_ - first_ == 1) return field_.frames[first_];
    Coefficients<4> h{};
    for (CellIndex i = first_; i < last_; ++i) {
      const double width = field_.tree[i].width();
      add_scaled(h, width * width * width, coefficients_of(i));
    }
    // Ascend from the nearest leaf's frame.
    CellIndex start = first_;
    double most = -INFINITY;
    for (CellIndex i = first_; i < last_; ++i) {
      const double score = dot(h, coefficients_of(i));
      if (score > most) most = score, start = i;
    }
    const Quaternion nearby = refine_frame<4>(h, from_stored(field_.frames[start]));
    const bool is_nearest =
        dot(h, frame_coefficients<4>(nearby)) > kCertainlyNearest * std::sqrt(squared_norm(h));
    return to_stored(is_nearest ? nearby : nearest_frame<4>(h));
  }

  float energy_density() const {
    return mean_of(field_.energy_density, [&](CellIndex i) {
      const double width = field_.tree[i].width();
      return width * width * width;
    });
  }

  float alignment_deg() const {
    return mean_of(field_.alignment_deg, [&](CellIndex i) {
      const double width = field_.tree[i].width();
      return field_.on_boundary[i] ? width * width : 0;
    });
  }

  std::uint8_t on_boundary() const {
    return std::any_of(field_.on_boundary.begin() + first_, field_.on_boundary.begin() + last_,
                       [](std::uint8_t holds_surface) { return holds_surface != 0; });
  }

  /// The class of most of its surface, measured by the areas of the sides of its leaves; the lowest on a tie.
  CellConstraint constraint() const {
    std::array<double, kCellConstraintCount> sides{};
    for (CellIndex i = first_; i < last_; ++i) {
      const double width = field_.tree[i].width();
      if (field_.constraints[i] != CellConstraint::kNoSurface)
        sides[static_cast<std::size_t>(field_.constraints[i])] += width * width;
    }
    return static_cast<CellConstraint>(std::max_element(sides.begin(), sides.end()) - sides.begin());
  }

  /// The region of most of its volume; the lowest on a tie.
  std::int32_t region() const {
    std::map<std::int32_t, double> volumes;
    for (CellIndex i = first_; i < last_; ++i) {
      const double width = field_.tree[i].width();
      volumes[field_.regions[i]] += width * width * width;
    }
    return std::max_element(volumes.begin(), volumes.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
  }

  std::uint8_t open_faces() const {
    unsigned open = 0;
    for (CellIndex i = first_; i < last_; ++i) {
      for (int face = 0; face < kFaceCount; ++face) {
        const auto across = adjacent(field_.tree[i], face);
        if (across && !cell_.contains(*across)) open |= field_.open_faces[i] & 1u << face;
      }
    }
    return static_cast<std::uint8_t>(open);
  }

 private:
  Coefficients<4> coefficients_of(CellIndex i) const {
    return frame_coefficients<4>(from_stored(field_.frames[i]));
  }

  /// 0 if all weights are 0.
  template <class WeightOf>
  float mean_of(const std::vector<float>& values, const WeightOf& weight_of) const {
    if (last_ - first_ == 1) return values[first_];
    double sum = 0, total = 0;
    for (CellIndex i = first_; i < last_; ++i) {
      sum += weight_of(i) * values[i];
      total += weight_of(i);
    }
    return static_cast<float>(total > 0 ? sum / total : 0);
  }

  const FieldData& field_;
  CellAddress cell_;
  CellIndex first_, last_;
};

/// Closes faces that have no cell behind them.
void shut_towards_missing(FieldData& part) {
  const LeafFinder finder(part.tree);
  parallel_for(part.tree.size(), [&](std::size_t i) {
    for (int face = 0; face < kFaceCount; ++face) {
      if (finder.neighbour(static_cast<CellIndex>(i), face) == kNoCell)
        part.open_faces[i] &= static_cast<std::uint8_t>(~(1u << face));
    }
  });
}

}  // namespace

namespace {

/// A companion must have a name of its own, or that of the page.
void check_companion(const std::string& name) {
  std::vector<std::string> taken = all_result_files();
  std::erase(taken, kPageFile);
  const bool is_name =
      !name.empty() && name != "." && name != ".." && std::filesystem::path(name).filename() == name;
  if (!is_name || std::find(taken.begin(), taken.end(), name) != taken.end())
    throw Error(ErrorKind::kUsage, "'" + name + "' cannot be the name of an additional file",
                Remedy::kNameOutput);
}

}  // namespace

void check_output_options(const OutputOptions& options) {
  if (options.level && (*options.level < 0 || *options.level > kMaxDepth))
    throw Error(ErrorKind::kUsage,
                fmt::format("the output level is {}, but must be from 0 to {}, a depth of the octree",
                            *options.level, kMaxDepth));
  if (!(options.hex_size > 0) || !std::isfinite(options.hex_size))
    throw Error(ErrorKind::kUsage,
                fmt::format("the size of hexahedra is {}, but must be positive", options.hex_size));
  if (options.companion) check_companion(options.companion->name);
  if (!options.clip) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = options.clip->low[axis], high = options.clip->high[axis];
    if (!(low <= high))
      throw Error(
          ErrorKind::kUsage,
          fmt::format("the clip box extends from {} to {} along {}, so it is empty", low, high, "xyz"[axis]));
  }
}

bool ask_for_all(const OutputOptions& options, const Octree& tree) {
  if (options.clip) {
    const Box root = tree.root().box(CellAddress::root());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (root.low[axis] < options.clip->low[axis] || options.clip->high[axis] < root.high[axis])
        return false;
    }
  }
  return !options.level || std::all_of(tree.leaves().begin(), tree.leaves().end(),
                                       [&](CellAddress leaf) { return leaf.depth() <= *options.level; });
}

FieldData output_cells(const FieldData& field, const OutputOptions& options, const Monitor& monitor) {
  check_output_options(options);
  ChosenCells cells = chosen_cells(field.tree, options, monitor);
  const std::size_t count = cells.addresses.size();
  FieldData part;
  part.degree = field.degree;
  part.report = field.report;
  part.frames.resize(count);
  part.open_faces.resize(count);
  part.on_boundary.resize(count);
  part.energy_density.resize(count);
  part.alignment_deg.resize(count);
  if (!field.constraints.empty()) part.constraints.resize(count);
  if (!field.regions.empty()) part.regions.resize(count);
  parallel_for_chunks(count, kParallelGrain, [&](std::size_t begin, std::size_t end) {
    monitor.check();
    for (std::size_t i = begin; i < end; ++i) {
      const MergedLeaves leaves(field, cells.addresses[i], cells.first_leaves[i]);
      part.frames[i] = leaves.frame();
      part.open_faces[i] = leaves.open_faces();
      part.on_boundary[i] = leaves.on_boundary();
      part.energy_density[i] = leaves.energy_density();
      part.alignment_deg[i] = leaves.alignment_deg();
      if (!field.constraints.empty()) part.constraints[i] = leaves.constraint();
      if (!field.regions.empty()) part.regions[i] = leaves.region();
    }
  });
  part.tree = Octree(field.tree.root(), std::move(cells.addresses));
  part.merged = field.merged;
  if (options.level) part.merged = {field.merged ? field.merged->from : field.tree.size(), *options.level};
  if (options.clip) shut_towards_missing(part);
  return part;
}

FieldData merged_part(const FieldData& part, const OutputOptions& options, const Monitor& monitor) {
  FieldData united = part;
  unite_cells(united, options.level.value());
  FieldData merged = output_cells(united, options, monitor);
  merged.merged->from = united.share().of_all;
  merged.part = united.part;
  renumber(merged);
  return merged;
}

}  // namespace crossgrain
