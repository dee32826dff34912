// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/cad/cad_messages.hpp"
#include "io/cad/program/bodies.hpp"

namespace crossgrain {

/// The faces of all bodies as triangles, one body after the other, each face in the orientation that looks
/// out of its body; with faces, solids, corner normals and creases. Warns of faces that could not be meshed.
/// Throws Fault where none could. The same on every run: meshing is on one thread.
TriangleMesh tessellate(const Bodies& bodies, const ReadOptions& options);

}  // namespace crossgrain
