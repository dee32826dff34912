// SPDX-License-Identifier: Apache-2.0
#include "display/surface_spots.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

/// Distance of sampled points from the surface, as a share of the smallest cell size.
constexpr double kInwards = 0.02;

/// Side of the square with the least area of a spot, as a share of the longest side: slivers have many pieces
/// in a cell, of which one stands for several.
constexpr double kLeastSide = 0.25;

/// Number of triangles cut by one task.
constexpr std::size_t kTrianglesAtOnce = 64;

/// Number of tasks after which their spots are gathered.
constexpr std::size_t kTasksAtOnce = 64;

/// Most halvings of one triangle: pieces are then a millionth of it in size, below any cell.
constexpr int kMostHalvings = 40;

using Barycentric = std::array<double, 2>;  // of the second and third corner

Barycentric mean_of(const Barycentric& a, const Barycentric& b) {
  return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
}

class TriangleCutter {
 public:
  TriangleCutter(const SolvedSurface& surface, std::uint32_t triangle, const FieldData& field,
                 const SurfaceLeaves& leaves, double longest)
      : triangle_(triangle), field_(field), leaves_(leaves), longest_(longest) {
    const auto& [a, b, c] = surface.triangles[triangle];
    first_ = surface.vertices[a];
    sides_ = {surface.vertices[b] - first_, surface.vertices[c] - first_};
    const Vector3 across = cross(sides_[0], sides_[1]);
    area_ = 0.5 * norm(across);
    normal_ = normalised(across);
  }

  /// Calls visit(spot) for each piece.
  template <class Visit>
  void cut(const Visit& visit) {
    if (area_ > 0) cut({{{0, 0}, {1, 0}, {0, 1}}}, 0, true, visit);
  }

 private:
  Vector3 place_of(const Barycentric& at) const { return first_ + at[0] * sides_[0] + at[1] * sides_[1]; }

  template <class Visit>
  void cut(const std::array<Barycentric, 3>& piece, int halvings, bool is_last, const Visit& visit) {
    const Barycentric middle{(piece[0][0] + piece[1][0] + piece[2][0]) / 3,
                             (piece[0][1] + piece[1][1] + piece[2][1]) / 3};
    std::size_t longest = 0;
    double most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double length = norm(place_of(piece[(k + 1) % 3]) - place_of(piece[k]));
      if (length > most) most = length, longest = k;
    }
    if (most <= longest_ * leaves_.largest_cell() || halvings == kMostHalvings) {
      leaf_ = leaves_.beside(place_of(middle), normal_, leaf_).leaf;
      const double cell = leaf_ == kNoCell ? leaves_.largest_cell() : field_.tree.cell_size(leaf_);
      if (most <= longest_ * cell || halvings == kMostHalvings) {
        pending_ += std::ldexp(area_, -halvings);
        const double side = kLeastSide * longest_ * cell;
        if (pending_ < side * side && !is_last) return;
        visit(SurfaceSpot{triangle_, static_cast<float>(middle[0]), static_cast<float>(middle[1]),
                          static_cast<float>(pending_), leaf_});
        pending_ = 0;
        return;
      }
    }
    const Barycentric &a = piece[longest], &b = piece[(longest + 1) % 3], &c = piece[(longest + 2) % 3];
    const Barycentric half = mean_of(a, b);
    cut({a, half, c}, halvings + 1, false, visit);
    cut({half, b, c}, halvings + 1, is_last, visit);
  }

  std::uint32_t triangle_;
  const FieldData& field_;
  const SurfaceLeaves& leaves_;
  double longest_;
  Vector3 first_{}, normal_{};
  std::array<Vector3, 2> sides_{};
  double area_ = 0;
  CellIndex leaf_ = kNoCell;  ///< of the last piece: most are in the same or the next
  double pending_ = 0;        ///< area of the pieces since the last spot
};

}  // namespace

SurfaceLeaves::SurfaceLeaves(const FieldData& field) : field_(field), finder_(field.tree) {
  int deepest = 0, coarsest = kMaxDepth;
  for (CellIndex i = 0; i < field.tree.size(); ++i) {
    deepest = std::max(deepest, field.tree[i].depth());
    if (field.on_boundary[i] != 0) coarsest = std::min(coarsest, field.tree[i].depth());
  }
  inwards_ = kInwards * field.tree.root().cell_size(deepest);
  largest_ = field.tree.root().cell_size(std::min(coarsest, deepest));
}

SurfaceLeaves::Beside SurfaceLeaves::beside(const Vector3& point, const Vector3& normal,
                                            CellIndex likely) const {
  Beside found{point, kNoCell};
  for (const double way : {-inwards_, inwards_}) {
    const Vector3 place = point + way * normal;
    const auto cell = field_.tree.root().locate(place);
    if (!cell) continue;
    const bool is_likely = likely != kNoCell && field_.tree[likely].contains(*cell);
    const CellIndex leaf = is_likely ? likely : finder_.containing(*cell);
    if (leaf == kNoCell) continue;
    if (field_.on_boundary[leaf] != 0) return {place, leaf};
    if (found.leaf == kNoCell) found = {place, leaf};
  }
  return found;
}

std::deque<SurfaceSpot> surface_spots(const SolvedSurface& surface, const FieldData& field,
                                      const SurfaceLeaves& leaves, double longest) {
  const std::size_t count = surface.triangles.size();
  const auto cutter = [&](std::size_t t) {
    return TriangleCutter(surface, static_cast<std::uint32_t>(t), field, leaves, longest);
  };
  // Round by round into a deque: one list that grows would take several times the memory.
  std::deque<SurfaceSpot> spots;
  std::array<std::vector<SurfaceSpot>, kTasksAtOnce> found;
  for (std::size_t round = 0; round < count; round += kTasksAtOnce * kTrianglesAtOnce) {
    const std::size_t size = std::min(kTasksAtOnce * kTrianglesAtOnce, count - round);
    parallel_for_chunks(size, kTrianglesAtOnce, [&](std::size_t first, std::size_t last) {
      std::vector<SurfaceSpot>& own = found[first / kTrianglesAtOnce];
      own.clear();
      for (std::size_t t = first; t < last; ++t)
        cutter(round + t).cut([&](const SurfaceSpot& spot) { own.push_back(spot); });
    });
    for (std::size_t task = 0; task * kTrianglesAtOnce < size; ++task)
      spots.insert(spots.end(), found[task].begin(), found[task].end());
  }
  return spots;
}

}  // namespace crossgrain
