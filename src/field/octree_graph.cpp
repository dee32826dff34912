// SPDX-License-Identifier: Apache-2.0
#include "field/octree_graph.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/parallel.hpp"
#include "constraint/spectral_shift.hpp"
#include "grid/cell_constraints.hpp"
#include "grid/leaf_finder.hpp"
#include "grid/open_faces.hpp"

namespace crossgrain {
namespace {

/// The share of an edge's weight that a shared 2:1 face takes away; see LeafConnections.
constexpr double kHangingShare = 1.0 / 3;

class LeafConnector {
 public:
  LeafConnector(const GridLevel& level, const Solid& solid)
      : level_(level), tree_(level.tree), finder_(level.tree), solid_(solid) {}

  /// The edges that leaf i owns: to larger leaves, and to leaves of its size on its high side.
  /// Returns their faces, bit by bit.
  std::uint8_t connect(CellIndex i, std::vector<WeightedEdge>& edges) const {
    unsigned open_faces = 0;
    for (int face = 0; face < kFaceCount; ++face) {
      const CellIndex j = finder_.neighbour(i, face);
      if (j == kNoCell) continue;
      const bool same_size = tree_[j].depth() == tree_[i].depth();
      if (same_size && face_sign(face) < 0) continue;
      const double fraction = open_between(i, face, j);
      if (fraction <= 0) continue;
      edges.push_back(edge(i, face, j, fraction));
      open_faces |= 1u << face;
    }
    return static_cast<std::uint8_t>(open_faces);
  }

  /// The face behind which the solid most likely goes on: the one that the inward normal of leaf i points at
  /// most, of those with an admissible leaf behind and more than `least` along the normal. -1 for none.
  template <class Admissible>
  int tie_face(CellIndex i, double least, const Admissible& admissible) const {
    Vector3 inward{0, 0, 0};
    for (const SurfacePiece& piece : level_.pieces_of(i))
      inward += -piece.area * solid_.outward_normal(piece.triangle);
    int best_face = -1;
    for (int face = 0; face < kFaceCount; ++face) {
      const double along = face_sign(face) * inward[face_axis(face)];
      if (along <= least) continue;
      const CellIndex j = finder_.neighbour(i, face);
      if (j == kNoCell || !admissible(j)) continue;
      least = along;
      best_face = face;
    }
    return best_face;
  }

  /// The smallest edge there can be.
  WeightedEdge tie(CellIndex i, int face) const {
    return edge(i, face, finder_.neighbour(i, face), 0.5 / (kOpenFaceSamples * kOpenFaceSamples));
  }

 private:
  double open_between(CellIndex i, int face, CellIndex j) const {
    // A face of a leaf without surface is not crossed, so it is as open as that leaf is inside.
    if (!level_.holds_surface(i) || !level_.holds_surface(j)) return 1;
    return open_fraction(level_, solid_, i, face);
  }

  WeightedEdge edge(CellIndex i, int face, CellIndex j, double fraction) const {
    const double size_i = tree_.cell_size(i), size_j = tree_.cell_size(j);
    double weight = fraction * size_i * size_i / (0.5 * (size_i + size_j));
    if (size_i == size_j) weight *= 1 - kHangingShare * shared_hanging_faces(i, face, j);
    return {i, j, static_cast<float>(weight)};
  }

  /// How many leaves of twice the size touch both i and its neighbour j across `face`.
  int shared_hanging_faces(CellIndex i, int face, CellIndex j) const {
    if (tree_[i].depth() == 0 || tree_[i].parent() != tree_[j].parent()) return 0;
    int shared = 0;
    for (int other = 0; other < kFaceCount; ++other) {
      if (face_axis(other) == face_axis(face)) continue;
      const CellIndex k = finder_.neighbour(i, other);
      shared += k != kNoCell && tree_[k].depth() < tree_[i].depth();
    }
    return shared;
  }

  const GridLevel& level_;
  const Octree& tree_;
  LeafFinder finder_;
  const Solid& solid_;
};

/// Sets of leaves that edges join (union by smaller index, path halving).
class Components {
 public:
  explicit Components(const GridLevel& level)
      : root_(level.size()), size_(level.size(), 1), inside_(level.size()) {
    std::iota(root_.begin(), root_.end(), CellIndex{0});
    for (CellIndex i = 0; i < level.size(); ++i) inside_[i] = level.centre_inside(i);
  }

  void join(CellIndex a, CellIndex b) {
    a = find(a);
    b = find(b);
    if (a == b) return;
    if (b < a) std::swap(a, b);
    root_[b] = a;
    size_[a] += size_[b];
    inside_[a] |= inside_[b];
  }

  /// Whether no centre of the leaf's component is inside and it is too small for a thin plate of its own:
  /// leaves, mostly one or two, that the surface barely cuts.
  bool is_speck(CellIndex i) {
    const CellIndex root = find(i);
    return !inside_[root] && size_[root] <= kLargestSpeck;
  }
  bool is_alone(CellIndex i) { return size_[find(i)] == 1; }

 private:
  static constexpr std::uint32_t kLargestSpeck = 8;

  CellIndex find(CellIndex i) {
    while (root_[i] != i) i = root_[i] = root_[root_[i]];
    return i;
  }

  std::vector<CellIndex> root_;
  std::vector<std::uint32_t> size_;
  std::vector<std::uint8_t> inside_;
};

/// Ties specks to the rest of the solid, inwards and from the rest outwards, so that none is tied to another
/// speck only. Single leaves that this does not reach are tied to any neighbour.
void tie_specks(const GridLevel& level, const LeafConnector& connector, LeafConnections& connections) {
  Components components(level);
  for (const WeightedEdge& edge : connections.edges) components.join(edge.first, edge.second);
  std::vector<CellIndex> specks;
  for (CellIndex i = 0; i < level.size(); ++i) {
    if (components.is_speck(i)) specks.push_back(i);
  }
  bool inwards = true;
  while (!specks.empty()) {
    std::vector<CellIndex> waiting;
    for (const CellIndex i : specks) {
      if (inwards ? !components.is_speck(i) : !components.is_alone(i)) continue;
      const int face = connector.tie_face(i, inwards ? 0 : -INFINITY,
                                          [&](CellIndex j) { return !inwards || !components.is_speck(j); });
      if (face < 0) {
        waiting.push_back(i);
        continue;
      }
      const WeightedEdge tie = connector.tie(i, face);
      components.join(i, tie.second);
      connections.edges.push_back(tie);
      connections.open_faces[i] |= static_cast<std::uint8_t>(1u << face);
      ++connections.tied_leaves;
    }
    if (waiting.size() == specks.size()) {
      if (!inwards) break;  // leaves without any neighbour
      inwards = false;
    }
    specks = std::move(waiting);
  }
}

}  // namespace

LeafConnections connect_leaves(const GridLevel& level, const Solid& solid, const Monitor& monitor) {
  const LeafConnector connector(level, solid);
  const std::size_t count = level.size();
  std::vector<std::vector<WeightedEdge>> runs((count + kParallelGrain - 1) / kParallelGrain);
  LeafConnections result;
  result.open_faces.resize(count);
  parallel_for_chunks(count, kParallelGrain, [&](std::size_t begin, std::size_t end) {
    monitor.check();
    for (auto i = static_cast<CellIndex>(begin); i < end; ++i) {
      result.open_faces[i] = connector.connect(i, runs[begin / kParallelGrain]);
    }
  });
  std::size_t edge_count = 0;
  for (const auto& run : runs) edge_count += run.size();
  result.edges.reserve(edge_count);
  for (auto& run : runs) {
    result.edges.insert(result.edges.end(), run.begin(), run.end());
    std::vector<WeightedEdge>().swap(run);
  }
  tie_specks(level, connector, result);
  return result;
}

template <int D>
CellForms<D> boundary_forms(const GridLevel& level, const Solid& solid, double boundary_weight, Shift shift) {
  CellForms<D> forms(level.size());
  const double degree_factor = D == 3 ? 5.0 / 3 : 1.0;
  std::vector<CellIndex> general;
  for (CellIndex i = 0; i < level.size(); ++i) {
    if (!level.holds_surface(i)) continue;
    if (!has_single_normal(level, solid, i)) {
      general.push_back(i);
      continue;
    }
    double area = 0;
    for (const SurfacePiece& piece : level.pieces_of(i)) area += piece.area;
    const Vector3& normal = solid.surface.normals[level.pieces_of(i)[0].triangle];
    forms.set_plane(i, normal, degree_factor * boundary_weight / level.tree.cell_size(i) * area);
  }
  forms.reserve_general(general);
  parallel_for(general.size(), [&](std::size_t k) {
    const CellIndex i = general[k];
    const double scale = degree_factor * boundary_weight / level.tree.cell_size(i);
    const QuadraticForm<D> form = cell_form<D>(level, solid, i);
    forms.set_general(i, shift == Shift::kSpectral ? shifted(form) : form, scale);
  });
  return forms;
}

template CellForms<3> boundary_forms<3>(const GridLevel&, const Solid&, double, Shift);
template CellForms<4> boundary_forms<4>(const GridLevel&, const Solid&, double, Shift);

}  // namespace crossgrain
