// SPDX-License-Identifier: Apache-2.0
#include "fit/layers.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/ascending.hpp"
#include "fit/embedding_update.hpp"
#include "fit/hex_sheet.hpp"
#include "fit/hex_sides.hpp"
#include "fit/layer_extent.hpp"
#include "fit/layer_needs.hpp"
#include "measure/hex_validity.hpp"

namespace crossgrain {
namespace {

/// How often layers follow where pillows, or layers of other faces, have left two sides of a hexahedron on
/// one smooth face.
constexpr int kMostRepeats = 2;

/// Pillows that are inserted at once.
struct PillowBatch {
  PillowBatch(const HexMesh& mesh, std::vector<std::uint8_t> done)
      : is_top(6 * mesh.hexahedra.size(), 0),
        is_covered(6 * mesh.hexahedra.size(), 0),
        has_vertex(mesh.vertices.size(), 0),
        is_done(std::move(done)) {}

  std::vector<std::uint8_t> is_top;      ///< of each side of a hexahedron, whether it is a quad of a face
  std::vector<std::uint8_t> is_covered;  ///< or is covered although it is on the boundary, or between two
  std::vector<std::uint8_t> has_vertex;  ///< of the hexahedra at the faces
  std::vector<std::uint8_t> is_done;     ///< of each group
  std::size_t groups = 0;
};

/// Adds layers to a mesh, one sheet after the other.
class LayerAddition {
 public:
  LayerAddition(HexMesh& mesh, const FeatureComplex& features, Embedding& embedding)
      : mesh_(mesh),
        features_(features),
        embedding_(embedding),
        wedges_(wedges_of_curves(features)),
        surface_(surface_of(mesh, features)) {}

  AddedLayers run() {
    add_layers_under_faces(layer_needs(embedded()).wants_layer);
    add_pillows();
    for (int again = 0; again < kMostRepeats; ++again) {
      const LayerNeeds needs = layer_needs(embedded());
      if (needs.flat_edges == 0) break;
      add_layers_under_faces(needs.has_flat_edges);
      add_pillows();
    }
    return counted();
  }

  AddedLayers run_everywhere() {
    add_layer(sides_below(std::vector<std::uint8_t>(features_.faces.size(), 1)));
    add_pillows();
    return counted();
  }

 private:
  EmbeddedMesh embedded() const { return {mesh_, features_, embedding_, wedges_, surface_}; }

  void add_layers_under_faces(const std::vector<std::uint8_t>& wants_layer);
  void add_layer(const std::vector<std::uint8_t>& is_covered_side);
  AddedLayers counted();
  void add_pillows();
  std::vector<std::uint8_t> sides_below(const std::vector<std::uint8_t>& is_chosen) const;
  std::size_t insert(const HexSheet& sheet);
  void add_to_batch(std::uint32_t group, std::span<const LayerNeeds::Pillow> pillows,
                    PillowBatch& batch) const;
  std::vector<std::uint32_t> sides_at_curves(const std::vector<std::uint8_t>& is_top) const;

  HexMesh& mesh_;
  const FeatureComplex& features_;
  Embedding& embedding_;
  const std::vector<std::vector<CurveWedge>> wedges_;
  QuadComplex surface_;
  std::vector<std::uint32_t> opposite_;  ///< of the mesh without the pillows of a batch
  AddedLayers added_;
};

/// Marks the sides of hexahedra that are quads of faces; both of a quad between two solids.
std::vector<std::uint8_t> LayerAddition::sides_below(const std::vector<std::uint8_t>& is_chosen) const {
  std::vector<std::uint8_t> sides(6 * mesh_.hexahedra.size(), 0);
  for (std::uint32_t q = 0; q < surface_.quads().size(); ++q) {
    const std::uint32_t face = embedding_.face_of_quad[q];
    if (face == Embedding::kNone || !is_chosen[face]) continue;
    const QuadComplex::Quad& quad = surface_.quads()[q];
    const auto vertices = ascending<4>(quad.vertices);
    for (const std::uint32_t h : {quad.hexahedron_below, quad.hexahedron_above})
      for (std::uint32_t side = 6 * h; h != QuadComplex::kNone && side < 6 * h + 6; ++side)
        if (ascending<4>(corners_of_side(mesh_, side)) == vertices) sides[side] = 1;
  }
  return sides;
}

/// Returns the number of hexahedra added.
std::size_t LayerAddition::insert(const HexSheet& sheet) {
  if (sheet.is_crowded) {
    ++added_.left_out;
    return 0;
  }
  const InsertedSheet inserted = insert_sheet(mesh_, sheet);
  QuadComplex after = surface_of(mesh_, features_);
  update_embedding(surface_, after, inserted, embedding_);
  surface_ = std::move(after);
  return inserted.base.size();
}

void LayerAddition::add_layer(const std::vector<std::uint8_t>& is_covered_side) {
  std::vector<std::uint8_t> all(mesh_.hexahedra.size(), 1);
  const std::size_t count =
      insert(sheet_around(mesh_, std::move(all), opposite_sides(mesh_),
                          [&](std::uint32_t side) { return is_covered_side[side] != 0; }));
  added_.layers += count > 0;
  added_.layer_hexahedra += count;
}

AddedLayers LayerAddition::counted() {
  const std::vector<std::uint8_t> is_inverted = inverted_hexahedra(mesh_);
  added_.inverted = static_cast<std::size_t>(std::ranges::count(is_inverted, 1));
  return added_;
}

void LayerAddition::add_layers_under_faces(const std::vector<std::uint8_t>& wants_layer) {
  std::vector<std::uint8_t> is_done(wants_layer.size(), 0);
  for (std::uint32_t face = 0; face < is_done.size(); ++face) {
    if (!wants_layer[face] || is_done[face]) continue;
    const std::vector<std::uint8_t> is_covered = layer_extent(embedded(), face);
    add_layer(sides_below(is_covered));
    for (std::size_t other = 0; other < is_done.size(); ++other) is_done[other] |= is_covered[other];
  }
}

/// Adds what a group of faces needs to a batch of pillows.
void LayerAddition::add_to_batch(std::uint32_t group, std::span<const LayerNeeds::Pillow> pillows,
                                 PillowBatch& batch) const {
  const EmbeddedMesh all = embedded();
  std::vector<std::uint8_t> faces(features_.faces.size());
  for (std::uint32_t face = 0; face < faces.size(); ++face) faces[face] = all.group(face) == group;
  const std::vector<std::uint8_t> is_top = sides_below(faces);
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t side = 0; side < is_top.size(); ++side)
    if (is_top[side])
      vertices.insert(vertices.end(), mesh_.hexahedra[side / 6].begin(), mesh_.hexahedra[side / 6].end());
  if (std::ranges::any_of(vertices, [&](std::uint32_t v) { return batch.has_vertex[v] != 0; })) return;
  for (const std::uint32_t v : vertices) batch.has_vertex[v] = 1;
  ++batch.groups;
  batch.is_done[group] = 1;

  // Below a curve beside which there are other hexahedra, the layer goes on in any case.
  const std::vector<std::uint32_t> sides = sides_at_curves(is_top);
  std::vector<std::uint8_t> curves(features_.curves.size(), 0);
  for (const LayerNeeds::Pillow& pillow : pillows)
    if (pillow.group == group) curves[pillow.curve] = 1;
  for (std::uint32_t side = 0; side < sides.size(); ++side)
    if (sides[side] != Embedding::kNone && opposite_[side] != kNoSide) curves[sides[side]] = 1;
  extend_pillow(all, group, curves);
  for (std::uint32_t side = 0; side < sides.size(); ++side) {
    batch.is_top[side] |= is_top[side];
    if (sides[side] == Embedding::kNone || !curves[sides[side]]) continue;
    const auto& beside = features_.curves[sides[side]].sides;
    const bool is_inner = beside.size() == 2 && all.group(beside[0].face) == all.group(beside[1].face);
    batch.is_covered[side] = opposite_[side] == kNoSide || is_inner;
  }
}

/// For each side of a hexahedron that is across an edge of a curve from a chosen one, the curve.
std::vector<std::uint32_t> LayerAddition::sides_at_curves(const std::vector<std::uint8_t>& is_top) const {
  const std::vector<std::uint32_t> curves = curves_of_edges(embedded());
  std::vector<std::uint32_t> sides(is_top.size(), Embedding::kNone);
  for (std::uint32_t side = 0; side < is_top.size(); ++side) {
    if (!is_top[side]) continue;
    const auto corners = corners_of_side(mesh_, side);
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t across = side_across_edge(side, k);
      const std::uint32_t curve = curves[surface_.edge_between(corners[k], corners[(k + 1) % 4])];
      if (curve != Embedding::kNone && !is_top[across]) sides[across] = curve;
    }
  }
  return sides;
}

/// Faces whose hexahedra share no vertex have their pillows at once.
void LayerAddition::add_pillows() {
  const std::vector<LayerNeeds::Pillow> pillows = layer_needs(embedded()).pillows;
  std::vector<std::uint8_t> is_done(features_.faces.size(), 0);
  for (;;) {
    opposite_ = opposite_sides(mesh_);
    PillowBatch batch(mesh_, is_done);
    for (const LayerNeeds::Pillow& pillow : pillows)
      if (!is_done[pillow.group] && !batch.is_done[pillow.group]) add_to_batch(pillow.group, pillows, batch);
    if (batch.groups == 0) return;
    is_done = batch.is_done;
    std::vector<std::uint8_t> is_shrunk(mesh_.hexahedra.size(), 0);
    for (std::size_t side = 0; side < batch.is_top.size(); ++side) is_shrunk[side / 6] |= batch.is_top[side];
    const std::size_t count =
        insert(sheet_around(mesh_, std::move(is_shrunk), opposite_,
                            [&](std::uint32_t side) { return batch.is_covered[side] != 0; }));
    added_.pillows += count > 0 ? batch.groups : 0;
    added_.pillow_hexahedra += count;
  }
}

}  // namespace

AddedLayers add_layers(HexMesh& mesh, const FeatureComplex& features, Embedding& embedding) {
  return LayerAddition(mesh, features, embedding).run();
}

AddedLayers add_padding(HexMesh& mesh, const FeatureComplex& features, Embedding& embedding) {
  return LayerAddition(mesh, features, embedding).run_everywhere();
}

}  // namespace crossgrain
