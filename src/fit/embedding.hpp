// SPDX-License-Identifier: Apache-2.0
// Where the features of a model lie on a mesh of hexahedra.
#pragma once

#include <cstdint>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "fit/quad_complex.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

/// A part of the surface of a mesh (its QuadComplex) for every part of a FeatureComplex: corners are
/// vertices, curves paths of edges that share no vertex but corners, faces sets of quads between them.
///
/// Without faults it has the model's topology exactly. Faces between which a curve has no path are one group,
/// known by its lowest face; the quads of each group are connected over edges of no path, have the Euler
/// number of its faces together, and are bordered by the same loops of curves, in the same order and
/// direction.
struct Embedding {
  static constexpr std::uint32_t kNone = UINT32_MAX;

  enum class FaultKind : std::uint8_t {
    kCorner,  ///< no vertex
    kCurve,   ///< no path; never of a soft curve
    kFace,    ///< its quads are of another topology; or, if the index is kNone, quads of no face
    kEdge     ///< an edge of three or more solids is on no path; the index is kNone
  };

  struct Fault {
    FaultKind kind;
    std::uint32_t index;  ///< in the features
    Vector3 place;
  };

  std::vector<std::uint32_t> vertex_of_corner;  ///< kNone without

  /// Vertices of each curve from its first end to its last, a closed one's first again at the end; empty
  /// without.
  std::vector<std::vector<std::uint32_t>> path_of_curve;

  std::vector<std::uint32_t> group_of_face;  ///< the lowest face of its group
  std::vector<std::uint32_t> face_of_quad;   ///< for the quads of `surface_of`; kNone without

  std::vector<Fault> faults;
};

/// Returns the number of each hexahedron's solid in the features: its region + 1, or the only one that they
/// have.
std::vector<std::int32_t> solids_of_hexahedra(const HexMesh& mesh, const FeatureComplex& features);

/// Returns the quads that an Embedding refers to.
QuadComplex surface_of(const HexMesh& mesh, const FeatureComplex& features);

struct EmbeddingOptions {
  /// Whether hexahedra may be added where corners have too few edges or curves find no way.
  bool makes_room = true;
};

/// Embeds features into the surface of a mesh, whose hexahedra are of about this size. Corners go to near
/// vertices by a least assignment, curves along the shortest disjoint paths near them by negotiation.
///
/// Soft curves are embedded last, where a straight path is left; the others are taken out of the features
/// (`without_curves`). May add hexahedra to the mesh: its vertices and hexahedra keep their numbers, and
/// vertices on its boundary stay there.
Embedding embedded(HexMesh& mesh, FeatureComplex& features, double size,
                   const EmbeddingOptions& options = {});

}  // namespace crossgrain
