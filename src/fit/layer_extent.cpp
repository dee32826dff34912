// SPDX-License-Identifier: Apache-2.0
#include "fit/layer_extent.hpp"

#include <algorithm>
#include <cstddef>

#include "base/degree.hpp"
#include "base/disjoint_sets.hpp"

namespace crossgrain {
namespace {

/// Grows a set of groups until a layer under them can end.
class LayerExtent {
 public:
  LayerExtent(const EmbeddedMesh& embedded, std::uint32_t face)
      : embedded_(embedded), is_covered_(embedded.features.faces.size(), 0) {
    is_covered_[embedded.group(face)] = 1;
  }

  std::vector<std::uint8_t> run() {
    do {
      // All curves first: a corner counts the faces beside it that are covered.
      do {
        is_larger_ = false;
        for (std::uint32_t c = 0; c < embedded_.features.curves.size(); ++c)
          if (!embedded_.embedding.path_of_curve[c].empty()) grow_at_curve(c);
      } while (is_larger_);
      for (std::uint32_t c = 0; c < embedded_.features.corners.size(); ++c)
        if (embedded_.embedding.vertex_of_corner[c] != Embedding::kNone) grow_at_corner(c);
    } while (is_larger_);
    std::vector<std::uint8_t> faces(is_covered_.size());
    for (std::uint32_t f = 0; f < faces.size(); ++f) faces[f] = covers(f);
    return faces;
  }

 private:
  bool covers(std::uint32_t face) const { return is_covered_[embedded_.group(face)] != 0; }

  void cover(std::uint32_t face) {
    is_larger_ |= !covers(face);
    is_covered_[embedded_.group(face)] = 1;
  }

  bool is_between_solids(std::uint32_t face) const { return embedded_.features.faces[face].above != 0; }

  void grow_at_curve(std::uint32_t curve);
  void grow_where_solids_meet(const std::vector<FeatureComplex::Side>& sides);
  void grow_at_corner(std::uint32_t corner);
  bool is_pinched(std::uint32_t vertex) const;

  const EmbeddedMesh& embedded_;
  std::vector<std::uint8_t> is_covered_;  ///< of each lowest face of a group
  bool is_larger_ = false;
};

void LayerExtent::grow_at_curve(std::uint32_t curve) {
  const auto& sides = embedded_.features.curves[curve].sides;
  for (const CurveWedge& wedge : embedded_.wedges[curve]) {
    const std::uint32_t a = sides[wedge.from].face, b = sides[wedge.to].face;
    if (covers(a) == covers(b) || wedge.most_rad <= kMostLayerDeg * kDegree) continue;
    cover(a);
    cover(b);
  }
  if (sides.size() > 2) grow_where_solids_meet(sides);
}

void LayerExtent::grow_where_solids_meet(const std::vector<FeatureComplex::Side>& sides) {
  const auto is_between = [&](const auto& side) { return is_between_solids(side.face); };
  const bool has_several = std::ranges::count_if(sides, is_between) > 1;
  const bool is_reached = std::ranges::any_of(
      sides, [&](const auto& side) { return covers(side.face) && (has_several || !is_between(side)); });
  if (!is_reached) return;
  for (const auto& side : sides)
    if (has_several || !is_between(side)) cover(side.face);
}

/// Whether covered quads at a vertex do not hang together over edges there.
bool LayerExtent::is_pinched(std::uint32_t vertex) const {
  const auto quads = embedded_.surface.quads_of(vertex);
  const auto is_covered = [&](std::uint32_t quad) {
    const std::uint32_t group = embedded_.group_of_quad(quad);
    return group != Embedding::kNone && is_covered_[group];
  };
  const auto place = [&](std::uint32_t quad) {
    return static_cast<std::uint32_t>(std::ranges::find(quads, quad) - quads.begin());
  };
  DisjointSets fans(quads.size());
  for (const std::uint32_t edge : embedded_.surface.edges_of(vertex)) {
    std::uint32_t first = Embedding::kNone;
    for (const QuadComplex::Use& use : embedded_.surface.uses_of_edge(edge)) {
      if (!is_covered(use.quad)) continue;
      if (first == Embedding::kNone) first = place(use.quad);
      fans.join(first, place(use.quad));
    }
  }
  std::size_t count = 0;
  for (std::uint32_t k = 0; k < quads.size(); ++k) count += is_covered(quads[k]) && fans.root(k) == k;
  return count > 1;
}

void LayerExtent::grow_at_corner(std::uint32_t corner) {
  const auto& [vertex, point, ends, sectors] = embedded_.features.corners[corner];
  const auto is_reached = [&](std::uint32_t end, std::uint32_t face) {
    const std::uint32_t curve = ends[end].curve;
    return !embedded_.embedding.path_of_curve[curve].empty() &&
           std::ranges::any_of(embedded_.features.curves[curve].sides, [&](const FeatureComplex::Side& side) {
             return side.face != face && covers(side.face);
           });
  };
  for (const FeatureComplex::Sector& sector : sectors) {
    if (sector.from == FeatureComplex::kNone || covers(sector.face)) continue;
    const double quads = is_reached(sector.from, sector.face) + is_reached(sector.to, sector.face);
    if (quads > 0 && sector.angle_rad > quads * kMostLayerDeg * kDegree) cover(sector.face);
  }
  if (!is_pinched(embedded_.embedding.vertex_of_corner[corner])) return;
  for (const FeatureComplex::Sector& sector : sectors) cover(sector.face);
}

/// Whether a pillow along one curve of a sector can end at the other.
bool can_end(const EmbeddedMesh& embedded, const FeatureComplex::Corner& corner,
             const FeatureComplex::Sector& sector) {
  if (corner.ends.size() != 3 || sector.angle_rad > kMostLayerDeg * kDegree) return false;
  const std::uint32_t curve = corner.ends[3 - sector.from - sector.to].curve;
  return !embedded.embedding.path_of_curve[curve].empty() &&
         std::ranges::all_of(embedded.wedges[curve], [](const CurveWedge& wedge) {
           return wedge.most_rad <= kMostLayerDeg * kDegree;
         });
}

}  // namespace

std::vector<std::uint8_t> layer_extent(const EmbeddedMesh& embedded, std::uint32_t face) {
  return LayerExtent(embedded, face).run();
}

void extend_pillow(const EmbeddedMesh& embedded, std::uint32_t group, std::vector<std::uint8_t>& curves) {
  for (bool is_larger = true; is_larger;) {
    is_larger = false;
    for (const FeatureComplex::Corner& corner : embedded.features.corners) {
      for (const FeatureComplex::Sector& sector : corner.sectors) {
        if (sector.from == FeatureComplex::kNone || embedded.group(sector.face) != group) continue;
        std::uint8_t &from = curves[corner.ends[sector.from].curve],
                     &to = curves[corner.ends[sector.to].curve];
        if (from == to || can_end(embedded, corner, sector)) continue;
        from = to = 1;
        is_larger = true;
      }
    }
  }
}

}  // namespace crossgrain
