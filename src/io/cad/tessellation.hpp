// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/cad/bodies.hpp"
#include "io/cad_messages.hpp"

namespace crossgrain {

/// The faces of all bodies as triangles, one body after the other, each face in the orientation that looks
/// out of its body; with faces, solids, corner normals and creases. Warns of faces that could not be meshed.
/// Throws Fault where none could. The same on every run: meshing is on one thread.
TriangleMesh tessellate(const Bodies& bodies, const ReadOptions& options);

}  // namespace crossgrain
