// SPDX-License-Identifier: Apache-2.0
// Layers of hexahedra at the surface of an embedding, where it needs them or everywhere.
#pragma once

#include <cstddef>

#include "crossgrain/hex_mesh.hpp"
#include "fit/embedding.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

/// What `add_layers` has added.
struct AddedLayers {
  std::size_t layers = 0, layer_hexahedra = 0;  ///< sheets under faces
  std::size_t pillows = 0,
              pillow_hexahedra = 0;  ///< faces with a ring of quads, and hexahedra for all of them
  std::size_t inverted = 0;          ///< hexahedra, of all of the mesh, for which there was no room
  std::size_t left_out = 0;  ///< layers and pillows that would not conform, since solids touch in an edge

  std::size_t hexahedra() const { return layer_hexahedra + pillow_hexahedra; }
};

/// Adds hexahedra where `layer_needs` says so, and only there. The model's angles then are divided by enough
/// hexahedra and quads:
///
/// 1. A layer covers a face and dives along its neighbours, which then have a row of quads more; it covers
///    those too beside which one hexahedron would be too wide: both sides of concave and of nearly straight
///    curves, and corners of a neighbour that are too wide for one quad.
/// 2. A pillow is put around the hexahedra below a face, but for their sides on it: each quad then has at
/// most
///    one edge on a curve.
///
/// The embedding stays true: vertices of the surface and of paths keep their numbers, and where a layer dives
/// along a curve its path has a vertex more. Between solids, layers are on both sides.
AddedLayers add_layers(HexMesh& mesh, const FeatureComplex& features, Embedding& embedding);

/// Adds one layer under all faces, so that each quad has a hexahedron of its own, and then pillows as above.
AddedLayers add_padding(HexMesh& mesh, const FeatureComplex& features, Embedding& embedding);

}  // namespace crossgrain
