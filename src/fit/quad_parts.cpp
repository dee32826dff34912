// SPDX-License-Identifier: Apache-2.0
#include "fit/quad_parts.hpp"

#include <algorithm>
#include <array>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
#include "fit/nowhere.hpp"

namespace crossgrain {
namespace {

/// The path on an edge of the surface.
struct EdgeOnPath {
  std::uint32_t curve = kNowhere;
  bool is_forward = false;                 // the path runs from the lower vertex to the higher
  bool is_first = false, is_last = false;  // of the path
};

class PartsOfSurface {
 public:
  PartsOfSurface(const QuadComplex& surface, const std::vector<std::vector<std::uint32_t>>& paths)
      : surface_(surface), paths_(surface.edges().size()) {
    for (std::uint32_t c = 0; c < paths.size(); ++c) {
      for (std::size_t k = 1; k < paths[c].size(); ++k) {
        const std::uint32_t edge = surface.edge_between(paths[c][k - 1], paths[c][k]);
        paths_[edge] = {c, paths[c][k - 1] < paths[c][k], k == 1, k + 1 == paths[c].size()};
      }
    }
  }

  std::vector<QuadPart> parts() {
    flood();
    count_euler();
    find_loops();
    return std::move(parts_);
  }

 private:
  /// The quad across side k of one in the same part; kNowhere at a border.
  std::uint32_t beside(std::uint32_t quad, std::size_t k) const {
    const std::uint32_t edge = surface_.quads()[quad].edges[k];
    return paths_[edge].curve == kNowhere ? surface_.across(quad, edge) : kNowhere;
  }

  std::uint32_t place_in(std::uint32_t quad, std::uint32_t vertex) const {
    const auto& vertices = surface_.quads()[quad].vertices;
    return static_cast<std::uint32_t>(std::ranges::find(vertices, vertex) - vertices.begin());
  }

  void flood() {
    const std::size_t count = surface_.quads().size();
    part_of_.assign(count, kNowhere);
    Checkpoint checkpoint;
    std::vector<std::uint32_t> open;
    for (std::uint32_t first = 0; first < count; ++first) {
      if (part_of_[first] != kNowhere) continue;
      QuadPart& part = parts_.emplace_back();
      const auto number = static_cast<std::uint32_t>(parts_.size() - 1);
      part_of_[first] = number;
      open.push_back(first);
      while (!open.empty()) {
        checkpoint.pass();
        const std::uint32_t quad = open.back();
        open.pop_back();
        part.quads.push_back(quad);
        for (std::size_t k = 0; k < 4; ++k) {
          const std::uint32_t next = beside(quad, k);
          if (next == kNowhere) part.is_torn |= paths_[surface_.quads()[quad].edges[k]].curve == kNowhere;
          if (next == kNowhere || part_of_[next] != kNowhere) continue;
          part_of_[next] = number;
          open.push_back(next);
        }
      }
      std::ranges::sort(part.quads);
    }
  }

  /// Quads - edges + vertices without the border, which has the Euler number 0.
  void count_euler() {
    const std::size_t count = surface_.quads().size();
    DisjointSets fans(4 * count);
    std::vector<std::uint8_t> is_at_border(4 * count, 0);
    for (std::uint32_t quad = 0; quad < count; ++quad) {
      const auto& vertices = surface_.quads()[quad].vertices;
      int& euler = parts_[part_of_[quad]].euler;
      ++euler;
      for (std::uint32_t k = 0; k < 4; ++k) {
        const std::uint32_t other = beside(quad, k);
        if (other != kNowhere && other > quad) --euler;
        for (const std::uint32_t end : {k, (k + 1) % 4})
          if (other == kNowhere)
            is_at_border[4 * quad + end] = 1;
          else
            fans.join(4 * quad + end, 4 * other + place_in(other, vertices[end]));
      }
    }
    for (std::uint32_t corner = 0; corner < 4 * count; ++corner)
      if (is_at_border[corner] != 0) is_at_border[fans.root(corner)] = 1;
    for (std::uint32_t corner = 0; corner < 4 * count; ++corner)
      if (fans.root(corner) == corner && is_at_border[corner] == 0) ++parts_[part_of_[corner / 4]].euler;
  }

  void find_loops() {
    std::vector<bool> is_seen(4 * surface_.quads().size(), false);
    Checkpoint checkpoint;
    for (std::uint32_t first = 0; first < is_seen.size(); ++first) {
      if (is_seen[first] || beside(first / 4, first % 4) != kNowhere) continue;
      FeatureLoop loop;
      for (std::uint32_t side = first; side != kNowhere && !is_seen[side]; side = next_side(side)) {
        checkpoint.pass();
        is_seen[side] = true;
        add_step(side, loop);
      }
      if (!loop.empty()) parts_[part_of_[first / 4]].loops.push_back(from_least_step(std::move(loop)));
    }
    for (QuadPart& part : parts_) std::ranges::sort(part.loops);
  }

  /// Adds the curve that begins with a side of a quad, which lies on its left.
  void add_step(std::uint32_t side, FeatureLoop& loop) const {
    const auto& vertices = surface_.quads()[side / 4].vertices;
    const EdgeOnPath& path = paths_[surface_.quads()[side / 4].edges[side % 4]];
    if (path.curve == kNowhere) return;
    const bool is_forward = path.is_forward == (vertices[side % 4] < vertices[(side + 1) % 4]);
    if (is_forward ? path.is_first : path.is_last) loop.push_back({path.curve, is_forward});
  }

  /// The next side along the border of a part, counter-clockwise around it.
  std::uint32_t next_side(std::uint32_t side) const {
    std::uint32_t quad = side / 4, k = (side + 1) % 4;
    const std::uint32_t vertex = surface_.quads()[quad].vertices[k];
    for (std::size_t steps = surface_.quads_of(vertex).size(); steps > 0; --steps) {
      const std::uint32_t next = beside(quad, k);
      if (next == kNowhere) return 4 * quad + k;
      quad = next;
      k = place_in(quad, vertex);
    }
    return kNowhere;
  }

  const QuadComplex& surface_;
  std::vector<EdgeOnPath> paths_;
  std::vector<std::uint32_t> part_of_;
  std::vector<QuadPart> parts_;
};

}  // namespace

std::vector<QuadPart> parts_between(const QuadComplex& surface,
                                    const std::vector<std::vector<std::uint32_t>>& path_of_curve) {
  return PartsOfSurface(surface, path_of_curve).parts();
}

}  // namespace crossgrain
