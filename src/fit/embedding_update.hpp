// SPDX-License-Identifier: Apache-2.0
// An embedding after a sheet of hexahedra.
#pragma once

#include "fit/embedding.hpp"
#include "fit/hex_sheet.hpp"
#include "fit/quad_complex.hpp"

namespace crossgrain {

/// Follows what a sheet did to quads and paths. `before` and `after` are the surfaces of the mesh. A quad
/// keeps its face, a new one has that of the quad beside; a path that the sheet has cut runs over the twins,
/// and is empty if it cannot.
void update_embedding(const QuadComplex& before, const QuadComplex& after, const InsertedSheet& sheet,
                      Embedding& embedding);

}  // namespace crossgrain
