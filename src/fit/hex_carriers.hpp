// SPDX-License-Identifier: Apache-2.0
// What vertices of hexahedra belong to on a model.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

struct HexCarrier {
  /// kHeld: stays where it is.
  enum class Kind : std::uint8_t { kInside, kHeld, kFace, kCurve, kCorner };
  Kind kind = Kind::kInside;
  std::uint32_t index = 0;  ///< of the group of faces, the curve or the corner

  bool is_on_surface() const { return kind != Kind::kInside && kind != Kind::kHeld; }

  friend bool operator==(const HexCarrier&, const HexCarrier&) = default;
};

struct HexCarriers {
  /// A face of hexahedra on the model's surface.
  struct Quad {
    std::array<std::uint32_t, 4> vertices;  ///< seen from the side that normals of the model look to
    std::uint32_t group;
  };

  std::vector<HexCarrier> of_vertex;

  /// Of each curve the vertices on it, in its direction, with those at its corners; a closed one ends with
  /// its first. Empty where none follow it.
  std::vector<std::vector<std::uint32_t>> path_of_curve;

  /// Faces between which no path runs are one group, known by the lowest of them.
  std::vector<std::uint32_t> group_of_face;

  std::vector<Quad> quads;
};

/// Returns the carriers of a mesh whose paths and faces are known: `path_of_curve`, `vertex_of_corner` (kNone
/// without) and the face of each quad, seen from the side that normals look to.
HexCarriers carriers_on(std::size_t vertices, const FeatureComplex& complex,
                        const std::vector<std::uint32_t>& vertex_of_corner,
                        std::vector<std::vector<std::uint32_t>> path_of_curve,
                        std::vector<HexCarriers::Quad> quads_with_faces);

/// Returns carriers by which vertices of the boundary keep to the surface anywhere.
HexCarriers carriers_without_features(const HexMesh& mesh, const FeatureComplex& complex);

}  // namespace crossgrain
