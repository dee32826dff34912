// SPDX-License-Identifier: Apache-2.0
#include "fit/layer_needs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/ascending.hpp"
#include "base/degree.hpp"
#include "base/lists.hpp"
#include "measure/hex_faces.hpp"

namespace crossgrain {
namespace {

constexpr std::uint32_t kNoGroup = Embedding::kNone;

/// How far one hexahedron or quad of several in an angle is from a right angle.
double misfit(double angle_rad, double parts) {
  return std::abs(angle_rad / parts - std::numbers::pi / 2);
}

bool fits(double angle_rad) {
  return angle_rad >= kLeastLayerDeg * kDegree && angle_rad <= kMostLayerDeg * kDegree;
}

/// The solids of the hexahedra at each edge of the surface.
Lists<std::int32_t> solids_at_edges(const EmbeddedMesh& embedded) {
  const std::vector<std::int32_t> solids = solids_of_hexahedra(embedded.mesh, embedded.features);
  return Lists<std::int32_t>(embedded.surface.edges().size(), [&](const auto& add) {
    for (std::size_t h = 0; h < solids.size(); ++h) {
      for (const auto& [a, b] : kHexEdges) {
        const auto& hexahedron = embedded.mesh.hexahedra[h];
        const std::uint32_t edge = embedded.surface.edge_between(hexahedron[a], hexahedron[b]);
        if (edge != QuadComplex::kNone) add(edge, solids[h]);
      }
    }
  });
}

/// Finds the needs of a mesh, one kind after the other.
class NeedSearch {
 public:
  explicit NeedSearch(const EmbeddedMesh& embedded)
      : embedded_(embedded), curves_(curves_of_edges(embedded)) {
    needs_.wants_layer.assign(embedded.features.faces.size(), 0);
    needs_.has_flat_edges = needs_.wants_layer;
  }

  LayerNeeds run() {
    const Lists<std::int32_t> solids = solids_at_edges(embedded_);
    for (std::uint32_t edge = 0; edge < curves_.size(); ++edge) {
      if (curves_[edge] == Embedding::kNone)
        look_inside_face(edge, solids[edge]);
      else
        look_at_curve(curves_[edge], solids[edge]);
    }
    for (const FeatureComplex::Corner& corner : embedded_.features.corners) look_at_corner(corner);
    for (std::uint32_t curve = 0; curve < embedded_.features.curves.size(); ++curve) look_along(curve);
    for (std::vector<std::uint8_t>* const of_faces : {&needs_.wants_layer, &needs_.has_flat_edges})
      for (std::uint32_t face = 0; face < of_faces->size(); ++face)
        (*of_faces)[face] = (*of_faces)[embedded_.group(face)];
    sort_uniquely(needs_.pillows);
    return std::move(needs_);
  }

 private:
  void look_inside_face(std::uint32_t edge, std::span<const std::int32_t> solids);
  void look_at_curve(std::uint32_t curve, std::span<const std::int32_t> solids);
  void look_at_corner(const FeatureComplex::Corner& corner);
  void look_along(std::uint32_t curve);
  void look_at_sector(std::uint32_t vertex, std::uint32_t first_quad, double angle_rad);

  bool is_on_curve(std::uint32_t edge) const { return curves_[edge] != Embedding::kNone; }

  const EmbeddedMesh& embedded_;
  std::vector<std::uint32_t> curves_;
  LayerNeeds needs_;
};

void NeedSearch::look_inside_face(std::uint32_t edge, std::span<const std::int32_t> solids) {
  const auto uses = embedded_.surface.uses_of_edge(edge);
  const QuadComplex::Quad& quad = embedded_.surface.quads()[uses[0].quad];
  const std::uint32_t group = embedded_.group_of_quad(uses[0].quad);
  if (uses.size() != 2 || group == kNoGroup || group != embedded_.group_of_quad(uses[1].quad)) return;
  for (const std::int32_t solid : {quad.below, quad.above}) {
    const auto count = static_cast<double>(std::ranges::count(solids, solid));
    if (count == 0 || fits(std::numbers::pi / count)) continue;
    needs_.wants_layer[group] = needs_.has_flat_edges[group] = 1;
    ++needs_.flat_edges;
  }
}

void NeedSearch::look_at_curve(std::uint32_t curve, std::span<const std::int32_t> solids) {
  const std::vector<CurveWedge>& wedges = embedded_.wedges[curve];
  for (std::size_t k = 0; k < wedges.size(); ++k) {
    const std::int32_t solid = wedges[k].solid;
    const auto is_same = [&](const CurveWedge& wedge) { return wedge.solid == solid; };
    const auto first = std::ranges::find_if(wedges, is_same);
    if (first != wedges.begin() + static_cast<std::ptrdiff_t>(k))
      continue;  // wedges of a solid are counted together
    double angle_rad = 0, parts = 0;
    for (const CurveWedge& wedge : wedges)
      if (is_same(wedge)) angle_rad += wedge.mean_rad, parts += 1;
    const auto count = static_cast<double>(std::ranges::count(solids, solid));
    if (count == 0 || fits(angle_rad / count)) continue;
    const double now = misfit(angle_rad, count), one = misfit(angle_rad, parts),
                 two = misfit(angle_rad, 2 * parts);
    if (std::min(one, two) > now - kDegree) continue;
    ++needs_.unsuited_edges;
    for (const CurveWedge& wedge : wedges) {
      if (!is_same(wedge)) continue;
      const auto& sides = embedded_.features.curves[curve].sides;
      needs_.wants_layer[embedded_.group(sides[wedge.from].face)] = 1;
      if (two < one) needs_.wants_layer[embedded_.group(sides[wedge.to].face)] = 1;
    }
  }
}

/// A sector begins with a quad and ends at the next edge of a curve.
void NeedSearch::look_at_sector(std::uint32_t vertex, std::uint32_t first_quad, double angle_rad) {
  const std::uint32_t group = embedded_.group_of_quad(first_quad);
  const auto edges = embedded_.surface.edges_at(first_quad, vertex);
  if (angle_rad <= kMostLayerDeg * kDegree || group == kNoGroup || !is_on_curve(edges[1])) return;
  for (const std::uint32_t edge : edges) needs_.pillows.push_back({group, curves_[edge]});
  ++needs_.wide_sectors;
}

void NeedSearch::look_at_corner(const FeatureComplex::Corner& corner) {
  for (const FeatureComplex::Sector& sector : corner.sectors) {
    if (sector.from == FeatureComplex::kNone) continue;
    const auto& [curve, is_last] = corner.ends[sector.from];
    const auto& path = embedded_.embedding.path_of_curve[curve];
    if (path.empty()) continue;
    const std::uint32_t vertex = is_last ? path.back() : path.front();
    const std::uint32_t edge =
        embedded_.surface.edge_between(vertex, is_last ? path[path.size() - 2] : path[1]);
    for (const QuadComplex::Use& use : embedded_.surface.uses_of_edge(edge)) {
      const QuadComplex::Quad& quad = embedded_.surface.quads()[use.quad];
      if (quad.below == sector.below && quad.above == sector.above &&
          embedded_.surface.edges_at(use.quad, vertex)[0] == edge)
        look_at_sector(vertex, use.quad, sector.angle_rad);
    }
  }
}

/// Between corners every sector is nearly straight.
void NeedSearch::look_along(std::uint32_t curve) {
  const auto& path = embedded_.embedding.path_of_curve[curve];
  if (path.empty()) return;
  const bool has_corner = embedded_.features.curves[curve].corners[0] != FeatureComplex::kNone;
  for (std::size_t k = has_corner ? 1 : 0; k + 1 < path.size(); ++k)
    for (const std::uint32_t quad : embedded_.surface.quads_of(path[k]))
      if (is_on_curve(embedded_.surface.edges_at(quad, path[k])[0]))
        look_at_sector(path[k], quad, std::numbers::pi);
}

}  // namespace

std::vector<std::uint32_t> curves_of_edges(const EmbeddedMesh& embedded) {
  std::vector<std::uint32_t> curves(embedded.surface.edges().size(), Embedding::kNone);
  for (std::uint32_t c = 0; c < embedded.embedding.path_of_curve.size(); ++c) {
    const auto& path = embedded.embedding.path_of_curve[c];
    for (std::size_t k = 0; k + 1 < path.size(); ++k)
      curves[embedded.surface.edge_between(path[k], path[k + 1])] = c;
  }
  return curves;
}

LayerNeeds layer_needs(const EmbeddedMesh& embedded) {
  return NeedSearch(embedded).run();
}

}  // namespace crossgrain
