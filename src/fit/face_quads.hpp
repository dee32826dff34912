// SPDX-License-Identifier: Apache-2.0
// Quads of faces, by the paths of their curves.
#pragma once

#include "fit/coarser_features.hpp"
#include "fit/embedding.hpp"

namespace crossgrain {

/// Finds the faces of quads: Embedding::group_of_face and face_of_quad, from path_of_curve. A part between
/// paths belongs to the faces that are on these sides of their curves, one without a border to the nearest
/// face without; each quad to that of its group which is nearest. Appends faults of faces and edges.
void find_face_quads(const HexMesh& mesh, const QuadComplex& surface, const FeatureComplex& features,
                     Embedding& embedding);

}  // namespace crossgrain
