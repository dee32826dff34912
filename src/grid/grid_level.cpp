// SPDX-License-Identifier: Apache-2.0
#include "grid/grid_level.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "grid/winding_in_leaf.hpp"
#include "surface/clipping.hpp"

namespace crossgrain {
namespace {

/// Pieces below this share of both a cell face and their triangle are rounding errors of a triangle that only
/// touches the cell.
constexpr double kSmallestPiece = 1e-9;

/// Most leaves that one task refines, and pieces after which it takes no more leaves: near the root, leaves
/// hold most of the surface.
constexpr std::size_t kRefineGrain = 512, kRefinePieces = std::size_t{1} << 16;

/// Offset of the surface from the centre of the root cube, in finest cells. Any three numbers work that are
/// not close to a fraction with a small denominator.
constexpr Vector3 kGenericShift{0.3127, 0.3719, 0.4337};

/// A hole of an open surface is closed by a cap, on which the winding number is 1/2. A cell without surface
/// is away from the cap if the winding number at its centre is within this distance of 0 or 1.
constexpr double kFarFromCap = 0.1;

/// Leaves that replace a run of leaves of the previous level.
struct RefinedRun {
  std::vector<CellAddress> leaves;
  std::vector<std::uint32_t> piece_counts;
  std::vector<SurfacePiece> pieces;
  std::vector<std::int8_t> centre_winding;
  std::vector<CellIndex> parent;
  std::size_t split = 0;  ///< own leaves
};

std::int8_t in_byte(int winding) {
  return static_cast<std::int8_t>(std::clamp<int>(winding, INT8_MIN, INT8_MAX));
}

/// Winding number at a point, rounded, and whether the cap of a hole may be near.
struct Winding {
  std::int8_t count = 0;
  bool near_cap = false;
};

Winding winding_at(const Solid& solid, const Vector3& point) {
  const double winding = solid.winding.at(point);
  if (solid.closed) return {in_byte(static_cast<int>(std::lround(winding))), false};
  return {static_cast<std::int8_t>(winding > 0.5 ? 1 : 0),
          winding > kFarFromCap && winding < 1 - kFarFromCap};
}

class Refiner {
 public:
  Refiner(const GridLevel& level, const Solid& solid, const Monitor& monitor)
      : level_(level), owned_(level.share()), solid_(solid), monitor_(monitor) {}

  RefinedRun refine(CellIndex begin, CellIndex end, const std::vector<bool>& marked) const {
    RefinedRun run;
    for (CellIndex i = begin; i < end; ++i) {
      if (marked[i]) {
        split(i, run);
      } else {
        const auto pieces = level_.pieces_of(i);
        run.pieces.insert(run.pieces.end(), pieces.begin(), pieces.end());
        close_leaf(i, level_.tree[i], pieces.size(), level_.centre_winding[i], run);
      }
    }
    return run;
  }

 private:
  void split(CellIndex i, RefinedRun& run) const {
    run.split += owned_.owns(i);
    const std::array<Winding, 8> windings = windings_of_children(i);
    const std::vector<std::uint8_t> octants = octants_of_pieces(i);
    for (int octant = 0; octant < 8; ++octant) {
      monitor_.check_stop();
      const CellAddress child = level_.tree[i].child(octant);
      const std::size_t piece_count = clip_to(child, octant, level_.pieces_of(i), octants, run.pieces);
      const auto [winding, near_cap] = windings[octant];
      if (piece_count > 0 || winding > 0 || (near_cap && reaches_inside(child)))
        close_leaf(i, child, piece_count, winding, run);
    }
  }

  /// Returns for each piece of leaf i the children that the box of its triangle meets: bit k for octant k.
  std::vector<std::uint8_t> octants_of_pieces(CellIndex i) const {
    // The octants in the lower and upper half of the cell along each axis.
    constexpr std::array<std::uint8_t, 3> kLower{0b01010101, 0b00110011, 0b00001111};
    const auto pieces = level_.pieces_of(i);
    const RootCube& root = level_.tree.root();
    const Box lower = root.box(level_.tree[i].child(0)), upper = root.box(level_.tree[i].child(7));
    std::vector<std::uint8_t> octants(pieces.size(), 0xff);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const std::array<Vector3, 3> corners = solid_.surface.corners(pieces[k].triangle);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [low, high] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
        if (low >= lower.high[axis]) octants[k] &= static_cast<std::uint8_t>(~kLower[axis]);
        if (high < upper.low[axis]) octants[k] &= kLower[axis];
      }
    }
    return octants;
  }

  /// Clips the pieces that may be in `child` to it, appends the results to `clipped`, and returns their
  /// number. `octants` as octants_of_pieces returns.
  std::size_t clip_to(CellAddress child, int octant, std::span<const SurfacePiece> pieces,
                      const std::vector<std::uint8_t>& octants, std::vector<SurfacePiece>& clipped) const {
    const std::size_t before = clipped.size();
    const Box box = level_.tree.root().box(child);
    const double cell_size = level_.tree.root().cell_size(child.depth());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      if ((octants[k] >> octant & 1) == 0) continue;
      const SurfacePiece& piece = pieces[k];
      const double area = clip_triangle(solid_.surface.corners(piece.triangle), box).area;
      if (area > kSmallestPiece * std::min(cell_size * cell_size, solid_.surface.areas[piece.triangle]))
        clipped.push_back({piece.triangle, static_cast<float>(area)});
    }
    return clipped.size() - before;
  }

  /// Returns the winding numbers at the centres of the children of leaf i. Between the leaf's centre and
  /// these points the number changes only at the surface in the leaf, or at a cap. It is computed directly if
  /// rounding could miscount the crossings, or if the surface is open.
  std::array<Winding, 8> windings_of_children(CellIndex i) const {
    std::array<Winding, 8> windings;
    windings.fill({level_.centre_winding[i], false});
    if (!level_.holds_surface(i) && (solid_.closed || !winding_at(solid_, level_.tree.centre(i)).near_cap))
      return windings;
    PointsByAxis<8> centres;
    for (int octant = 0; octant < 8; ++octant) {
      const Vector3 centre = level_.tree.root().centre(level_.tree[i].child(octant));
      for (int axis = 0; axis < 3; ++axis) centres[axis][octant] = centre[axis];
    }
    WindingChanges<8> found;
    if (solid_.closed) found = winding_changes(level_, solid_, i, centres);
    for (int octant = 0; octant < 8; ++octant) {
      const Vector3 centre{centres[0][octant], centres[1][octant], centres[2][octant]};
      windings[octant] = found.certain[octant]
                             ? Winding{in_byte(level_.centre_winding[i] + found.change[octant]), false}
                             : winding_at(solid_, centre);
    }
    return windings;
  }

  /// Returns whether a corner of a leaf is inside. Then children may have their centres inside even if the
  /// leaf has not, so it is kept.
  bool reaches_inside(CellAddress leaf) const {
    const Box box = level_.tree.root().box(leaf);
    for (int corner = 0; corner < 8; ++corner) {
      Vector3 place = box.low;
      for (int axis = 0; axis < 3; ++axis) {
        if (corner >> axis & 1) place[axis] = box.high[axis];
      }
      if (solid_.winding.inside(place)) return true;
    }
    return false;
  }

  static void close_leaf(CellIndex parent, CellAddress leaf, std::size_t piece_count, std::int8_t winding,
                         RefinedRun& run) {
    run.leaves.push_back(leaf);
    run.piece_counts.push_back(static_cast<std::uint32_t>(piece_count));
    run.centre_winding.push_back(winding);
    run.parent.push_back(parent);
  }

  const GridLevel& level_;
  const Share owned_;
  const Solid& solid_;
  const Monitor& monitor_;
};

/// Returns the first leaves of the runs that tasks refine, and the number of leaves.
std::vector<CellIndex> begins_of_runs(const GridLevel& level) {
  std::vector<CellIndex> begins;
  const auto leaves = static_cast<CellIndex>(level.size());
  for (CellIndex i = 0; i < leaves; ++i) {
    const bool is_full = begins.empty() || i - begins.back() == kRefineGrain ||
                         level.piece_begin[i] - level.piece_begin[begins.back()] >= kRefinePieces;
    if (is_full) begins.push_back(i);
  }
  begins.push_back(leaves);
  return begins;
}

RefinedLevel joined(const RootCube& root, std::vector<RefinedRun> runs, std::size_t leaves_before) {
  std::vector<std::size_t> leaf_begin{0}, piece_begin{0};
  std::size_t split = 0;
  for (const RefinedRun& run : runs) {
    leaf_begin.push_back(leaf_begin.back() + run.leaves.size());
    piece_begin.push_back(piece_begin.back() + run.pieces.size());
    split += run.split;
  }
  if (std::max(leaf_begin.back(), piece_begin.back()) >= kNoCell) {
    throw Error(ErrorKind::kLimit, "the grid needs more than 4 billion cells", Remedy::kLowerResolution);
  }
  RefinedLevel made;
  GridLevel& level = made.level;
  auto leaves = sized_vector<CellAddress>(leaf_begin.back());
  level.pieces = sized_vector<SurfacePiece>(piece_begin.back());
  level.piece_begin = sized_vector<std::uint32_t>(leaf_begin.back() + 1);
  level.centre_winding = sized_vector<std::int8_t>(leaf_begin.back());
  made.parent = sized_vector<CellIndex>(leaf_begin.back());
  parallel_for(
      runs.size(),
      [&](std::size_t r) {
        RefinedRun run = std::move(runs[r]);
        const auto at = static_cast<std::ptrdiff_t>(leaf_begin[r]);
        std::ranges::copy(run.leaves, leaves.begin() + at);
        std::ranges::copy(run.centre_winding, level.centre_winding.begin() + at);
        std::ranges::copy(run.parent, made.parent.begin() + at);
        std::ranges::copy(run.pieces, level.pieces.begin() + static_cast<std::ptrdiff_t>(piece_begin[r]));
        auto pieces_before = static_cast<std::uint32_t>(piece_begin[r]);
        for (std::size_t k = 0; k < run.leaves.size(); ++k)
          level.piece_begin[leaf_begin[r] + k + 1] = pieces_before += run.piece_counts[k];
      },
      1);
  level.tree = Octree(root, std::move(leaves));
  level.examined_leaves = leaves_before + 7 * split;
  return made;
}

/// Returns the level whose only leaf is the root, with the whole surface.
RefinedLevel root_level(const Solid& solid, const RootCube& root) {
  RefinedLevel made;
  GridLevel& level = made.level;
  level.tree = Octree(root, {CellAddress::root()});
  const std::size_t triangle_count = solid.surface.size();
  level.pieces.reserve(triangle_count);
  for (std::size_t t = 0; t < triangle_count; ++t) {
    level.pieces.push_back({static_cast<std::uint32_t>(t), static_cast<float>(solid.surface.areas[t])});
  }
  level.piece_begin = {0, static_cast<std::uint32_t>(triangle_count)};
  level.centre_winding = {winding_at(solid, root.centre(CellAddress::root())).count};
  made.neighbours = face_neighbours(level.tree);
  if (solid.guides != nullptr) level.guides = LeafGuides(level.tree, *solid.guides);
  level.examined_leaves = 1;
  return made;
}

}  // namespace

GridFrame frame_around(const Box& box, double cell_size) {
  const Vector3 extent = box.high - box.low;
  const double cells = std::max({extent[0], extent[1], extent[2]}) / cell_size;
  // One cell of margin on each side leaves room for the offset.
  int depth = 0;
  while (depth <= kMaxDepth && std::ldexp(1.0, depth) < cells + 2) ++depth;
  if (depth > kMaxDepth) {
    throw Error(ErrorKind::kLimit, "more than 524286 cells across the model", Remedy::kLowerResolution);
  }
  const double size = std::ldexp(cell_size, depth);
  const Vector3 centre = 0.5 * (box.low + box.high);
  const Vector3 half{size / 2, size / 2, size / 2};
  return {{centre - half + cell_size * kGenericShift, size}, depth};
}

RefinedLevel uniform_level(const Solid& solid, const RootCube& root, int depth, const Monitor& monitor) {
  RefinedLevel made = root_level(solid, root);
  for (int d = 0; d < depth; ++d)
    made = refined(made.level, made.neighbours, solid, std::vector<bool>(made.level.size(), true), monitor);
  made.parent.clear();
  return made;
}

RefinedLevel refined(const GridLevel& level, std::span<const FaceNeighbours> neighbours, const Solid& solid,
                     std::vector<bool> marked, const Monitor& monitor) {
  balance_marks(level.tree, neighbours, marked);
  const Refiner refiner(level, solid, monitor);
  const std::vector<CellIndex> begins = begins_of_runs(level);
  std::vector<RefinedRun> runs(begins.size() - 1);
  parallel_for(
      runs.size(), [&](std::size_t r) { runs[r] = refiner.refine(begins[r], begins[r + 1], marked); }, 1);
  const Share share = level.share();
  // Of processes that share a level, the first counts the leaves before.
  RefinedLevel finer =
      joined(level.tree.root(), std::move(runs), share.is_of_first() ? level.examined_leaves : 0);
  finer.neighbours = face_neighbours({level.tree, neighbours, marked}, finer.level.tree, finer.parent);
  if (!share.is_whole()) {
    const auto index_of_first = [&](CellIndex parent) {
      const auto first = std::ranges::lower_bound(finer.parent, parent);
      return static_cast<CellIndex>(first - finer.parent.begin());
    };
    finer.level.part = Share{index_of_first(share.begin), index_of_first(share.end), 0, 0, share.exchange};
    return finer;
  }
  if (solid.guides != nullptr) finer.level.guides = LeafGuides(finer.level.tree, *solid.guides);
  return finer;
}

}  // namespace crossgrain
