// SPDX-License-Identifier: Apache-2.0
#include "surface/feature_edges.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/ascending.hpp"
#include "base/parallel.hpp"
#include "surface/creases.hpp"

namespace crossgrain {
namespace {

using VertexEdge = std::array<std::uint32_t, 2>;

/// A piece of a curve of the mesh that is an edge between two vertices.
struct KnownPiece {
  VertexEdge vertices;                ///< ascending
  std::array<Vector3, 2> directions;  ///< of the curve, from each vertex into the piece
  std::int32_t tag;
  bool is_tagged;
};

/// Vertices of triangles by their position.
class VertexFinder {
 public:
  explicit VertexFinder(const TriangleMesh& mesh) : vertices_(mesh.vertices) {
    for (const auto& triangle : mesh.triangles)
      sorted_.insert(sorted_.end(), triangle.begin(), triangle.end());
    sort_uniquely(sorted_);
    std::sort(sorted_.begin(), sorted_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return vertices_[a] < vertices_[b]; });
  }

  std::optional<std::uint32_t> at(const Vector3& point) const {
    const auto found = std::lower_bound(
        sorted_.begin(), sorted_.end(), point,
        [&](std::uint32_t vertex, const Vector3& wanted) { return vertices_[vertex] < wanted; });
    if (found == sorted_.end() || vertices_[*found] != point) return std::nullopt;
    return *found;
  }

 private:
  const std::vector<Vector3>& vertices_;
  std::vector<std::uint32_t> sorted_;
};

/// Returns the pieces of the curves of a mesh that join two of its vertices, ascending; of equal ones the
/// first.
std::vector<KnownPiece> known_pieces(const TriangleMesh& mesh) {
  if (mesh.creases.empty()) return {};
  const VertexFinder finder(mesh);
  std::vector<KnownPiece> pieces;
  for (const CreaseCurve& curve : mesh.creases) {
    std::optional<std::uint32_t> before;
    for (std::size_t k = 0; k < curve.points.size(); ++k) {
      const std::optional<std::uint32_t> vertex = finder.at(curve.points[k]);
      if (k > 0 && before && vertex && before != vertex) {
        KnownPiece piece{
            {*before, *vertex}, {curve.tangents[k - 1], -curve.tangents[k]}, curve.tag, curve.is_tagged};
        if (*vertex < *before) {
          std::swap(piece.vertices[0], piece.vertices[1]);
          std::swap(piece.directions[0], piece.directions[1]);
        }
        pieces.push_back(piece);
      }
      before = vertex;
    }
  }
  std::ranges::stable_sort(pieces, {}, &KnownPiece::vertices);
  const auto repeats = std::ranges::unique(pieces, {}, &KnownPiece::vertices);
  pieces.erase(repeats.begin(), repeats.end());
  return pieces;
}

std::vector<VertexEdge> edges_of_chains(const std::vector<std::vector<std::uint32_t>>& chains) {
  std::vector<VertexEdge> edges;
  for (const std::vector<std::uint32_t>& chain : chains) {
    for (std::size_t k = 0; k + 1 < chain.size(); ++k)
      edges.push_back(ascending(VertexEdge{chain[k], chain[k + 1]}));
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

bool changes_solids(const FeatureSurface& surface, std::span<const EdgeUse> uses) {
  return surface.solids[uses[0].triangle] != surface.solids[uses[1].triangle];
}

bool is_between_faces(const TriangleMesh& mesh, std::span<const EdgeUse> uses) {
  return !mesh.faces.empty() && mesh.faces[uses[0].triangle] != mesh.faces[uses.back().triangle];
}

/// Whether any of the pieces is an edge of a triangle.
bool any_is_edge(const std::vector<KnownPiece>& pieces, std::span<const EdgeUse> all_uses) {
  return std::ranges::any_of(pieces, [&](const KnownPiece& piece) {
    const std::uint64_t edge = (std::uint64_t{piece.vertices[0]} << 32) | piece.vertices[1];
    const auto found = std::ranges::lower_bound(all_uses, edge, {}, &EdgeUse::edge);
    return found != all_uses.end() && found->edge == edge;
  });
}

}  // namespace

std::vector<FeatureEdge> feature_edges(const FeatureSurface& surface, std::span<const EdgeUse> all_uses,
                                       const CreaseAngles& angles) {
  const TriangleMesh& mesh = surface.surface.mesh;
  std::vector<KnownPiece> pieces = known_pieces(mesh);
  if (!any_is_edge(pieces, all_uses)) pieces.clear();
  std::vector<VertexEdge> sharp;
  if (pieces.empty()) sharp = edges_of_chains(sharp_chains(surface.surface, all_uses, angles));
  std::vector<FeatureEdge> edges;
  Checkpoint checkpoint;
  for_each_edge(all_uses, [&](std::span<const EdgeUse> uses) {
    checkpoint.pass();
    FeatureEdge edge{{uses[0].low(), uses[0].high()}, uses};
    edge.is_forced = uses.size() != 2 || uses[0].forward == uses[1].forward || changes_solids(surface, uses);
    const auto piece = std::ranges::lower_bound(pieces, edge.vertices, {}, &KnownPiece::vertices);
    const bool is_known = piece != pieces.end() && piece->vertices == edge.vertices;
    edge.is_of_known_crease = is_known && !piece->is_tagged;
    edge.is_crease = edge.is_of_known_crease || std::ranges::binary_search(sharp, edge.vertices);
    if (!edge.is_forced && !edge.is_crease && !is_known && !is_between_faces(mesh, uses)) return;
    const Vector3 along = normalised(mesh.vertices[edge.vertices[1]] - mesh.vertices[edge.vertices[0]]);
    edge.directions = {along, -along};
    if (is_known) {
      edge.tag = piece->tag;
      edge.directions = piece->directions;
    }
    edges.push_back(edge);
  });
  return edges;
}

}  // namespace crossgrain
