// SPDX-License-Identifier: Apache-2.0
// Where hexahedra are too few, at the surface of an embedding, to follow the model's angles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "fit/curve_wedges.hpp"
#include "fit/embedding.hpp"

namespace crossgrain {

/// One hexahedron, or one quad, can fill an angle of this at most: the scaled Jacobian of a wider corner is
/// below 0.82, and of a straight one 0.
inline constexpr double kMostLayerDeg = 125;

/// And of this at least.
inline constexpr double kLeastLayerDeg = 55;

/// A mesh with an embedding, as `layer_needs` and `add_layers` read it. Refers to all of it.
struct EmbeddedMesh {
  const HexMesh& mesh;
  const FeatureComplex& features;
  const Embedding& embedding;
  const std::vector<std::vector<CurveWedge>>& wedges;  ///< of the features
  const QuadComplex& surface;                          ///< `surface_of` the mesh

  /// The group of one of the model's faces.
  std::uint32_t group(std::uint32_t face) const { return embedding.group_of_face[face]; }

  /// The group of a quad; kNone without.
  std::uint32_t group_of_quad(std::uint32_t quad) const {
    const std::uint32_t face = embedding.face_of_quad[quad];
    return face == Embedding::kNone ? face : group(face);
  }
};

/// Returns for each edge of the surface the curve whose path has it; kNone without.
std::vector<std::uint32_t> curves_of_edges(const EmbeddedMesh& embedded);

struct LayerNeeds {
  std::vector<std::uint8_t> wants_layer;     ///< of each face, 1 if its group wants a layer beneath
  std::vector<std::uint8_t> has_flat_edges;  ///< of each face, 1 if this is for a flat edge of the group

  /// A group of faces, by the lowest, and a curve beside which its quads are to be divided.
  struct Pillow {
    std::uint32_t group, curve;

    friend auto operator<=>(const Pillow&, const Pillow&) = default;
  };
  std::vector<Pillow> pillows;  ///< ascending

  /// Edges inside faces at which one hexahedron fills the straight angle below the surface, or four and more
  /// share it.
  std::size_t flat_edges = 0;

  /// Edges of curves whose angle is outside the limits for the hexahedra there, and inside for, or nearer to
  /// a right angle with, one or two.
  std::size_t unsuited_edges = 0;

  /// Sectors of faces above the limit that a single quad fills: at corners, and along curves, where that quad
  /// has two edges on one curve.
  std::size_t wide_sectors = 0;
};

LayerNeeds layer_needs(const EmbeddedMesh& embedded);

}  // namespace crossgrain
